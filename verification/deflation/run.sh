#!/usr/bin/env bash
# Deflation from rest on three meshes and with three time steps: run.sh OUTPUT_FOLDER. QUICK=1: the coarse mesh only.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
out=$1
mkdir -p "$out"
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1

# deflate MM MESH CFL [VISCOSITY]: orifice radius in mm, cell sizes over the default ones, fem.cfl, viscosity over water's
deflate() {
  local mm=$1 mesh=$2 cfl=$3 thick=${4:-1} name="orifice-$1mm-mesh$2-cfl$3${4:+-viscosity$4}"
  [ -e "$out/$name/run.json" ] && grep -q '"complete"' "$out/$name/run.json" && return
  echo "== $name"
  # the motion of the shipped case up to the end of the stretch at constant rate, the other way round
  local keys
  keys=$(awk -v mm="$mm" -v mesh="$mesh" 'BEGIN {
    rise = mm == 30 ? 0.5 : 0.1 * (mm >= 20 ? 1 : (mm / 20) ^ 3); hold = mm == 30 ? 1 : rise
    printf "motion.velocity=[{to=\"-2 cm/s\",over=\"%.9g s\",shape=\"smooth\"},{hold=\"%.9g s\"}]\n", rise, hold
    printf "solve.t_end=\"%.9g s\"\nsolve.times=[", rise + hold
    for (i = 0; i <= 10; i++) printf "%s\"%.9g s\"", i ? "," : "", rise + hold * i / 10
    printf "]\nfem.h_rim=\"%.9g mm\"\nfem.h_orifice=\"%.9g mm\"\nfem.h_wall=\"%.9g mm\"\n", mm / 60 * mesh, mm / 15 * mesh, 8 * mesh }')
  local set=()
  while read -r key; do set+=(--set "$key"); done <<<"$keys"
  sed '/^samples/d' "$root/cases/motion-orifice-${mm}mm.toml" >"$out/$name.toml"
  "${TURGOR:-$root/build/release/bin/turgor}" fem flow "$out/$name.toml" -o "$out/$name" --force -q "${set[@]}" \
    --set "fem.cfl=$cfl" --set fem.fields=0 --set "fluid.viscosity=$(awk -v n="$thick" 'BEGIN { print 8.94e-4 * n }') Pa s"
}

orifices=(30 20 10 5)
for mm in "${orifices[@]}"; do deflate "$mm" 2 1; done
if [ -z "${QUICK:-}" ]; then
  for mm in "${orifices[@]}"; do
    deflate "$mm" 1 1
    deflate "$mm" 1 0.5
    deflate "$mm" 1 0.25
    deflate "$mm" 0.5 1
  done
  for thick in 0.1 10 100 1000; do deflate 20 2 1 "$thick"; done
fi
/usr/bin/python3 "$here/table.py" "$out" "$here/reference.json"
