"""Errors of a study against what they must be, and their picture: check.py FOLDER REFERENCE.json [--record].

FOLDER/errors.csv has rows panel,quantity,x,value. REFERENCE.json has, for every panel and quantity, what is asked of it:
  order, within   slope of log value over log x between the last two rows (the finest), and what it may be off
  exact, within   what every value must be, and what it may be off
  at_most         of every value
  falls           values fall from row to row
  values          as recorded, each to be met to the relative `tolerance`
--record puts the values that were found into REFERENCE.json, where there is a tolerance, and the picture beside it.
"""

import csv
import json
import math
import pathlib
import shutil
import subprocess
import sys

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")


def read(path):
    """{panel: {quantity: {x: value}}}, in the order of the file."""
    found = {}
    with open(path) as file:
        for row in csv.DictReader(file):
            series = found.setdefault(row["panel"], {}).setdefault(row["quantity"], {})
            series[row["x"]] = float(row["value"])
    return found


def order(series):
    """Observed orders between neighbouring rows."""
    points = [(float(x), value) for x, value in series.items()]
    return [math.log(v / w) / math.log(x / y) if v > 0 and w > 0 else math.nan for (x, v), (y, w) in zip(points, points[1:])]


def faults(series, asked):
    """In words, what is not as asked."""
    if not series:
        yield "is missing"
        return
    if not all(math.isfinite(value) for value in series.values()):
        yield "is not finite"
        return
    if "order" in asked and not abs(order(series)[-1] - asked["order"]) <= asked["within"]:
        yield f"has order {order(series)[-1]:.2f}, not {asked['order']} within {asked['within']}"
    if "exact" in asked:
        off = max(abs(value - asked["exact"]) for value in series.values())
        if not off <= asked["within"]:
            yield f"is off {asked['exact']} by {off:.3g}, more than {asked['within']}"
    if "at_most" in asked and not max(series.values()) <= asked["at_most"]:
        yield f"is {max(series.values()):.3g}, above {asked['at_most']}"
    if asked.get("falls") and any(w >= v for v, w in zip(series.values(), list(series.values())[1:])):
        yield "does not fall"
    if "tolerance" in asked:
        was = asked.get("values", {})
        if was.keys() != series.keys():
            yield f"has other rows than recorded: {', '.join(sorted(was.keys() ^ series.keys()))}"
        for x in was.keys() & series.keys():
            if not abs(series[x] - was[x]) <= asked["tolerance"] * abs(was[x]):
                yield f"is {series[x]:.6g} at {x}, recorded as {was[x]:.6g}"


def plot(panel, quantities, asked):
    """Commands of gnuplot for a panel: values as points, orders and exact values as lines."""
    shown = {name: series for name, series in quantities.items() if name in asked["quantities"]}
    logarithmic = asked.get("scale", "log") == "log"
    commands = f"set title '{panel}'; set xlabel '{asked['x']}'; set ylabel '{asked['y']}'\n"
    places = [float(x) for series in shown.values() for x in series]
    left, right = (min(places) / 1.5, max(places) * 1.5) if logarithmic else (0, max(places) * 1.1)
    commands += f"unset logscale; set xrange [{left}:{right}]; set yrange [*:*]\n"
    commands += "set logscale xy; set format y '10^{%L}'; set format x '%g'\n" if logarithmic else "set format '%g'\n"
    commands += f"set yrange [{asked['yrange']}]\n" if "yrange" in asked else ""
    curves = []
    for i, (name, series) in enumerate(shown.items()):
        points = [(x, value) for x, value in series.items() if value > 0 or not logarithmic]
        if not points:
            continue
        commands += f"$S{i} << E\n" + "\n".join(f"{x} {value!r}" for x, value in points) + "\nE\n"
        title = name
        if "order" in asked["quantities"][name]:
            slope = asked["quantities"][name]["order"]
            (x0, _), (x, value) = points[0], points[-1]
            commands += f"$L{i} << E\n{x} {value!r}\n{x0} {value * (float(x0) / float(x)) ** slope!r}\nE\n"
            curves.append(f"$L{i} with lines dt '-' lw 1.5 lc rgb '{COLOURS[i]}' notitle")
            title += f", order {order(series)[-1]:.2f}"
        curves.append(f"$S{i} using 1:2 with points pt {(7, 5, 9, 11, 13, 4)[i]} ps 1.6 lc rgb '{COLOURS[i]}' title '{title}'")
    for value in {rule["exact"] for rule in asked["quantities"].values() if "exact" in rule}:
        curves.append(f"{value} with lines dt '-' lw 1.5 lc rgb 'black' title 'exact'")
    return commands + "plot " + ", \\\n  ".join(curves) + "\n"


def draw(found, panels, picture):
    pictured = [name for name, asked in panels.items() if "x" in asked and name in found]
    commands = f"""set terminal pngcairo size {720 * len(pictured)},760 font 'Helvetica,14' fontscale 1.4 enhanced
set output '{picture}'
set border 31 lw 0.8; set tics nomirror; set grid lw 0.5 lc rgb 'grey85'; set samples 200
set key bottom right samplen 1 font ',11'
set multiplot layout 1,{len(pictured)}
"""
    commands += "".join(plot(name, found[name], panels[name]) for name in pictured) + "unset multiplot\n"
    subprocess.run(["gnuplot"], input=commands, text=True, check=True)


def main():
    folder, reference = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    record = "--record" in sys.argv
    found = read(folder / "errors.csv")
    recorded = json.loads(reference.read_text())
    panels = recorded["panels"]
    wrong = 0
    print("| panel | quantity | values | orders | |\n|---|---|---|---|---|")
    for panel, quantity in dict.fromkeys(
        [(p, q) for p, asked in panels.items() for q in asked["quantities"]] + [(p, q) for p in found for q in found[p]]
    ):
        asked = panels.get(panel, {}).get("quantities", {}).get(quantity)
        series = found.get(panel, {}).get(quantity, {})
        if record and asked and "tolerance" in asked:
            asked["values"] = {x: float(f"{value:.6g}") for x, value in series.items()}
        said = list(faults(series, asked)) if asked else ["nothing is asked of it"]
        wrong += len(said)
        orders = " ".join(f"{o:.2f}" for o in order(series)) if asked and "order" in asked else ""
        print(f"| {panel} | {quantity} | {' '.join(f'{v:.4g}' for v in series.values())} | {orders} | {'; '.join(said) or 'ok'} |")
    draw(found, panels, folder / "errors.png")
    if record:
        reference.write_text(json.dumps(recorded, indent=1) + "\n")
        shutil.copy(folder / "errors.png", reference.parent / "errors.png")
    sys.exit(1 if wrong else 0)


main()
