"""Cases in code and from files."""

import pickle

import numpy as np
import pytest
from conftest import CASES, TABLES

import turgor


def test_code_and_text_make_the_same_case(tables):
    text = "\n".join(f"[{name}]\n" + "\n".join(f'{k} = "{v}"' for k, v in table.items())
                     for name, table in tables.items())
    assert turgor.Case(**tables) == turgor.Case.parse(text)


@pytest.mark.parametrize("radius", ["30 cm", (30, "cm"), (0.3, "m"), (np.float64(300), "mm"), (np.int64(30), "cm")])
def test_quantities_are_texts_or_pairs(tables, radius):
    tables["balloon"]["radius"] = radius
    assert turgor.Case(**tables).balloon.radius == 0.3


def test_quantities_of_unit_libraries(tables):
    class Quantity:
        magnitude = 30
        units = "cm"

    tables["balloon"]["radius"] = Quantity()
    assert turgor.Case(**tables).balloon.radius == 0.3


def test_arrays_with_a_unit(tables):
    times = np.linspace(0, 2, 5)
    tables["solve"]["times"] = (times, "s")
    tables["pressure"] = {"table": {"t": (times, "s"), "p": (1e4 * times, "Pa"), "interpolation": "linear"}}
    case = turgor.Case(**tables)
    assert case.solve.times == times.tolist()
    assert np.array_equal(case.run().t, times)
    assert np.array_equal(case.pressure_at(times), 1e4 * times)


def test_values_are_in_si_units_with_defaults(case):
    assert (case.balloon.thickness, case.fluid.viscosity, case.inlet.channel_length) == (0.003, 0.894e-3, 0.0)
    assert case["inlet.orifice_radius"] == 0.03
    assert case.initial.stretch == 1.0
    assert "orifice_radius" in dir(case.inlet) and "inlet" in dir(case)
    with pytest.raises(AttributeError, match="inlet.length: this case has no such key; it has"):
        case.inlet.length
    with pytest.raises(KeyError, match="inlet.length"):
        case["inlet.length"]


def test_replace_makes_another_case_and_keeps_this_one(case):
    other = case.replace({"inlet.orifice_radius": "2 cm"}, solve={"rtol": 1e-11})
    assert (other.inlet.orifice_radius, other.solve.rtol, other.solve.t_end) == (0.02, 1e-11, case.solve.t_end)
    assert case.inlet.orifice_radius == 0.03
    assert other != case and other.replace({"inlet.orifice_radius": "3 cm", "solve.rtol": 1e-9}) == case
    steady = case.replace(pressure={"constant": "30 kPa"})
    assert steady.pressure_at(5.0) == 30000
    assert steady.replace(pressure={"harmonic": {"mean": "30 kPa", "amplitude": "3 kPa", "frequency": "0.5 Hz"}})


def test_pickles_keep_changes(case):
    other = case.replace({"inlet.orifice_radius": "2 cm"})
    again = pickle.loads(pickle.dumps(other))
    assert again == other and hash(again) == hash(other) and again.inlet.orifice_radius == 0.02


def test_tables_next_to_the_file_are_found_after_pickling():
    case = turgor.Case.read(CASES / "orifice-30mm.toml",
                            model={"closure": "profile", "profile": "profile-orifice.csv"})
    assert pickle.loads(pickle.dumps(case)) == case


@pytest.mark.parametrize("file", sorted(CASES.glob("*.toml")), ids=lambda file: file.stem)
def test_resolved_cases_read_back(file):
    case = turgor.Case.read(file)
    again = turgor.Case.parse(case.resolved)
    assert again.resolved == case.resolved
    assert repr(case) and case._repr_html_()


def test_the_example_of_the_class():
    case = turgor.Case(**TABLES | {"solve": {"t_end": (2, "s")}})
    assert case.inlet.orifice_radius == 0.03
    assert round(case.run().peak_stretch, 6) == 1.273579
