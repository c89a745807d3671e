"""What `progress=True` shows."""

from __future__ import annotations

import sys
from typing import Any, Callable, Union

Progress = Union[bool, Callable[[float], Any], None]


def progress_function(progress: Progress, name: str) -> Callable[[float], Any] | None:
    """Return what the extension calls with a fraction: a bar of tqdm, a line, or what is given."""
    if progress is None or progress is False:
        return None
    if callable(progress):
        return progress
    if progress is not True:
        raise TypeError(f"progress has to be True, or a function of a fraction, not {progress!r}")
    try:
        from tqdm.auto import tqdm
    except ImportError:
        bar = None
    else:
        bar = tqdm(total=100, desc=name, bar_format="{l_bar}{bar}| {elapsed}")

    def show(fraction: float) -> None:
        if bar is None:
            print(f"\r{name} {100 * fraction:3.0f} %", end="\n" * (fraction >= 1), file=sys.stderr, flush=True)
            return
        bar.update(100 * fraction - bar.n)
        if fraction >= 1:
            bar.close()

    return show
