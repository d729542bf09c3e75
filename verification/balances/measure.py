"""Rows panel,quantity,x,value for check.py from the runs of run.sh in a folder: measure.py FOLDER."""

import base64
import pathlib
import struct
import sys
import xml.etree.ElementTree as xml

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent))
import tables

folder = pathlib.Path(sys.argv[1])


def table(run, name):
    return tables.rows(folder / run / name)


def energy_error(row):
    """Kinetic energy less what the liquid was given and has not lost, over what went in and out."""
    left = row["wall_work"] + row["inlet_work"] - row["viscous_work"] - row["stabilisation_work"]
    return abs(row["kinetic"] - left) / (abs(row["wall_work"]) + abs(row["inlet_work"]))


def flow_rate_error(row):
    """Of the flux through the orifice against the rate of the exact volume of a sphere that is cut at its rim."""
    return abs(row["flow_rate"] / tables.volume_rate(row, 0.03) - 1)


def velocities_on_axis(run):
    """Radial velocities of the nodes on the axis in the last field."""
    root = xml.parse(sorted((folder / run / "fields").glob("*.vtu"))[-1]).getroot()

    def numbers(path):
        data = base64.b64decode(root.find(path).text)
        return struct.unpack_from(f"<{struct.unpack_from('<Q', data)[0] // 8}d", data, 8)

    places, velocity = numbers(".//Points/DataArray"), numbers(".//DataArray[@Name='velocity']")
    return [velocity[i] for i in range(0, len(places), 3) if places[i] == 0]


def differences(run, other):
    """Bytes and lines that differ, times of solver.csv left out: they are of the clock on the wall."""
    files = ["history.csv", *sorted(str(p.relative_to(folder / run)) for p in (folder / run / "fields").glob("*.vtu"))]
    differing = sum((folder / run / f).read_bytes() != (folder / other / f).read_bytes() for f in files)
    rows = [[{k: v for k, v in row.items() if k != "wall"} for row in table(name, "solver.csv")] for name in (run, other)]
    return differing + (rows[0] != rows[1])


for motion, row, steps in (("deflation", 1, ("4", "2", "1", "0.5")), ("inflation", -1, ("1", "0.5", "0.25"))):
    for mesh in "421":
        run = f"{motion}-mesh{mesh}-step1"
        rows = table(run, "history.csv")
        print(f"volume,volume in {motion},{mesh},{max(abs(r['volume_error']) for r in table(run, 'solver.csv'))}")
        print(f"volume,flow rate in {motion},{mesh},{max(map(flow_rate_error, rows[1:]))}")
        print(f"energy by mesh,{motion},{mesh},{energy_error(rows[-1])}")
    for step in steps:
        print(f"energy by step,{motion},{step},{energy_error(table(f'{motion}-mesh2-step{step}', 'history.csv')[row])}")
    radial = velocities_on_axis(f"{motion}-mesh1-step1")
    print(f"axis,radial velocity in {motion},{len(radial)},{max(map(abs, radial))}")
for run in ("interrupted", "killed"):
    print(f"restart,files that differ after it was {run},0,{differences('whole', run)}")
