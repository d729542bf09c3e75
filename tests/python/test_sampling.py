"""Functions as tables of a case."""

import pickle

import numpy as np
import pytest
from conftest import TABLES

import turgor

MU = 450e3


def neo_hookean(stretch):
    return MU / 2 * (2 * stretch**2 + stretch**-4 - 3)


def case_of(**changes):
    return turgor.Case(**TABLES | {"solve": {"t_end": "5 s", "rtol": 1e-10}} | changes)


def test_pressures_are_met_within_their_tolerance():
    for tolerance in (1e-4, 1e-6):
        def heart(t):
            return 12e3 + 4e3 * np.sin(2 * np.pi * t) ** 3

        case = case_of(pressure=turgor.pressure_table(heart, 5, tolerance=tolerance))
        t = np.linspace(0, 5, 3001)
        # refinement looks at the middle of each interval, where a cubic's error is greatest or nearly so
        assert np.abs(case.pressure_at(t) - heart(t)).max() < 3 * tolerance * 16e3


def test_a_sampled_harmonic_gives_the_run_of_the_form():
    mean, size, frequency = 25e3, 4e3, 0.5
    sampled = turgor.pressure_table(lambda t: mean + size * np.sin(2 * np.pi * frequency * t), 5, tolerance=1e-8, most=50000)
    form = {"harmonic": {"mean": (mean, "Pa"), "amplitude": (size, "Pa"), "frequency": (frequency, "Hz")}}
    scales = {"pressure": "29 kPa", "time": "1 s"}
    here, there = (case_of(pressure=p, scales=scales).run() for p in (sampled, form))
    # the balloon follows the pressure with less than ten times its relative error
    assert np.abs(here.stretch - there.stretch).max() < 1e-6


def test_jumps_are_found_faster_when_named():
    def valve(t):
        return 30e3 if t >= 1 else 10e3

    stepped = case_of(pressure={"start": "10 kPa", "segments": [{"hold": "1 s"}, {"step": "30 kPa"}]}).run()
    named, found = turgor.pressure_table(valve, 5, knots=[1]), turgor.pressure_table(valve, 5)
    assert len(named["table"]["t"][0]) < len(found["table"]["t"][0])
    for table in (named, found):
        assert np.abs(case_of(pressure=table).run().stretch - stepped.stretch).max() < 1e-6


def test_noise_is_no_pressure():
    random = np.random.default_rng(1)
    with pytest.raises(turgor.InvalidInput, match="more than 5000 rows near t = "):
        turgor.pressure_table(lambda t: random.uniform(1e4, 2e4), 5)


@pytest.mark.parametrize("given", [
    {"energy": neo_hookean},
    {"stress": lambda x: MU * (x - x**-5)},
], ids=["energy", "stress"])
def test_walls_give_the_runs_of_their_formula(given):
    """The spline is within 1e-8 of the greatest stress, hundred times that near R = 1.1."""
    own = case_of(material=turgor.material_table(**given, stretches=(0.9, 3)), pressure={"constant": "3 kPa"})
    known = case_of(material={"model": "neo-hookean", "mu": (MU, "Pa")}, pressure={"constant": "3 kPa"})
    assert np.abs(own.run().stretch - known.run().stretch).max() < 1e-5
    assert pickle.loads(pickle.dumps(own)) == own
    assert turgor.Case.parse(own.resolved).resolved == own.resolved


@pytest.mark.parametrize("wrong, words", [
    (lambda: turgor.pressure_table(lambda t: np.nan, 5), "pressure"),
    (lambda: turgor.pressure_table(lambda t: 1.0, -5), "t_end"),
    (lambda: turgor.pressure_table(lambda t: 1.0, np.nan), "t_end"),
    (lambda: turgor.pressure_table(lambda t: 1.0, 5, knots=[7]), "knots"),
    (lambda: turgor.material_table(), "exactly one"),
    (lambda: turgor.material_table(stress=lambda x: 1.0, energy=lambda x: 1.0), "exactly one"),
    (lambda: turgor.material_table(stress=lambda x: x, stretches=(2, 1)), "stretches"),
    (lambda: turgor.material_table(stress=lambda x: 1 / (x - 1) if x != 1 else np.inf), "stretch = 1.0"),
    (lambda: turgor.material_table(stress=lambda x: abs(x - 2) - 1), "rows"),
    (lambda: turgor.material_table(energy=lambda x: abs(x - 2.1)), "smooth"),
])
def test_functions_that_are_none(wrong, words):
    with pytest.raises(turgor.InvalidInput, match=words):
        wrong()


def test_what_a_function_raises_comes_through():
    def broken(t):
        raise RuntimeError("no pump")

    with pytest.raises(RuntimeError, match="no pump"):
        turgor.pressure_table(broken, 5)


def test_a_wall_with_stress_at_rest_is_refused():
    with pytest.raises(turgor.InvalidInput, match="material"):
        case_of(material=turgor.material_table(stress=lambda x: 1e5 * x, stretches=(1, 3)))
