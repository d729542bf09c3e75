"""Tables that turgor has written, in SI units, and what several studies measure in them."""

import csv
import math
import re

SI = {"m": 1, "cm": 1e-2, "mm": 1e-3, "L": 1e-3, "s": 1, "ms": 1e-3, "kPa": 1e3, "1": 1, "Pa": 1, "N": 1, "J": 1, "W": 1}


def factor(unit):
    """Of a unit such as cm/ms^2."""
    result = 1.0
    for i, part in enumerate(unit.split("/")):
        name, _, power = part.partition("^")
        result *= SI[name] ** ((-1 if i else 1) * int(power or 1))
    return result


def rows(path):
    """Rows {name: value} of a CSV file with columns "name [unit]"; columns without a unit are counts."""
    with open(path) as file:
        lines = csv.reader(file)
        columns = [re.fullmatch(r"(.*?)(?: \[(.*)\])?", title).groups("1") for title in next(lines)]
        return [{name: float(x) * factor(unit) for (name, unit), x in zip(columns, line)} for line in lines]


def volume_rate(row, a):
    """Rate of the volume of a sphere that is cut off by its orifice of radius a."""
    r = row["r"]
    centre = math.sqrt(r * r - a * a)
    height, slope = r + centre, 1 + r / centre
    return math.pi * (2 * height * slope * (3 * r - height) + height**2 * (3 - slope)) / 3 * row["drdt"]


def centripetal(row, a, density=1000):
    """K = F r_ch^4/(rho r^6 (dr/dt)^2)."""
    return row["force"] * a**4 / (density * row["r"] ** 6 * row["drdt"] ** 2)


def inertial(row, a, density=1000):
    """-F r_ch/(rho r^4 d2r/dt2)."""
    return -row["force"] * a / (density * row["r"] ** 4 * row["d2rdt2"])
