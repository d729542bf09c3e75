"""Results are those of the command line, bit for bit: its tables hold the shortest text that reads back as the same double."""

import json

import numpy as np
import pytest
from conftest import CASES

import turgor

FREE = [file for file in sorted(CASES.glob("*.toml")) if not file.stem.startswith(("motion", "jet", "coupled", "snap"))]
SI = {"time_unit": "s", "length_unit": "m", "pressure_unit": "Pa", "volume_unit": "m^3", "flow_unit": "m^3/s",
      "energy_unit": "J"}
NAMES = {"t": "t", "stretch": "R", "rate": "dRdt", "radius": "r", "pressure": "p_gauge", "regime": "regime",
         "volume": "volume", "flow_rate": "flow_rate", "kinetic": "kinetic", "elastic": "elastic",
         "inlet_work": "inlet_work", "dissipated": "dissipated"}


@pytest.mark.parametrize("file", FREE, ids=lambda file: file.stem)
def test_runs(file, program, tmp_path):
    units = [word for key, unit in SI.items() for word in ("--set", f"output.{key}={unit}")]
    program("run", file, "-o", "there", "--no-pictures", "-q", *units)
    run = turgor.Case.read(file, output=SI).run()
    there = turgor.Columns((tmp_path / "there" / "trajectory.csv").read_text())
    assert set(NAMES) == set(turgor.COLUMNS)
    for name, column in NAMES.items():
        assert np.array_equal(getattr(run, name), there[column]), name
    events = turgor.Columns((tmp_path / "there" / "events.csv").read_text())
    assert np.array_equal(run.events.t, events["t"]) and np.array_equal(run.events.stretch, events["R"])
    assert np.array_equal(run.events.after, events["new_regime"])
    here, report = run.report(), json.loads((tmp_path / "there" / "run.json").read_text())
    for document in (here, report):
        document.pop("timings")
    assert here == report
    run.save(tmp_path / "here", pictures=False)
    for table in ("trajectory.csv", "dimensionless.csv", "events.csv", "resolved.toml"):
        assert (tmp_path / "here" / table).read_bytes() == (tmp_path / "there" / table).read_bytes()
    assert run.to_csv() == (tmp_path / "there" / "trajectory.csv").read_text()


@pytest.mark.parametrize("command, question", [
    ("info", lambda case: case.info()),
    ("statics", lambda case: case.statics()),
    ("asymptotics", lambda case: case.asymptotics()),
])
def test_questions(command, question, program, case):
    report = question(case)
    assert dict(report) == json.loads(program(command, CASES / "orifice-30mm.toml", "--json"))
    assert str(report) == program(command, CASES / "orifice-30mm.toml")


def test_statics_over_a_key(program, case, tmp_path):
    report = case.statics(over="material.s1=1 MPa:2 MPa", compliance="2e-8 m^3/Pa")
    program("statics", CASES / "orifice-30mm.toml", "--over", "material.s1=1 MPa:2 MPa", "--compliance", "2e-8 m^3/Pa",
            "-o", "there", "--no-pictures")
    for name, table in (("curve", "statics.csv"), ("branches", "branches.csv")):
        there = turgor.Columns((tmp_path / "there" / table).read_text())
        assert list(getattr(report, name)) == list(there)
        assert all(np.array_equal(getattr(report, name)[column], there[column]) for column in there)
    assert dict(report) == json.loads((tmp_path / "there" / "statics.json").read_text())


def test_portrait(program, case, tmp_path):
    program("portrait", CASES / "orifice-30mm.toml", "--pressure", "41.3 kPa", "-o", "there", "--no-pictures", "-q")
    report = case.portrait(pressure="41.3 kPa")
    assert dict(report) == json.loads((tmp_path / "there" / "portrait.json").read_text())
    there = turgor.Columns((tmp_path / "there" / "portrait.csv").read_text())
    assert all(np.array_equal(report.curves[column], there[column]) for column in there)


