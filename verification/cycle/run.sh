#!/usr/bin/env bash
# Full cycles of inflation, rest and deflation, through orifices and channels, on several meshes and with several time steps:
# run.sh OUTPUT_FOLDER. QUICK=1: one of them. Runs that are complete are not repeated.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
out=$1
mkdir -p "$out"
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1

# cycle KIND MM MESH CFL: orifice or channel, its radius in mm, cell sizes over the default ones, fem.cfl
cycle() {
  local kind=$1 mm=$2 mesh=$3 cfl=$4 name="$1-$2mm-mesh$3-cfl$4" rim orifice wall
  [ -e "$out/$name/run.json" ] && grep -q '"complete"' "$out/$name/run.json" && return
  echo "== $name"
  read -r rim orifice wall <<<"$(awk -v a="$mm" -v n="$mesh" 'BEGIN { print a / 60 * n, a / 15 * n, 8 * n }')"
  "${TURGOR:-$root/build/release/bin/turgor}" fem flow "$root/cases/motion-$kind-${mm}mm.toml" -o "$out/$name" --force -q \
    --set "fem.h_rim=$rim mm" --set "fem.h_orifice=$orifice mm" --set "fem.h_wall=$wall mm" \
    --set "fem.cfl=$cfl" --set solve.samples=241 --set fem.fields=0 || echo "FAILED: $name"
}

cycle orifice 30 1.3 1
if [ -z "${QUICK:-}" ]; then
  for mm in 20 10 5; do cycle orifice "$mm" 1.3 1; done
  for mm in 30 20 10 5; do cycle channel "$mm" 2 1; done
  for mm in 30 20 10 5; do cycle channel "$mm" 3 1; done
  cycle channel 20 2 0.5
  cycle orifice 30 2 1
  cycle orifice 30 1.3 0.5
  cycle orifice 20 2 1
  cycle orifice 20 1.3 0.5
fi
/usr/bin/python3 "$here/table.py" "$out" "$here/reference.json"
