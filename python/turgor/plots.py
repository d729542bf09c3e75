"""Pictures by matplotlib in the look of the command line's."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import invalid, optional

if TYPE_CHECKING:
    from .run import Run

#: Of M. Okabe & K. Ito's palette, told apart by every kind of colour vision.
COLOURS = {1: "#0072B2", -1: "#D55E00", 0: "black"}
NAMES = {1: "inflating", -1: "deflating", 0: "at rest"}


def _pyplot() -> Any:
    return optional("matplotlib.pyplot", "pictures")


def _framed(axes: Any) -> None:
    axes.grid(color="0.85", linewidth=0.5)
    axes.set_axisbelow(True)


def _phases(run: Run) -> list[tuple[int, Any]]:
    """Regimes between events with times at which to draw: dense output, events included, seventeen or more."""
    ends = np.array([0.0, *run.events.t, run.end_time])
    grid = np.linspace(0, run.end_time, 2001)
    regimes = run.at((ends[:-1] + ends[1:]) / 2).regime
    return [(int(regime), np.union1d(grid[(grid > start) & (grid < end)], np.linspace(start, end, 17)))
            for start, end, regime in zip(ends[:-1], ends[1:], regimes)]


def _draw(run: Run, axes: Any, x: Any, y: Any) -> None:
    seen: set[int] = set()
    for regime, times in _phases(run):
        stretch, rate = run.sol(times)
        axes.plot(x(times, stretch, rate), y(times, stretch, rate), color=COLOURS[regime], linewidth=1.5,
                  label=None if regime in seen else NAMES[regime])
        seen.add(regime)


def history(run: Run, axes: Any = None) -> Any:
    """R over the pressure [kPa], against t."""
    if axes is None:
        _, axes = _pyplot().subplots(2, 1, sharex=True, height_ratios=(7, 3), figsize=(8, 5.6), layout="constrained")
    try:
        upper, lower = axes
    except (TypeError, ValueError):
        raise invalid("axes", type(axes).__name__, "is not two axes", "give those of pyplot.subplots(2, 1)") from None
    _draw(run, upper, lambda t, R, v: t, lambda t, R, v: R)
    upper.set_title(run.case.title)
    upper.set_ylabel("stretch $R = r/r_0$ [1]")
    upper.legend(frameon=False)
    t = np.unique(np.concatenate([times for _, times in _phases(run)] + [run.t]))
    lower.plot(t, run.case.pressure_at(t) / 1000, color="black", linewidth=1.5)
    lower.set_ylabel("$p_{ext} - p_a$ [kPa]")
    lower.set_xlabel("t [s]")
    _framed(upper)
    _framed(lower)
    return axes


def phase(run: Run, axes: Any = None) -> Any:
    """dR/dt against R, from start to end."""
    if axes is None:
        _, axes = _pyplot().subplots(figsize=(8, 5.6), layout="constrained")
    _draw(run, axes, lambda t, R, v: R, lambda t, R, v: v)
    first, last = run.sol([0.0, run.end_time]).T
    axes.plot(*first, "o", color="black", fillstyle="none", markersize=8, label="start")
    axes.plot(*last, "o", color="black", markersize=4, label="end")
    axes.axhline(0, color="0.6", linewidth=0.8, zorder=0)
    axes.set_title(run.case.title)
    axes.set_xlabel("stretch $R = r/r_0$ [1]")
    axes.set_ylabel("dR/dt [1/s]")
    axes.legend(frameon=False)
    _framed(axes)
    return axes
