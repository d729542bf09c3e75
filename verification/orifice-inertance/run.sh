#!/usr/bin/env bash
# Inertance of a balloon's liquid from the mean pressure on its wall: run.sh OUTPUT_FOLDER [--record]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
out=$1
mkdir -p "$out"
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
"$root/build/release/bin/flow-studies" orifice-inertance >"$out/errors.csv"
/usr/bin/python3 "$here/../check.py" "$out" "$here/reference.json" "${@:2}"
