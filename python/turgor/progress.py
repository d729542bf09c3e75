"""Progress of long computations: a callable, or a bar by tqdm, which knows notebooks."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from .errors import optional


@contextmanager
def reporting(progress: Callable[[float], object] | bool | None, unit: str,
              total: float) -> Iterator[Callable[[float], object] | None]:
    """What a computation calls with how far it is."""
    if progress is None or progress is False:
        yield None
    elif callable(progress):
        yield progress
    else:
        tqdm = optional("tqdm.auto", "bars of progress").tqdm
        with tqdm(total=total, unit=unit, bar_format="{l_bar}{bar}| {n:.4g}/{total:.4g} {unit} {elapsed}") as bar:
            yield lambda value: bar.update(value - bar.n)
            bar.update(total - bar.n)
