"""Wrong input: Python exceptions that name the key, never a crash."""

import pickle

import numpy as np
import pytest
from conftest import CASES

import turgor

NAN = float("nan")


@pytest.mark.parametrize(
    "key, value, words",
    [
        ("balloon.radius", 0.3, "unit"),
        ("balloon.radius", "0.3", "missing unit"),
        ("balloon.radius", "3 kg", "wrong dimension"),
        ("balloon.radius", "-3 cm", "out of range"),
        ("balloon.radius", (NAN, "cm"), "not"),
        ("balloon.radius", (float("inf"), "cm"), "not"),
        ("balloon.radius", ("3", 4), "list"),
        ("balloon.radius", None, "NoneType"),
        ("balloon.radius", object(), "object"),
        ("balloon.radius", 1j, "complex"),
        ("balloon.radius", (np.ones((2, 2)), "cm"), "list"),
        ("balloon.radius", ([1, 2], "cm"), "list"),
        ("balloon.radius", {"a": 1}, "table"),
        ("balloon.radius", b"3 cm", "bytes"),
        ("balloon.raduis", "3 cm", "radius"),
        ("solve.rtol", NAN, "not"),
        ("solve.rtol", "tight", "number"),
        ("solve.rtol", 10**400, "not"),
        ("solve.times", (np.array([0.0, NAN]), "s"), "not"),
        ("solve.times", np.ones((2, 2)), "shape"),
        ("model.name", "best", "full"),
        ("material.s3", "1 Pa", "unknown"),
    ],
)
def test_wrong_values_name_the_key(tables, key, value, words):
    table, name = key.split(".")
    tables.setdefault(table, {})[name] = value
    with pytest.raises(turgor.InvalidInput, match=words) as error:
        turgor.Case(**tables)
    assert any(k.startswith(key) for k in error.value.keys)
    with pytest.raises(turgor.InvalidInput) as error:
        turgor.Case.read(CASES / "orifice-30mm.toml").replace({key: value})
    assert any(k.startswith(key) for k in error.value.keys)


def test_every_issue_is_reported_as_on_the_command_line(program, tmp_path):
    text = '[balloon]\nradius = "30"\nthickness = "3 kg"\n[inlet]\norifice = "1 cm"\n'
    file = tmp_path / "bad.toml"
    file.write_text(text)
    with pytest.raises(turgor.InvalidInput) as error:
        turgor.Case.read(file)
    with pytest.raises(Exception) as there:
        program("validate", file)
    assert there.value.stderr == "".join(f"error: {line}\n" for line in str(error.value).split("\n"))
    issue = error.value.issues[0]
    assert (issue.key, issue.line, issue.file) == ("inlet.orifice", 5, str(file))
    assert "balloon.radius" in error.value.keys
    again = pickle.loads(pickle.dumps(error.value))
    assert (str(again), again.issues) == (str(error.value), error.value.issues)
    assert isinstance(error.value, ValueError)


def test_files_and_text_that_are_none(tmp_path):
    with pytest.raises(turgor.InvalidInput, match="cannot read"):
        turgor.Case.read(tmp_path / "none.toml")
    with pytest.raises(turgor.InvalidInput, match="not valid TOML"):
        turgor.Case.parse("balloon = [")
    with pytest.raises(TypeError):
        turgor.Case.parse(3)
    with pytest.raises(TypeError):
        turgor.Case({"balloon": {}})
    with pytest.raises(turgor.InvalidInput, match="bal"):
        turgor.Case(bal={})
    with pytest.raises(turgor.InvalidInput, match="balloon"):
        turgor.Case(balloon=3)
    with pytest.raises(turgor.InvalidInput, match="text"):
        turgor.Case(balloon={3: 4})


