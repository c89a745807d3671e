"""The values of a field, and what stands for them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from . import _arrays


class Field:
    """The field as it was handed in, and what the extension has instead where no double has its values."""

    def __init__(self, scalars: Any, order: Any) -> None:
        values = _arrays.values_array(scalars)
        self.size = len(values)
        self.dtype = values.dtype
        self.values: np.ndarray | None = None  # only if there are ranks
        self.ranks: np.ndarray | None = None
        self.levels: np.ndarray | None = None  # the value of each rank, if they ascend
        self.base: Any = 0  # what has been taken off doubles, for which there are ranks
        if order is None and _arrays.are_doubles(values):
            self.doubles = np.ascontiguousarray(values, dtype=np.float64)
            return
        self.values = values.copy()
        self.base = self._find_base()
        with np.errstate(over="ignore"):
            if values.dtype.kind in "iu":  # differences are exact in numbers that wrap
                self.doubles = (self.values.astype(np.uint64) - np.array(self.base).astype(np.uint64)).astype(np.float64)
            else:
                self.doubles = (self.values - self.base).astype(np.float64)
        self.ranks = _arrays.ranks(self.values if order is None else _arrays.values_array(order, "order"))
        if len(self.ranks) != len(self.values):
            raise ValueError(f"order has {len(self.ranks)} ranks for {len(self.values)} scalars")
        if len(self.ranks) > 0:
            self._find_levels()

    def _find_base(self) -> Any:
        """Return what is taken off the values, so that doubles have their differences."""
        if _arrays.are_doubles(self.values) or not np.isfinite(self.values).all():
            return self.dtype.type(0)
        return self.values.min()

    def _find_levels(self) -> None:
        ranks = self.ranks.astype(np.int64)
        levels = np.empty(ranks.max() + 1, dtype=self.dtype)
        levels[ranks] = self.values
        if np.all(levels[ranks] == self.values) and np.all(levels[1:] >= levels[:-1]):
            self.levels = levels

    def rank_of(self, value: Any) -> int:
        """Return the highest rank whose value is at most `value`; -1 if there is none."""
        if self.levels is None:
            raise ValueError("the order that was given is not that of the scalars: there are no levels of values")
        if self.dtype.kind in "iu" and np.isfinite(float(value)):
            limits = np.iinfo(self.dtype)
            if math.floor(value) < limits.min:
                return -1
            value = self.dtype.type(min(math.floor(value), limits.max))
        return int(np.searchsorted(self.levels, value, side="right")) - 1

    def without_base(self, value: Any) -> float:
        if isinstance(value, np.integer):
            value = int(value)
        return float(value - (int(self.base) if self.dtype.kind in "iu" else self.base))

    def value_between(self, lower: Any, upper: Any, t: float) -> Any:
        """Return the value at the place `t`; integers are exact as long as the difference is one of double."""
        if self.dtype.kind == "f":
            return lower + self.dtype.type(t) * (upper - lower)
        return int(lower) + int(t * (int(upper) - int(lower)))
