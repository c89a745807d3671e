"""Scalar fields, and curves that cut a surface."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from . import _arrays, _core
from ._progress import Progress, progress_function


def _vertex_numbers(numbers: Any, name: str) -> list[int]:
    array = np.atleast_1d(np.asarray(numbers))
    if array.size > 0 and array.dtype.kind not in "iu":
        raise TypeError(f"{name} are integers, the numbers of vertices, not {numbers!r}")
    if array.ndim > 1 or np.any(array < 0):
        raise ValueError(f"{name} are the numbers of vertices, from 0, not {numbers!r}")
    return [int(number) for number in array]


def _run(function: Any, mesh: _arrays.Mesh, number: Any, arguments: Any, threads: Any, progress: Any, name: str) -> Any:
    arrays, threads = _arrays.to_core(mesh, number), _arrays.threads_number(threads)
    return function(arrays, *arguments, threads, progress_function(progress, name))


def _field(name: str, mesh: _arrays.Mesh, threads: Any, progress: Any, scalars: Any = None, **settings: Any) -> np.ndarray:
    if mesh.points is None:
        raise ValueError(f"the field {name} needs points: they come behind the triangles")
    options = _core.FieldOptions()
    for key, value in {"field": name, **settings}.items():
        setattr(options, key, value)
    scalars = None if scalars is None else _arrays.doubles(_arrays.scalars_of(mesh, scalars))
    number = len(mesh.points) if scalars is None else len(scalars)
    return _run(_core.field, mesh, number, (number, options, scalars), threads, progress, name)


def harmonic(
    triangles: Any, points: Any = None, *, minimum: int | None = None, maximum: int | None = None,
    weights: str = "mean-value", between_borders: bool = False, threads: int | None = None, progress: Progress = None,
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
    threads, progress
        As for `compute`, here and below.

    Returns
    -------
    (n,) array of float

    Notes
    -----
    M. S. Floater, *Mean value coordinates*, 2003.
    """
    if weights not in ("mean-value", "cotangent", "uniform"):
        raise ValueError(f"weights are 'mean-value', 'cotangent', or 'uniform', not {weights!r}")
    if (minimum is None) != (maximum is None):
        raise ValueError("minimum and maximum go together")
    settings: dict[str, Any] = {"weights": weights}
    if minimum is not None:
        settings["minimum"], settings["maximum"] = _vertex_numbers([minimum, maximum], "minimum and maximum")
    name = "harmonic-between-borders" if between_borders else "harmonic"
    return _field(name, _arrays.take(triangles, points), threads, progress, **settings)


def poisson(
    triangles: Any, points: Any = None, *, sources: Any = (), threads: int | None = None, progress: Progress = None
) -> np.ndarray:
    """Compute the field whose Laplacian is the mean curvature, as an (n,) array of float.

    Parameters
    ----------
    triangles : (m, 3) array of integers, or a mesh
    points : (n, 3) array
    sources : int or sequence of int
        The vertices where it is 0; by default one in each component.
    """
    mesh = _arrays.take(triangles, points)
    return _field("poisson", mesh, threads, progress, sources=_vertex_numbers(sources, "sources"))


def unit_gradient(
    triangles: Any, points: Any = None, scalars: Any = None, *, threads: int | None = None, progress: Progress = None
) -> np.ndarray:
    """Compute a field whose gradient has about unit length, with about the level sets of another one.

    Parameters
    ----------
    triangles : (m, 3) array of integers, or a mesh
    points : (n, 3) array
    scalars : (n,) array, optional
        The other field; by default the harmonic one.

    Returns
    -------
    (n,) array of float
        In units of length.
    """
    return _field("unit-gradient", _arrays.take(triangles, points), threads, progress, scalars)


def geodesic(
    triangles: Any, points: Any = None, *, sources: Any = (), edges: Any = None, tetrahedra: Any = None,
    threads: int | None = None, progress: Progress = None,
) -> np.ndarray:
    """Compute the distance on the surface from vertices; along edges, if the mesh is no oriented manifold surface.

    Parameters
    ----------
    triangles : (m, 3) array of integers, or a mesh
    points : (n, 3) array
    sources : int or sequence of int
        The vertices where it is 0; by default one in each component, far from another one.
    edges, tetrahedra : arrays of integers, optional

    Returns
    -------
    (n,) array of float
        In units of length.

    Notes
    -----
    By the heat method: K. Crane, C. Weischedel, M. Wardetzky, *Geodesics in Heat*, 2013.
    """
    mesh = _arrays.take(triangles, points, edges, tetrahedra)
    return _field("geodesic", mesh, threads, progress, sources=_vertex_numbers(sources, "sources"))


def height(triangles: Any, points: Any = None, direction: Any = (0, 0, 1)) -> np.ndarray:
    """Compute the height of each vertex along a direction of any length but 0, in units of length.

    The triangles, or None, play no role: they are there for meshes in their place.
    """
    vector = np.asarray(direction, dtype=np.float64)
    if vector.shape != (3,):
        raise ValueError(f"the direction has three coordinates, not the shape {vector.shape}")
    mesh = _arrays.take(triangles, points)._replace(triangles=None, edges=None, tetrahedra=None)
    return _field("height", mesh, None, None, direction=vector.tolist())


