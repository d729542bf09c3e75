"""Forces, balances and cost of the full cycles in a folder, beside what was recorded: table.py FOLDER REFERENCE.json [--record]."""

import json
import math
import pathlib
import re
import statistics
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent))
import tables


def measure(run, a):
    rows = tables.rows(run / "history.csv")
    top = max(row["drdt"] for row in rows)
    steady = lambda sign: [row for row in rows if abs(row["drdt"] - sign * top) < 1e-9 * top]
    k = [tables.centripetal(row, a) for row in steady(-1)]
    deflating = math.sqrt(statistics.fmean(row["force"] ** 2 for row in steady(-1)))
    inflating = [row["force"] / deflating for row in steady(1)]
    # where it moves at all: at a hundredth of the greatest rate
    flux = [abs(row["flow_rate"] / tables.volume_rate(row, a) - 1) for row in rows if abs(row["drdt"]) > 0.01 * top]
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
        "volume error": float(f"{max(abs(row['volume_error']) for row in tables.rows(run / 'solver.csv')):.1e}"),
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
