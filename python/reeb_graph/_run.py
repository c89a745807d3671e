"""How functions of the extension are run, and what `progress=True` shows."""

from __future__ import annotations

import operator
import sys
import threading
from typing import Any, Callable, Union

from . import _core
from ._errors import StoppedError

Progress = Union[bool, Callable[[float], Any], None]
TURN, PATIENCE = 0.03, 0.3  # seconds


def run(function: Any, *arguments: Any, threads: int | None = None, progress: Progress = None, name: str = "") -> Any:
    """Call a function in a thread of its own. Meanwhile, this one calls `progress`, and is where signals arrive.

    What is stopped ends when it looks for that next. This thread does not wait for it, but the interpreter does.
    """
    show = _progress_function(progress, name)
    control = _core.Run(_number_of_threads(threads))
    results: list[Any] = []
    errors: list[BaseException] = []
    ended = threading.Event()  # A signal in Thread.join() makes Python 3.11 take a running thread for one that has ended.

    def work() -> None:
        try:
            results.append(function(*arguments, control))
        except BaseException as error:
            errors.append(error)
        finally:
            ended.set()

    threading.Thread(target=work).start()
    told = -1.0
    try:
        while not ended.is_set():
            ended.wait(TURN)
            if show is not None and control.fraction > told:
                told = control.fraction
                if show(told) is False:
                    raise StoppedError("the function progress has stopped the work")
    except BaseException:
        control.stop()
        ended.wait(PATIENCE)
        raise
    if errors:
        raise errors.pop()
    if show is not None and told < 1:
        show(1.0)
    return results.pop()


def _number_of_threads(threads: int | None) -> int:
    """Return 0 for one per core."""
    if isinstance(threads, bool):
        raise TypeError(f"threads has to be an integer, not {threads!r}")
    if threads is not None and not 1 <= operator.index(threads) <= 1024:
        raise ValueError(f"threads has to be from 1 to 1024, not {threads}")
    return threads or 0


def _progress_function(progress: Progress, name: str) -> Callable[[float], Any] | None:
    """Return what is called with a fraction: a bar of tqdm, a line, or what is given."""
    if progress is None or progress is False:
        return None
    if callable(progress):
        return progress
    if progress is not True:
        raise TypeError(f"progress has to be True, or a function of a fraction, not {progress!r}")
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return lambda f: print(f"\r{name} {100 * f:3.0f} %", end="\n" * (f >= 1), file=sys.stderr, flush=True)
    bar = tqdm(total=100, desc=name, bar_format="{l_bar}{bar}| {elapsed}")

    def show(fraction: float) -> None:
        bar.update(100 * fraction - bar.n)
        if fraction >= 1:
            bar.close()

    return show