def test_force(program, tmp_path):
    file = CASES / "motion-orifice-30mm.toml"
    program("force", file, "-o", "there", "--no-pictures", "-q")
    report = turgor.Case.read(file).force()
    assert dict(report) == json.loads((tmp_path / "there" / "force.json").read_text())
    there = turgor.Columns((tmp_path / "there" / "force.csv").read_text())
    assert all(np.array_equal(report.history[column], there[column]) for column in there)


def test_coefficients(program, case, tmp_path):
    program("coefficients", "--kappa", "1/100:1/10:5", "--harmonics", "50", "-o", "there", "--no-pictures")
    there = turgor.Columns((tmp_path / "there" / "coefficients.csv").read_text())
    here = turgor.coefficients(there["kappa"], harmonics=50)
    assert list(here) == list(there) and len(there["kappa"]) == 5
    assert all(np.array_equal(here[column], there[column]) for column in there)
    own = case.coefficients([1.0, 2.0])
    assert np.allclose(own["g1"], turgor.coefficients([0.1, 0.05])["g1"], rtol=1e-12)


def test_flow(program, case, tmp_path):
    program("flow", CASES / "orifice-30mm.toml", "--at", "stretch=1.1, rate=-0.1 1/s", "-o", "there", "--no-pictures",
            "-q", "--resolution", "20")
    flow = case.flow(stretch=1.1, rate=-0.1)
    assert dict(flow.report(20)) == json.loads((tmp_path / "there" / "flow.json").read_text())
    there = turgor.Columns((tmp_path / "there" / "wall.csv").read_text())
    for here, column in zip(flow.wall().values(), there):
        assert np.array_equal(here, there[column])
    flow.to_vtu(tmp_path / "here.vtu", 20)
    assert (tmp_path / "here.vtu").read_bytes() == (tmp_path / "there" / "flow.vtu").read_bytes()


def test_sweep(program, tmp_path):
    file = CASES / "sweep-orifice-pressure.toml"
    axes = {"inlet.orifice_radius": {"from": "1 cm", "to": "3 cm", "n": 4},
            "model.closure": {"values": ["theoretical", "corrected"]}}
    case = turgor.Case.read(file, sweep={"axes": axes})
    sweep = case.sweep(tmp_path / "here.nc", threads=1)
    text = "{ " + ", ".join(
        f'"{key}" = ' + ("{ from = \"1 cm\", to = \"3 cm\", n = 4 }" if "from" in axis else
                         "{ values = [\"theoretical\", \"corrected\"] }") for key, axis in axes.items()) + " }"
    program("sweep", file, "--set", f"sweep={{ axes = {text} }}", "-o", "there.nc", "--no-pictures", "-q")
    import xarray

    there = xarray.load_dataset(tmp_path / "there.nc")
    assert (sweep.members, sweep.failed) == (8, 0)
    for name in there.variables:
        assert np.array_equal(np.asarray(sweep.data[name]), np.asarray(there[name]),
                              equal_nan=there[name].dtype.kind == "f"), name
    assert case.sweep().data.equals(sweep.data)
    with pytest.raises(turgor.InvalidInput, match="force"):
        case.sweep(tmp_path / "here.nc")


def test_sweeps_that_were_stopped_go_on(tmp_path):
    """What raises in `progress` stops a sweep as Ctrl-C does; finished members are kept."""
    case = turgor.Case.read(CASES / "sweep-orifice-pressure.toml", sweep={
        "sampler": "latin-hypercube", "members": 30000, "quantities": ["peak_stretch"],
        "axes": {"inlet.orifice_radius": {"from": "1 cm", "to": "3 cm"}}})

    def stop(share):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        case.sweep(tmp_path / "out.nc", threads=1, progress=stop)
    assert (tmp_path / "out.nc.part").exists() and not (tmp_path / "out.nc").exists()
    shares = []
    sweep = case.sweep(tmp_path / "out.nc", resume=True, threads=1, progress=shares.append)
    assert shares == sorted(shares) and sweep.members == 30000
    assert sweep.data.equals(case.sweep().data)
