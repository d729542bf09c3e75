"""Draws cost.png from reference.json by gnuplot: draw.py, after new numbers are recorded there."""

import json
import pathlib
import subprocess

folder = pathlib.Path(__file__).parent
recorded = json.loads((folder / "reference.json").read_text())
data = lambda name: "".join(f"{size} {value}\n" for size, value in recorded[name].items())
subprocess.run(
    ["gnuplot"],
    input=f"""set terminal pngcairo size 1440,760 font 'Helvetica,14' fontscale 1.4 enhanced
set output '{folder / "cost.png"}'
set border 31 lw 0.8; set tics nomirror; set grid lw 0.5 lc rgb 'grey85'; set logscale xy
set xlabel 'unknowns'; set xrange [5e3:5e5]; set format x '10^{{%L}}'; set key top left samplen 1
$T << E
{data("turgor_s_per_step")}E
$F << E
{data("freefem_s_per_step")}E
$M << E
{data("turgor_memory_GB")}E
set multiplot layout 1,2
set ylabel 'time per step [s]'; set yrange [0.01:2]
plot $T with linespoints pt 7 ps 1.6 lc rgb '#0072B2' title 'turgor', $F with points pt 5 ps 1.6 lc rgb '#D55E00' title 'FreeFEM'
set ylabel 'memory [GB]'; set yrange [0.1:3]
plot $M with linespoints pt 7 ps 1.6 lc rgb '#0072B2' title 'turgor', 1.5 with lines dt '-' lc rgb 'black' title '1.5 GB'
unset multiplot
""",
    text=True,
    check=True,
)
