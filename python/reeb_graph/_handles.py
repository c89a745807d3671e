"""Handles and tunnels."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from . import _arrays, _core
from ._functions import _give_columns, _take_columns
from ._results import count
from ._run import Progress, run


@dataclass(frozen=True, repr=False)
class Loop:
    """A loop of edges of a surface that cannot be contracted.

    Attributes
    ----------
    kind : str
        `handle` if it bounds inside, `tunnel` if it bounds outside, `hole` if it is a border, or `loop` without inside.
    length : float
    component : int
    center : (3,) array of float
        The mean of its points, by length.
    box : (2, 3) array of float
        The least and the greatest coordinates.
    vertices : (k,) array of int
        The vertices along it.
    partner : int or None
        The number of the loop that crosses it once.
    persistence : float or None
        That of a loop of the Reeb graph that belongs to the pair.
    area : float or None
        That of a disc that fills it, where one does.
    simple : bool
        Whether it passes no vertex twice.
    certain : bool
        Whether its kind is; it is not if self-intersections are ignored.
    reason : str
        Why a handle that was to be removed is still there; empty if it is not.
    """

    kind: str
    length: float
    component: int
    center: np.ndarray
    box: np.ndarray
    vertices: np.ndarray
    partner: int | None = None
    persistence: float | None = None
    area: float | None = None
    simple: bool = True
    certain: bool = True
    reason: str = ""

    def __repr__(self) -> str:
        return f"<Loop: {self.kind} of length {self.length:.6g} at {np.array2string(self.center, precision=6)}>"


def _loop(kind: str, length: float, component: int, place: Any, *others: Any, **more: Any) -> Loop:
    center, box, vertices = place
    return Loop(kind, length, component, np.array(center), np.array(box), vertices, *others, **more)


class Handles(NamedTuple):
    """What `handles` finds: loops, and how many pairs of triangles intersect."""

    loops: list[Loop]
    intersecting_pairs: int

    def __repr__(self) -> str:
        kinds = [loop.kind for loop in self.loops]
        return f"<Handles: {', '.join(count(kinds.count(kind), kind) for kind in ('handle', 'tunnel', 'hole', 'loop'))}>"


class WithoutHandles(NamedTuple):
    """What `remove_handles` leaves: a mesh, and the loops along which it has been cut, or for a reason has not."""

    triangles: np.ndarray
    points: np.ndarray
    removals: list[Loop]
    vertex_arrays: dict[str, np.ndarray]


def _take(triangles: Any, points: Any) -> _arrays.Mesh:
    mesh = _arrays.take(triangles, points)
    if mesh.points is None:
        raise ValueError("handles need points: they come behind the triangles")
    return mesh


def handles(
    triangles: Any, points: Any = None, scalars: Any = None, *, shorten: bool = True,
    ignore_self_intersections: bool = False, threads: int | None = None, progress: Progress = None,
) -> Handles:
    """Find short handles and tunnels of a surface, and where they are.

    Parameters
    ----------
    triangles : (m, 3) array of integers, or a mesh
        An oriented manifold surface.
    points : (n, 3) array
    scalars : (n,) array, or the name of data of the mesh, optional
        A field, which decides the persistence of pairs only; by default a height.
    shorten : bool
        Whether loops are made short.
    ignore_self_intersections : bool
        Whether handles are told from tunnels also where triangles intersect. It is not certain there.
    threads, progress
        As for `compute`.

    Returns
    -------
    Handles
        Pairs of a handle and a tunnel, the smallest first: `handles(triangles, points).loops[0].vertices`.
    """
    mesh = _take(triangles, points)
    values = None if scalars is None else _arrays.doubles(_arrays.scalars_of(mesh, scalars))
    number = len(mesh.points if values is None else values)
    arguments = mesh.checked(number), number, values, bool(shorten), bool(ignore_self_intersections)
    rows, pairs = run(_core.handles, *arguments, threads=threads, progress=progress, name="handles")
    return Handles([_loop(*row) for row in rows], pairs)


def remove_handles(
    triangles: Any, points: Any = None, *, below: float | str | None = None, number: int | None = None,
    vertex_arrays: Mapping[str, Any] | None = None, ignore_self_intersections: bool = False,
    threads: int | None = None, progress: Progress = None,
) -> WithoutHandles:
    """Remove small handles: cut the mesh along loops of them, and close it.

    Parameters
    ----------
    below : float or str, optional
        Handles that are smaller are removed. The size is the length of the shorter loop of a pair. `'5 %'` is a part of
        the diagonal of the box of the mesh.
    number : int, optional
        At most so many are removed, the smallest ones. One of the two is needed.
    vertex_arrays : mapping from names to arrays with n rows, optional
        Arrays that are carried over to added points, which come last.

    The other parameters are those of `handles`.

    Returns
    -------
    WithoutHandles
    """
    if below is None and number is None:
        raise ValueError("below or number is needed")
    size = below if below is None or isinstance(below, str) else float(below)
    most = _arrays.count_of(number, "number", 0)
    mesh = _take(triangles, points)
    given, columns = _take_columns(vertex_arrays, len(mesh.points))
    arguments = mesh.checked(len(mesh.points)), len(mesh.points), sum(columns.values(), []), size
    found = run(_core.remove_handles, *arguments, 2**62 if most is None else most, bool(ignore_self_intersections),
                threads=threads, progress=progress, name="removal")
    of_triangles, of_points, of_result, rows = found
    removals = [_loop(*row[:-1], reason=row[-1]) for row in rows]
    return WithoutHandles(of_triangles, of_points, removals, _give_columns(given, columns, of_result))
