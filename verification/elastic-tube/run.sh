#!/usr/bin/env bash
# Waves in a tube of elastic rings, and the pressure pulse of the literature: run.sh OUTPUT_FOLDER [--record]
exec "$(dirname "$0")/../study.sh" "$0" "flow-studies elastic-tube" "$@"
