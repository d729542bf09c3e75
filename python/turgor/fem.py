"""Finite elements from Python.

The solver is the program ``turgor-fem``, a process of its own: its libraries take most of a second to load, are not made
for several threads, and nothing that happens to them can end the interpreter.
"""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import tempfile
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _core
from .errors import ComputationFailed, InvalidInput, Issue, MissingComponent, invalid
from .reports import Columns

if TYPE_CHECKING:
    from .case import Case


def program() -> str:
    """The solver: TURGOR_FEM of the environment, the one of the same build, or the one on PATH.

    :raises MissingComponent: when there is none
    """
    built = Path(_core.__file__).resolve().parents[2] / "bin" / "turgor-fem"
    for candidate in (os.environ.get("TURGOR_FEM"), str(built), shutil.which("turgor-fem")):
        if candidate and os.access(candidate, os.X_OK):
            return candidate
    raise MissingComponent("there is no finite element solver, turgor-fem: build turgor with `./dev build fem` or the "
                           "CMake option TURGOR_FEM, and put it on PATH or its path into TURGOR_FEM")


class FemRun:
    """A run directory of ``turgor fem``, as far as it has come."""

    def __init__(self, folder: str | PathLike[str]) -> None:
        """:raises InvalidInput: when it is none"""
        self.folder = Path(folder)
        try:
            self.report: dict[str, Any] = json.loads((self.folder / "run.json").read_text())
        except (OSError, json.JSONDecodeError):
            raise invalid("folder", str(self.folder), "is no run directory of turgor fem") from None

    @property
    def status(self) -> str:
        """``complete``, ``interrupted``, ``failed``; ``running`` also when it was killed."""
        return str(self.report["status"])

    @property
    def history(self) -> Columns:
        """``history.csv``: a row for each requested time."""
        return Columns((self.folder / "history.csv").read_text())

    @property
    def solver(self) -> Columns:
        """``solver.csv``: a row for each step."""
        return Columns((self.folder / "solver.csv").read_text())

    @property
    def fields(self) -> list[Path]:
        """Fields for ParaView, in order of time."""
        return sorted(self.folder.glob("**/*.vtu"))

    def __repr__(self) -> str:
        return f"<turgor.fem.FemRun {str(self.folder)!r}: {self.status}>"


def run(case: Case, output: str | PathLike[str], *, resume: bool = False, force: bool = False,
        max_wall_time: float | None = None, pictures: bool = False) -> FemRun:
    """The case by finite elements, ``turgor fem flow`` where it dictates the motion, ``turgor fem fsi`` where not.

    Minutes to hours. Ctrl-C keeps a checkpoint, from which ``resume=True`` goes on.

    :param output: run directory
    :param resume: go on with an unfinished run
    :param force: replace an earlier run in that folder
    :param max_wall_time: stop with a checkpoint after so many seconds; the result's status is then ``interrupted``
    :param pictures: draw pictures of the fields
    :raises MissingComponent: without the solver
    :raises InvalidInput: what is wrong with case or folder
    :raises ComputationFailed: a step failed; what was computed is kept in the folder
    """
    command = [program(), "fem", "flow" if case._native.dictates_motion else "fsi"]
    with tempfile.TemporaryDirectory() as scratch:
        file = Path(scratch, "case.toml")
        file.write_text(case.resolved)
        command += [str(file), "-o", fspath(output), "--json"]
        command += [flag for flag, wanted in (("--resume", resume), ("--force", force), ("--no-pictures", not pictures))
                    if wanted]
        if max_wall_time is not None:
            command += ["--max-wall-time", repr(float(max_wall_time))]
        code, answer, words = _finish(command)
    if code == 2:
        raise _invalid(answer, words)
    if code not in (0, 130):
        raise ComputationFailed(words.strip() or f"turgor-fem ended with code {code}")
    return FemRun(output)


def _finish(command: list[str]) -> tuple[int, str, str]:
    """Runs a command; Ctrl-C goes on to it, and it may finish its step."""
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          start_new_session=True) as process:
        try:
            answer, words = process.communicate()
        except BaseException:
            process.send_signal(signal.SIGINT)
            process.communicate()
            raise
        return process.returncode, answer, words


def _invalid(answer: str, words: str) -> InvalidInput:
    try:
        issues = [Issue(**issue) for issue in json.loads(answer)["issues"]]
    except (json.JSONDecodeError, KeyError, TypeError):
        issues = []
    text = "\n".join(line.removeprefix("error: ") for line in words.strip().splitlines())
    return InvalidInput(text, issues)
