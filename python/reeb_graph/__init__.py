"""Exact Reeb graphs of scalar fields on triangle meshes, from NumPy arrays.

Read `help(reeb_graph.compute)` and `help(reeb_graph.ReebGraph)` first.

compute             makes the `ReebGraph` of triangles and scalars; its contours are arrays, `reeb_graph.Contour`
height              the height of each vertex along a direction
geodesic            the distance from vertices
harmonic            one minimum and one maximum, nothing else between
poisson             follows the mean curvature
unit_gradient       rises by one for each unit of length
make_borders_level  changes scalars so that each border is a level
cutting_system      cuts a surface to genus 0
pants               cuts a surface into pieces with three borders each
branches            cuts branches off a surface
repair              merges points, orients and splits
cut_along_levels    cuts a surface where the scalars have given values
cut_to_disks        cuts a surface to disks, to flatten it
handles             short handles and tunnels of a surface, and where they are
remove_handles      cuts small ones
compare             tells how far two shapes are from each other, and which arcs stand for the same: a `Comparison`
distances           the distances of many shapes from each other
like_tips           vertices of meshes that stand for the same place, as sources of fields to compare
skeleton            lines inside of a surface, with radii: a `Skeleton`
read                reads a mesh file; all functions take its name in the place of triangles, too
mesh_arrays         takes the arrays of a mesh of trimesh, PyVista, meshio, or VTK

Examples
--------
Cut a scan into head, body, and limbs, by the distance from its highest vertex:

>>> distance = reeb_graph.geodesic(triangles, points, sources=points[:, 2].argmax())
>>> graph = reeb_graph.compute(triangles, distance, points=points).simplify("auto")
>>> segments = graph.vertex_arcs  # the arc that each vertex belongs to; negative at nodes
>>> graph.write("scan.ply")  # the scan, each segment in its color; graph.svg is the drawing of the graph
"""

try:
    from . import _core
except ImportError as error:
    raise ImportError(
        "the extension of reeb_graph is missing: build it by\n"
        "    cmake -S . -B build -D CGAL_REEB_GRAPH_BUILD_PYTHON=ON && cmake --build build --target reeb_graph_python\n"
        "and set PYTHONPATH=build/python, or install it by `pip install .`; both in the top folder of the project"
        f" ({error})"
    ) from error

from ._arrays import Mesh, mesh_arrays, read
from ._comparison import Comparison, compare, distances, like_tips
from ._errors import MeshError, NumberError, StoppedError
from ._functions import Cut, branches, cutting_system, geodesic, harmonic, height, make_borders_level, pants, poisson
from ._functions import Repaired, cut_along_levels, cut_to_disks, repair, unit_gradient
from ._graph import ReebGraph, compute
from ._handles import Handles, Loop, WithoutHandles, handles, remove_handles
from ._results import Contour, CriticalSet, Embedding
from ._skeleton import Skeleton, skeleton

__version__ = _core.__version__
# Without `Contour`, whose 2,000 inherited lines would be most of what `help(reeb_graph)` shows.
__all__ = ["Comparison", "CriticalSet", "Cut", "Embedding", "Handles", "Loop", "Mesh", "MeshError", "NumberError"]
__all__ += ["ReebGraph", "Repaired", "Skeleton", "StoppedError", "WithoutHandles", "branches", "compare", "compute"]
__all__ += ["cut_along_levels", "cut_to_disks", "cutting_system", "distances", "geodesic", "handles", "harmonic"]
__all__ += ["height", "like_tips", "make_borders_level", "mesh_arrays", "pants", "poisson", "read", "remove_handles"]
__all__ += ["repair", "skeleton", "unit_gradient"]
