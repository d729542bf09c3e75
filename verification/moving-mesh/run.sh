#!/usr/bin/env bash
# What the motion of the mesh must not do to the flow: run.sh OUTPUT_FOLDER [--record]
exec "$(dirname "$0")/../study.sh" "$0" "flow-studies moving-mesh" "$@"
