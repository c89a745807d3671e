"""What is handed in. Here, all but the numbers in arrays of a mesh is checked; the extension copies and checks those."""

from __future__ import annotations

import operator
import os
import warnings
from typing import Any, Iterable, NamedTuple

import numpy as np

from . import _core
from ._errors import MeshError
from ._run import run

LARGEST_NUMBER = 2**32 - 2  # of vertices
LARGEST_NUMBER_OF_CELLS = 2**32 // 12
MESH_ATTRIBUTES = ("faces", "cells_dict", "tetrahedra", "geometry", "GetPoints")
ITEMS = {"triangles": "triangle", "edges": "edge", "tetrahedra": "tetrahedron"}  # in the rows of these arrays


class Mesh(NamedTuple):
    """The arrays of a mesh, as `mesh_arrays` returns them: three indices a triangle, and two or three numbers a point.

    What the mesh has for its vertices is in `point_data`, a mapping from names to arrays.
    """

    triangles: np.ndarray | None
    points: np.ndarray | None
    edges: np.ndarray | None = None
    tetrahedra: np.ndarray | None = None
    point_data: Any = {}

    def checked(self, number: int) -> tuple[np.ndarray | None, ...]:
        """Return the arrays of a mesh with so many vertices as the extension takes them."""
        columns = {"triangles": 3, "edges": 2, "tetrahedra": 4}
        cells = {name: _cells(getattr(self, name), width, name) for name, width in columns.items()}
        return cells["triangles"], _points(self.points, number), cells["edges"], cells["tetrahedra"]


def one_of(name: str, names: Iterable[str], what: str) -> str:
    """Return the name, if it is one of these."""
    if name not in names:
        raise ValueError(f"{what} is one of {', '.join(names)}, not {name!r}")
    return name


def real(number: Any, name: str) -> float:
    """Return a real number as a double. An integer that is too large for one is a ValueError."""
    try:
        return float(number)
    except OverflowError:
        raise ValueError(f"{name} is too large for a double") from None
    except (TypeError, ValueError):
        raise TypeError(f"{name} has to be a real number, not {number!r}") from None


def measure(number: Any, name: str) -> float | None:
    """Return a real number that is not negative, or None."""
    if number is None:
        return None
    if not real(number, name) >= 0:
        raise ValueError(f"{name} must not be negative or NaN, as {number} is")
    return real(number, name)


def count_of(number: Any, name: str, least: int) -> int | None:
    """Return an integer from `least` on, or None. More than there can be of anything is as many as there can be."""
    if number is None:
        return None
    try:
        number = operator.index(number)
    except TypeError:
        raise TypeError(f"{name} has to be an integer, not {number!r}") from None
    if number < least:
        raise ValueError(f"{name} must not be less than {least}, as {number} is")
    return min(number, 2**62)


def refuse_mask(array: Any, item: str) -> None:
    """Refuse an array in which items are masked, whose numbers mean nothing; `item` is what a row of it stands for."""
    if np.ma.is_masked(array):
        mask = np.ma.getmaskarray(array)
        number = int(mask.reshape(len(mask), -1).any(axis=1).argmax()) if mask.ndim > 0 else 0
        raise MeshError(f"{item} {number} has no value: it is masked", item, number)


def numbers(array: Any, name: str, kinds: str = "iufb", what: str = "real numbers", largest: int = LARGEST_NUMBER) -> Any:
    """Return an array of numbers of these kinds, of which there are not too many, and none is masked."""
    refuse_mask(array, ITEMS.get(name, "vertex"))
    array = np.asarray(array)
    if array.dtype.kind not in kinds and array.size > 0:
        raise TypeError(f"{name} has the dtype {array.dtype}; it has to be one of {what}")
    if array.ndim > 0 and array.shape[0] > largest:
        raise ValueError(f"{name} has {array.shape[0]} rows, at most {largest} are possible")
    return array


def _cells(array: Any, columns: int, name: str) -> np.ndarray | None:
    if array is None or np.shape(array) in ((0,), (0, columns)):
        return None
    if name == "triangles" and np.asarray(array).dtype.kind == "f":
        raise TypeError("triangles are integers; what is handed in looks like points, which come as points=, behind them")
    array = numbers(array, name, "iu", "integers, the numbers of vertices", LARGEST_NUMBER_OF_CELLS)
    if array.ndim != 2 or array.shape[1] != columns:
        raise ValueError(f"{name} has the shape {array.shape}; it has to be (number, {columns})")
    return np.require(array, np.int64, ["C", "ALIGNED"])


