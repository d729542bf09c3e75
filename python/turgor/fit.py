"""Constants of the wall from measurements."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from .errors import invalid, optional

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class MooneyRivlinFit:
    """s1 and s2 of (2.18) by least squares."""

    s1: float  #: [Pa]
    s2: float  #: [Pa]
    s1_interval: tuple[float, float]  #: confidence interval [Pa]
    s2_interval: tuple[float, float]
    covariance: Floats  #: of (s1, s2) [Pa^2]
    confidence: float  #: of the intervals
    residuals: Floats  #: measured less fitted pressure [Pa]
    deviation: float  #: standard deviation of one pressure about the fit [Pa]

    @property
    def material(self) -> dict[str, Any]:
        """For ``Case(material=...)``."""
        return {"model": "mooney-rivlin", "s1": (self.s1, "Pa"), "s2": (self.s2, "Pa")}

    def __str__(self) -> str:
        def line(name: str, value: float, interval: tuple[float, float]) -> str:
            return f"{name} = {value:.6g} Pa ({100 * self.confidence:g} %: {interval[0]:.6g} to {interval[1]:.6g} Pa)"

        return f"{line('s1', self.s1, self.s1_interval)}\n{line('s2', self.s2, self.s2_interval)}"


def _column(name: str, values: npt.ArrayLike) -> Floats:
    array = np.asarray(values, float)
    if array.ndim != 1:
        raise invalid(name, array.shape, "is an array of the wrong shape", "give one with one dimension")
    if not np.isfinite(array).all():
        where = int(np.flatnonzero(~np.isfinite(array))[0])
        raise invalid(f"{name}[{where}]", float(array[where]), "is not a finite number")
    return array


def _positive(name: str, value: float) -> float:
    if not (np.isfinite(value) and value > 0):
        raise invalid(name, value, "out of range", "allowed is > 0")
    return float(value)


def fit_mooney_rivlin(radius: npt.ArrayLike, pressure: npt.ArrayLike, *, radius0: float, thickness: float,
                      deviation: npt.ArrayLike | None = None, confidence: float = 0.95) -> MooneyRivlinFit:
    """s1 and s2 from slow inflation: the curve p(r) of (3.1), in which they are linear,

        p = 4 d0/r0 (1/R - 1/R^7) (s1 + s2 R^2),    R = r/r0.

    Intervals are those of linear regression: pressures have independent normal errors, equal ones or in the ratio of
    ``deviation``, of a size that the residuals tell (Student's t with n - 2 degrees of freedom); radii have none.

    :param radius: measured radii [m], other than r0, at least three different ones
    :param pressure: gauge pressures at them [Pa]
    :param radius0: r0 [m]
    :param thickness: d0 [m]
    :param deviation: standard deviations of the pressures, or their ratios
    :param confidence: of the intervals, within 0 to 1
    :raises InvalidInput: for data that cannot tell s1 from s2, wrong shapes, numbers that are not finite
    """
    stats = optional("scipy.stats", "fits")
    r, p = _column("radius", radius), _column("pressure", pressure)
    r0, d0 = _positive("radius0", radius0), _positive("thickness", thickness)
    if r.size != p.size:
        raise invalid("pressure", f"{p.size} values", f"has not as many values as radius, {r.size}")
    if not 0 < confidence < 1:
        raise invalid("confidence", confidence, "out of range", "allowed is within 0 to 1, such as 0.95")
    if (r <= 0).any():
        raise invalid("radius", float(r.min()), "out of range", "allowed is > 0 m")
    stretch = r / r0
    if np.unique(stretch[stretch != 1]).size < 3:
        raise invalid("radius", f"{r.size} values", "are too few different ones", "give at least three other than r0")
    weight = np.ones_like(p)
    if deviation is not None:
        sigma = np.broadcast_to(np.asarray(deviation, float), p.shape)
        if not (np.isfinite(sigma).all() and (sigma > 0).all()):
            raise invalid("deviation", None, "has values that are not positive numbers")
        weight = 1 / sigma
    shape = 4 * d0 / r0 * (stretch**-1 - stretch**-7)
    matrix = np.column_stack((shape, shape * stretch**2)) * weight[:, None]
    solution, _, rank, _ = np.linalg.lstsq(matrix, p * weight, rcond=None)
    if rank < 2:
        raise invalid("radius", None, "cannot tell s1 from s2", "spread the radii further")
    scaled = (p * weight) - matrix @ solution
    freedom = p.size - 2
    variance = float(scaled @ scaled) / freedom
    covariance = variance * np.linalg.inv(matrix.T @ matrix)
    half = stats.t.ppf((1 + confidence) / 2, freedom) * np.sqrt(np.diag(covariance))
    s1, s2 = (float(s) for s in solution)
    residuals = p - shape * (s1 + s2 * stretch**2)
    return MooneyRivlinFit(s1, s2, (s1 - half[0], s1 + half[0]), (s2 - half[1], s2 + half[1]), covariance, confidence,
                           residuals, float(np.sqrt(residuals @ residuals / freedom)))


__all__ = ["MooneyRivlinFit", "fit_mooney_rivlin"]
