"""Results of runs."""

from __future__ import annotations

import enum
import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from os import PathLike, fspath
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _core
from .errors import invalid, optional

if TYPE_CHECKING:
    from .case import Case

Floats = npt.NDArray[np.float64]


class Status(enum.Enum):
    """Whether a run is what was asked for."""

    COMPLETE = "complete"
    FAILED = "failed"
    INTERRUPTED = "interrupted"

    def __bool__(self) -> bool:
        return self is Status.COMPLETE


class Outcome(enum.Enum):
    """Why a run ended where it did."""

    REACHED_END = "reached-end"  #: at ``solve.t_end``
    AT_REST = "at-rest"  #: within ``solve.rest_tol`` of an equilibrium
    MAX_EVENTS = "max-events"  #: after ``solve.max_events`` changes of regime
    BURST = "burst"  #: reached ``material.max_stretch``
    RUNAWAY = "runaway"  #: nothing holds the balloon any more
    STEP_FAILED = "step-failed"  #: the step size fell below what the clock resolves
    MAX_STEPS = "max-steps"  #: more steps than ``solve.max_steps``
    INTERRUPTED = "interrupted"  #: stopped from outside
    CLOSURE_END = "closure-end"  #: reached a stretch beyond which the closure is not known


class Regime(enum.IntEnum):
    """What the balloon is doing: the sign of dR/dt."""

    DEFLATING = -1
    REST = 0
    INFLATING = 1


@dataclass(frozen=True)
class Warned:
    """An assumption of the model that a run strains, with the numbers."""

    name: str
    text: str


@dataclass(frozen=True)
class Expectation:
    """A quantity of ``[expect]`` and whether it was met."""

    quantity: str
    value: float
    tolerance: float
    found: float | None
    met: bool


@dataclass(frozen=True, repr=False)
class Events:
    """Changes of regime, where dR/dt is exactly zero; the start is none."""

    t: Floats  #: [s]
    stretch: Floats
    before: npt.NDArray[np.int_]  #: Regime
    after: npt.NDArray[np.int_]

    def __len__(self) -> int:
        return len(self.t)

    def __repr__(self) -> str:
        return f"<turgor.Events {len(self)} changes of regime>"

    def _repr_html_(self) -> str:
        return str(self.to_pandas()._repr_html_())

    def to_pandas(self) -> Any:
        """A pandas.DataFrame with a row for each."""
        return optional("pandas", "data frames").DataFrame(self.__dict__)


@dataclass(frozen=True)
class State:
    """The balloon at some times; every array has the shape of the times. SI units."""

    t: Floats
    stretch: Floats
    rate: Floats
    radius: Floats
    volume: Floats
    flow_rate: Floats
    regime: npt.NDArray[np.int_]


#: Columns of a run: unit and meaning.
COLUMNS: Mapping[str, tuple[str, str]] = MappingProxyType({
    "t": ("s", "time"),
    "stretch": ("1", "R = r/r0"),
    "rate": ("1/s", "dR/dt"),
    "radius": ("m", "r"),
    "pressure": ("Pa", "gauge, at the inlet"),
    "regime": ("1", "-1 deflating, 0 at rest, 1 inflating"),
    "volume": ("m^3", "of liquid in the balloon"),
    "flow_rate": ("m^3/s", "into the balloon"),
    "kinetic": ("J", "energy of wall and moving liquid"),
    "elastic": ("J", "energy of the wall"),
    "inlet_work": ("J", "of the inlet's gauge pressure, from the start"),
    "dissipated": ("J", "from the start"),
})


