"""Rows panel,quantity,x,value for check.py from the runs of run.sh in a folder: measure.py FOLDER."""

import csv
import math
import pathlib
import sys

folder = pathlib.Path(sys.argv[1])
DENSITY = 1000
SI = {"cm": 1e-2, "cm/s": 1e-2, "cm/s^2": 1e-2, "cm/ms": 10, "cm/ms^2": 1e4}


def table(run, name):
    """Columns without their units; lengths in m, their rates by seconds."""
    with open(folder / run / name) as file:
        rows = csv.reader(file)
        columns = [(c.split(" [")[0], SI.get(c.split("[")[-1].rstrip("]"), 1)) for c in next(rows)]
        return [{name: float(x) * unit for (name, unit), x in zip(columns, row)} for row in rows]


def inertia(mm, mesh):
    """Ratio r_ch/r, and -F r_ch/(rho r^4 d2r/dt2) over its expansion to the second term in that ratio."""
    row = table(f"rest-{mm}-{mesh}", "history.csv")[-1]
    a = mm / 1000
    kappa = a / row["r"]
    found = -row["force"] * a / (DENSITY * row["r"] ** 4 * row["d2rdt2"])
    return kappa, found / (4 * math.pi**2 + 4 * math.pi * kappa * math.log(1 / (2 * kappa)))


def bernoulli(mm):
    """Ratio r_ch/r, and F r_ch^4/(rho r^6 (dr/dt)^2) over 32 pi f(0)^2, means over the stretch at constant rate."""
    rows = [row for row in table(f"jet-{mm}", "history.csv") if row["d2rdt2"] == 0 and row["drdt"] < 0]
    a = mm / 1000
    jet = [row["force"] * a**4 / (DENSITY * row["r"] ** 6 * row["drdt"] ** 2) for row in rows]
    centre = table(f"jet-{mm}", "profile.csv")[0]
    value = centre[next(name for name in centre if name.startswith("f"))]
    kappa = sum(a / row["r"] for row in rows) / len(rows)
    return kappa, sum(jet) / len(jet) / (32 * math.pi * value**2)


for mm in (5, 10, 20, 30):
    kappa, coarse = inertia(mm, 2)
    _, fine = inertia(mm, 1)
    print(f"inertia,mesh 2,{kappa:.4f},{coarse}")
    print(f"inertia,mesh 1,{kappa:.4f},{fine}")
    print(f"inertia,extrapolated,{kappa:.4f},{2 * fine - coarse}")
points = [bernoulli(mm) for mm in (5, 10, 20, 30)]
for kappa, value in points:
    print(f"Bernoulli,K/32 pi f(0)^2,{kappa:.4f},{value}")
(x, v), (y, w) = points[:2]
print(f"Bernoulli,towards a small orifice,0,{v - x * (w - v) / (y - x)}")
