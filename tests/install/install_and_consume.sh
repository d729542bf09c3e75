#!/usr/bin/env bash
# Installs the build into a fresh prefix and builds the example consumer against it.
set -euo pipefail
build=$1 source=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake --install "$build" --prefix "$work/prefix" >/dev/null
cmake -S "$source/examples/consumer" -B "$work/consumer" -G Ninja -DCMAKE_PREFIX_PATH="$work/prefix" -DCMAKE_BUILD_TYPE=Release "${@:3}" >/dev/null
cmake --build "$work/consumer"
"$work/consumer/consumer" "$work/prefix/share/turgor/cases/channel-30mm.toml" | tee "$work/out"
grep -q 'events' "$work/out"
"$work/prefix/bin/turgor" validate "$work/prefix/share/turgor/cases/channel-30mm.toml"
"$work/prefix/bin/turgor" figure 7 -o "$work/figure" --no-pictures -q
test -s "$work/figure/figure-7.csv"
if [ -x "$work/prefix/bin/turgor-sweep" ]; then
  "$work/prefix/bin/turgor" sweep "$work/prefix/share/turgor/cases/sweep-orifice-pressure.toml" -o "$work/map.nc" -q --no-pictures
  test -s "$work/map.nc"
fi
if [ -x "$work/prefix/bin/turgor-fem" ]; then
  "$work/prefix/bin/turgor" fem versions | grep -q '^MUMPS'
fi
test -s "$work/prefix/share/man/man1/turgor.1"
