"""Curve skeletons."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from typing import Any

import numpy as np

from . import _arrays, _core
from ._results import count
from ._run import Progress, run


@dataclass(frozen=True, repr=False)
class Skeleton:
    """A curve skeleton: lines inside of a surface, with radii.

    Attributes
    ----------
    points : (n, 3) array of float
    edges : (m, 2) array of int
        The points at the ends of each edge, those of one arc after the other.
    radii : (n,) array of float
        The radius of a circle of the area of the contour at each point.
    inscribed_radii : (n,) array of float
        The distance of each point from the surface; 0 at the ends of tubes.
    arcs : list of arrays of int
        The points of each arc, from node to node.
    vertex_map : (number of vertices,) array of int
        The point that stands for each vertex of the mesh, -1 for those without triangles.
    counts : dict from str to int
        Components, genus, arcs, ends, junctions, loops and hidden handles, and what certifies the lines: vertices outside
        of the surface, edges that cross it, loops that can be pulled to a point inside, the index of what loops generate
        (1 if they are a basis), and components that intersect themselves, or are inside out.
    branches : dict from str to arrays with a number for each arc
        Its `component`, `parent` (-1 at a root), `from` and `to`, `length`, `tortuosity` (NaN if it is closed),
        `strahler`, `radius` and `inscribed_radius` as means by length, `least_radius`, `greatest_radius`, `volume` and
        `area`, which add up to those of the solid and of the surface, and `junction_volume` and `junction_area`, what of
        these lies in junctions. Parents and Strahler numbers are those of the trees of an SWC file.
    point_in_junction, edge_in_junction : (n,) and (m,) arrays of bool
    face_branches : (number of triangles,) array of int, or None if a copy has been repaired
        The arc around which each triangle lies.
    face_in_junction : (number of triangles,) array of bool, or None
    """

    points: np.ndarray
    edges: np.ndarray
    radii: np.ndarray
    inscribed_radii: np.ndarray
    arcs: list[np.ndarray]
    vertex_map: np.ndarray
    counts: dict[str, int]
    branches: dict[str, np.ndarray]
    point_in_junction: np.ndarray
    edge_in_junction: np.ndarray
    face_branches: np.ndarray | None
    face_in_junction: np.ndarray | None

    @property
    def cable_length(self) -> float:
        return float(self.branches["length"].sum())

    @property
    def n_loops(self) -> int:
        return self.counts["loops"]

    def to_networkx(self) -> Any:
        """Return a `networkx.MultiGraph` with a node for each point.

        Nodes have the attributes `pos`, `radius`, and `inscribed_radius`, edges have `arc` and `length`.
        """
        import networkx  # type: ignore[import-untyped]

        graph = networkx.MultiGraph()
        columns = zip(self.points.tolist(), self.radii.tolist(), self.inscribed_radii.tolist())
        for number, (point, radius, inscribed) in enumerate(columns):
            graph.add_node(number, pos=tuple(point), radius=radius, inscribed_radius=inscribed)
        for number, arc in enumerate(self.arcs):
            for a, b in zip(arc[:-1].tolist(), arc[1:].tolist()):
                graph.add_edge(a, b, arc=number, length=math.dist(self.points[a], self.points[b]))
        return graph

    def write(
        self, *files: str | os.PathLike[str], root: str | int = "tip", radius: str = "area", swc_type: int = 3
    ) -> None:
        """Write the skeleton to files: `.swc`, `.vtp`, `.polylines.txt`, `.graphml`, or `.csv`, which has `branches`.

        In SWC, a loop is cut once: a comment `# CYCLE_BREAK reconnect DUPLICATE ORIGINAL` names the copy of a point. No
        radius there is 0: it is that of a point beside it then.

        Parameters
        ----------
        root : "tip", "thickest", or int
            The roots of the trees: a tip of each, the thickest point, which has the type 1 of a soma in the largest tree,
            or, of one tree, that of a vertex of the mesh.
        radius : "area" or "inscribed"
            The radii of SWC: `radii` or `inscribed_radii`.
        swc_type : int
            The type of other points in SWC, from 2 on: 2 axon, 3 dendrite, 4 apical dendrite.
        """
        place = None if root == "tip" else _core.SkeletonPlace(None if root == "thickest" else self._point_of(root))
        if radius not in ("area", "inscribed"):
            raise ValueError("radius has to be 'area' or 'inscribed'")
        if swc_type < 2:
            raise ValueError("swc_type has to be at least 2: programs refuse 0, and 1 is that of a soma")
        options = _core.SwcOptions(radius == "inscribed", swc_type)
        names = "volume", "area", "junction_volume", "junction_area"
        sizes = np.column_stack([self.branches[name] for name in names]).tolist()
        for file in files:
            arrays = self.radii.tolist(), self.inscribed_radii.tolist(), [arc.tolist() for arc in self.arcs]
            points = np.require(self.points, np.float64, ["C", "ALIGNED"])
            _core.write_skeleton(os.fspath(file), points, *arrays, sizes, place, options)

    def _point_of(self, vertex: str | int) -> int:
        if isinstance(vertex, str) or not 0 <= vertex < len(self.vertex_map) or self.vertex_map[vertex] < 0:
            raise ValueError(f"{vertex!r} is none of 'tip', 'thickest', and a vertex of the mesh with triangles")
        return int(self.vertex_map[vertex])

    def __repr__(self) -> str:
        size = f"{count(len(self.points), 'point')}, {count(len(self.arcs), 'arc')}"
        return f"<Skeleton: {size}, {count(self.counts['ends'], 'end')}, {count(self.n_loops, 'loop')}>"


def skeleton(
    triangles: Any, points: Any = None, scalars: Any = None, *, pruning_ratio: float = 0.5, sampling_ratio: float = 0.5,
    ends_at_borders: bool = True, smooth: float = 1, spacing: float = 0, least_piece: float = 0, strict: bool = False,
    threads: int | None = None, progress: Progress = None,
) -> Skeleton:
    """Extract a curve skeleton: lines inside of a surface, with a loop for each handle, and radii.

    Parameters
    ----------
    triangles : (m, 3) array of integers, or a mesh
        If they are not an oriented manifold surface, a copy is repaired as by `repair` with `all`; of tetrahedra, the
        border is taken.
    points : (n, 3) array
    scalars : (n,) array, or the name of data of the mesh, optional
        A field whose contours give the lines; by default the distance from a tip of each component.
    pruning_ratio : float
        Branches go that are shorter than this share of their radius, or stand out from the trunk by less than this
        share of its radius; 0 keeps all.
    sampling_ratio : float
        The distance between points as a share of the radius, from 0.01 to 100.
    ends_at_borders : bool
        Whether borders are ends; if not, they are filled, as holes of a scan.
    smooth : float
        The price of bends when lines are moved to the middle, up to 100; 0 leaves them where they are.
    spacing : float
        The distance between points, in the unit of the mesh, but before the end of a line; 0 for that by the radius.
    least_piece : float
        The share of the area from which on components stay, as for `repair`.
    strict : bool
        Whether a mesh that is not an oriented manifold surface is a ValueError.
    threads, progress
        As for `compute`.

    Returns
    -------
    Skeleton

    Notes
    -----
    F. Lazarus and A. Verroust, *Level set diagrams of polyhedral objects*, 1999.
    """
    mesh = _arrays.take(triangles, points)
    if mesh.points is None:
        raise ValueError("a skeleton needs points: they come behind the triangles")
    values = None if scalars is None else _arrays.doubles(_arrays.scalars_of(mesh, scalars))
    number = len(mesh.points if values is None else values)
    numbers = float(pruning_ratio), float(sampling_ratio), bool(ends_at_borders), float(smooth), float(spacing)
    settings = _core.SkeletonSettings(*numbers)
    repairs = _core.RepairOptions(True, None, None, True, not strict, True, float(least_piece), 0, False, False)
    arguments = mesh.checked(number), number, values, settings, repairs
    found = run(_core.skeleton, *arguments, threads=threads, progress=progress, name="skeleton")
    of_points, radii, inscribed_radii, arcs, vertex_map, counts, branches, *flags = found
    of_points_inside, of_edges_inside, face_branches, of_faces_inside = flags
    pairs = [np.column_stack([arc[:-1], arc[1:]]) for arc in arcs]
    edges = np.concatenate(pairs) if pairs else np.zeros((0, 2), dtype=np.int64)
    of_faces = (face_branches, of_faces_inside.astype(bool)) if len(face_branches) else (None, None)
    return Skeleton(of_points, edges, radii, inscribed_radii, arcs, vertex_map, counts, branches,
                    of_points_inside.astype(bool), of_edges_inside.astype(bool), *of_faces)
