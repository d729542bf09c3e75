"""Rows panel,quantity,x,value for check.py from the runs of run.sh in a folder: measure.py FOLDER."""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent))
import tables

folder = pathlib.Path(sys.argv[1])


def table(run, name):
    return tables.rows(folder / run / name)


def inertia(mm, mesh):
    """Ratio r_ch/r, and -F r_ch/(rho r^4 d2r/dt2) over its expansion to the second term in that ratio."""
    row = table(f"rest-{mm}-{mesh}", "history.csv")[-1]
    a = mm / 1000
    kappa = a / row["r"]
    return kappa, tables.inertial(row, a) / (4 * math.pi**2 + 4 * math.pi * kappa * math.log(1 / (2 * kappa)))


def bernoulli(mm):
    """Ratio r_ch/r, and F r_ch^4/(rho r^6 (dr/dt)^2) over 32 pi f(0)^2, means over the stretch at constant rate."""
    rows = [row for row in table(f"jet-{mm}", "history.csv") if row["d2rdt2"] == 0 and row["drdt"] < 0]
    a = mm / 1000
    jet = [tables.centripetal(row, a) for row in rows]
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