def _points(points: Any, number: int) -> np.ndarray | None:
    if points is None:
        return None
    points = numbers(points, "points")
    if points.size == 0:
        points = np.zeros((0, 3))
    if points.ndim != 2 or points.shape[1] not in (2, 3):
        raise ValueError(f"points has the shape {points.shape}; it has to be (number of vertices, 3)")
    if len(points) != number:
        raise ValueError(f"there are {len(points)} points and {number} scalars; there has to be one of each per vertex")
    if points.shape[1] == 2:
        points = np.column_stack([points, np.zeros(number)])
    return np.require(points, np.float64, ["C", "ALIGNED"])


def values_array(scalars: Any, name: str = "scalars") -> np.ndarray:
    """Return `scalars` as an array of one dimension of real numbers, in the byte order of the machine."""
    scalars = numbers(scalars, name)
    if scalars.ndim != 1:
        raise ValueError(f"{name} has the shape {scalars.shape}; it has to be (number of vertices,)")
    if scalars.dtype.kind not in "iuf":  # truth values, or none at all
        return scalars.astype(np.uint8 if scalars.dtype.kind == "b" else np.float64)
    return scalars.astype(scalars.dtype.newbyteorder("="), copy=False)


def are_doubles(values: np.ndarray) -> bool:
    """Tell whether the values survive the way to `double` and back."""
    if values.dtype.itemsize < 8 or values.dtype == np.float64:
        return True
    with np.errstate(over="ignore"):
        there = values.astype(np.float64)
    if values.dtype.kind == "f":
        return np.array_equal(there, values, equal_nan=True)
    are_inside = there < float(np.iinfo(values.dtype).max)  # which is one more than the greatest integer
    return bool(are_inside.all()) and np.array_equal(there.astype(values.dtype), values)


def settled(values: np.ndarray) -> np.ndarray:
    """Return values as contiguous doubles that nobody can change any more: a copy, unless they are that already."""
    result = np.require(values, np.float64, ["C", "ALIGNED"])
    owner: Any = result
    while type(owner) is np.ndarray and not owner.flags.writeable:
        owner = owner.base
    is_shared = result is values and owner is not None and not isinstance(owner, bytes)
    return result.copy() if is_shared else result


def doubles(scalars: Any, name: str = "scalars") -> np.ndarray:
    """Return values as settled doubles; those that would change are refused."""
    values = values_array(scalars, name)
    if not are_doubles(values):
        raise ValueError(f"{name} has the dtype {values.dtype}, and values that a double cannot hold: this function computes with doubles")
    return settled(values)


def _rows(cells: Any, size: int, what: str) -> np.ndarray:
    """Return cells that are listed one behind the other, each after its number of vertices, as rows of `size` numbers."""
    cells = np.asarray(cells)
    if cells.ndim == 2:
        return cells
    if len(cells) % (size + 1) != 0 or np.any(cells[:: size + 1] != size):
        raise ValueError(f"the mesh has {what}: triangulate it before, as triangulate() does")
    return cells.reshape(-1, size + 1)[:, 1:]


def _cells_by_type(mesh: Any) -> dict[str, np.ndarray]:
    """Return the cells, which meshio has by their names, and PyVista by the numbers of VTK, by their names."""
    names = {1: "vertex", 3: "line", 5: "triangle", 10: "tetra"}
    cells = {names.get(kind, kind): rows for kind, rows in mesh.cells_dict.items()}
    for name in set(cells) - set(names.values()):
        raise ValueError(f"the mesh has cells of the type {name}; only triangles, tetrahedra and lines are possible")
    return cells


def read(file: str | os.PathLike[str], *, triangulate: bool = False) -> Mesh:
    """Read a mesh file as the program does: OFF, OBJ, PLY, STL, TS, MESH, VTK, VTU, or VTP.

    What the program says of the mesh, such as faces that are left out, is a UserWarning.

    Parameters
    ----------
    file : str or path
    triangulate : bool
        Whether faces that are not triangles are cut into triangles; without, they are a ValueError.

    Returns
    -------
    Mesh
        `point_data` has the numbers that PLY and VTK files have for their vertices.
    """
    os.stat(file)  # which says best what is wrong with its name
    try:
        *arrays, text = run(_core.read, os.fspath(file), bool(triangulate), name="reading")
    except ValueError as error:
        message = str(error).replace("--triangulate cuts", "reeb_graph.read(file, triangulate=True) cuts")
        raise ValueError(message) from None
    for line in text.splitlines():
        warnings.warn(f"{os.fspath(file)}: {' '.join(line.split())}", stacklevel=2)
    return Mesh(*arrays)