def test_arguments_of_questions(case, run):
    for wrong, key in [
        (lambda: case.statics(over="inlet.width=1:2"), "inlet.width"),
        (lambda: case.statics(compliance="3 m"), "compliance"),
        (lambda: case.statics(compliance=-1), "compliance"),
        (lambda: case.statics(compliance=(-1, "m^3/Pa")), "compliance"),
        (lambda: case.portrait(pressure="3 cm"), "pressure"),
        (lambda: case.portrait(pressure=3), "pressure"),
        (lambda: case.portrait(stretches=(2, 1)), "stretches"),
        (lambda: case.portrait(rates=(1, 2)), "rates"),
        (lambda: case.flow(stretch=1.1, rate=0.1), "rate"),
        (lambda: case.flow(stretch=NAN, rate=-0.1), "stretch"),
        (lambda: case.force(), "motion"),
        (lambda: case.sweep(), "sweep"),
        (lambda: turgor.coefficients(2.0), "kappa"),
        (lambda: turgor.coefficients([[0.1]]), "kappas"),
        (lambda: turgor.coefficients(0.1, harmonics=-1), "harmonics"),
        (lambda: run.sol(-1), "t"),
        (lambda: run.at([1, NAN]), "t"),
        (lambda: run.sol(1e9), "t"),
        (lambda: run.plot(axes=3), "axes"),
    ]:
        with pytest.raises(turgor.InvalidInput) as error:
            wrong()
        assert key in str(error.value)
    with pytest.raises((TypeError, ValueError)):
        run.sol("later")
    with pytest.raises(AttributeError, match="peak_stretch"):
        run.peak
    motion = turgor.Case.read(CASES / "motion-orifice-30mm.toml")
    for question in (motion.run, motion.info, motion.statics, motion.sweep):
        with pytest.raises(turgor.InvalidInput):
            question()


def test_points_and_times_of_wrong_shape(case):
    flow = case.flow(stretch=1.1, rate=-0.1)
    with pytest.raises(turgor.InvalidInput, match="z"):
        flow.fields([0.1, 0.2], [0.1])
    assert np.isnan(flow.fields([9.0, NAN], [0.0, 0.0])["pressure"]).all()


def test_failing_runs_are_results(case):
    run = case.replace({"pressure": {"constant": "60 kPa"}, "material.max_stretch": 2.0, "initial.stretch": 1.5}).run()
    assert run.outcome is turgor.Outcome.BURST and run.status is turgor.Status.FAILED and not run.status
    assert "burst" in run.message
    short = case.replace({"solve.max_steps": 5}).run()
    assert short.outcome is turgor.Outcome.MAX_STEPS and len(short.t) and np.isfinite(short.stretch).all()


def test_results_cannot_be_written_to(run):
    for name in turgor.COLUMNS:
        with pytest.raises(ValueError, match="read-only"):
            getattr(run, name)[0] = 1
    with pytest.raises((AttributeError, TypeError)):
        run.t = 3


def test_missing_solver(case, monkeypatch, tmp_path):
    monkeypatch.setenv("TURGOR_FEM", str(tmp_path / "none"))
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(turgor.fem._core, "__file__", str(tmp_path / "turgor" / "_core.so"))
    with pytest.raises(turgor.MissingComponent, match="TURGOR_FEM"):
        case.fem(tmp_path / "out")
    with pytest.raises(turgor.InvalidInput, match="no run directory"):
        turgor.fem.FemRun(tmp_path)
    with pytest.raises(turgor.InvalidInput):
        case.verify(tmp_path / "none")


@pytest.mark.parametrize("module, call", [
    ("matplotlib.pyplot", lambda run: run.plot()),
    ("pandas", lambda run: run.to_pandas()),
    ("pandas", lambda run: run.events.to_pandas()),
    ("xarray", lambda run: run.to_xarray()),
    ("xarray", lambda run: run.case.sweep(axes={"material.s1": {"values": ["1 MPa"]}})),
    ("scipy.interpolate", lambda run: turgor.pressure_table(lambda t: t, 1)),
    ("scipy.stats", lambda run: turgor.fit_mooney_rivlin([1, 2, 3], [1, 2, 3], radius0=0.5, thickness=0.1)),
])
def test_missing_packages_are_named(module, call, run, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, module, None)
    with pytest.raises(turgor.MissingComponent, match=f"need {module.split('.')[0]}"):
        call(run)


def test_no_times_at_all(tables):
    tables["solve"]["times"] = []
    with pytest.raises(turgor.InvalidInput, match="solve.times"):
        turgor.Case(**tables)


def test_missing_sweeps(case, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "turgor._sweep", None)
    with pytest.raises(turgor.MissingComponent, match="TURGOR_SWEEP"):
        case.sweep()
