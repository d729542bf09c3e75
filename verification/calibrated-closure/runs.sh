#!/usr/bin/env bash
# Makes the runs behind data.csv: verification/calibrated-closure/runs.sh FOLDER, after ./dev build fem. Half an hour for the
# orifices on the coarser meshes, a day with the finest and the channels.
set -euo pipefail
cd "$(dirname "$0")/../.."
out=$1

# flow NAME KIND MM REFINEMENT OPTION...: a mesh with cells 1/REFINEMENT of the default
flow() {
  local name=$1 kind=$2 mm=$3 refinement=$4
  shift 4
  sed '/^samples/d' "cases/motion-$kind-${mm}mm.toml" >"$out/$name.toml"
  read -r rim orifice wall <<<"$(awk -v a="$mm" -v n="$refinement" 'BEGIN { print a / 60 / n, a / 15 / n, 8 / n }')"
  build/release/bin/turgor fem flow "$out/$name.toml" -o "$out/$name" --force -q --set fem.fields=0 \
    --set "fem.h_rim=$rim mm" --set "fem.h_orifice=$orifice mm" --set "fem.h_wall=$wall mm" "$@"
}

# The instant after rest, almost without viscosity: inertia alone.
rest() { # KIND MM REFINEMENT
  flow "rest-$1-$2-$3" "$1" "$2" "$3" --set 'motion.velocity=[{to="-2 mm/s",over="1000 s"}]' --set 'fluid.viscosity=1e-12 Pa s' \
    --set solve.samples=3 --set 'solve.t_end=2 ms' --set 'fem.time_step=1 ms'
}

# From rest to 2 cm/s and on at that: centripetal force alone. The times follow r_ch^3, but those of 3 cm.
jet() { # KIND MM REFINEMENT CFL
  local times begin end
  read -r times begin end <<<"$(awk -v a="$2" 'BEGIN {
    begin = a == 30 ? 0.5 : 0.1 * (a / 20) ^ 3; hold = a == 30 ? 1 : begin
    for (i = 0; i <= 10; ++i) list = list (i ? "," : "") sprintf("\"%.9gs\"", begin + hold * i / 10)
    print "[" list "]", begin "s", begin + hold "s" }')"
  flow "jet-$1-$2-$3-$4" "$1" "$2" "$3" --set "fem.cfl=$4" --set "solve.times=$times" --set "solve.t_end=$end" \
    --set "motion.velocity=[{to=\"-2 cm/s\",over=\"$begin\",shape=\"smooth\"},{hold=\"$end\"}]"
}

mkdir -p "$out"
for mm in 30 20 10 5; do
  for refinement in 0.5 1 2; do rest orifice $mm $refinement; done
  for refinement in 0.5 1; do jet orifice $mm $refinement 1; done
  jet orifice $mm 1 0.5
  jet channel $mm 0.5 1
done
