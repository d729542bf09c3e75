"""What can go wrong, as exceptions."""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Issue:
    """One thing that is wrong with an input."""

    key: str  #: full name of the key or argument, such as ``inlet.orifice_radius``
    value: str  #: what was given, as written; empty when nothing was given
    problem: str  #: what is wrong with it
    advice: str  #: what is allowed, or what to try
    file: str  #: where it stands; empty outside case files
    line: int  #: line in that file, counted from 1; 0 when unknown


class InvalidInput(ValueError):
    """An input that cannot be used. ``issues`` has everything that was found, not only the first."""

    def __init__(self, message: str, issues: list[Issue] | None = None) -> None:
        super().__init__(message)
        self.issues: list[Issue] = issues or []

    def __reduce__(self) -> tuple[type[InvalidInput], tuple[str, list[Issue]]]:
        return (type(self), (str(self), self.issues))

    @property
    def keys(self) -> list[str]:
        """The keys that the issues are about."""
        return [issue.key for issue in self.issues]


class ComputationFailed(RuntimeError):
    """A computation that was well posed but could not be carried out; the text says where and with which values."""


class MissingComponent(ImportError):
    """A part of turgor that is optional and not here; the text says how to get it."""


def optional(module: str, purpose: str) -> Any:
    """A module that only some functions need.

    :raises MissingComponent: when it is not installed, with the package of Debian that has it
    """
    try:
        return importlib.import_module(module)
    except ImportError:
        package = module.split(".")[0]
        raise MissingComponent(f"{purpose} need {package} (Debian: python3-{package.lower()})") from None


def invalid(key: str, value: object, problem: str, advice: str = "") -> InvalidInput:
    """An InvalidInput with one issue, in the words of the command line."""
    shown = "" if value is None else repr(value)
    text = (key if not shown else f"{key} = {shown}") + f": {problem}" + (f"; {advice}" if advice else "")
    return InvalidInput(text, [Issue(key, shown, problem, advice, "", 0)])
