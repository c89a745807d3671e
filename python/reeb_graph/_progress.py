"""What `progress=True` shows."""

from __future__ import annotations

import sys
from typing import Any, Callable, Union

Progress = Union[bool, Callable[[float], Any], None]


def _line(name: str) -> Callable[[float], Any]:
    def show(fraction: float) -> None:
        end = "\n" if fraction >= 1 else ""
        print(f"\r{name} {100 * fraction:3.0f} %", end=end, file=sys.stderr, flush=True)

    return show


def _bar(name: str) -> Callable[[float], Any]:
    from tqdm.auto import tqdm

    bar = tqdm(total=100, desc=name, bar_format="{l_bar}{bar}| {elapsed}")

    def show(fraction: float) -> None:
        bar.update(100 * fraction - bar.n)
        if fraction >= 1:
            bar.close()

    return show


def progress_function(progress: Progress, name: str) -> Callable[[float], Any] | None:
    """Return what the extension calls with a fraction: a bar of tqdm, a line, or what is given."""
    if progress is None or progress is False:
        return None
    if progress is True:
        try:
            return _bar(name)
        except ImportError:
            return _line(name)
    if not callable(progress):
        raise TypeError(f"progress has to be True, or a function of a fraction, not {progress!r}")
    return progress
