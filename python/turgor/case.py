"""Cases: one balloon and the question asked of it."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Callable, Iterator, Mapping
from functools import cached_property
from os import PathLike, fspath
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core, _toml
from .errors import invalid
from .reports import Columns, Flow, Report, coefficients
from .run import Run

if TYPE_CHECKING:
    from .sweep import Sweep

Progress = Callable[[float], object]

#: Every key of a case: name -> type, unit, range, choices, default, required, only_with_material, meaning.
SCHEMA: Mapping[str, Mapping[str, Any]] = MappingProxyType(
    {key["key"]: MappingProxyType(key) for key in json.loads(_core.schema_json())}
)
TABLES = tuple(dict.fromkeys(key.split(".")[0] for key in SCHEMA if "." in key))


class Table(Mapping[str, Any]):
    """A table of a resolved case: ``case.balloon.radius``, SI units, defaults filled in. Read-only."""

    def __init__(self, path: str, values: Mapping[str, Any]) -> None:
        self._path = path
        self._values = values

    def __getitem__(self, name: str) -> Any:
        return _in_si(f"{self._path}.{name}", self._values[name])

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        try:
            return self[name]
        except KeyError:
            known = ", ".join(self._values)
            raise AttributeError(f"{self._path}.{name}: this case has no such key; it has {known}") from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._values]

    def __repr__(self) -> str:
        return f"{self._path}({', '.join(f'{name}={self[name]!r}' for name in self)})"


def _in_si(path: str, value: Any) -> Any:
    if isinstance(value, Mapping):
        return Table(path, value)
    key = SCHEMA.get(path)
    if key is None or not str(key["type"]).endswith(("quantity", "quantities")):
        return value
    if isinstance(value, list):
        return [_in_si(path, item) for item in value]
    try:
        return float(str(value).split(" ", 1)[0])
    except ValueError:  # a word in place of a number
        return value


class Case:
    """One balloon and the question asked of it. A case never changes; ``replace`` makes another one.

    Tables are mappings of what a case file holds. Quantities have a unit: ``"3 cm"`` or ``(3, "cm")``; arrays and lists
    take ``(array, "s")``.

    :raises InvalidInput: with every issue that could be found, as ``turgor validate`` has them

    >>> case = Case(
    ...     balloon={"radius": "30 cm", "thickness": "3 mm", "density": "1000 kg/m^3"},
    ...     material={"model": "mooney-rivlin", "s1": "1.5 MPa", "s2": "0.15 MPa"},
    ...     fluid={"density": "1000 kg/m^3", "viscosity": "0.894 mPa s"},
    ...     inlet={"orifice_radius": "3 cm"},
    ...     pressure={"constant": "30 kPa"},
    ...     solve={"t_end": (2, "s")},
    ... )
    >>> case.inlet.orifice_radius
    0.03
    >>> round(case.run().peak_stretch, 6)
    1.273579
    """

    _native: _core.Case
    _overrides: tuple[str, ...]

    def __init__(self, **tables: Any) -> None:
        self._set(_toml.document(tables), "", ())

    @classmethod
    def read(cls, file: str | PathLike[str], **changes: Any) -> Case:
        """A case file, with changes as in ``replace``."""
        case = cls.__new__(cls)
        overrides = tuple(_toml.assignments(changes))
        case._native = _core.read_case(fspath(file), list(overrides))
        case._overrides = overrides
        return case

    @classmethod
    def parse(cls, text: str, file: str | PathLike[str] = "") -> Case:
        """The text of a case file; relative file names in it start from ``file``'s folder."""
        case = cls.__new__(cls)
        case._set(text, fspath(file), ())
        return case

    def replace(self, changes: Mapping[str, Any] | None = None, /, **tables: Any) -> Case:
        """This case with other values: ``replace({"inlet.orifice_radius": "2 cm"})``, ``replace(solve={"rtol": 1e-11})``.

        A table changes what is in it and leaves its other keys as they are, but ``pressure``, ``motion``, ``material``,
        ``sweep`` and ``expect``, which are replaced as a whole.
        """
        case = type(self).__new__(type(self))
        overrides = (*self._overrides, *_toml.assignments({**(changes or {}), **tables}))
        case._set(self._native.source, self._native.file, overrides)
        return case

    def _set(self, text: str, file: str, overrides: tuple[str, ...]) -> None:
        self._native = _core.parse_case(text, file, list(overrides))
        self._overrides = overrides

    def __reduce__(self) -> tuple[Any, ...]:
        return (_restored, (self._native.source, self._native.file, self._overrides))

    def __eq__(self, other: object) -> bool:
        """Whether both resolve to the same balloon and question."""
        return isinstance(other, Case) and self._native.resolved == other._native.resolved

    def __hash__(self) -> int:
        return hash(self._native.resolved)

    # What it says

    @property
    def title(self) -> str:
        """Shown in pictures and summaries."""
        return self._native.title

    @property
    def resolved(self) -> str:
        """The case as TOML, defaults filled in, SI units; running it again gives the same results."""
        return self._native.resolved

    @cached_property
    def _tables(self) -> Mapping[str, Any]:
        return MappingProxyType(tomllib.loads(self._native.resolved))

    def __getattr__(self, name: str) -> Any:
        if name in TABLES and "_native" in self.__dict__:
            return Table(name, self._tables.get(name, {}))
        raise AttributeError(f"a case has no {name!r}; its tables are {', '.join(TABLES)}")

    def __getitem__(self, key: str) -> Any:
        """The value of a key such as ``"inlet.orifice_radius"``, SI units."""
        value: Any = self._tables
        for name in key.split("."):
            if not isinstance(value, Mapping) or name not in value:
                raise KeyError(f"{key}: this case has no such key")
            value = value[name]
        return _in_si(key, value)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *TABLES]

    def __repr__(self) -> str:
        return f"<turgor.Case {self.title!r}>"

    def _repr_html_(self) -> str:
        from .html import case_html

        return case_html(self)

    def pressure_at(self, t: Any) -> Any:
        """Gauge pressure [Pa] of the program at times [s]."""
        return self._native.pressure(t)

    # Questions

    def run(self, *, progress: Progress | bool | None = None) -> Run:
        """Simulates the case, as ``turgor run``. Other threads run meanwhile; Ctrl-C raises KeyboardInterrupt.

        :param progress: called now and then with the simulated time [s]; True shows a bar (with tqdm)
        """
        from .progress import reporting

        with reporting(progress, "simulated s", self._native.t_end) as report:
            return Run._of(self, _core.run(self._native, report))

    def info(self) -> Report:
        """Dimensionless groups, limit points, equilibria, time constants, strained assumptions."""
        return Report(*_core.info(self._native))

    def statics(self, *, over: str | list[str] | None = None, compliance: Any = None) -> Report:
        """The balloon at rest: equilibria, limit points, bistable pressures, barriers, jumps.

        ``.curve`` has the columns of p0(R), ``.branches`` those of curves over keys.

        :param over: one key or two with a range: ``"material.s1=1 MPa:2 MPa"``
        :param compliance: of the supply that fills the balloon, such as ``"2e-8 m^3/Pa"``; 0: its volume is prescribed
        """
        keys = [over] if isinstance(over, str) else list(over or [])
        given = _argument("compliance", compliance, "m^3/Pa")
        if given is not None and given < 0:
            raise invalid("compliance", compliance, "out of range", "allowed is >= 0 m^3/Pa")
        document, text, curve, branches = _core.statics(self._native, keys, given)
        return Report(document, text, curve=curve, branches=branches)

    def asymptotics(self, *, start: float | None = None) -> Report:
        """The closed approximations of section 3 at the final pressure, with their errors.

        :param start: stretch from which the balloon deflates
        """
        return Report(*_core.asymptotics(self._native, start))

    def portrait(self, *, pressure: Any = None, stretches: tuple[float, float] | None = None,
                 rates: tuple[float, float] | None = None) -> Report:
        """Phase portrait at one pressure; ``.curves`` has columns curve, kind, R, dR/dt.

        :param pressure: gauge, with its unit; otherwise the case's at ``solve.t_end``
        :param stretches: least and greatest stretch to show
        :param rates: dR/dt to show [1/s], the first negative
        """
        low, high = stretches or (0.0, 0.0)
        if stretches and not 0 < low < high:
            raise invalid("stretches", stretches, "is not a range of positive stretches", "write (0.9, 2)")
        down, up = rates or (0.0, 0.0)
        if rates and not down < 0 < up:
            raise invalid("rates", rates, "must have 0 inside", "write (-0.01, 200), in 1/s")
        given = _argument("pressure", pressure, "Pa")
        document, text, curves = _core.portrait(self._native, given, (low, high, -down, up))
        return Report(document, text, curves=curves)

    def flow(self, *, stretch: float, rate: float, acceleration: float | None = None, pressure: Any = None,
             time: float = 0.0, profile: str | PathLike[str] = "") -> Flow:
        """The flow inside the deflating balloon at one instant.

        :param stretch: R
        :param rate: dR/dt [1/s], negative
        :param acceleration: d2R/dt2 [1/s^2]; otherwise by the equation of motion
        :param pressure: gauge, at the inlet, with its unit; otherwise the program's at ``time`` [s]
        :param profile: file of an outflow profile; otherwise uniform
        """
        given = _argument("pressure", pressure, "Pa")
        return Flow(_core.flow(self._native, stretch, rate, time, acceleration, given, fspath(profile)), stretch, rate)

    def coefficients(self, stretches: Any = 1.0, *, profile: str | PathLike[str] = "", harmonics: int = 0) -> Columns:
        """g1 ... g5 of the liquid's force (2.8) on this balloon at stretches R: kappa = r_ch/(r0 R).

        See :func:`turgor.coefficients` for the parameters.
        """
        kappas = self.inlet.orifice_radius / (self.balloon.radius * np.atleast_1d(np.asarray(stretches, float)))
        return coefficients(kappas, profile=profile, harmonics=harmonics)

    def force(self) -> Report:
        """The force of the liquid where the case dictates the motion; ``.history`` has its columns."""
        document, text, history = _core.force(self._native)
        return Report(document, text, history=history)

    def sweep(self, output: str | PathLike[str] | None = None, *, resume: bool = False, force: bool = False,
              threads: int = 0, progress: Progress | bool | None = None, **settings: Any) -> Sweep:
        """Runs the parameter study of the case's ``[sweep]`` table, or of one given here: ``sweep(axes={...})``.

        :param output: NetCDF file; otherwise a temporary one that is read and removed
        :param resume: go on with an unfinished sweep
        :param force: replace an earlier result
        :param threads: 0: one for each core
        :param progress: called now and then with the share done; True shows a bar (with tqdm)
        :raises MissingComponent: when turgor was built without sweeps
        """
        from .sweep import sweep

        case = self.replace(sweep=settings) if settings else self
        return sweep(case, output, resume, force, threads, progress)

    def fem(self, output: str | PathLike[str], **options: Any) -> Any:
        """Finite elements, see :func:`turgor.fem.run`."""
        from . import fem

        return fem.run(self, output, **options)

    def verify(self, folder: str | PathLike[str]) -> Report:
        """The model against finite elements, a folder of ``fem()`` or ``turgor fem``; ``.history`` has the columns."""
        document, text, history = _core.verify(self._native, fspath(folder))
        return Report(document, text, history=history)


def _restored(text: str, file: str, overrides: tuple[str, ...]) -> Case:
    case = Case.__new__(Case)
    case._set(text, file, overrides)
    return case


def _argument(name: str, value: Any, unit: str) -> float | None:
    """A quantity given to a function, in SI units."""
    if value is None:
        return None
    text = _toml.to_toml(value, name)
    return _core.parse_argument(name, json.loads(text) if text.startswith('"') else text, unit)
