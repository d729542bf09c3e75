"""How things look in a notebook."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .case import Case
    from .run import Run


def preformatted(text: str) -> str:
    return f"<pre>{escape(text)}</pre>"


def table(caption: str, rows: list[tuple[str, str]]) -> str:
    body = "".join(f"<tr><th style='text-align:left'>{escape(a)}</th><td style='text-align:left'>{escape(b)}</td></tr>"
                   for a, b in rows)
    return f"<table><caption>{escape(caption)}</caption>{body}</table>"


def case_html(case: Case) -> str:
    from .case import SCHEMA

    def shown(key: str, value: object) -> str:
        unit = SCHEMA.get(key, {}).get("unit", "1")
        return (f"{value:.9g}" if isinstance(value, float) else str(value)) + ("" if unit == "1" else f" {unit}")

    rows = [(f"{name}.{key}", shown(f"{name}.{key}", value))
            for name in ("balloon", "material", "fluid", "inlet", "model") for key, value in getattr(case, name).items()]
    return table(case.title, rows) + f"<details><summary>all keys</summary>{preformatted(case.resolved)}</details>"


def run_html(run: Run) -> str:
    units = {name: unit for name, (_, unit) in run._native.quantities().items()}
    rows = [("status", f"{run.status.value} ({run.outcome.value})"), ("model", run.model)]
    rows += [(name, f"{value:.9g}" + ("" if units[name] == "1" else f" {units[name]}"))
             for name, value in run.quantities.items() if value == value]
    rows += [("warning", warning.text) for warning in run.warnings]
    return table(run.case.title, rows)
