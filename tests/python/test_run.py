"""Results of runs."""

import pickle
import subprocess
import sys
import time

import numpy as np
import pytest

import turgor


def test_arrays_are_views(run):
    for name in turgor.COLUMNS:
        first, second = getattr(run, name), getattr(run, name)
        assert first.__array_interface__["data"] == second.__array_interface__["data"]
        assert not first.flags.owndata and not first.flags.writeable


def test_views_outlive_their_run(case):
    stretch = case.run().stretch
    again = case.run().stretch
    assert np.array_equal(stretch, again)


def test_dense_output_goes_through_rows_and_solves_the_equation(run):
    assert np.array_equal(run.sol(run.t), np.array([run.stretch, run.rate]))
    t = np.linspace(0.1, run.end_time - 0.1, 501)
    h = 1e-5  # (R(t + h) - R(t - h))/2h is dR/dt to h^2 R'''/6 and rounding, 1e-16/h = 1e-11
    slope = (run.sol(t + h)[0] - run.sol(t - h)[0]) / (2 * h)
    assert np.abs(slope - run.sol(t)[1]).max() < 1e-5 * np.abs(run.rate).max()
    assert run.sol(1.0).shape == (2,) and run.sol(t.reshape(3, 167)).shape == (2, 3, 167)
    state = run.at(t)
    assert np.array_equal(state.regime, np.sign(state.rate))
    assert np.allclose(state.radius, run.case.balloon.radius * state.stretch, rtol=1e-15)


def test_flow_rate_is_the_change_of_volume(run):
    t = np.linspace(0.5, 5, 51)
    h = 1e-5
    change = (run.at(t + h).volume - run.at(t - h).volume) / (2 * h)
    assert np.abs(change - run.at(t).flow_rate).max() < 1e-5 * np.abs(run.flow_rate).max()


def test_events_have_no_rate(run):
    assert len(run.events) == run.quantities["events"] == len(run.events.to_pandas())
    assert np.abs(run.sol(run.events.t)[1]).max() < 1e-12
    assert set(np.unique(run.events.after)) <= {-1, 0, 1}


def test_status_and_quantities(run, case):
    assert run.status is turgor.Status.COMPLETE and run.outcome is turgor.Outcome.REACHED_END
    assert run.peak_stretch == run.quantities["peak_stretch"] == max(run.quantities["peak_stretch"], run.stretch.max())
    assert run.case is case and run.model == "orifice" and "peak_stretch" in dir(run)
    assert run.statistics["steps"] > 10 and run.report()["status"] == "complete"
    assert all(expectation.met for expectation in run.expectations)
    assert [warning.name for warning in run.warnings] == [w["name"] for w in run.report()["warnings"]]
    with pytest.raises(AttributeError):
        run.nothing


def test_pickles_have_the_same_bits(run):
    again = pickle.loads(pickle.dumps(run))
    for name in turgor.COLUMNS:
        assert np.array_equal(getattr(again, name), getattr(run, name)), name
    t = np.linspace(0, run.end_time, 1001)
    assert np.array_equal(again.sol(t), run.sol(t))
    assert again.report() == run.report() and str(again) == str(run) and again.case == run.case


def test_pickles_of_other_versions_are_refused(run):
    restore, (version, *rest) = run.__reduce__()
    with pytest.raises(turgor.InvalidInput, match="version"):
        restore("0.0.0", *rest)


def test_tables_of_pandas_and_xarray(run):
    frame = run.to_pandas()
    assert np.array_equal(frame["stretch"], run.stretch) and frame.index.name == "t"
    assert frame.attrs["units"]["radius"] == "m"
    data = run.to_xarray()
    assert data.radius.attrs["units"] == "m" and np.array_equal(data.t, run.t)
    assert turgor.Case.parse(data.attrs["case"]) == run.case
    assert float(data.stretch.sel(t=3.0, method="nearest")) == pytest.approx(float(run.sol(3.0)[0]), rel=1e-3)


def test_csv(run, tmp_path):
    run.to_csv(tmp_path / "rows.csv")
    assert (tmp_path / "rows.csv").read_text() == run.to_csv()


def test_words(run, case):
    for thing in (run, case, case.statics()):
        assert repr(thing).startswith("<turgor.") and thing._repr_html_().startswith("<")
    assert "orifice" in str(run) and "steps" in run.summary(verbose=True)


def test_pictures(run):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    upper, lower = run.plot()
    drawn = np.concatenate([line.get_ydata() for line in upper.get_lines()])
    assert drawn.max() == pytest.approx(run.peak_stretch, rel=1e-12)
    assert lower.get_lines()[0].get_ydata().max() == pytest.approx(36)
    assert run.plot(phase=True).get_xlabel().startswith("stretch")
    assert run.plot(axes=(upper, lower))[0] is upper


def test_progress_is_called_and_can_raise(case):
    slow = case.replace({"solve.rtol": 1e-13, "solve.t_end": "2000 s", "pressure": {
        "harmonic": {"mean": "30 kPa", "amplitude": "3 kPa", "frequency": "3 Hz"}}})
    seen = []

    def stop(t):
        seen.append(t)
        if len(seen) == 3:
            raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        slow.run(progress=stop)
    assert seen == sorted(seen) and len(seen) == 3


def test_bars(case, capsys, monkeypatch):
    pytest.importorskip("tqdm")
    case.run(progress=True)
    case.sweep(axes={"inlet.orifice_radius": {"values": ["1 cm", "2 cm"]}}, quantities=["peak_stretch"], progress=True)
    shown = capsys.readouterr().err
    assert "60/60 simulated s" in shown and "1/1 done" in shown
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    with pytest.raises(turgor.MissingComponent, match="tqdm"):
        case.run(progress=True)


def test_interruption():
    """Ctrl-C while C++ computes raises KeyboardInterrupt at once."""
    script = """
import sys, turgor
case = turgor.Case.read(sys.argv[1], solve={"t_end": "1e6 s", "rtol": 1e-13, "max_steps": 100000000},
                        pressure={"harmonic": {"mean": "30 kPa", "amplitude": "3 kPa", "frequency": "3 Hz"}})
print("computing", flush=True)
try:
    case.run()
except KeyboardInterrupt:
    print("interrupted")
"""
    from conftest import CASES

    command = [sys.executable, "-c", script, str(CASES / "orifice-30mm.toml")]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout.readline() == "computing\n"
        time.sleep(0.3)
        process.send_signal(2)
        assert process.communicate(timeout=30)[0] == "interrupted\n"
