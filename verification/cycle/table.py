"""Forces, balances and cost of the full cycles in a folder, beside what was recorded: table.py FOLDER REFERENCE.json [--record]."""

import csv
import json
import math
import pathlib
import re
import statistics
import sys

SI = {"m": 1, "cm": 1e-2, "m/s": 1, "cm/s": 1e-2, "cm/ms": 10, "N": 1, "m^3": 1, "m^3/s": 1, "L": 1e-3, "L/s": 1e-3, "s": 1, "ms": 1e-3}


def column(rows, name):
    """The values of a column "name [unit]" in SI units."""
    key = next(k for k in rows[0] if k.startswith(name + " ["))
    return [float(row[key]) * SI.get(key[len(name) + 2 : -1], 1) for row in rows]


def table(path):
    with open(path) as file:
        return list(csv.DictReader(file))


def sphere_rate(r, rate, a):
    """Rate of the volume of a sphere that is cut off at its rim."""
    centre = math.sqrt(r * r - a * a)
    height, growth = r + centre, 1 + r / centre
    return math.pi * (2 * height * growth * (3 * r - height) + height * height * (3 - growth)) / 3 * rate


def measure(run, a):
    rows = table(run / "history.csv")
    radius, rate, force, flow = (column(rows, n) for n in ("r", "drdt", "force", "flow_rate"))
    top = max(rate)
    steady = lambda sign: [i for i in range(len(rows)) if abs(rate[i] - sign * top) < 1e-9 * top]
    k = [force[i] * a**4 / (1000 * rate[i] ** 2 * radius[i] ** 6) for i in steady(-1)]
    deflating = math.sqrt(statistics.fmean(force[i] ** 2 for i in steady(-1)))
    inflating = [force[i] / deflating for i in steady(1)]
    # where it moves at all: a hundredth of the greatest rate
    flux = [abs(flow[i] / sphere_rate(radius[i], rate[i], a) - 1) for i in range(len(rows)) if abs(rate[i]) > 0.01 * top]
    report = json.loads((run / "run.json").read_text())
    return {
        "unknowns": report["discretisation"]["unknowns"],
        "steps": report["steps"],
        "seconds": round(report["timings"]["integration_s"], 1),
        "K": round(statistics.fmean(k), 2),
        "K least": round(min(k), 2),
        "K greatest": round(max(k), 2),
        "inflation mean %": round(100 * statistics.fmean(inflating), 2),
        "inflation deviation %": round(100 * statistics.pstdev(inflating), 2),
        "flux error": float(f"{max(flux):.1e}"),
        "volume error": float(f"{max(abs(v) for v in column(table(run / 'solver.csv'), 'volume_error')):.1e}"),
    }


def main():
    folder, reference = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    recorded = json.loads(reference.read_text()) if reference.exists() else {"tolerance": 0.03, "runs": {}}
    found, failed = {}, 0
    for run in sorted(p for p in folder.iterdir() if (p / "run.json").exists()):
        if json.loads((run / "run.json").read_text())["status"] != "complete":
            print(f"{run.name}: not complete")
            failed += 1
            continue
        mm = int(re.match(r"(?:orifice|channel)-(\d+)mm", run.name).group(1))
        found[run.name] = measure(run, mm / 1000)
    if not found:
        sys.exit("no complete run")
    names = list(next(iter(found.values())))
    print("| run | " + " | ".join(names) + " | |\n" + "|---" * (len(names) + 2) + "|")
    for name, values in found.items():
        was = recorded["runs"].get(name)
        off = was is not None and abs(values["K"] / was["K"] - 1) > recorded["tolerance"]
        off = off or values["flux error"] > 1e-6 or values["volume error"] > 1e-4
        failed += off
        print(f"| {name} | " + " | ".join(str(v) for v in values.values()) + f" | {'OFF' if off else 'ok' if was else 'new'} |")
    if "--record" in sys.argv:
        recorded["runs"].update(found)
        reference.write_text(json.dumps(recorded, indent=1) + "\n")
    sys.exit(1 if failed else 0)


main()
