#!/usr/bin/env bash
# Orders, balances and restart of a coupled balloon: run.sh OUTPUT_FOLDER [--record]
exec "$(dirname "$0")/../study.sh" "$0" "flow-studies coupled-orders" "$@"
