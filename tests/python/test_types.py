"""The package's annotations, and those that its users see, hold by mypy."""

import shutil
import subprocess
from pathlib import Path

import pytest

import turgor

USER = """
import turgor

case = turgor.Case.read("a.toml")
run = case.run()
peak: float = run.peak_stretch
rows: int = len(run.t)
status: turgor.Status = run.status
wrong: str = run.end_time
"""


def test_mypy(tmp_path):
    program = shutil.which("mypy", path="/usr/bin")
    if program is None:
        pytest.skip("no mypy")
    package = Path(turgor.__file__).parent
    configuration = Path(__file__).parents[2] / "pyproject.toml"
    (tmp_path / "user.py").write_text(USER)
    command = [program, "--config-file", configuration, "--python-executable", "/usr/bin/python3", "--cache-dir", tmp_path]
    done = subprocess.run([*command, "-p", "turgor"], cwd=package.parent, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout
    done = subprocess.run([*command, tmp_path / "user.py"], cwd=package.parent, capture_output=True, text=True,
                          env={"MYPYPATH": str(package.parent), "PATH": "/usr/bin:/bin"})
    errors = [line for line in done.stdout.splitlines() if "error" in line and "Found" not in line]
    assert len(errors) == 1 and ':9: error: Incompatible types in assignment' in errors[0], done.stdout