def _vtk_cells(cells: Any, size: int, what: str) -> np.ndarray | None:
    """Return the cells of a vtkCellArray as rows, if all of them have this size."""
    from vtkmodules.util.numpy_support import vtk_to_numpy  # type: ignore[import-untyped]

    if cells.GetNumberOfCells() == 0:
        return None
    if np.any(np.diff(vtk_to_numpy(cells.GetOffsetsArray())) != size):
        raise ValueError(f"the mesh has {what}: vtkTriangleFilter makes triangles and lines of all cells")
    return vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, size)


def _vtk_arrays(mesh: Any) -> Mesh:
    """Take the arrays of a vtkPolyData; whoever has one has VTK."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    if mesh.GetStrips().GetNumberOfCells() > 0:
        raise ValueError("the mesh has strips of triangles: vtkTriangleFilter makes triangles of them")
    data = mesh.GetPointData()
    arrays = [data.GetArray(i) for i in range(data.GetNumberOfArrays()) if data.GetArray(i) is not None]
    points = vtk_to_numpy(mesh.GetPoints().GetData()) if mesh.GetNumberOfPoints() > 0 else np.zeros((0, 3))
    return Mesh(
        _vtk_cells(mesh.GetPolys(), 3, "faces that are not triangles"), points,
        _vtk_cells(mesh.GetLines(), 2, "lines of more than two points"), None,
        {array.GetName(): vtk_to_numpy(array) for array in arrays if array.GetName()},
    )


def mesh_arrays(mesh: Any) -> Mesh:
    """Take the arrays of a mesh of another package, by its attributes; none of them is imported, but VTK for its own.

    Parameters
    ----------
    mesh : trimesh.Trimesh, trimesh.Scene, pyvista.PolyData, pyvista.UnstructuredGrid, meshio.Mesh, vtkPolyData, or alike
        `vertices` and `faces`; or `points` and `faces`, with the number of vertices before those of each face; or
        `points` and `cells_dict`, with triangles, tetrahedra and lines. Other cells are a ValueError. A scene is all of
        its meshes, in their places. The name of a file is one for `read`.

    Returns
    -------
    Mesh
        A named tuple of `triangles`, `points`, `edges`, `tetrahedra`, and `point_data`.
    """
    if isinstance(mesh, Mesh):
        return mesh
    if isinstance(mesh, (str, os.PathLike)):
        return read(mesh)
    if hasattr(mesh, "geometry") and hasattr(mesh, "dump"):  # a scene of trimesh
        mesh = mesh.to_mesh() if hasattr(mesh, "to_mesh") else mesh.dump(concatenate=True)
    data = getattr(mesh, "point_data", getattr(mesh, "vertex_attributes", {}))
    points = getattr(mesh, "points", getattr(mesh, "vertices", None))
    if points is not None and hasattr(mesh, "cells_dict"):
        cells = _cells_by_type(mesh)
        return Mesh(cells.get("triangle"), np.asarray(points), cells.get("line"), cells.get("tetra"), data)
    if np.size(getattr(mesh, "strips", ())) > 0:
        raise ValueError("the mesh has strips of triangles: triangulate it before, as triangulate() does")
    if points is not None and hasattr(mesh, "faces"):
        lines = _rows(getattr(mesh, "lines", ()), 2, "lines of more than two points")
        return Mesh(_rows(mesh.faces, 3, "faces that are not triangles"), np.asarray(points), lines, None, data)
    if hasattr(mesh, "GetPolys"):
        return _vtk_arrays(mesh)
    raise TypeError(
        f"a {type(mesh).__name__} is not an array of triangles, and not a mesh: pass triangles and points as arrays, the "
        "name of a file, or a mesh of trimesh, PyVista, meshio, or VTK (vtkPolyData), which has vertices and faces, or "
        "points and faces or cells_dict"
    )


def take(triangles: Any, points: Any = None, edges: Any = None, tetrahedra: Any = None) -> Mesh:
    """Return the arrays of a mesh, which stands in the place of the triangles, or those that are given."""
    is_file = isinstance(triangles, (str, os.PathLike))
    if not is_file and not any(hasattr(triangles, name) for name in MESH_ATTRIBUTES):
        return Mesh(triangles, points, edges, tetrahedra)
    given = {"points": points, "edges": edges, "tetrahedra": tetrahedra}
    return mesh_arrays(triangles)._replace(**{name: array for name, array in given.items() if array is not None})


def scalars_of(mesh: Mesh, scalars: Any) -> Any:
    """Return the scalars, or what the mesh has by this name, or a coordinate."""
    if not isinstance(scalars, str):
        return scalars
    if scalars not in mesh.point_data and scalars in ("x", "y", "z") and mesh.points is not None:
        return mesh.points[:, "xyz".index(scalars)]
    if scalars not in mesh.point_data:
        raise ValueError(f"the mesh has no data {scalars!r} of its vertices")
    return mesh.point_data[scalars]
