#!/usr/bin/env bash
# Deflation from rest against potential flow: run.sh OUTPUT_FOLDER [--record]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
out=$1
mkdir -p "$out"
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1

# flow NAME MM MESH OPTION...: orifice radius in mm, cell sizes over the default ones
flow() {
  local name=$1 mm=$2 mesh=$3
  shift 3
  sed '/^samples/d' "$root/cases/motion-orifice-${mm}mm.toml" >"$out/$name.toml"
  "$root/build/release/bin/turgor" fem flow "$out/$name.toml" -o "$out/$name" --force -q --set fem.fields=0 \
    --set "fem.h_rim=$(bc -l <<<"$mm/60*$mesh") mm" --set "fem.h_orifice=$(bc -l <<<"$mm/15*$mesh") mm" \
    --set "fem.h_wall=$(bc -l <<<"8*$mesh") mm" "$@"
}

"$root/build/release/bin/flow-studies" potential-limit >"$out/errors.csv"
for mm in 5 10 20 30; do
  for mesh in 2 1; do # the instant after rest, almost without viscosity
    flow "rest-$mm-$mesh" $mm $mesh --set 'motion.velocity=[{to="-2 mm/s",over="1000 s"}]' --set 'fluid.viscosity=1e-12 Pa s' \
      --set solve.samples=3 --set 'solve.t_end=2 ms' --set 'fem.time_step=1 ms'
  done
  # to a constant rate, in times that follow the orifice's volume
  read -r rise end <<<"$(awk -v a=$mm 'BEGIN { t = 0.1 * (a >= 20 ? 1 : (a / 20) ^ 3); print t, 2 * t }')"
  flow "jet-$mm" $mm 2 --set "motion.velocity=[{to=\"-2 cm/s\",over=\"$rise s\",shape=\"smooth\"},{hold=\"$end s\"}]" \
    --set fem.cfl=1 --set solve.samples=21 --set "solve.t_end=$end s"
done
/usr/bin/python3 "$here/measure.py" "$out" >>"$out/errors.csv"
/usr/bin/python3 "$here/../check.py" "$out" "$here/reference.json" "${@:2}"