def make_borders_level(
    triangles: Any, scalars: Any, points: Any = None, *, threads: int | None = None, progress: Progress = None
) -> np.ndarray:
    """Return a field that is changed so that each border lies in one level, and is an extremum.

    That is what functions that cut need, which do it by default. The points play no role.
    """
    mesh = _arrays.take(triangles, points)
    values = _arrays.doubles(_arrays.scalars_of(mesh, scalars))
    return _run(_core.make_borders_level, mesh, len(values), (values,), threads, progress, "borders")


@dataclass(frozen=True)
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
    """

    points: np.ndarray
    triangles: np.ndarray
    patches: np.ndarray
    curves: list[np.ndarray]
    scalars: np.ndarray
    vertex_arrays: dict[str, np.ndarray] = field(default_factory=dict)

    @property
    def n_patches(self) -> int:
        return int(self.patches.max(initial=-1)) + 1


def _columns(arrays: Mapping[str, np.ndarray], number: int) -> list[np.ndarray]:
    """Return the columns of all arrays, as doubles."""
    columns: list[np.ndarray] = []
    for name, array in arrays.items():
        if array.ndim == 0 or len(array) != number:
            raise ValueError(f"the vertex array {name!r} has the shape {array.shape} for {number} vertices")
        columns += [_arrays.doubles(c, f"the vertex array {name!r}") for c in array.reshape(number, _width(array)).T]
    return columns


def _width(array: np.ndarray) -> int:
    return int(np.prod(array.shape[1:], dtype=np.int64))


def _arrays_of_columns(given: Mapping[str, np.ndarray], columns: list[np.ndarray]) -> dict[str, np.ndarray]:
    result = {}
    for name, array in given.items():
        table = np.stack([columns.pop(0) for _ in range(_width(array))], axis=-1)
        table = np.rint(table) if array.dtype.kind in "iub" else table
        result[name] = table.reshape(-1, *array.shape[1:]).astype(array.dtype)
    return result


def _cut(
    kind: Any, triangles: Any, scalars: Any, points: Any, *, vertex_arrays: Mapping[str, Any] | None = None,
    borders: str = "make-level", cut_open: bool = False, max_triangles: int | None = None, threads: int | None = None,
    progress: Progress = None, **thresholds: float | None,
) -> Cut:
    if borders not in ("make-level", "level"):
        raise ValueError(f"borders is 'make-level' or 'level', not {borders!r}")
    if max_triangles is not None and max_triangles < 1:
        raise ValueError(f"max_triangles has to be positive, not {max_triangles}")
    mesh = _arrays.take(triangles, points)
    if mesh.points is None:
        raise ValueError("to cut a surface needs its points: they come behind the scalars")
    values = _arrays.doubles(_arrays.scalars_of(mesh, scalars))
    given = {name: np.asarray(array) for name, array in (vertex_arrays or {}).items()}
    options = _core.CutOptions()
    options.type, options.cut_open = kind, bool(cut_open)
    options.borders = _core.Borders.level if borders == "level" else _core.Borders.make_level
    for name, threshold in thresholds.items():
        if threshold is not None and not threshold >= 0:
            raise ValueError(f"{name} must not be negative or NaN, as {threshold} is")
        setattr(options, name, threshold)
    arguments = (values, _columns(given, len(values)), options, max_triangles or 2**62)
    *found, columns = _run(_core.cut, mesh, len(values), arguments, threads, progress, "cut")
    return Cut(*found, _arrays_of_columns(given, columns))


def cutting_system(triangles: Any, scalars: Any, points: Any = None, **options: Any) -> Cut:
    """Find curves along which a surface is cut to genus 0: one for each handle.

    Parameters
    ----------
    triangles : (m, 3) array of integers, or a mesh
        An oriented manifold surface.
    scalars : (n,) array, or the name of data of the mesh
    points : (n, 3) array
    vertex_arrays : mapping from names to arrays with n rows, optional
        Are interpolated at points that are added.
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
    return _cut(_core.Curves.cutting_system, triangles, scalars, points, **options)


def pants(triangles: Any, scalars: Any, points: Any = None, **options: Any) -> Cut:
    """Cut a surface into pairs of pants, spheres with three holes.

    The parameters and the result are those of `cutting_system`. A sphere, disk, annulus, or torus has no such cut, which
    is a ValueError.
    """
    return _cut(_core.Curves.pants, triangles, scalars, points, **options)


def branches(
    triangles: Any, scalars: Any, points: Any = None, *, persistence: float | None = None, area: float | None = None,
    **options: Any,
) -> Cut:
    """Cut the branches off a surface, where they begin.

    Those with values that differ by less than `persistence`, or of less area than `area`, are left out. The other
    parameters and the result are those of `cutting_system`.
    """
    thresholds = {"persistence": persistence, "area": area}
    return _cut(_core.Curves.branches, triangles, scalars, points, **thresholds, **options)
