"""Force coefficients of the runs in a folder, beside those that were recorded: table.py FOLDER REFERENCE.json [--record]."""

import json
import pathlib
import re
import shutil
import statistics
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent))
import tables


def coefficients(run, a):
    """Mean r_ch/r, and K, over the stretch at constant rate."""
    rows = tables.rows(run / "history.csv")[1:]
    return statistics.fmean(a / row["r"] for row in rows), [tables.centripetal(row, a) for row in rows]


def draw(points, picture):
    """K over r_ch/r by mesh; points: {mesh: [(r_ch/r, K)]} with water and cfl 1."""
    commands = f"""set terminal pngcairo size 1100,760 font 'Helvetica,14' fontscale 1.4 enhanced
set output '{picture}'
set border 31 lw 0.8; set tics nomirror; set grid lw 0.5 lc rgb 'grey85'
set xlabel 'r_{{ch}}/r'; set ylabel 'K = F r_{{ch}}^4/{{/Symbol r}} r^6 (dr/dt)^2'; set xrange [0:0.12]; set yrange [90:180]
set key right center samplen 2
"""
    curves = ["96 with lines dt '-.' lw 2 lc rgb '#009E73' title '(2.12)'", "150 with lines dt '-' lw 2 lc rgb '#E69F00' title '(2.15)'"]
    looks = {"2": (7, "#56B4E9"), "1": (5, "#0072B2"), "0.5": (9, "black")}
    for mesh, (shape, colour) in looks.items():
        if mesh not in points:
            continue
        commands += f"$M{mesh.replace('.', '')} << E\n" + "".join(f"{x} {k}\n" for x, k in sorted(points[mesh])) + "E\n"
        curves.append(f"$M{mesh.replace('.', '')} with points pt {shape} ps 1.6 lc rgb '{colour}' title 'cells {mesh} times the default'")
    subprocess.run(["gnuplot"], input=commands + "plot " + ", ".join(curves) + "\n", text=True, check=True)


def main():
    folder, reference = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    recorded = json.loads(reference.read_text()) if reference.exists() else {"tolerance": 1e-3, "runs": {}}
    found, points, failed = {}, {}, 0
    print("| orifice | mesh | cfl | viscosity/water's | unknowns | steps | K | over the stretch | (2.12)/K - 1 | (2.15)/K - 1 | recorded |")
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    for run in sorted(p for p in folder.iterdir() if (p / "run.json").exists()):
        mm, mesh, cfl, thick = re.fullmatch(r"orifice-(\d+)mm-mesh([\d.]+)-cfl([\d.]+?)(?:-viscosity([\d.]+))?", run.name).groups()
        report = json.loads((run / "run.json").read_text())
        if report["status"] != "complete":
            continue
        kappa, ks = coefficients(run, int(mm) / 1000)
        k, least, most = statistics.fmean(ks), min(ks), max(ks)
        if cfl == "1" and not thick:
            points.setdefault(mesh, []).append((kappa, k))
        found[run.name] = {"K": round(k, 4), "unknowns": report["discretisation"]["unknowns"], "steps": report["steps"]}
        was = recorded["runs"].get(run.name, {}).get("K")
        off = was is not None and abs(k / was - 1) > recorded["tolerance"]
        failed += off
        print(
            f"| {mm} mm | {mesh} | {cfl} | {thick or 1} | {found[run.name]['unknowns']} | {report['steps']} | {k:.3f} | {least:.3f} ... {most:.3f} "
            f"| {100 * (96 / k - 1):.1f} % | {100 * (150 / k - 1):.1f} % | {was}{' OFF' if off else ''} |"
        )
    draw(points, folder / "coefficients.png")
    if "--record" in sys.argv:
        shutil.copy(folder / "coefficients.png", reference.parent / "coefficients.png")
        recorded["runs"].update(found)
        reference.write_text(json.dumps(recorded, indent=1) + "\n")
    sys.exit(1 if failed else 0)


main()
