#!/usr/bin/env bash
# Draws closures.png: two balloons by four closures. docs/images/closures.sh, after ./dev build
set -euo pipefail
cd "$(dirname "$0")/../.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for balloon in orifice-10mm channel-10mm; do
  for closure in theoretical corrected potential profile; do
    build/release/bin/turgor run "cases/$balloon.toml" --set model.name=full --set 'expect={}' --set "model.closure=$closure" \
      $([ "$closure" = profile ] && echo --set model.profile=profile-orifice.csv) -o "$folder/$balloon-$closure" \
      --no-pictures --quiet
  done
done
gnuplot <<EOF
set terminal pngcairo size 1600,800 font 'Helvetica,15' fontscale 1.7 linewidth 2 rounded enhanced
set output 'docs/images/closures.png'
set datafile separator ','
set border 31 lw 0.8; set tics nomirror; set grid lw 0.5 lc rgb 'grey85'
set multiplot layout 1,2
set xlabel 't [s]'; set ylabel 'stretch R = r/r_0 [1]' offset 1; set key top right samplen 2 font ',12'
f(b,c) = sprintf('$folder/%s-%s/trajectory.csv', b, c)
do for [b in 'orifice-10mm channel-10mm'] {
  set yrange [0.98:(b eq 'orifice-10mm' ? 1.24 : 1.40)]
  set title (b eq 'orifice-10mm' ? '1 cm orifice' : '1 cm channel, 50 cm long')
  plot f(b,'theoretical') using 1:2 skip 1 with lines lw 2 dt '_. ' lc rgb '#009E73' title '(2.12) theoretical', \
       f(b,'corrected') using 1:2 skip 1 with lines lw 2 dt '-' lc rgb '#E69F00' title '(2.15) corrected', \
       f(b,'potential') using 1:2 skip 1 with lines lw 2 lc rgb '#D55E00' title '(2.8) potential', \
       f(b,'profile') using 1:2 skip 1 with lines lw 2 dt '. ' lc rgb 'black' title '(2.8) profile'
}
unset multiplot
EOF
