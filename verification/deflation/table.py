"""Force coefficients of the runs in a folder, beside those that were recorded: table.py FOLDER REFERENCE.json [--record]."""

import csv
import json
import pathlib
import re
import sys

SI = {"m": 1, "cm": 1e-2, "mm": 1e-3, "m/s": 1, "cm/s": 1e-2, "mm/s": 1e-3, "mm/ms": 1, "cm/ms": 10, "N": 1}


def column(row, name):
    """The value of a column "name [unit]" in SI units."""
    key = next(k for k in row if k.startswith(name + " ["))
    return float(row[key]) * SI[key[len(name) + 2 : -1]]


def coefficient(run, radius):
    """K = F r_ch^4 / (rho r^6 rdot^2) over the stretch at constant rate: mean, least, greatest."""
    with open(run / "history.csv") as file:
        rows = list(csv.DictReader(file))
    ks = [column(r, "force") * radius**4 / (1000 * column(r, "drdt") ** 2 * column(r, "r") ** 6) for r in rows[1:]]
    return sum(ks) / len(ks), min(ks), max(ks)


def main():
    folder, reference = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    recorded = json.loads(reference.read_text()) if reference.exists() else {"tolerance": 1e-3, "runs": {}}
    found, failed = {}, 0
    print("| orifice | mesh | cfl | viscosity/water's | unknowns | steps | K | over the stretch | (2.12)/K - 1 | (2.15)/K - 1 | recorded |")
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    for run in sorted(p for p in folder.iterdir() if (p / "run.json").exists()):
        mm, mesh, cfl, thick = re.fullmatch(r"orifice-(\d+)mm-mesh([\d.]+)-cfl([\d.]+?)(?:-viscosity([\d.]+))?", run.name).groups()
        report = json.loads((run / "run.json").read_text())
        if report["status"] != "complete":
            continue
        k, least, most = coefficient(run, int(mm) / 1000)
        found[run.name] = {"K": round(k, 4), "unknowns": report["discretisation"]["unknowns"], "steps": report["steps"]}
        was = recorded["runs"].get(run.name, {}).get("K")
        off = was is not None and abs(k / was - 1) > recorded["tolerance"]
        failed += off
        print(
            f"| {mm} mm | {mesh} | {cfl} | {thick or 1} | {found[run.name]['unknowns']} | {report['steps']} | {k:.3f} | {least:.3f} ... {most:.3f} "
            f"| {100 * (96 / k - 1):.1f} % | {100 * (150 / k - 1):.1f} % | {was}{' OFF' if off else ''} |"
        )
    if "--record" in sys.argv:
        recorded["runs"].update(found)
        reference.write_text(json.dumps(recorded, indent=1) + "\n")
    sys.exit(1 if failed else 0)


main()
