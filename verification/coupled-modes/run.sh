#!/usr/bin/env bash
# Oscillations of the coupled balloon against an eigenproblem: run.sh OUTPUT_FOLDER [--record]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
out=$1
mkdir -p "$out"
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
"$root/build/release/bin/flow-studies" coupled-modes >"$out/errors.csv"
/usr/bin/python3 "$here/../check.py" "$out" "$here/reference.json" "${@:2}"
