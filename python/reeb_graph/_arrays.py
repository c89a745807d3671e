"""What is handed in: arrays are looked at here, and copied and checked by the extension."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from . import _core
from ._errors import MeshError

LARGEST_NUMBER = 2**32 - 2  # of vertices
LARGEST_NUMBER_OF_CELLS = 2**32 // 12


class Mesh(NamedTuple):
    """The arrays of a mesh.

    Attributes
    ----------
    triangles : (m, 3) array of integers, or None
    points : (n, 3) array of floats, or None
    edges : (k, 2) array of integers, or None
    tetrahedra : (l, 4) array of integers, or None
    point_data : mapping from names to arrays
        What the mesh has for its vertices.
    """

    triangles: np.ndarray | None
    points: np.ndarray | None
    edges: np.ndarray | None = None
    tetrahedra: np.ndarray | None = None
    point_data: Any = {}


def _numbers(array: Any, name: str, kinds: str = "iufb", what: str = "real numbers", largest: int = LARGEST_NUMBER) -> Any:
    """Return an array of numbers of these kinds, of which there are not too many."""
    array = np.asarray(array)
    if array.dtype.kind not in kinds and array.size > 0:
        raise TypeError(f"{name} has the dtype {array.dtype}; it has to be one of {what}")
    if array.ndim > 0 and array.shape[0] > largest:
        raise ValueError(f"{name} has {array.shape[0]} rows, at most {largest} are possible")
    return array


def indices(array: Any, columns: int, name: str) -> np.ndarray | None:
    """Return `array` as one of integers that the extension takes, with so many columns, or None if there are no rows."""
    if array is None or np.shape(array) in ((0,), (0, columns)):
        return None
    if name == "triangles" and np.asarray(array).dtype.kind == "f":
        raise TypeError("triangles are integers; what is handed in looks like points, which come as points=, behind them")
    array = _numbers(array, name, "iu", "integers, the numbers of vertices", LARGEST_NUMBER_OF_CELLS)
    if array.ndim != 2 or array.shape[1] != columns:
        raise ValueError(f"{name} has the shape {array.shape}; it has to be (number, {columns})")
    return np.require(array, np.int64, ["C_CONTIGUOUS", "ALIGNED"])


def points_array(points: Any, number: int | None = None) -> np.ndarray | None:
    """Return `points` as C-contiguous doubles, three a row; two coordinates get 0 as third one."""
    if points is None:
        return None
    points = _numbers(points, "points")
    if points.size == 0 and points.ndim < 2:
        points = np.zeros((0, 3))
    if points.ndim != 2 or points.shape[1] not in (2, 3):
        raise ValueError(f"points has the shape {points.shape}; it has to be (number of vertices, 3)")
    if number is not None and points.shape[0] != number:
        raise ValueError(f"there are {points.shape[0]} points and {number} scalars; there has to be one of each per vertex")
    if points.shape[1] == 2:
        points = np.column_stack([points, np.zeros(len(points))])
    return np.ascontiguousarray(points, dtype=np.float64)


def values_array(scalars: Any, name: str = "scalars") -> np.ndarray:
    """Return `scalars` as an array of one dimension of real numbers, in the byte order of the machine."""
    if isinstance(scalars, np.ma.MaskedArray) and np.ma.getmaskarray(scalars).any():
        vertex = int(np.flatnonzero(np.ma.getmaskarray(scalars).ravel())[0])
        raise MeshError(f"vertex {vertex} has no value: it is masked", "vertex", vertex)
    scalars = _numbers(scalars, name)
    if scalars.ndim != 1:
        raise ValueError(f"{name} has the shape {scalars.shape}; it has to be (number of vertices,)")
    if scalars.dtype.kind == "b" or scalars.size == 0:
        return scalars.astype(np.uint8 if scalars.dtype.kind == "b" else np.float64)
    return scalars.astype(scalars.dtype.newbyteorder("="), copy=False)


def are_doubles(values: np.ndarray) -> bool:
    """Tell whether the values survive the way to `double` and back."""
    if values.dtype.itemsize < 8 or values.dtype == np.float64 or values.size == 0:
        return True
    if values.dtype.kind == "f":
        with np.errstate(over="ignore"):
            doubles = values.astype(np.float64)
        return bool(np.all((doubles == values) | np.isnan(values)))
    if int(values.max()) <= 2**53 and int(values.min()) >= -(2**53):
        return True
    doubles = values.astype(np.float64)
    if float(doubles.max()) >= float(np.iinfo(values.dtype).max):
        return False
    return bool(np.all(doubles.astype(values.dtype) == values))


def settled(values: np.ndarray) -> np.ndarray:
    """Return values as contiguous doubles, read-only if nobody else can write them: the extension copies others."""
    result = np.ascontiguousarray(values, dtype=np.float64)
    if result is values:
        owner: Any = values
        while type(owner) is np.ndarray and not owner.flags.writeable:
            owner = owner.base
        if values.flags.writeable or owner is None or isinstance(owner, bytes):
            return values
        result = values.copy()
    result.flags.writeable = False
    return result


def doubles(scalars: Any, name: str = "scalars") -> np.ndarray:
    """Return values as doubles; those that would change are refused."""
    values = values_array(scalars, name)
    if not are_doubles(values):
        raise ValueError(f"{name} has the dtype {values.dtype}, and values that no double has: this function computes with doubles")
    return settled(values)


def _rows(cells: Any, size: int, what: str) -> np.ndarray:
    """Return cells that are listed one behind the other, each after its number of vertices, as rows of `size` numbers."""
    cells = np.asarray(cells)
    if cells.ndim == 2:
        return cells
    if len(cells) % (size + 1) != 0 or np.any(cells[:: size + 1] != size):
        raise ValueError(f"the mesh has {what}: triangulate it before, as triangulate() does")
    return cells.reshape(-1, size + 1)[:, 1:]


def _of_cells(cells: Any) -> dict[str, np.ndarray]:
    """Return the cells that meshio lists in blocks, and PyVista in a dict, by their types."""
    if isinstance(cells, dict):
        blocks = [({5: "triangle", 10: "tetra", 3: "line", 1: "vertex"}.get(int(k), str(k)), v) for k, v in cells.items()]
    else:
        blocks = [(block.type, block.data) for block in cells]
    found: dict[str, list[np.ndarray]] = {}
    for name, rows in blocks:
        if name not in ("triangle", "tetra", "line", "vertex"):
            raise ValueError(f"the mesh has cells of the type {name}; only triangles, tetrahedra and lines are possible")
        found.setdefault(name, []).append(np.asarray(rows))
    return {name: np.concatenate(rows) for name, rows in found.items()}


def mesh_arrays(mesh: Any) -> Mesh:
    """Take the arrays of a mesh of another package, by its attributes; none of them is imported.

    Parameters
    ----------
    mesh : trimesh.Trimesh, pyvista.PolyData, pyvista.UnstructuredGrid, meshio.Mesh, or alike
        `vertices` and `faces`; or `points` and `faces`, with the number of vertices before those of each face; or
        `points` and `cells` or `cells_dict`, with triangles, tetrahedra and lines.

    Returns
    -------
    Mesh
        A named tuple of `triangles`, `points`, `edges`, `tetrahedra`, and `point_data`.

    Raises
    ------
    TypeError
        if the object has none of these attributes
    ValueError
        if there are other cells
    """
    if isinstance(mesh, Mesh):
        return mesh
    data = getattr(mesh, "point_data", getattr(mesh, "vertex_attributes", {}))
    if hasattr(mesh, "points") and hasattr(mesh, "cells"):
        cells = _of_cells(mesh.cells if isinstance(mesh.cells, (list, tuple)) else mesh.cells_dict)
        return Mesh(cells.get("triangle"), np.asarray(mesh.points), cells.get("line"), cells.get("tetra"), data)
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        return Mesh(np.asarray(mesh.faces), np.asarray(mesh.vertices), None, None, data)
    if hasattr(mesh, "points") and hasattr(mesh, "faces"):
        lines = _rows(getattr(mesh, "lines", ()), 2, "lines of more than two points")
        return Mesh(_rows(mesh.faces, 3, "faces that are no triangles"), np.asarray(mesh.points), lines, None, data)
    raise TypeError(
        f"a {type(mesh).__name__} is no array of triangles, and no mesh: it has neither vertices and faces, nor points and "
        "faces or cells"
    )


def take(triangles: Any, points: Any = None, edges: Any = None, tetrahedra: Any = None) -> Mesh:
    """Return the arrays of a mesh, which stands in the place of the triangles, or those that are given."""
    if not any(hasattr(triangles, name) for name in ("faces", "cells", "tetrahedra")):
        return Mesh(triangles, points, edges, tetrahedra)
    given = {"points": points, "edges": edges, "tetrahedra": tetrahedra}
    return mesh_arrays(triangles)._replace(**{name: array for name, array in given.items() if array is not None})


def scalars_of(mesh: Mesh, scalars: Any) -> Any:
    """Return the scalars, or what the mesh has by this name."""
    if not isinstance(scalars, str):
        return scalars
    if scalars not in mesh.point_data:
        raise ValueError(f"the mesh has no data {scalars!r} of its vertices")
    return mesh.point_data[scalars]


def to_core(mesh: Mesh, number: int | None = None) -> Any:
    """Return the arrays of a mesh as the extension takes them."""
    return _core.MeshArrays(
        indices(mesh.triangles, 3, "triangles"),
        points_array(mesh.points, number),
        indices(mesh.edges, 2, "edges"),
        indices(mesh.tetrahedra, 4, "tetrahedra"),
    )


def threads_number(threads: int | None) -> int:
    """Return the number of threads, 0 for one per core."""
    if threads is None:
        return 0
    if isinstance(threads, (bool, np.bool_)) or not isinstance(threads, (int, np.integer)):
        raise TypeError(f"threads has to be an integer, not {threads!r}")
    if not 1 <= threads <= 1024:
        raise ValueError(f"threads has to be from 1 to 1024, not {threads}")
    return int(threads)
