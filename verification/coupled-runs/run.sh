#!/usr/bin/env bash
# Elastic balloons by finite elements against the model: the paper's seven, other orifices and ramps, meshes and steps, damping, the
# inlet's pressure, snap-through: run.sh OUTPUT_FOLDER. QUICK=1: one of them. Runs that are complete are not repeated.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
out=$1
mkdir -p "$out"
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
turgor=${TURGOR:-$root/build/release/bin/turgor}

# balloon NAME CASE [--set KEY=VALUE]...: a run, and the comparison with the model
balloon() {
  local name=$1 case=$2
  shift 2
  grep -qs '"complete"' "$out/$name/run.json" && return
  echo "== $name"
  "$turgor" fem fsi "$case" -o "$out/$name" --force -q "$@" || { echo "ENDED EARLY: $name"; return; }
  "$turgor" verify "$case" --fem "$out/$name" -o "$out/$name.verify" --force -q --no-pictures "$@"
}

# paper KIND MM [--set KEY=VALUE]...: a case of the paper, cells of twice the default size
paper() {
  local kind=$1 mm=$2 cells
  shift 2
  read -r -a cells <<<"$(awk -v a="$mm" 'BEGIN { print a / 30, a / 7.5 }')"
  balloon "${name:-$kind-${mm}mm}" "$root/cases/$kind-${mm}mm.toml" --set solve.samples=1201 \
    --set "fem.h_rim=${cells[0]} mm" --set "fem.h_orifice=${cells[1]} mm" --set "fem.h_wall=16 mm" --set fem.cfl=1 "$@"
}

# ramp MM SECONDS: bare orifice, 36 kPa up, held and down in equal times, 462 cells or fewer, 10 ms of damping
ramp() {
  local cells
  read -r -a cells <<<"$(awk -v a="$1" 'BEGIN { print int(a / 20), int(a / 5) }')"
  name="ramp-$1mm-$2s" paper orifice 30 --set "inlet.orifice_radius=$1 mm" \
    --set "pressure.segments[0].over=$2 s" --set "pressure.segments[1].hold=$2 s" --set "pressure.segments[2].over=$2 s" \
    --set "solve.t_end=$((3 * $2)) s" --set "wall.damping_time=10 ms" \
    --set "fem.h_rim=${cells[0]} mm" --set "fem.h_orifice=${cells[1]} mm" --set "fem.h_wall=20 mm"
}

ramp 50 2
if [ -z "${QUICK:-}" ]; then
  for s in 10 5; do ramp 50 $s && ramp 30 $s; done
  slow=$root/cases/coupled-orifice-30mm.toml
  balloon slow "$slow"
  balloon slow-cfl0.5 "$slow" --set fem.cfl=0.5
  balloon slow-finer "$slow" --set "fem.h_rim=0.7 mm" --set "fem.h_orifice=2.8 mm" --set "fem.h_wall=11.3 mm"
  for ms in 0 2 5 10 20; do
    name="damping-${ms}ms" paper orifice 30 --set "solve.t_end=6 s" --set "wall.damping_time=$ms ms"
  done
  name=total-pressure paper orifice 30 --set "solve.t_end=6 s" --set "wall.damping_time=0 s" --set inlet.pressure=total
  balloon snap-through "$root/cases/snap-orifice-6mm.toml"
  for mm in 30 20 15 10; do paper orifice $mm; done
  paper channel 30
  paper channel 15 --set fem.cfl=3
  paper channel 10 --set fem.cfl=3 --set "fem.h_rim=1.2 mm" --set "fem.h_orifice=3.3 mm" --set "fem.h_wall=24 mm" # coarse: hours otherwise
fi
/usr/bin/python3 "$here/table.py" "$out" "$here/reference.json"
