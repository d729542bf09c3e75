#!/usr/bin/env bash
# Time per step in deflation at constant rate, from 7k to 200k unknowns, and FreeFEM at as many: run.sh OUTPUT_FOLDER.
# Needs FreeFem++-nw (Debian's freefem++) for the comparison, bc and time. QUICK=1: small ones only.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
out=$1
mkdir -p "$out"
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
sed '/^samples/d' "$root/cases/motion-orifice-30mm.toml" >"$out/case.toml"

# step MESH: sizes over the default ones; prints a line of JSON
step() {
  local mesh=$1
  PETSC_OPTIONS="-log_view :$out/petsc-$mesh.log" /usr/bin/time -f %M -o "$out/memory-$mesh.txt" \
    "$root/build/release/bin/turgor" fem flow "$out/case.toml" -o "$out/mesh-$mesh" --force -q \
    --set 'motion.velocity=[{to="-2 cm/s",over="0.1 s",shape="smooth"},{hold="1 s"}]' \
    --set 'solve.times=["0.15 s"]' --set 'solve.t_end="0.15 s"' --set fem.fields=0 \
    --set "fem.h_rim=$(bc -l <<<"0.5*$mesh") mm" --set "fem.h_orifice=$(bc -l <<<"2*$mesh") mm" \
    --set "fem.h_wall=$(bc -l <<<"8*$mesh") mm"
  /usr/bin/python3 "$here/line.py" "$out/mesh-$mesh" "$out/petsc-$mesh.log" "$out/memory-$mesh.txt"
}

meshes=(1.9 1.23 0.63)
[ -n "${QUICK:-}" ] || meshes+=(0.45 0.33)
for mesh in "${meshes[@]}"; do step "$mesh"; done
if command -v FreeFem++-nw >/dev/null; then # in turns, so that a busy machine is as busy for both
  for round in 1 2 3; do
    FreeFem++-nw -v 0 -nw "$here/balloon.edp" 0.945 | grep FreeFEM
    step 1.23
  done
fi
