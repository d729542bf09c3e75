#!/usr/bin/env bash
# Poiseuille's and Womersley's flow: run.sh OUTPUT_FOLDER [--record]
exec "$(dirname "$0")/../study.sh" "$0" "flow-studies channel" "$@"
