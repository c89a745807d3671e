"""Scalar fields, and curves that cut a surface."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from . import _arrays, _core
from ._results import count
from ._run import Progress, run

LEVEL_BORDERS = "with level borders"


def _vertex_numbers(given: Any, name: str) -> list[int]:
    array = np.atleast_1d(_arrays.numbers(given, name, "iu", "integers, the numbers of vertices"))
    if array.ndim > 1 or np.any(array < 0):
        raise ValueError(f"{name} are the numbers of vertices, from 0, not {given!r}")
    return array.astype(int).tolist()


def _is_left(unreached: str) -> bool:
    return _arrays.one_of(unreached, ("error", "nan"), "unreached") == "nan"


def _field(
    name: str, mesh: _arrays.Mesh, threads: Any = None, progress: Any = None, scalars: Any = None, **settings: Any
) -> np.ndarray:
    if mesh.points is None and name != LEVEL_BORDERS:
        raise ValueError(f"the field {name} needs points: they come behind the triangles")
    options = _core.FieldOptions()
    for key, value in {"field": name, **settings}.items():
        setattr(options, key, value)
    scalars = None if scalars is None else _arrays.doubles(_arrays.scalars_of(mesh, scalars))
    number = len(mesh.points if scalars is None else scalars)
    return run(_core.field, mesh.checked(number), number, options, scalars, threads=threads, progress=progress, name=name)


def harmonic(
    triangles: Any, points: Any = None, *, minimum: int | None = None, maximum: int | None = None,
    weights: str = "mean-value", between_borders: bool = False, unreached: str = "error", threads: int | None = None,
    progress: Progress = None,
) -> np.ndarray:
    """Compute a harmonic field: on each component it has one minimum, one maximum, and no other extremum.

    Parameters
    ----------
    triangles : (m, 3) array of integers, or a mesh
        An oriented manifold surface, or a mesh that `mesh_arrays` takes.
    points : (n, 3) array
    minimum, maximum : int, optional
        The vertices of least and greatest value, 0 and 1, both or none of them; by default two that are far apart.
    weights : {'mean-value', 'cotangent', 'uniform'}
    between_borders : bool
        Whether the borders are the extrema instead.
    unreached : {'error', 'nan'}
        What components without `minimum` and `maximum` are.
    threads, progress
        As for `compute`, here and below.

    Returns
    -------
    (n,) array of float

    Notes
    -----
    M. S. Floater, *Mean value coordinates*, 2003.
    """
    if (minimum is None) != (maximum is None):
        raise ValueError("minimum and maximum go together")
    settings: dict[str, Any] = {"weights": _arrays.one_of(weights, ("mean-value", "cotangent", "uniform"), "weights")}
    if minimum is not None:
        settings["minimum"], settings["maximum"] = _vertex_numbers([minimum, maximum], "minimum and maximum")
        settings["unreached_left"] = _is_left(unreached)
    name = "harmonic-between-borders" if between_borders else "harmonic"
    return _field(name, _arrays.take(triangles, points), threads, progress, **settings)


def poisson(
    triangles: Any, points: Any = None, *, sources: Any = (), unreached: str = "error", threads: int | None = None,
    progress: Progress = None,
) -> np.ndarray:
    """Compute the field whose Laplacian is the mean curvature.

    The parameters and the result are those of `geodesic`, but for edges and tetrahedra.
    """
    mesh = _arrays.take(triangles, points)
    return _field("poisson", mesh, threads, progress, sources=_vertex_numbers(sources, "sources"),
                  unreached_left=_is_left(unreached))


def unit_gradient(
    triangles: Any, points: Any = None, scalars: Any = None, *, threads: int | None = None, progress: Progress = None
) -> np.ndarray:
    """Compute a field whose gradient has about unit length, with about the level sets of another one.

    That is `scalars`, by default the harmonic field. The other parameters are those of `harmonic`.
    """
    return _field("unit-gradient", _arrays.take(triangles, points), threads, progress, scalars)


def geodesic(
    triangles: Any, points: Any = None, *, sources: Any = (), edges: Any = None, tetrahedra: Any = None,
    unreached: str = "error", threads: int | None = None, progress: Progress = None,
) -> np.ndarray:
    """Compute the distance on the surface from vertices; along edges, if the mesh is not an oriented manifold surface.

    Parameters
    ----------
    triangles : (m, 3) array of integers, or a mesh
    points : (n, 3) array
    sources : int or sequence of int
        The vertices where it is 0; by default one in each component, far from another one.
    edges, tetrahedra : arrays of integers, optional
    unreached : {'error', 'nan'}
        What components without a source are.

    Returns
    -------
    (n,) array of float
        In units of length.

    Notes
    -----
    By a marching front: M. Novotni, R. Klein, *Computing Geodesic Distances on Triangular Meshes*, 2002.
    """
    mesh = _arrays.take(triangles, points, edges, tetrahedra)
    return _field("geodesic", mesh, threads, progress, sources=_vertex_numbers(sources, "sources"),
                  unreached_left=_is_left(unreached))


def height(triangles: Any, points: Any = None, direction: Any = (0, 0, 1)) -> np.ndarray:
    """Compute the height of each vertex along a direction of any length but 0, in units of length.

    The triangles, or None, play no role: they are there for meshes in their place.
    """
    _arrays.refuse_mask(direction, "coordinate")
    vector = np.asarray(direction, dtype=np.float64)
    if vector.shape != (3,):
        raise ValueError(f"the direction has three coordinates, not the shape {vector.shape}")
    mesh = _arrays.Mesh(None, _arrays.take(triangles, points).points)
    return _field("height", mesh, direction=vector.tolist())


def make_borders_level(
    triangles: Any, scalars: Any, points: Any = None, *, threads: int | None = None, progress: Progress = None
) -> np.ndarray:
    """Return a field that is changed so that each border lies in one level, and is an extremum.

    That is what functions that cut need, which do it by default. The points play no role.
    """
    return _field(LEVEL_BORDERS, _arrays.take(triangles, points), threads, progress, scalars)


class Repaired(NamedTuple):
    """What `repair` makes of a mesh: triangles, points, and in `map` the new number of each given point, -1 for none."""

    triangles: np.ndarray
    points: np.ndarray
    map: np.ndarray


def repair(
    triangles: Any, points: Any = None, *, merge: bool = False, merge_within: float | None = None,
    stitch: float | str | None = None, cancel_opposite: bool = False, split: bool = False, orient: bool = False,
    least_piece: float = 0, fill: int = 0, largest: bool = False, unused: bool = False, all: bool = False, threads: int | None = None, progress: Progress = None,
) -> Repaired:
    """Leave out triangles with a repeated corner and repeated ones, and do more if asked to, in the order of parameters.

    Parameters
    ----------
    triangles : (m, 3) array of integers, or a mesh
        Of a mesh with tetrahedra, their border is taken.
    points : (n, 3) array
    merge : bool
        Whether points that coincide become one, unless an edge would get more than two triangles, or a point several fans
        of them.
    merge_within : float, optional
        Points of border edges that are at most so far apart become one: each joins the nearest one before it that has
        joined none, never in chains. The one with the lowest number stays.
    stitch : float or str, optional
        Borders are joined, also where points of one lie on edges of the other: points of borders that are at most so far
        apart become one, and edges of borders are cut at points of borders that are at most so far from them. A length, or,
        as "0.1%", a share of the diagonal of the box.
    cancel_opposite : bool
        Whether triangles with the same corners cancel each other one by one, one way round against the other. Where a whole
        component would go, one side of it stays.
    split : bool
        Whether triangles are paired at edges with more than two, and the mesh is cut open at those that are left, at
        vertices with several fans, and where no orientation agrees. Points that are added come last.
    orient : bool
        Whether triangles are reversed so that neighbors agree, and solids that are inside out are turned, with what lies
        in them.
    least_piece : float
        The share of the area from which on components stay. If it is not 0, closed ones go, too, that have no inside.
    fill : int
        Borders of at most so many edges are filled, as by CGAL.
    largest : bool
        Whether only the component with the most triangles stays.
    unused : bool
        Whether points of no triangle are left out.
    all : bool
        The same as `merge`, `cancel_opposite`, `split`, `orient` and `unused`.
    threads, progress
        As for `compute`.

    Returns
    -------
    Repaired
        Its `map` brings what is known of old points to new ones: `new[map[map >= 0]] = old[map >= 0]`.
    """
    mesh = _arrays.take(triangles, points)
    if mesh.points is None:
        raise ValueError("repair needs points: they come behind the triangles")
    if merge and merge_within is not None:
        raise ValueError("merge and merge_within do not go together")
    distance = None if merge_within is None else float(merge_within)
    fill = _arrays.count_of(fill, "fill", 0)
    stitch = stitch if stitch is None or isinstance(stitch, str) else float(stitch)
    options = _core.RepairOptions(bool(merge or all), distance, stitch, bool(cancel_opposite or all), bool(split or all),
                                  bool(orient or all), float(least_piece), fill, bool(largest), bool(unused or all))
    result = run(_core.repair, mesh.checked(len(mesh.points)), len(mesh.points), options, threads=threads, progress=progress, name="repair")
    return Repaired(*result)


@dataclass(frozen=True, repr=False)
class Cut:
    """A surface that has been cut along curves, which run along edges of it.

    Attributes
    ----------
    points : (n, 3) array of float
        Those that were handed in come first.
    triangles : (m, 3) array of int
    patches : (m,) array of int
        The piece of each triangle, from 0.
    curves : list of (k, 3) arrays
        The points of each curve; the first one is the last one again.
    scalars : (n,) array of float
        The field at each point.
    vertex_arrays : dict of arrays
        Those that were handed in, interpolated at points that have been added, in their dtype.
    bands : (m,) array of int, or None
        Of levels: how many of them are below the highest corner of each triangle.
    curve_values, curve_arcs, curve_closed : arrays, one number for each curve, or None
        Of levels: the value of each curve, the arc of `compute(cut.triangles, cut.scalars)` next to it, on the higher
        side if there is one, or -1 inside of a plateau, and whether it is closed.
    original : (n,) array of int, or None
        Of disks: the point that was handed in of which each one is a copy.
    """

    points: np.ndarray
    triangles: np.ndarray
    patches: np.ndarray
    curves: list[np.ndarray]
    scalars: np.ndarray
    vertex_arrays: dict[str, np.ndarray] = field(default_factory=dict)
    bands: np.ndarray | None = None
    curve_values: np.ndarray | None = None
    curve_arcs: np.ndarray | None = None
    curve_closed: np.ndarray | None = None
    original: np.ndarray | None = None

    @property
    def n_patches(self) -> int:
        return int(self.patches.max(initial=-1)) + 1

    def __repr__(self) -> str:
        size = f"{len(self.points)} points, {len(self.triangles)} triangles"
        return f"<Cut: {size}, {count(self.n_patches, 'patch', 'es')}, {count(len(self.curves), 'curve')}>"


def _columns(array: np.ndarray, name: str, number: int) -> list[np.ndarray]:
    """Return what a vertex array has for the vertices, each number of it as an array of doubles."""
    if array.ndim == 0 or len(array) != number:
        raise ValueError(f"the vertex array {name!r} has the shape {array.shape} for {number} vertices")
    table = array.reshape(number, int(np.prod(array.shape[1:])))
    return [_arrays.doubles(column, f"the vertex array {name!r}") for column in table.T]


def _of_columns(columns: list[np.ndarray], like: np.ndarray) -> np.ndarray:
    table = np.stack(columns, axis=-1).reshape(-1, *like.shape[1:])
    return (np.rint(table) if like.dtype.kind in "iub" else table).astype(like.dtype)


def _take_columns(vertex_arrays: Any, number: int) -> tuple[dict[str, np.ndarray], dict[str, list[np.ndarray]]]:
    for array in (vertex_arrays or {}).values():
        _arrays.refuse_mask(array, "vertex")
    given = {name: np.asarray(array) for name, array in (vertex_arrays or {}).items()}
    return given, {name: _columns(array, name, number) for name, array in given.items()}


def _give_columns(given: dict[str, np.ndarray], columns: dict[str, list[np.ndarray]], of_result: Any) -> dict[str, Any]:
    rest = iter(of_result)
    return {name: _of_columns([next(rest) for _ in columns[name]], array) for name, array in given.items()}


def _cut(
    kind: Any, triangles: Any, scalars: Any, points: Any, vertex_arrays: Any, borders: str, cut_open: bool,
    max_triangles: int | None, threads: int | None, progress: Progress, *, persistence: Any = None, area: Any = None,
) -> Cut:
    manners = _core.Borders.__members__
    persistence, area = _arrays.measure(persistence, "persistence"), _arrays.measure(area, "area")
    manner = manners[_arrays.one_of(borders, manners, "borders")]
    options = _core.CutOptions(kind, persistence, area, bool(cut_open), manner)
    max_triangles = _arrays.count_of(max_triangles, "max_triangles", 1)
    mesh = _arrays.take(triangles, points)
    if mesh.points is None:
        raise ValueError("to cut a surface needs its points: they come behind the scalars")
    values = _arrays.doubles(_arrays.scalars_of(mesh, scalars))
    given, columns = _take_columns(vertex_arrays, len(values))
    arguments = mesh.checked(len(values)), values, sum(columns.values(), []), options, max_triangles or 2**62
    *found, of_result = run(_core.cut, *arguments, threads=threads, progress=progress, name="cut")
    return Cut(*found, _give_columns(given, columns, of_result))


def cutting_system(
    triangles: Any, scalars: Any, points: Any = None, *, vertex_arrays: Mapping[str, Any] | None = None,
    borders: str = "make-level", cut_open: bool = False, max_triangles: int | None = None, threads: int | None = None,
    progress: Progress = None,
) -> Cut:
    """Find curves along which a surface is cut to genus 0: one for each handle.

    Parameters
    ----------
    triangles : (m, 3) array of integers, or a mesh
        An oriented manifold surface.
    scalars : (n,) array, or the name of data of the mesh
    points : (n, 3) array
    vertex_arrays : mapping from names to arrays with n rows, optional
        Arrays that are interpolated at added points.
    borders : {'make-level', 'level'}
        Whether the field is changed so that borders are levels, or it is an error if they are not.
    cut_open : bool
        Whether the surface is cut open along the curves, so that their points are there twice.
    max_triangles : int, optional
        It is an error if the cut surface would have more.
    threads, progress
        As for `compute`.

    Returns
    -------
    Cut
    """
    options = vertex_arrays, borders, cut_open, max_triangles, threads, progress
    return _cut(_core.Curves.cutting_system, triangles, scalars, points, *options)


def pants(
    triangles: Any, scalars: Any, points: Any = None, *, vertex_arrays: Mapping[str, Any] | None = None,
    borders: str = "make-level", cut_open: bool = False, max_triangles: int | None = None, threads: int | None = None,
    progress: Progress = None,
) -> Cut:
    """Cut a surface into pairs of pants, spheres with three holes.

    The parameters and the result are those of `cutting_system`. A sphere, disk, annulus, or torus has no such cut, which
    is a ValueError.
    """
    options = vertex_arrays, borders, cut_open, max_triangles, threads, progress
    return _cut(_core.Curves.pants, triangles, scalars, points, *options)


def branches(
    triangles: Any, scalars: Any, points: Any = None, *, persistence: float | None = None, area: float | None = None,
    vertex_arrays: Mapping[str, Any] | None = None, borders: str = "make-level", cut_open: bool = False,
    max_triangles: int | None = None, threads: int | None = None, progress: Progress = None,
) -> Cut:
    """Cut the branches off a surface, where they begin.

    Those with values that differ by less than `persistence`, or of less area than `area`, are left out. There is no
    'auto': `ReebGraph.counts` has thresholds that matter. The other parameters and the result are those of
    `cutting_system`.
    """
    options = vertex_arrays, borders, cut_open, max_triangles, threads, progress
    return _cut(_core.Curves.branches, triangles, scalars, points, *options, persistence=persistence, area=area)


def cut_along_levels(
    triangles: Any, scalars: Any, points: Any = None, *, level: Any = None, levels: Any = None,
    spacing: float | None = None, vertex_arrays: Mapping[str, Any] | None = None, cut_open: bool = False,
    max_triangles: int | None = None, threads: int | None = None, progress: Progress = None,
) -> Cut:
    """Cut a surface where the scalars have given values: isolines as edges of it, and the bands between them.

    One of `level`, `levels` and `spacing` is needed. Edges are split at the exact places, no point moves, and the scalars
    are not changed. A level that no edge has is no error.

    Parameters
    ----------
    level : float or sequence of float, optional
        The values.
    levels : int, optional
        So many values, which cut the range of the scalars into equal steps.
    spacing : float, optional
        The multiples of this value inside of the range of the scalars.

    The other parameters and the result are those of `cutting_system`; the result has `bands` and `curve_values`, too.
    """
    if levels is not None and np.ndim(levels) > 0:
        raise TypeError("levels is their number: the values are given as level")
    if sum(given is not None for given in (level, levels, spacing)) != 1:
        raise ValueError("one of level, levels and spacing is needed")
    if levels is not None and (int(levels) != levels or levels < 1):
        raise ValueError(f"levels is a number from 1, not {levels}")
    if max_triangles is not None and max_triangles < 1:
        raise ValueError(f"max_triangles has to be positive, not {max_triangles}")
    values = [] if level is None else np.atleast_1d(np.asarray(level, dtype=np.float64)).tolist()
    choice = _core.LevelChoice(values, None if levels is None else int(levels), spacing)
    mesh = _arrays.take(triangles, points)
    if mesh.points is None:
        raise ValueError("to cut a surface needs its points: they come behind the scalars")
    field_values = _arrays.doubles(_arrays.scalars_of(mesh, scalars))
    given, columns = _take_columns(vertex_arrays, len(field_values))
    arguments = mesh.checked(len(field_values)), field_values, sum(columns.values(), []), choice, bool(cut_open)
    *found, of_result, bands, curve_values, arcs, closed = run(
        _core.cut_levels, *arguments, max_triangles or 2**62, threads=threads, progress=progress, name="cut")
    return Cut(*found, _give_columns(given, columns, of_result), np.asarray(bands), np.asarray(curve_values),
               np.asarray(arcs), np.asarray(closed, dtype=bool))


def cut_to_disks(
    triangles: Any, points: Any = None, *, vertex_arrays: Mapping[str, Any] | None = None, threads: int | None = None,
    progress: Progress = None,
) -> Cut:
    """Cut each component of a surface to a disk along edges, as it is needed to flatten it.

    No triangle changes; points of the cut are there several times, as the array `original` of the result says. A surface
    of genus 0 without border is cut along two edges. The other parameters and the result are those of `cutting_system`;
    `patches` are the disks, and `scalars` is empty.
    """
    mesh = _arrays.take(triangles, points)
    if mesh.points is None:
        raise ValueError("to cut a surface needs its points: they come behind the triangles")
    number = len(mesh.points)
    given, columns = _take_columns(vertex_arrays, number)
    arguments = mesh.checked(number), number, sum(columns.values(), [])
    cut_points, cut_triangles, disks, curves, of_result, original = run(
        _core.cut_disks, *arguments, threads=threads, progress=progress, name="cut")
    return Cut(cut_points, cut_triangles, disks, curves, np.empty(0), _give_columns(given, columns, of_result),
               original=np.asarray(original))
