"""Properties that hold for every balloon."""

import numpy as np
from conftest import TABLES
from hypothesis import given, settings
from hypothesis import strategies as st

import turgor
from turgor import _toml

texts = st.text(st.characters(blacklist_categories=("Cs",)), max_size=20)
scalars = st.one_of(texts, st.integers(-2**62, 2**62), st.floats(allow_nan=False), st.booleans())
trees = st.recursive(scalars, lambda inner: st.one_of(st.lists(inner, max_size=3),
                                                      st.dictionaries(texts.filter(bool), inner, max_size=3)), max_leaves=8)


@settings(deadline=None, max_examples=300)
@given(st.dictionaries(texts.filter(bool), trees, max_size=4))
def test_toml_reads_back(document):
    import tomllib

    assert tomllib.loads(_toml.document(document)) == document


@settings(deadline=None, max_examples=300)
@given(st.dictionaries(st.sampled_from([*TABLES, "title", "model", "other"]), trees, max_size=8))
def test_whatever_is_given_is_refused_or_a_case(tables):
    try:
        case = turgor.Case(**tables)
    except turgor.InvalidInput as error:
        assert error.issues and str(error)
    else:
        assert case.resolved


@settings(deadline=None, max_examples=60)
@given(orifice=st.floats(0.005, 0.05), channel=st.sampled_from([0.0, 0.2, 0.5]), pressure=st.floats(5e3, 38e3),
       ramp=st.floats(0.5, 5), s1=st.floats(1e6, 2e6))
def test_energy_balances_and_nothing_is_lost(orifice, channel, pressure, ramp, s1):
    case = turgor.Case(**TABLES | {
        "inlet": {"orifice_radius": (orifice, "m"), "channel_length": (channel, "m")},
        "material": {"model": "mooney-rivlin", "s1": (s1, "Pa"), "s2": "0.15 MPa"},
        "pressure": {"segments": [{"to": (pressure, "Pa"), "over": (ramp, "s"), "shape": "smooth"}]},
        "solve": {"t_end": (3 * ramp, "s"), "samples": 200},
        "model": {"name": "full"},
    })
    run = case.run()
    assert run.status
    # the ledger's integrals are independent of the equation of motion; rtol is 1e-9 a step, some hundred steps
    assert run.energy_error < 1e-5
    balance = run.kinetic + run.elastic - run.inlet_work + run.dissipated
    assert np.abs(balance - balance[0]).max() < 1e-5 * max(run.elastic.max(), run.inlet_work.max())
    assert (np.diff(run.dissipated) > -1e-12 * max(1.0, run.dissipated.max())).all()
    assert np.isfinite(run.to_pandas().to_numpy()).all()
    assert np.abs(run.sol(run.events.t)[1]).max(initial=0) < 1e-9 * max(np.abs(run.rate).max(), 1e-300)


@settings(deadline=None, max_examples=40)
@given(scale=st.floats(0.1, 10))
def test_units_do_not_matter(scale):
    """A balloon in other units of length, time and mass has the same R(t/t_typ): similarity of (2.22)."""
    def scaled(length, time, mass):
        pressure = mass / (length * time**2)
        density = mass / length**3
        return turgor.Case(
            balloon={"radius": (0.3 * length, "m"), "thickness": (0.003 * length, "m"),
                     "density": (1000 * density, "kg/m^3")},
            material={"model": "mooney-rivlin", "s1": (1.5e6 * pressure, "Pa"), "s2": (0.15e6 * pressure, "Pa")},
            fluid={"density": (1000 * density, "kg/m^3"), "viscosity": (1e-3 * mass / (length * time), "Pa s")},
            inlet={"orifice_radius": (0.03 * length, "m"), "channel_length": (0.5 * length, "m")},
            pressure={"constant": (3e4 * pressure, "Pa")},
            model={"name": "full"},
            solve={"t_end": (3 * time, "s"), "samples": 50, "rtol": 1e-11},
        ).run()

    one, other = scaled(1, 1, 1), scaled(scale, 1 / scale, scale**2)
    # both are within the accumulated error of rtol = 1e-11
    assert np.abs(one.stretch - other.stretch).max() < 1e-8
