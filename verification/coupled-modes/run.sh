#!/usr/bin/env bash
# Oscillations of the coupled balloon against an eigenproblem: run.sh OUTPUT_FOLDER [--record]
exec "$(dirname "$0")/../study.sh" "$0" "flow-studies coupled-modes" "$@"
