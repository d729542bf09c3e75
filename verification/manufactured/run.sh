#!/usr/bin/env bash
# A made-up flow on a moving mesh that touches the axis: run.sh OUTPUT_FOLDER [--record]
exec "$(dirname "$0")/../study.sh" "$0" "flow-studies manufactured" "$@"
