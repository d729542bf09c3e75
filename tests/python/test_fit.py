"""Constants of the wall from measurements."""

import numpy as np
import pytest

import turgor

GEOMETRY = {"radius0": 0.3, "thickness": 0.003}
R = np.linspace(1.02, 3, 40)


def curve(tables):
    """p0(R) of the program, not of the fit."""
    rows = turgor.Case(**tables).statics().curve
    above = rows["R"] > 1.001
    return rows["R"][above], rows["p_gauge"][above]


def test_exact_data_give_exact_constants(tables):
    stretch, pressure = curve(tables)
    fit = turgor.fit_mooney_rivlin(0.3 * stretch, pressure, **GEOMETRY)
    assert (fit.s1, fit.s2) == (pytest.approx(1.5e6, rel=1e-9), pytest.approx(0.15e6, rel=1e-9))
    assert fit.deviation < 1e-6 * pressure.max()
    again = turgor.Case(**tables | {"material": fit.material})
    assert again.material.s1 == fit.s1 and "s1 = 1.5e+06 Pa" in str(fit)


def test_intervals_hold_the_truth_as_often_as_they_say():
    """1000 noisy measurements: a 90 % interval misses 100 +- 9.5 times; four of these deviations are allowed."""
    random = np.random.default_rng(1)
    shape = 4 * 0.003 / 0.3 * (1 / R - R**-7)
    truth = shape * (1.5e6 + 0.15e6 * R**2)
    held = 0
    for _ in range(1000):
        fit = turgor.fit_mooney_rivlin(0.3 * R, truth + random.normal(0, 500, R.size), confidence=0.9, **GEOMETRY)
        held += fit.s1_interval[0] < 1.5e6 < fit.s1_interval[1]
    assert abs(held - 900) < 38


def test_weights_follow_the_better_data():
    shape = 4 * 0.003 / 0.3 * (1 / R - R**-7)
    pressure = shape * (1.5e6 + 0.15e6 * R**2)
    pressure[:3] *= 1.5
    deviation = np.where(np.arange(R.size) < 3, 1e6, 1.0)
    assert turgor.fit_mooney_rivlin(0.3 * R, pressure, deviation=deviation, **GEOMETRY).s1 == pytest.approx(1.5e6, rel=1e-4)
    assert turgor.fit_mooney_rivlin(0.3 * R, pressure, **GEOMETRY).s1 != pytest.approx(1.5e6, rel=1e-3)


@pytest.mark.parametrize("change, key", [
    ({"radius": [0.3, 0.4]}, "pressure"),
    ({"radius": [[0.3, 0.4, 0.5]]}, "radius"),
    ({"radius": [0.3, 0.4, np.nan]}, r"radius\[2\]"),
    ({"radius": [0.4, 0.4, 0.4]}, "radius"),
    ({"radius": [0.4, 0.5, -0.6]}, "radius"),
    ({"pressure": [1.0, np.inf, 2.0]}, r"pressure\[1\]"),
    ({"radius0": 0}, "radius0"),
    ({"thickness": np.nan}, "thickness"),
    ({"confidence": 95}, "confidence"),
    ({"deviation": [1, 0, 1]}, "deviation"),
])
def test_wrong_data_name_the_argument(change, key):
    arguments = {"radius": [0.4, 0.5, 0.6], "pressure": [3e4, 4e4, 5e4], **GEOMETRY} | change
    with pytest.raises(turgor.InvalidInput, match=key):
        turgor.fit_mooney_rivlin(**arguments)
