"""Finite elements from Python, where they are built."""

import threading
import time

import numpy as np
import pytest
from conftest import CASES

import turgor

try:
    turgor.fem.program()
except turgor.MissingComponent:
    pytest.skip("no finite element solver", allow_module_level=True)

COARSE = {"h_rim": "2 mm", "h_orifice": "6 mm", "h_wall": "24 mm", "fields": 1, "cfl": 1}


@pytest.fixture(scope="module")
def case():
    motion = {"radius": "30 cm", "velocity": [{"to": "-2 cm/s", "over": "60 ms", "shape": "smooth"}, {"hold": "40 ms"}]}
    return turgor.Case.read(CASES / "motion-orifice-30mm.toml", motion=motion, fem=COARSE, solve={"samples": 11})


@pytest.fixture(scope="module")
def finished(case, tmp_path_factory):
    return case.fem(tmp_path_factory.mktemp("fem") / "run")


def test_runs_are_read(finished):
    assert finished.status == "complete" and finished.report["discretisation"]["cells"] > 100
    assert len(finished.history["t"]) == 11 and finished.history.units["force"] == "N"
    assert np.isfinite(finished.history["force"]).all() and len(finished.solver["t"]) == finished.report["steps"]
    assert len(finished.fields) >= 1
    again = turgor.fem.FemRun(finished.folder)
    assert np.array_equal(again.history["force"], finished.history["force"])


def test_the_model_is_set_against_it(case, finished):
    """The corrected closure is known to be some 10 % below finite elements there."""
    report = case.verify(finished.folder)
    assert report.force_mode["even_deflation_ratio_minus_1"]["corrected"]["mean"] == pytest.approx(-0.1, abs=0.1)
    assert len(report.history["t"]) == 11


def test_folders_and_cases_that_do_not_fit(case, finished):
    with pytest.raises(turgor.InvalidInput, match="--force"):
        case.fem(finished.folder)
    with pytest.raises(turgor.InvalidInput) as error:
        case.replace({"fem.h_rim": "50 cm"}).fem(finished.folder.parent / "bad")
    assert any("h_rim" in key for key in error.value.keys)
    with pytest.raises(turgor.InvalidInput):
        case.replace({"motion.radius": "31 cm"}).verify(finished.folder)


def test_a_run_goes_on_to_the_same_numbers(case, finished, tmp_path):
    """Stopped by the clock after its first step, then finished."""
    part = case.replace({"fem.checkpoint_every": "0 s"}).fem(tmp_path / "part", max_wall_time=0.2)
    assert part.status == "interrupted"
    whole = case.replace({"fem.checkpoint_every": "0 s"}).fem(tmp_path / "part", resume=True)
    assert whole.status == "complete"
    # to the tolerance of the nonlinear solve, 1e-6 relative or better, unless checkpoints fall on the same steps
    assert np.allclose(whole.history["force"], finished.history["force"], rtol=1e-4)


def test_other_threads_run_meanwhile(case, tmp_path):
    worker = threading.Thread(target=lambda: case.fem(tmp_path / "run"))
    worker.start()
    ticks = 0
    while worker.is_alive():
        time.sleep(0.001)
        ticks += 1
    assert ticks > 20
