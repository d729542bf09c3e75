#!/usr/bin/env bash
# Volume and energy of a short deflation and a short inflation, and runs that were stopped: run.sh OUTPUT_FOLDER [--record]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
out=$1
mkdir -p "$out"
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
sed '/^samples/d' "$root/cases/motion-orifice-30mm.toml" >"$out/case.toml"

# flow NAME MOTION MESH STEP OPTION...: cell sizes over the default ones, time step in ms
flow() {
  local name=$1 motion=$2 mesh=$3 step=$4 rate=-2 end=0.15
  shift 4
  if [ "$motion" = inflation ]; then rate=2 end=0.06; fi
  "$root/build/release/bin/turgor" fem flow "$out/case.toml" -o "$out/$name" -q --no-pictures \
    --set "motion.velocity=[{to=\"$rate cm/s\",over=\"0.1 s\",shape=\"smooth\"},{hold=\"0.05 s\"}]" \
    --set "solve.t_end=$end s" --set solve.samples=4 --set fem.fields=1 --set fem.tolerance=1e-5 \
    --set "fem.h_rim=$(bc -l <<<"0.5*$mesh") mm" --set "fem.h_orifice=$(bc -l <<<"2*$mesh") mm" \
    --set "fem.h_wall=$(bc -l <<<"8*$mesh") mm" --set "fem.time_step=$step ms" "$@"
}

for motion in deflation inflation; do
  for mesh in 4 2 1; do flow $motion-mesh$mesh-step1 $motion $mesh 1 --force; done
done
for step in 4 2 0.5; do flow deflation-mesh2-step$step deflation 2 $step --force; done
for step in 0.5 0.25; do flow inflation-mesh2-step$step inflation 2 $step --force; done

"$root/build/release/bin/flow-studies" balances >"$out/errors.csv"

# A checkpoint after every step; then a run that stops itself after a second, and one that is killed when 40 rows are there.
stopped=(inflation 2 0.5 --set fem.checkpoint_every=0s)
flow whole "${stopped[@]}" --force
flow interrupted "${stopped[@]}" --force --max-wall-time 1 && echo "the run was not interrupted" >&2 && exit 1
flow interrupted "${stopped[@]}" --resume
rm -rf "$out/killed"
flow killed "${stopped[@]}" &
run=$!
until [ -e "$out/killed/solver.csv" ] && [ "$(wc -l <"$out/killed/solver.csv")" -gt 40 ]; do sleep 0.02; done
kill -9 "$(pgrep -P $run || echo $run)"
wait $run && echo "the run was not killed" >&2 && exit 1
flow killed "${stopped[@]}" --resume
/usr/bin/python3 "$here/measure.py" "$out" >>"$out/errors.csv"
/usr/bin/python3 "$here/../check.py" "$out" "$here/reference.json" "${@:2}"
