#!/usr/bin/env bash
# A study that is a single run of flow-studies or membrane-studies: study.sh RUN.sh COMMAND OUTPUT_FOLDER [--record]
set -euo pipefail
study=$(cd "$(dirname "$1")" && pwd)
read -ra command <<<"$2"
out=$3
mkdir -p "$out"
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
"$study/../../build/release/bin/${command[0]}" "${command[@]:1}" >"$out/errors.csv"
/usr/bin/python3 "$study/../check.py" "$out" "$study/reference.json" "${@:4}"
