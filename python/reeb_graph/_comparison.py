"""How far shapes are from each other, and which limbs of one are limbs of the other."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np

from . import _arrays, _core
from ._graph import ReebGraph
from ._results import count
from ._run import Progress, run


@dataclass(frozen=True, repr=False)
class Comparison:
    """What `compare` finds of two graphs.

    Attributes
    ----------
    distance : float
        The bottleneck distance of the pairs of both graphs before they were simplified, in the unit of the scalars.
    by_kind : dict
        The same of each kind of pairs: `minimum-saddle`, `saddle-maximum`, `minimum-maximum`, and `loop`.
    pairs : (k, 2) array of int
        The arcs that are partners: one of the first graph, and one of the second one.
    alone : tuple of two arrays of int
        The arcs of each graph that have no partner.
    """

    distance: float
    by_kind: dict[str, float]
    pairs: np.ndarray
    alone: tuple[np.ndarray, np.ndarray]

    def __repr__(self) -> str:
        return f"<Comparison: distance {self.distance:g}, {count(len(self.pairs), 'pair')} of arcs>"


def compare(a: ReebGraph, b: ReebGraph, *, price_alone: float = 1, progress: Progress = None) -> Comparison:
    """Compare two shapes, seen by a field on each: how far they are from each other, and which arcs stand for the same.

    The scalars have to mean the same on both shapes, as the distance from the same place does: see `like_tips`. Simplify
    the graphs first; the distance is that of the graphs before.

    Parameters
    ----------
    a, b : ReebGraph
        Graphs of surfaces with points, of at most 300 arcs each.
    price_alone : float
        The price of an arc without partner: arcs that differ by more than twice of it are no partners.
    progress
        As for `compute`.

    Notes
    -----
    The distance is a pseudometric, and at most the greatest difference of two fields on one mesh: H. Edelsbrunner, J.
    Harer and others, *Extending Persistence Using Poincaré and Lefschetz Duality*, 2009. Nothing is promised of partners.
    """
    for graph in (a, b):
        _check(graph)
        if not graph.is_surface:
            raise ValueError("arcs are matched of graphs of surfaces; distances() takes all graphs")
        graph._need_points("matching arcs")
    price = _arrays.measure(price_alone, "price_alone")
    found = run(_core.compare, *_with_bases([a, b]), price, progress=progress, name="comparison")
    by_kind, pairs = dict(found[0]), np.reshape(found[1], (-1, 2))
    alone = (np.setdiff1d(np.arange(a.n_arcs), pairs[:, 0]), np.setdiff1d(np.arange(b.n_arcs), pairs[:, 1]))
    return Comparison(max(by_kind.values()), by_kind, pairs, alone)


def distances(graphs: Iterable[ReebGraph], *, progress: Progress = None) -> np.ndarray:
    """Return the distance of each graph from each, that of `compare`, as a symmetric matrix. It needs no points."""
    graphs = list(graphs)
    for graph in graphs:
        _check(graph)
    found = run(_core.distances, *_with_bases(graphs), progress=progress, name="distances")
    return np.reshape(found, (len(graphs), len(graphs)))


def like_tips(meshes: Iterable[Any], *, progress: Progress = None) -> np.ndarray:
    """Return a vertex of each mesh, such that all stand for the same place: the sources of fields to compare.

    They are the tips that are most alike to one of the first mesh. Nothing is promised of them. Meshes are pairs of
    triangles and points, or meshes as `compute` takes them: connected oriented manifold surfaces, which have tips. It is a
    ValueError if one is not connected.
    """
    taken = [_arrays.take(*(mesh if type(mesh) is tuple else (mesh,))) for mesh in meshes]
    if any(mesh.points is None for mesh in taken):
        raise ValueError("tips need points: they come behind the triangles")
    numbers = [len(mesh.points) for mesh in taken]
    arrays = [mesh.checked(number) for mesh, number in zip(taken, numbers)]
    tips = run(_core.like_tips, arrays, numbers, progress=progress, name="tips")
    if len(tips) != len(taken):
        raise ValueError("these meshes have no tips that are alike: are all connected?")
    return tips


def _check(graph: Any) -> None:
    if not isinstance(graph, ReebGraph):
        raise TypeError(f"a ReebGraph is needed, as compute() makes it, not {type(graph).__name__}")
    if graph._field.values is not None and graph._field.levels is None:
        raise ValueError("scalars in another order than that of their values have no distances")


def _with_bases(graphs: list[ReebGraph]) -> tuple[list[Any], list[float]]:
    return [graph._core for graph in graphs], [float(graph._field.base) for graph in graphs]
