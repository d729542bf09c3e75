"""Turgor: liquid-filled hyperelastic balloons.

>>> import turgor
>>> case = turgor.Case.read("cases/orifice-30mm.toml")     # doctest: +SKIP
>>> run = case.run()                                       # doctest: +SKIP
>>> run.peak_stretch, run.t, run.stretch                   # doctest: +SKIP
"""

from . import _core, fem
from .case import SCHEMA, Case, Table
from .errors import ComputationFailed, InvalidInput, Issue, MissingComponent
from .fit import MooneyRivlinFit, fit_mooney_rivlin
from .reports import Columns, Flow, Report, coefficients
from .run import COLUMNS, Events, Outcome, Regime, Run, State, Status
from .sampling import material_table, pressure_table
from .sweep import Sweep

__version__: str = _core.version

__all__ = [
    "COLUMNS",
    "SCHEMA",
    "Case",
    "Columns",
    "ComputationFailed",
    "Events",
    "Flow",
    "InvalidInput",
    "Issue",
    "MissingComponent",
    "MooneyRivlinFit",
    "Outcome",
    "Regime",
    "Report",
    "Run",
    "State",
    "Status",
    "Sweep",
    "Table",
    "coefficients",
    "fem",
    "fit_mooney_rivlin",
    "material_table",
    "materials",
    "pressure_table",
]


def materials() -> dict[str, dict[str, object]]:
    """The material models by name: strain energy, reference, constants and their SI units."""
    return {name: {"energy": energy, "reference": reference, "constants": constants}
            for name, energy, reference, constants in _core.materials()}
