#!/usr/bin/env bash
# The membrane at rest and its small oscillations: run.sh OUTPUT_FOLDER [--record]
exec "$(dirname "$0")/../study.sh" "$0" "membrane-studies" "$@"
