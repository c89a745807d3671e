"""The values of a field, and the doubles that stand for them."""

from __future__ import annotations

import bisect
import math
from typing import Any

import numpy as np

from . import _arrays
from ._errors import MeshError


class Field:
    """The field as it was handed in, and `doubles`, which have its order.

    Values that no double has are kept. Their doubles are the differences to `base`, the least value, moved apart by the
    least that doubles can where two values would become one: `places` for the ascending values `levels`. In an order that
    is not that of the values, the doubles are ranks, and there are no levels.
    """

    def __init__(self, scalars: Any, order: Any) -> None:
        values = _arrays.values_array(scalars)
        self.size, self.dtype = len(values), values.dtype
        self.values: np.ndarray | None = None
        self.levels: np.ndarray | None = None
        self.base: Any = 0
        if order is None and _arrays.are_doubles(values):
            self.doubles = _arrays.settled(values)
            return
        self.values = _checked(values.copy())
        deciding = self.values if order is None else _checked(_arrays.values_array(order, "order"))
        ranks = np.unique(deciding, return_inverse=True)[1].reshape(-1)
        if len(ranks) != self.size:
            raise ValueError(f"order has {len(ranks)} ranks for {self.size} scalars")
        levels = np.empty(ranks.max(initial=-1) + 1, dtype=self.dtype)
        levels[ranks] = self.values
        if np.array_equal(levels[ranks], self.values) and np.all(levels[1:] >= levels[:-1]):
            if not _arrays.are_doubles(levels) and np.isfinite(levels).all():
                self.base = levels[0]
            self.places = _moved_apart(self._differences(levels))
            self.levels = None if np.isnan(self.places).any() else levels
        self.doubles = _arrays.settled(ranks if self.levels is None else self.places[ranks])

    def _differences(self, levels: np.ndarray) -> np.ndarray:
        if self.dtype.kind in "iu":  # they are exact in numbers that wrap
            return (levels.astype(np.uint64) - np.array(self.base).astype(np.uint64)).astype(np.float64)
        with np.errstate(over="ignore"):
            return (levels - self.base).astype(np.float64)

    def of_vertices(self, vertices: Any, doubles: np.ndarray) -> np.ndarray:
        """Return the values of vertices that have these doubles."""
        return doubles.astype(self.dtype) if self.values is None else self.values[vertices]

    def place(self, level: Any) -> float:
        """Return the double of the level just above the last value that is at most `level`."""
        if self.values is None:
            return float(level)
        if self.levels is None:
            raise ValueError("the order that was given is not that of the scalars: there are no levels of values")
        # numbers of Python compare exactly
        level = level.item() if isinstance(level, np.generic) else level
        base, key = (int(self.base), int) if self.dtype.kind in "iu" else (self.base, None)
        rank = bisect.bisect_right(self.levels, level, key=key) - 1
        if rank < 0:
            return -math.inf
        upper = self.places[rank + 1] if rank + 1 < len(self.places) else math.inf
        return min(max(float(level - base), self.places[rank]), np.nextafter(upper, -math.inf))


def _checked(values: np.ndarray) -> np.ndarray:
    if values.dtype.kind == "f" and np.isnan(values).any():
        vertex = int(np.flatnonzero(np.isnan(values))[0])
        raise MeshError(f"the scalar value of vertex {vertex} is not a number (NaN)", "vertex", vertex)
    return values


def _moved_apart(doubles: np.ndarray) -> np.ndarray:
    """Return ascending doubles, of which no two are the same; NaN where there are too few of them."""
    bits = (doubles + 0.0).view(np.int64)
    least = np.iinfo(np.int64).min
    numbers = np.where(bits < 0, least - bits, bits)  # of the doubles, ascending
    steps = np.arange(len(numbers))
    numbers = np.maximum.accumulate(numbers - steps) + steps
    return np.where(numbers < 0, least - numbers, numbers).view(np.float64)
