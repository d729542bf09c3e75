#!/usr/bin/env bash
# Code for AVX must not be met on machines without it: a kernel's object may offer nothing but its entry, for the linker
# could choose its copy of a function that others share.
# usage: exports.sh NM OBJECT...; exit code 77 when NM is missing
set -euo pipefail
command -v "${1:-nm}" >/dev/null || exit 77
nm=$1
shift
for object in "$@"; do
  name=$(basename "$object" .o)
  symbols=$("$nm" --defined-only --extern-only --demangle "$object")
  count=$(wc -l <<<"$symbols")
  if [ "$count" -ne 1 ] || ! grep -q " T turgor::$name(" <<<"$symbols"; then
    echo "$object must offer turgor::$name alone, not these $count symbols:"
    echo "$symbols"
    exit 1
  fi
done