class Run:
    """What became of a case. Arrays are read-only views of the C++ results, one row for each requested time, SI units;
    quantities of interest are attributes: ``run.peak_stretch``.
    """

    _case: Case
    _native: _core.Run

    @classmethod
    def _of(cls, case: Case, native: _core.Run) -> Run:
        run = cls.__new__(cls)
        run._case = case
        run._native = native
        return run

    def __reduce__(self) -> tuple[Any, ...]:
        return (_restored, (_core.version, self._case, self._native.state()))

    @property
    def case(self) -> Case:
        """The case that was run."""
        return self._case

    @property
    def status(self) -> Status:
        """Complete, failed or interrupted."""
        return Status(self._native.status)

    @property
    def outcome(self) -> Outcome:
        """Why it ended."""
        return Outcome(self._native.outcome)

    @property
    def message(self) -> str:
        """The same for people; empty when all is well."""
        return self._native.message

    @property
    def model(self) -> str:
        """``full`` (2.22), ``orifice`` (2.23) or ``long-channel`` (2.25)."""
        return self._native.model

    @property
    def end_time(self) -> float:
        """[s]"""
        return self._native.end_time

    # Rows

    @property
    def t(self) -> Floats:
        """Times, exactly as requested [s]."""
        return self._native.t

    @property
    def stretch(self) -> Floats:
        """R = r/r0."""
        return self._native.stretch

    @property
    def rate(self) -> Floats:
        """dR/dt [1/s]."""
        return self._native.rate

    @property
    def radius(self) -> Floats:
        """r [m]."""
        return self._native.radius

    @property
    def pressure(self) -> Floats:
        """Gauge pressure at the inlet [Pa]; at a jump the new value."""
        return self._native.pressure

    @property
    def regime(self) -> npt.NDArray[np.intc]:
        """-1 deflating, 0 at rest, 1 inflating."""
        return self._native.regime

    @property
    def volume(self) -> Floats:
        """Liquid in the balloon [m^3]."""
        return self._native.volume

    @property
    def flow_rate(self) -> Floats:
        """Into the balloon, (2.1) [m^3/s]."""
        return self._native.flow_rate

    @property
    def kinetic(self) -> Floats:
        """Energy of wall and moving liquid [J]."""
        return self._native.kinetic

    @property
    def elastic(self) -> Floats:
        """Strain energy of the wall [J]."""
        return self._native.elastic

    @property
    def inlet_work(self) -> Floats:
        """Work of the inlet's gauge pressure from the start [J]."""
        return self._native.inlet_work

    @property
    def dissipated(self) -> Floats:
        """Energy lost in deflation from the start [J]."""
        return self._native.dissipated

    # Between rows

    def sol(self, t: npt.ArrayLike) -> Floats:
        """Dense output as SciPy has it: R and dR/dt [1/s] at times [s], of shape (2, ...).

        :raises InvalidInput: for times outside the run
        """
        times = np.asarray(t, float)
        return self._native.states(times.ravel())[:2].reshape(2, *times.shape)

    def at(self, t: npt.ArrayLike) -> State:
        """Everything about the balloon at times [s] within the run."""
        times = np.asarray(t, float)
        stretch, rate, radius, volume, flow_rate, regime = self._native.states(times.ravel()).reshape(6, *times.shape)
        return State(times, stretch, rate, radius, volume, flow_rate, regime.astype(int))

    @cached_property
    def events(self) -> Events:
        """Every change of regime."""
        t, stretch, before, after = self._native.events
        return Events(t, stretch, before.astype(int), after.astype(int))

    # Numbers and words

    @cached_property
    def quantities(self) -> Mapping[str, float]:
        """Quantities of interest, SI units; not a number where the run does not have one."""
        return MappingProxyType({name: value for name, (value, _) in self._native.quantities().items()})

    def __getattr__(self, name: str) -> float:
        if not name.startswith("_") and name in self.quantities:
            return self.quantities[name]
        raise AttributeError(f"a run has no {name!r}; quantities are {', '.join(self.quantities)}"
                             if not name.startswith("_") else name)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.quantities]

    @cached_property
    def warnings(self) -> list[Warned]:
        """Assumptions of the model that this run strains."""
        return [Warned(*warning) for warning in self._native.warnings()]

    @cached_property
    def expectations(self) -> list[Expectation]:
        """What ``[expect]`` asked for."""
        return [Expectation(*expectation) for expectation in self._native.expectations()]

    @property
    def statistics(self) -> Mapping[str, int]:
        """The integrator's work."""
        return self._native.statistics()

    def report(self) -> Mapping[str, Any]:
        """Everything in ``run.json``."""
        document: Mapping[str, Any] = json.loads(self._native.json())
        return document

    def summary(self, *, verbose: bool = False) -> str:
        """What ``turgor run`` prints."""
        return self._native.summary(verbose)

    def __str__(self) -> str:
        return self.summary()

    def __repr__(self) -> str:
        return f"<turgor.Run {self._case.title!r}: {self._native.outcome}, {self._native.model}>"

    def _repr_html_(self) -> str:
        from .html import run_html

        return run_html(self)

    # Elsewhere

    def to_pandas(self) -> Any:
        """The rows as a pandas.DataFrame indexed by t; its ``attrs["units"]`` has the units."""
        pandas = optional("pandas", "data frames")
        data = {name: getattr(self, name) for name in COLUMNS if name != "t"}
        frame = pandas.DataFrame(data, index=pandas.Index(self.t, name="t"))
        frame.attrs["units"] = {name: unit for name, (unit, _) in COLUMNS.items()}
        return frame

    def to_xarray(self) -> Any:
        """The rows as an xarray.Dataset along t, with units and meanings, and the case in its attributes."""
        xarray = optional("xarray", "datasets")

        def described(name: str) -> tuple[str, Any, dict[str, str]]:
            unit, meaning = COLUMNS[name]
            return ("t", getattr(self, name), {"units": unit, "long_name": meaning})

        return xarray.Dataset(
            {name: described(name) for name in COLUMNS if name != "t"},
            coords={"t": described("t")},
            attrs={"title": self._case.title, "turgor": _core.version, "outcome": self._native.outcome,
                   "model": self.model, "case": self._case.resolved},
        )

    def to_csv(self, file: str | PathLike[str] | None = None) -> str | None:
        """``trajectory.csv`` of ``turgor run``, units of ``[output]``; without a file its text is returned."""
        text = self._native.trajectory_csv()
        if file is None:
            return text
        with open(file, "w", encoding="utf-8", newline="") as stream:
            stream.write(text)
        return None

    def save(self, folder: str | PathLike[str], *, force: bool = False, pictures: bool = True) -> None:
        """Writes the run directory of ``turgor run``.

        :param force: replace an earlier run in that folder
        :param pictures: unless the case says ``output.pictures = false``
        """
        problem = self._native.save(fspath(folder), force, pictures)
        if problem:
            import warnings

            warnings.warn(problem, stacklevel=2)

    def plot(self, axes: Any = None, *, phase: bool = False) -> Any:
        """R and p against t, or dR/dt against R, in the look of the command line's pictures; returns the axes.

        :param axes: two matplotlib axes, or one for a phase picture; otherwise new ones
        :param phase: dR/dt against R
        """
        from . import plots

        return plots.phase(self, axes) if phase else plots.history(self, axes)


def _restored(version: str, case: Case, state: tuple[Any, ...]) -> Run:
    if version != _core.version:
        raise invalid("pickle", version, f"is of another version of turgor than this, {_core.version}", "run again")
    return Run._of(case, _core.restore(case._native, state))
