"""Answers that are documents: a mapping, the text of the command line, and tables as columns."""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Iterator, Mapping
from os import PathLike
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from .errors import invalid, optional


class Columns(Mapping[str, "npt.NDArray[Any]"]):
    """A table by its columns: ``columns["R"]``, with the units of its header in ``units``."""

    def __init__(self, text: str) -> None:
        rows = csv.reader(io.StringIO(text))
        headers = [re.fullmatch(r"(.*?)(?: \[(.*)\])?", header) for header in next(rows)]
        body = list(rows)
        self.units = {h[1]: h[2] or "1" for h in headers if h}
        self._columns = {name: _array([row[i] for row in body]) for i, name in enumerate(self.units)}

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        if name not in self._columns:
            raise KeyError(f"{name}: there is no such column; there are {', '.join(self)}")
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __repr__(self) -> str:
        rows = len(next(iter(self._columns.values()), ()))
        return f"<turgor.Columns {', '.join(self)}: {rows} rows>"

    def to_pandas(self) -> Any:
        """A pandas.DataFrame; its ``attrs["units"]`` has the units."""
        frame = optional("pandas", "data frames").DataFrame(self._columns)
        frame.attrs["units"] = self.units
        return frame

    def _repr_html_(self) -> str:
        return str(self.to_pandas()._repr_html_())


def _array(texts: list[str]) -> npt.NDArray[Any]:
    try:
        return np.array([float(text) if text else np.nan for text in texts])
    except ValueError:
        return np.array(texts)


class Report(Mapping[str, Any]):
    """What a question was answered with. A mapping of the command's JSON document; ``str()`` is its text."""

    def __init__(self, document: str, text: str, **tables: str) -> None:
        self._document: Any = json.loads(document)
        self._text = text
        self._tables = tables
        self._parsed: dict[str, Columns] = {}

    def __getitem__(self, key: str) -> Any:
        return self._document[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._document)

    def __len__(self) -> int:
        return len(self._document)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        if self._tables.get(name):
            return self._parsed.setdefault(name, Columns(self._tables[name]))
        if isinstance(self._document, dict) and name in self._document:
            return self._document[name]
        known = ", ".join([*self, *(table for table in self._tables if self._tables[table])])
        raise AttributeError(f"this report has no {name!r}; it has {known}")

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self, *self._tables]

    def __str__(self) -> str:
        return self._text

    def __repr__(self) -> str:
        return f"<turgor.Report {', '.join(self)}>"

    def _repr_html_(self) -> str:
        from .html import preformatted

        return preformatted(self._text)

    def __reduce__(self) -> tuple[Any, ...]:
        return (_restored, (json.dumps(self._document), self._text, self._tables))


def _restored(document: str, text: str, tables: dict[str, str]) -> Report:
    return Report(document, text, **tables)


class Flow:
    """The flow inside a deflating balloon at one instant."""

    def __init__(self, core: _core.Flow, stretch: float, rate: float) -> None:
        self._native = core
        self.stretch = stretch  #: R
        self.rate = rate  #: dR/dt [1/s]

    def fields(self, r: npt.ArrayLike, z: npt.ArrayLike) -> dict[str, npt.NDArray[np.float64]]:
        """``v_r``, ``v_z`` [m/s], gauge ``pressure`` [Pa] and ``potential`` [m^2/s] at points.

        Not a number outside the balloon and on the rim.

        :param r: distances from the axis [m]
        :param z: heights above the balloon's centre [m], the orifice at negative ones; of the same shape as r
        """
        radial, axial = np.asarray(r, float), np.asarray(z, float)
        if radial.shape != axial.shape:
            raise invalid("z", axial.shape, f"has not the shape of r, {radial.shape}", "give one z for each r")
        values = self._native.fields(radial.ravel(), axial.ravel())
        names = ("v_r", "v_z", "pressure", "potential")
        return {name: column.reshape(radial.shape) for name, column in zip(names, values)}

    def wall(self) -> dict[str, npt.NDArray[np.float64]]:
        """``theta`` [rad], ``s``, ``r``, ``z`` [m], gauge ``pressure`` [Pa], ``velocity`` [m/s] along the wall."""
        return dict(zip(("theta", "s", "r", "z", "pressure", "velocity"), self._native.wall()))

    def report(self, resolution: int = 200) -> Report:
        """What ``turgor flow`` says: the instant, the orifice, forces, profile, mesh."""
        return Report(self._native.json(resolution), self._native.summary())

    def to_vtu(self, file: str | PathLike[str], resolution: int = 200) -> None:
        """Writes the fields for ParaView.

        :param resolution: cells of the mesh in each direction
        """
        with open(file, "w", encoding="utf-8") as stream:
            stream.write(self._native.vtu(resolution))

    def __repr__(self) -> str:
        return f"<turgor.Flow at R = {self.stretch}, dR/dt = {self.rate} 1/s>"


def coefficients(kappas: npt.ArrayLike, *, profile: str | PathLike[str] = "", harmonics: int = 0) -> Columns:
    """g1 ... g5 of the liquid's force (2.8) against kappa = r_ch/r, exact and by the paper's fits.

    :param profile: file of an outflow profile; otherwise uniform
    :param harmonics: also the paper's sums, truncated after so many harmonics
    """
    from os import fspath

    values = np.atleast_1d(np.asarray(kappas, float))
    if values.ndim != 1:
        raise invalid("kappas", values.shape, "is an array of the wrong shape", "give one with one dimension")
    if not 0 <= harmonics <= 10_000_000:
        raise invalid("harmonics", harmonics, "out of range", "allowed is 0 to 10000000")
    return Columns(_core.coefficients(values.tolist(), fspath(profile), harmonics)[2])
