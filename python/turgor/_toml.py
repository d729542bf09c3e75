"""Python values as TOML text, and keys as paths."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

import numpy as np

from .errors import InvalidInput, invalid


def _text(value: str) -> str:
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")  # which JSON allows and TOML does not


def _number(value: Any, key: str) -> str:
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, (int, np.integer)):
        if not -(2**63) <= value < 2**63:
            raise invalid(key, value, "is not a number that 64 bits hold")
        return str(int(value))
    return repr(float(value))


def _pair(value: Any) -> tuple[Any, str] | None:
    """Number and unit of ``(30, "cm")``, or of a quantity of pint."""
    if isinstance(value, tuple) and len(value) == 2 and isinstance(value[1], str) and not isinstance(value[0], str):
        return value[0], value[1]
    if hasattr(value, "magnitude") and hasattr(value, "units"):
        return value.magnitude, str(value.units)
    return None


def to_toml(value: Any, key: str = "value") -> str:
    """A value as TOML writes it: texts, numbers, ``(number, unit)``, lists, arrays and mappings of them.

    :raises InvalidInput: for anything else, with the key named
    """
    pair = _pair(value)
    if pair is not None:
        number, unit = pair
        if np.ndim(number) == 0:
            return to_toml(f"{_checked(number, key)} {unit}", key)
        return to_toml([(x, unit) for x in np.asarray(number).tolist()], key)
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, (bool, int, float, np.bool_, np.integer, np.floating)):
        return _number(value, key)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{_key(k, key)} = {to_toml(v, f'{key}.{k}')}" for k, v in value.items()) + " }"
    if isinstance(value, np.ndarray):
        if value.ndim != 1:
            raise invalid(key, value.shape, "is an array of the wrong shape", "give one with one dimension")
        value = value.tolist()
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(to_toml(v, f"{key}[{i}]") for i, v in enumerate(value)) + "]"
    raise invalid(key, value, f"is of a type that no key takes, {type(value).__name__}",
                  'write "3 cm", (3, "cm"), a number, a list or a dict')


def _checked(number: Any, key: str) -> str:
    try:
        return _number(number, key)
    except InvalidInput:
        raise
    except (TypeError, ValueError):
        raise invalid(key, number, "is not a number") from None


def _key(key: Any, path: str) -> str:
    if not isinstance(key, str):
        raise invalid(path, key, "is not a text", "keys of a table are texts")
    return key if key and key.replace("_", "").replace("-", "").isalnum() and key.isascii() else _text(key)


def document(tables: Mapping[str, Any]) -> str:
    """A case file of these tables."""
    return "".join(f"{_key(name, 'case')} = {to_toml(value, name)}\n" for name, value in tables.items())


def assignments(changes: Mapping[str, Any]) -> list[str]:
    """``--set`` for changes given as ``{"inlet.orifice_radius": "2 cm"}`` or ``{"inlet": {"orifice_radius": ...}}``.

    A mapping changes what is in it and leaves the rest of the table as it is; ``pressure`` and ``motion`` are replaced,
    since what they hold excludes one another.
    """
    out = []
    for key, value in changes.items():
        if isinstance(value, Mapping) and "." not in key and key not in _WHOLE:
            out += [f"{key}.{_key(k, key)}={to_toml(v, f'{key}.{k}')}" for k, v in value.items()]
        else:
            out.append(f"{key}={to_toml(value, key)}")
    return out


_WHOLE = ("pressure", "motion", "material", "sweep", "expect")
