"""What a graph returns."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np


def count(number: int, noun: str, ending: str = "s") -> str:
    """Return the number with the noun, which has this ending unless there is one."""
    return f"{number} {noun}{'' if number == 1 else ending}"


class Contour(np.ndarray):
    """A contour: the array of its points, in the order in which they follow each other.

    On a surface, a closed contour repeats its first point. In a complex, `polylines` lead through the points, which are
    there once each; in tetrahedra, `triangles` do. Copies, and arrays with a point for each of its points, as
    `contour * 2`, keep its attributes.

    Attributes
    ----------
    arc : int
        The arc that the contour belongs to.
    value : float
        The value of its level.
    closed : bool
        Whether it is one closed curve; in tetrahedra, a surface without border.
    edges : (k, 2) array of int
        The lower and the higher vertex of each edge of the mesh that is crossed: point i is on edge i.
    polylines : list of arrays of int
        The lines as numbers of points.
    triangles : (l, 3) array of int
        The triangles, of a contour in tetrahedra.
    """

    arc: int
    value: float
    closed: bool
    edges: np.ndarray
    polylines: list[np.ndarray]
    triangles: np.ndarray

    @classmethod
    def _of(cls, points: np.ndarray, *attributes: Any) -> Contour:
        contour = points.view(cls)
        contour.__dict__.update(zip(cls.__annotations__, attributes))
        return contour

    def __array_finalize__(self, original: Any) -> None:
        if isinstance(original, Contour) and original.shape == self.shape:
            self.__dict__.update(original.__dict__)

    def __reduce__(self) -> tuple[Any, ...]:
        function, arguments, state = super().__reduce__()
        return function, arguments, (state, self.__dict__)

    def __setstate__(self, state: Any) -> None:
        of_array, attributes = state
        super().__setstate__(of_array)
        self.__dict__.update(attributes)

    @property
    def points(self) -> np.ndarray:
        """The points as a plain array."""
        return np.asarray(self)


@dataclass(frozen=True, repr=False)
class CriticalSet:
    """What a node stands for.

    Attributes
    ----------
    lower_contours, upper_contours : list of Contour
        For each arc below and above, its contour beside the node.
    star : array of int
        The triangles, or tetrahedra, at the vertex of the node. Where both are in a mesh, it has the faces of all
        tetrahedra behind its triangles, four for each.
    border_loop : array of int
        The vertices of the border loop that the node collapses; most often empty.
    """

    lower_contours: list[Contour]
    upper_contours: list[Contour]
    star: np.ndarray
    border_loop: np.ndarray

    def __repr__(self) -> str:
        below, above = count(len(self.lower_contours), "contour"), len(self.upper_contours)
        return f"<CriticalSet: {below} below and {above} above, star of {len(self.star)}>"


@dataclass(frozen=True, repr=False)
class Embedding:
    """A Reeb graph in space.

    Attributes
    ----------
    manner : str
        `centroids`, `on-surface`, or `straight`.
    node_points : (n, 3) array
    arc_polylines : list of (k, 3) arrays
        From the lower to the upper node of each arc.
    arc_values : list of (k,) arrays
        The value of the field at each point of them.
    """

    manner: str
    node_points: np.ndarray
    arc_polylines: list[np.ndarray]
    arc_values: list[np.ndarray]

    def __repr__(self) -> str:
        parts = f"{count(len(self.node_points), 'node')}, {count(len(self.arc_polylines), 'arc')}"
        return f"<Embedding, {self.manner}: {parts}>"


class Page(str):
    """HTML that notebooks show: a page in a frame."""

    def _repr_html_(self) -> str:
        return str(self)
