"""Every ```python block of README and docs runs, those of a page one after the other in one namespace.

A block after the comment `<!-- not run: REASON -->` does not.
"""

import os
import re
from pathlib import Path

import pytest
from conftest import CASES

ROOT = CASES.parent
BLOCK = re.compile(r"(<!-- not run: [^>]+ -->\s*)?^```python\n(.*?)^```", re.M | re.S)


def pages():
    for page in [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]:
        blocks = BLOCK.findall(page.read_text())
        if blocks:
            yield pytest.param(blocks, id=str(page.relative_to(ROOT)))


@pytest.mark.parametrize("blocks", pages())
def test_page(blocks, tmp_path, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    os.symlink(CASES, tmp_path / "cases")
    monkeypatch.chdir(tmp_path)
    namespace = {}
    for left_out, code in blocks:
        if not left_out:
            exec(compile(code, "block", "exec"), namespace)


def test_examples_in_docstrings():
    import doctest
    import importlib
    import pkgutil

    import turgor

    tried = 0
    for module in pkgutil.iter_modules(turgor.__path__, "turgor."):
        failed, count = doctest.testmod(importlib.import_module(module.name))
        assert failed == 0
        tried += count
    assert tried > 0
