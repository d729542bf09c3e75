"""Parameter studies."""

from __future__ import annotations

import importlib
import tempfile
from collections.abc import Callable, Mapping
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .errors import MissingComponent, optional
from .progress import reporting

if TYPE_CHECKING:
    from .case import Case


class Sweep:
    """The result of a parameter study: an xarray.Dataset, and how it went. Variables are attributes."""

    def __init__(self, data: Any, file: str | None, facts: Mapping[str, Any]) -> None:
        self.data = data  #: xarray.Dataset, in memory
        self.file = file  #: where it was written to; None for a temporary one
        self.members: int = facts["members"]
        self.failed: int = facts["failed"]  #: members; the others went on
        self.failures: Mapping[str, int] = facts["failures"]  #: reasons and how many members had each
        self.seconds: float = facts["seconds"]  #: of computing

    def to_xarray(self) -> Any:
        """The same xarray.Dataset."""
        return self.data

    def to_pandas(self) -> Any:
        """A pandas.DataFrame with a row for each member."""
        return self.data.to_dataframe().reset_index()

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or "data" not in self.__dict__ or name not in self.data:
            raise AttributeError(name)
        return self.data[name]

    def __repr__(self) -> str:
        return f"<turgor.Sweep {self.members} members, {self.failed} failed>"

    def _repr_html_(self) -> str:
        return str(self.data._repr_html_())


def sweep(case: Case, output: str | PathLike[str] | None, resume: bool, force: bool, threads: int,
          progress: Callable[[float], object] | bool | None) -> Sweep:
    """See Case.sweep()."""
    try:
        native = importlib.import_module("turgor._sweep")
    except ImportError as error:
        raise MissingComponent(f"this turgor was built without sweeps (CMake option TURGOR_SWEEP): {error}") from None
    xarray = optional("xarray", "results of sweeps")
    source = case._native
    with tempfile.TemporaryDirectory() as folder, reporting(progress, "done", 1.0) as report:
        file = fspath(output) if output is not None else str(Path(folder, "sweep.nc"))
        facts = native.sweep(source.source, source.file, list(case._overrides), file, resume, force, threads, report)
        return Sweep(xarray.load_dataset(file), None if output is None else file, facts)
