"""What the tests of the Python package share. The build sets PYTHONPATH, TURGOR_CASES and TURGOR_PROGRAM."""

import os
import subprocess
from pathlib import Path

import pytest

import turgor

CASES = Path(os.environ["TURGOR_CASES"])
PROGRAM = os.environ["TURGOR_PROGRAM"]


@pytest.fixture(scope="session")
def case():
    return turgor.Case.read(CASES / "orifice-30mm.toml")


@pytest.fixture(scope="session")
def run(case):
    return case.run()


@pytest.fixture
def program(tmp_path):
    """Runs `turgor ARGUMENTS` in an empty folder; returns what it prints."""

    def call(*arguments):
        command = [PROGRAM, *map(str, arguments)]
        return subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, text=True).stdout

    return call


TABLES = {
    "balloon": {"radius": "30 cm", "thickness": "3 mm", "density": "1000 kg/m^3"},
    "material": {"model": "mooney-rivlin", "s1": "1.5 MPa", "s2": "0.15 MPa"},
    "fluid": {"density": "1000 kg/m^3", "viscosity": "0.894 mPa s"},
    "inlet": {"orifice_radius": "3 cm"},
    "pressure": {"constant": "30 kPa"},
    "solve": {"t_end": "2 s"},
}


@pytest.fixture
def tables():
    return {name: dict(table) for name, table in TABLES.items()}
