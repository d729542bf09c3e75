#!/usr/bin/python3
"""Prints the rows of data.csv for complete run directories of `turgor fem flow`: measure.py DIR...

A run at a constant radial velocity gives K = F r_ch^4/(rho r^6 (dr/dt)^2), the mean over its rows with dr/dt constant, without the
channel's own centripetal term; one with a constant acceleration gives I = -F r_ch/(rho r^4 d2r/dt2) in its last row.
"""
import json
import math
import pathlib
import sys
import tomllib

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent))
import tables


def measure(folder):
    report = json.loads((folder / "run.json").read_text())
    if report["status"] != "complete":
        return
    case = tomllib.loads((folder / "resolved.toml").read_text())
    number = lambda table, key: float(case[table][key].split()[0])
    orifice, channel, density = number("inlet", "orifice_radius"), number("inlet", "channel_length"), number("fluid", "density")
    rows = tables.rows(folder / "history.csv")
    if rows[-1]["d2rdt2"] != 0:
        last = rows[-1]
        kappa = orifice / last["r"]
        values = [tables.inertial(last, orifice, density)]
        kind, step = "inertial", "1 ms"
    else:
        rows = [row for row in rows if row["d2rdt2"] == 0 and row["drdt"] == rows[-1]["drdt"]]
        kappa = sum(orifice / row["r"] for row in rows) / len(rows)
        values = []
        for row in rows:
            k = orifice / row["r"]
            rho = math.sqrt(1 - k * k)
            h4 = (1 + rho) ** 3 * (rho * rho + 2 * rho - 1) / (16 * rho**3)
            own = 32 * math.pi * h4 * channel / row["r"] * k**2
            values.append(tables.centripetal(row, orifice, density) + own)
        kind, step = "centripetal", f'cfl {case["fem"]["cfl"]:g}'
    refinement = 0.008 / report["discretisation"]["h_wall_m"]
    mean = sum(values) / len(values)
    print(f"{kind},{orifice * 1e3:g},{channel * 1e3:g},{kappa:.6f},{mean:.4f},{min(values):.4f},{max(values):.4f},"
          f'{refinement:g},{step},{report["discretisation"]["unknowns"]}')


print("coefficient,orifice_mm,channel_mm,kappa,value,least,greatest,refinement,step,unknowns")
for name in sys.argv[1:]:
    measure(pathlib.Path(name))
