"""Functions in Python as tables of a case.

A function is sampled once, when the table is made, so that runs, threads and sweeps never call Python, and the case that
a result names holds everything. Interpolation makes this slower and less exact than the forms that case files have: steps
end at every row of a pressure table.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
import numpy.typing as npt

from .errors import invalid, optional

Function = Callable[[float], float]


def _value(key: str, name: str, function: Function, x: float) -> float:
    value = float(function(x))
    if not np.isfinite(value):
        raise invalid(key, value, f"is not a finite number at {name} = {x!r}", "the function has to have one there")
    return value


def _interpolate() -> Any:
    return optional("scipy.interpolate", "functions as tables")


def pressure_table(function: Function, t_end: float, *, knots: Iterable[float] = (), tolerance: float = 1e-6,
                   most: int = 5000) -> dict[str, Any]:
    """A pressure program from a function: ``Case(pressure=pressure_table(lambda t: 3e4 * np.tanh(t), 10))``.

    Intervals are halved until the monotone cubic through the rows is within the tolerance in their middle.

    :param function: gauge pressure [Pa] at a time [s] from 0 to t_end
    :param t_end: [s]
    :param knots: times of jumps and kinks [s], which otherwise take some fifty rows each; a jump is drawn out over 1e-9
        t_end
    :param tolerance: over the greatest pressure in size
    :param most: rows
    :raises InvalidInput: when the function is not finite, or needs more rows
    """
    if not (np.isfinite(t_end) and t_end > 0):
        raise invalid("t_end", t_end, "out of range", "allowed is > 0 s")
    inner = sorted(float(k) for k in knots)
    if any(not 0 < k < t_end for k in inner):
        raise invalid("knots", inner, "out of range", f"allowed is within 0 to {t_end!r} s")
    just = 1e-9 * t_end
    ends = np.array([0.0, *inner, t_end])
    times = np.unique(np.concatenate([np.linspace(a, b, 9) for a, b in zip(ends[:-1], ends[1:])]
                                     + [np.array([k - just for k in inner])]))
    values = {t: _value("pressure", "t", function, t) for t in times.tolist()}
    while True:
        t = np.array(sorted(values))
        p = np.array([values[x] for x in t.tolist()])
        middle = ((t[:-1] + t[1:]) / 2)[np.diff(t) > 2 * just]
        there = np.array([_value("pressure", "t", function, x) for x in middle.tolist()])
        off = np.abs(_interpolate().PchipInterpolator(t, p)(middle) - there) > tolerance * max(np.abs(p).max(), 1e-300)
        if not off.any():
            return {"table": {"t": (t, "s"), "p": (p, "Pa"), "interpolation": "cubic"}}
        values.update(zip(middle[off].tolist(), there[off].tolist()))
        if len(values) > most:
            raise invalid("pressure", None, f"needs more than {most} rows near t = {float(middle[off][0])!r} s",
                          "name jumps and kinks in knots, or allow a greater tolerance")


def material_table(*, stress: Function | None = None, energy: Function | None = None,
                   stretches: tuple[float, float] = (1.0, 4.0), tolerance: float = 1e-8,
                   most: int = 2049) -> dict[str, Any]:
    """A wall from a function of its own: ``Case(material=material_table(energy=my_w, stretches=(1, 3)))``.

    Beyond its ends the stress goes on in a straight line, and runs that get there warn.

    :param stress: nominal stress in equal biaxial stretch, dW/dlambda/2 [Pa], at a stretch; or
    :param energy: strain energy density W [J/m^3] there, smooth
    :param stretches: where the function holds; the first at most 1
    :param tolerance: of the stress between rows, over the greatest in size
    :param most: rows
    :raises InvalidInput: when the function is not finite, or needs more rows
    """
    if (stress is None) == (energy is None):
        raise invalid("material", None, "takes exactly one of stress and energy")
    low, high = stretches
    if not (0 < low <= 1 < high < np.inf):
        raise invalid("stretches", stretches, "out of range", "allowed is 0 < first <= 1 < second")
    if stress is None:
        stress = _stress_of(energy, low, high)  # type: ignore[arg-type]
    rows = 9
    while True:
        at = np.unique(np.append(np.linspace(low, high, rows), 1.0))
        s = np.array([_value("material", "stretch", stress, x) for x in at.tolist()])
        if abs(s[at == 1.0][0]) <= tolerance * np.abs(s).max():
            s[at == 1.0] = 0.0
        middle = (at[:-1] + at[1:]) / 2
        there = np.array([_value("material", "stretch", stress, x) for x in middle.tolist()])
        if (np.abs(_interpolate().CubicSpline(at, s)(middle) - there) <= tolerance * np.abs(s).max()).all():
            return {"model": "table", "table": {"stretch": at, "stress": (s, "Pa")}}
        rows = 2 * rows - 1
        if rows > most:
            raise invalid("material", None, f"needs more than {most} rows",
                          "the function has to be smooth; or allow a greater tolerance")


def _stress_of(energy: Function, low: float, high: float) -> Function:
    """dW/dlambda/2 by the Chebyshev series of W."""
    def sampled(stretches: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        return np.array([_value("material", "stretch", energy, x) for x in stretches.tolist()])

    series = np.polynomial.Chebyshev([0.0])
    for degree in (16, 32, 64, 128, 256):
        series = np.polynomial.Chebyshev.interpolate(  # type: ignore[no-untyped-call]
            sampled, degree, [low, high])
        if np.abs(series.coef[-4:]).max() <= 1e-12 * np.abs(series.coef).max():  # rounding leaves some 1e-14
            break
    else:
        raise invalid("material", None, "is not smooth enough to be differentiated", "give its stress")
    negligible = 1e-13 * np.abs(series.coef).max()
    derivative = series.trim(negligible).deriv()  # type: ignore[no-untyped-call]
    return lambda stretch: float(derivative(stretch)) / 2
