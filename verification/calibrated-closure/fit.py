#!/usr/bin/python3
"""Fits h5 of the calibrated closure to data.csv, prints the constants of src/closure/calibration.cpp and the errors of the fits,
and draws fit.png by gnuplot. Without a channel h5 is a line in kappa through the finest mesh and shortest step of each orifice,
with one it is the mean."""
import csv
import math
import pathlib
import statistics
import subprocess

folder = pathlib.Path(__file__).parent
with open(folder / "data.csv") as file:
    rows = list(csv.DictReader(file))


def column(rows, name):
    return [float(row[name]) for row in rows]


def select(coefficient, channel):
    return [r for r in rows if r["coefficient"] == coefficient and (float(r["channel_mm"]) > 0) == channel]


def finest(rows):
    """The finest mesh of each orifice, and of its runs that with the shortest step."""
    best = {}
    for row in rows:
        order = (float(row["refinement"]), -float(row["step"].split()[-1]) if row["step"].startswith("cfl") else 0)
        if row["orifice_mm"] not in best or order > best[row["orifice_mm"]][0]:
            best[row["orifice_mm"]] = (order, row)
    return [row for _, row in best.values()]


def report(name, rows, fit):
    """Greatest error over some rows, of their means and of each instant, in per cent."""
    error = lambda key: 100 * max(abs(fit(float(row["kappa"])) / float(row[key]) - 1) for row in rows)
    print(f"{name}: {error('value'):.2f} % of the means, {max(error('least'), error('greatest')):.2f} % of any instant")


unit = 32 * math.pi
inertia = lambda kappa: 4 * math.pi**2 - 4 * math.pi * kappa * math.log(2 * kappa)
used = finest(select("centripetal", False))
line = statistics.linear_regression(column(used, "kappa"), column(used, "value"))
at_zero, slope = round(line.intercept / unit, 4), round(line.slope / unit, 4)
channel = finest(select("centripetal", True))
mean = round(statistics.mean(column(channel, "value")) / unit, 4)
print(f"orifice_at_zero = {at_zero}\norifice_slope = {slope}\nchannel_mean = {mean}")

jet = lambda kappa: unit * (at_zero + slope * kappa)
piped = lambda kappa: unit * mean
report("inertial, no channel, finest mesh", finest(select("inertial", False)), inertia)
report("inertial, no channel, all meshes", select("inertial", False), inertia)
report("centripetal, no channel, used", used, jet)
report("centripetal, no channel, all", select("centripetal", False), jet)
report("centripetal, channel, all", select("centripetal", True), piped)
report("(2.15) inertial", finest(select("inertial", False)), lambda kappa: 223 / 4)
report("(2.15) centripetal, no channel", used, lambda kappa: 150)
report("(2.15) centripetal, channel", select("centripetal", True), lambda kappa: 150)


def points(name, rows):
    lines = [f"{r['kappa']} {r['value']} {r['least']} {r['greatest']}" for r in rows]
    return f"${name} << E\n" + "\n".join(lines) + "\nE\n"


def meshes(rows, refinement):
    return [row for row in rows if float(row["refinement"]) == refinement]


commands = "".join(
    points(f"{name}{i}", chosen)
    for name, of in (("I", select("inertial", False)), ("K", select("centripetal", False)))
    for i, refinement in enumerate((0.5, 1, 2))
    if (chosen := meshes(of, refinement))
)
marks = ((6, "#999999", "half as fine"), (4, "#0072B2", "default mesh"), (7, "#009E73", "twice as fine"))


def series(name, of):
    return ", ".join(
        f"${name}{i} using 1:2 with points pt {mark} ps 1.6 lw 2 lc rgb '{colour}' title '{title}'"
        for i, (mark, colour, title) in enumerate(marks)
        if meshes(of, (0.5, 1, 2)[i])
    )


commands += points("C", select("centripetal", True))
commands += f"""set terminal pngcairo size 1700,800 font 'Helvetica,14' fontscale 1.5 rounded enhanced
set output '{folder / "fit.png"}'
set border 31 lw 0.8; set tics nomirror; set grid lw 0.5 lc rgb 'grey85'; set samples 400; set key samplen 2 font ',11'
set xrange [0:0.12]; set xlabel 'kappa = r_{{ch}}/r [1]'
set multiplot layout 1,2
set title 'inertia'; set yrange [38:60]; set ylabel '-F r_{{ch}}/(rho r^4 d^2r/dt^2) [1]'; set key top right
plot 55.75 with lines lw 2 dt '-' lc rgb '#E69F00' title '(2.15)', 50.91 with lines lw 2 dt '_. ' lc rgb 'black' title '(2.12)', \\
  4*pi**2 - 4*pi*x*log(2*x) with lines lw 2 lc rgb '#D55E00' title 'fit', {series("I", select("inertial", False))}
set title 'jet'; set yrange [90:240]; set ylabel 'F r_{{ch}}^4/(rho r^6 (dr/dt)^2) [1]'; set key top right maxrows 5
plot 150 with lines lw 2 dt '-' lc rgb '#E69F00' title '(2.15)', 96 with lines lw 2 dt '_. ' lc rgb 'black' title '(2.12)', \\
  {unit}*({at_zero} + {slope}*x) with lines lw 2 lc rgb '#D55E00' title 'fit', \\
  {unit * mean} with lines lw 2 dt '. ' lc rgb '#CC79A7' title 'fit, channel', {series("K", select("centripetal", False))}, \\
  $C using 1:2:3:4 with yerrorbars pt 5 ps 1.2 lw 2 lc rgb '#CC79A7' title 'channel, mean and range'
unset multiplot
"""
subprocess.run(["gnuplot"], input=commands, text=True, check=True)
