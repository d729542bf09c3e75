#!/usr/bin/env bash
# Inertance of a balloon's liquid from the mean pressure on its wall: run.sh OUTPUT_FOLDER [--record]
exec "$(dirname "$0")/../study.sh" "$0" "flow-studies orifice-inertance" "$@"
