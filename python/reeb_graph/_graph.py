"""The Reeb graph of arrays."""

from __future__ import annotations

import json
import math
import operator
import os
import tempfile
import warnings
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from . import _arrays, _core
from ._errors import NumberError
from ._field import Field
from ._progress import Progress, progress_function
from ._results import Contour, CriticalSet, Embedding, Page

KINDS = np.array(["isolated", "minimum", "saddle", "maximum", "degree-two"])
LARGEST_DRAWING = 2000  # arcs that a notebook shows without being asked


class ReebGraph:
    """The Reeb graph of a scalar field on a mesh, made by `compute`.

    Nodes, arcs, vertices and triangles are numbers from 0. The graph does not change; its arrays are read-only.

    Attributes
    ----------
    node_vertices : (nodes,) array of int
        The vertex of the mesh at each node.
    node_values : (nodes,) array
        Its scalar, in the dtype of the scalars.
    node_kinds : (nodes,) array of str
        `minimum`, `saddle`, `maximum`, `isolated`, or `degree-two`.
    arcs : (arcs, 2) array of int
        The lower and the upper node of each arc. Two arcs can have the same ends.
    vertex_places : (vertices,) array of int
        The place of each vertex of the mesh, found when it is asked for: the number of a node, or that of an arc plus
        the number of nodes.
    vertex_arcs : (vertices,) array of int
        The same as the number of an arc, or -1 minus that of a node.
    chains : list of arrays of int
        For each arc, the ascending path of vertices that begins at its lower node; the last edge crosses the level of
        the upper node.
    n_nodes, n_arcs, n_loops, n_leaves, n_components, n_vertices : int
        Counts.
    counts : dict
        What the report of the program tells of mesh and graph.
    is_surface : bool
        Whether the mesh is an oriented manifold surface, or can be oriented as one.
    """

    def __init__(self, core: Any, field: Field, threads: int) -> None:
        self._core = core
        self._field = field
        self._threads = threads
        self._has_points = False
        self._options: dict[str, Any] = {}  # of compute()
        self._simplification: dict[str, Any] = {}
        self.node_vertices, values, kinds = self._run("nodes")
        self.node_values = values.astype(field.dtype) if field.values is None else field.values[self.node_vertices]
        self.node_kinds = KINDS[kinds]
        self.arcs = self._run("arcs")
        for array in (self.node_vertices, self.node_values, self.node_kinds, self.arcs):
            array.flags.writeable = False

    # ---- the graph

    @cached_property
    def vertex_places(self) -> np.ndarray:
        places = self._run("places")
        places.flags.writeable = False
        return places

    @property
    def vertex_arcs(self) -> np.ndarray:
        places = self.vertex_places
        return np.where(places < self.n_nodes, -1 - places, places - self.n_nodes)

    @cached_property
    def chains(self) -> list[np.ndarray]:
        return self._run("chains")

    is_surface = property(lambda self: self._core.is_surface)
    n_vertices = property(lambda self: self._field.size)
    n_nodes = property(lambda self: len(self.node_vertices))
    n_arcs = property(lambda self: len(self.arcs))
    n_leaves = property(lambda self: len(self.leaves()))
    n_loops = property(lambda self: self.n_arcs + self.n_components - self.n_nodes)

    @cached_property
    def n_components(self) -> int:
        return int(self.components().max(initial=-1)) + 1

    @cached_property
    def counts(self) -> dict[str, Any]:
        return json.loads(self._run("write", _core.Files()))

    def components(self) -> np.ndarray:
        """Return the number of the connected component of each node."""
        return self._run("components")

    def leaves(self) -> np.ndarray:
        """Return the nodes at which one arc ends, ascending."""
        return np.flatnonzero(np.bincount(self.arcs.ravel(), minlength=self.n_nodes) == 1)

    def loops(self) -> list[np.ndarray]:
        """Return independent loops, each as an array of arcs in the order in which they follow each other."""
        return self._run("loops")

    def pairs(self) -> np.recarray:
        """Find the pairs of extended persistence.

        Returns
        -------
        recarray
            A row per pair, with `kind` (`minimum-saddle`, `saddle-maximum`, `minimum-maximum`, or `loop`), `lower_node`,
            `upper_node`, `lower_value`, `upper_value`, `persistence`, and as GUDHI has them `dimension`, `birth`, and
            `death`: saddles with maxima, and loops, have dimension 1, and are born at their upper node.
        """
        lower, upper, kinds = self._run("pairs")
        low, high = self.node_values[lower], self.node_values[upper]
        is_upper = np.isin(kinds, ["saddle-maximum", "loop"])
        with np.errstate(invalid="ignore"):
            persistence = np.where(low == high, 0, np.maximum(low, high) - np.minimum(low, high)).astype(np.float64)
        columns = {
            "kind": np.array(kinds, dtype="U15"), "lower_node": lower, "upper_node": upper, "lower_value": low,
            "upper_value": high, "persistence": persistence, "dimension": is_upper.astype(np.int64),
            "birth": np.where(is_upper, high, low), "death": np.where(is_upper, low, high),
        }
        return np.rec.fromarrays(list(columns.values()), names=list(columns))

    # ---- simplification

    def simplify(
        self, threshold: float | str | None = None, *, percent: float | None = None, leaves: int | None = None,
        cancel_loops: bool = False, progress: Progress = None,
    ) -> ReebGraph:
        """Remove branches of little persistence.

        It starts from the graph that has been computed, also if this one is simplified already.

        Parameters
        ----------
        threshold : float or str, optional
            What is less persistent is removed, in units of the field, or as `'5%'`; `'auto'` is the threshold that the
            graph suggests: below the widest gap of persistences.
        percent : float, optional
            The same in percent of the range of the field.
        leaves : int, optional
            The least persistent branches are removed until so many leaves are left.
        cancel_loops : bool
            Whether loops are removed as well; with a threshold only.
        progress : callable or bool, optional
            As for `compute`.

        Returns
        -------
        ReebGraph
            The simplified graph, which leads back to the mesh as this one does.
        """
        given = {"threshold": threshold, "percent": percent, "leaves": leaves, "cancel_loops": cancel_loops}
        if isinstance(threshold, str) and threshold.strip().endswith("%") and percent is None:
            threshold, percent = None, float(threshold.strip()[:-1])
        if threshold is not None and percent is not None:
            raise ValueError("threshold and percent do not go together")
        number = threshold if percent is None else percent
        if number is None and (leaves is None or cancel_loops):
            raise ValueError("a threshold or a percentage is needed, or without cancel_loops a number of leaves")
        if number != "auto" and number is not None and not float(number) >= 0:
            raise ValueError(f"the threshold must not be negative or NaN, as {number} is")
        if leaves is not None and operator.index(leaves) < 0:
            raise ValueError(f"the number of leaves must not be negative, as {leaves} is")
        number = None if number is None else math.nan if number == "auto" else float(number)
        core = self._run("simplify", number, percent is not None, leaves, bool(cancel_loops), progress=progress)
        simplified = ReebGraph(core, self._field, self._threads)
        simplified._has_points, simplified._options, simplified._simplification = self._has_points, self._options, given
        return simplified

    def simplified_scalars(self, *, progress: Progress = None) -> np.ndarray:
        """Compute a field on the mesh that has this simplified graph.

        Pieces that have been removed get values next to that of their saddle, or, where no field has the graph
        otherwise, that value itself: then there is a warning, and `ties='contract'` gives the graph.

        Returns
        -------
        (vertices,) array of float
            The given scalars, if nothing has been removed.

        Raises
        ------
        ValueError
            if the mesh is no surface, loops have been cancelled, or the scalars are ranked
        """
        if not self._simplification:
            return self._run("mesh_arrays")[-1] if self._field.values is None else self._field.values.copy()
        if not self.is_surface or self._field.values is not None or self._simplification["cancel_loops"]:
            raise ValueError("only simplified graphs of surfaces and of doubles, with all their loops, have such a field")
        scalars, are_ties_contracted = self._run("simplified_scalars", progress=progress)
        if are_ties_contracted[0]:
            warnings.warn("the simplified field has its graph with ties='contract' only", stacklevel=2)
        return scalars

    # ---- the way back to the mesh

    def contour(self, arc: int, t: float) -> Contour:
        """Trace the contour of an arc.

        Parameters
        ----------
        arc : int
        t : float
            The place between the lower node, 0, and the upper one, 1, both excluded; linear in the values.

        Returns
        -------
        Contour
            An array of points that tells more, see there.
        """
        return self._contours(self._number(arc, self.n_arcs, "arc"), float(t), None)[0]

    def contours(self, level: float) -> list[Contour]:
        """Trace all contours at a level: those just above the last vertex whose scalar is at most `level`."""
        if np.isnan(level):
            raise ValueError("the level is not a number (NaN)")
        return self._contours(None, None, self._field.place(level))

    def contours_of_arcs(self, t: float = 0.5) -> list[Contour]:
        """Trace the contour of each arc at the place `t` between its nodes."""
        return self._contours(None, float(t), None)

    def critical_set(self, node: int) -> CriticalSet:
        """Return what a node stands for: the contours that meet there, and more."""
        self._need_points("a critical set")
        lower, upper, star, loop = self._run("critical_set", self._number(node, self.n_nodes, "node"))
        return CriticalSet([self._contour(c) for c in lower], [self._contour(c) for c in upper], star, loop)

    def lengths(self) -> np.ndarray:
        """Measure the length of each arc along its chain, up to the level of its upper node."""
        return self._measure("length")

    def areas(self) -> np.ndarray:
        """Measure the area of the triangles that belongs to each arc. In tetrahedra, arcs have `volumes` instead."""
        return self._measure("area")

    def volumes(self) -> np.ndarray:
        """Measure the volume of the tetrahedra that belongs to each arc."""
        return self._measure("volume")

    def embed(self, manner: str | None = None, *, progress: Progress = None) -> Embedding:
        """Put the graph into space.

        Parameters
        ----------
        manner : {'centroids', 'on-surface', 'straight'}, optional
            Through the centroids of contours, ascending on the surface, or straight from node to node. By default the
            first one, or the last one where contours are very long, or the mesh is no surface.

        Returns
        -------
        Embedding
        """
        self._need_points("an embedding")
        by_default = _core.Manner.by_cost if self.is_surface else _core.Manner.straight
        found, points, polylines, values = self._run("embed", _manner(manner) or by_default, progress=progress)
        base = float(self._field.base)
        name = _core.Manner(int(found[0])).name.replace("_", "-")
        return Embedding(name, points, polylines, [numbers + base for numbers in values])

    # ---- files and other packages

    def write(
        self, path: str | os.PathLike[str], *, what: str | None = None, title: str = "Reeb graph", name: str = "scalars",
        unit: str = "", embedding: str | None = None, progress: Progress = None,
    ) -> None:
        """Write a file; the end of its name tells which one.

        `.graphml`, `.dot`, `.svg`, and in space `.vtp`, `.obj`, `.polylines.txt`, `.json`, and `.csv`, which stands for
        the tables `.nodes.csv` and `.arcs.csv`: the graph; `.html`: a page that shows it with the surface; `.ply`: the
        surface with the arc of each vertex, and colours; `.pers`: the pairs before it was simplified, as GUDHI has them.

        Parameters
        ----------
        path : path
        what : {'graph', 'page', 'mesh', 'pairs', 'diagram', 'vertex_arcs', 'simplified_scalars'}, optional
            What is written, if that is not what the end of the name stands for. The formats are those of the program.
        title : str
            The title of a page.
        name, unit : str
            What drawings call the field, and what it is measured in.
        embedding : {'centroids', 'on-surface', 'straight'}, optional
            Where arcs are in space, as for `embed`.
        progress : callable or bool, optional
            As for `compute`.

        Raises
        ------
        ValueError
            if there is no such format, or it needs points, or a surface
        OSError
            if the file cannot be written

        Notes
        -----
        Of integers that no double has, pages, drawings, and meshes show the differences to the least one; the name of
        the field tells so. Other files have the doubles next to the values.
        """
        path = Path(path)
        what = what or {".html": "page", ".ply": "mesh", ".pers": "pairs"}.get(path.suffix, "graph")
        in_space = path.name.endswith((".vtp", ".obj", ".polylines.txt", ".json", ".csv"))
        if what in ("page", "mesh") or (what == "graph" and in_space):
            self._need_points(path.suffix)
        files = _core.Files()
        if what not in ("graph", "page", "mesh", "pairs", "diagram", "vertex_arcs", "simplified_scalars"):
            raise ValueError(f"there is no {what!r} to write")
        setattr(files, what, os.fsencode(path))
        base = self._field.base
        is_seen = what in ("page", "mesh", "diagram") or path.suffix == ".svg"
        files.base = 0 if is_seen else float(base)
        files.name = f"{name} - {base}" if is_seen and base != 0 else name
        files.title, files.unit, files.embedding = title, unit, _manner(embedding)
        self._run("write", files, progress=progress)

    def show(self, **options: Any) -> Path:
        """Show the page in the browser. Returns its file, a temporary one. `options` are those of `write`."""
        import webbrowser

        path = Path(tempfile.mkdtemp(prefix="reeb_graph_")) / "reeb_graph.html"
        self.write(path, **options)
        webbrowser.open(path.as_uri())
        return path

    def to_iframe(self, width: str | int = "100%", height: int = 600, **options: Any) -> Page:
        """Return the page in a frame for notebooks. `options` are those of `write`."""
        return Page(self._text(".html", **options), width, height)

    def _repr_svg_(self) -> str | None:
        return self._text(".svg") if self.n_arcs <= LARGEST_DRAWING else None

    def to_networkx(self, directed: bool = False) -> Any:
        """Return the graph as a `networkx.MultiGraph`, or as a `MultiDiGraph` whose arcs ascend.

        Nodes are the numbers of nodes, with the attributes `vertex`, `value`, `kind`, and `point`; the key of an arc is
        its number, and its attributes are `index`, `lower_value`, `upper_value`, and with points `persistence`, `length`,
        `area` or in tetrahedra `volume`, and `vertices`, how many belong to it.
        """
        import networkx

        graph = networkx.MultiDiGraph() if directed else networkx.MultiGraph()
        points = self._run("embed", _core.Manner.straight)[1].tolist() if self._has_points else []
        values = self.node_values.tolist()
        for node, vertex in enumerate(self.node_vertices.tolist()):
            graph.add_node(node, vertex=vertex, value=values[node], kind=str(self.node_kinds[node]))
            if points:
                graph.nodes[node]["point"] = tuple(points[node])
        measures = {name: column.tolist() for name, column in self._measures.items()} if self._has_points else {}
        for arc, (lower, upper) in enumerate(self.arcs.tolist()):
            attributes = {name: column[arc] for name, column in measures.items()}
            attributes.update(index=arc, lower_value=values[lower], upper_value=values[upper])
            graph.add_edge(lower, upper, key=arc, **attributes)
        return graph

    def to_pyvista(self, manner: str | None = None) -> Any:
        """Return the embedded graph as a `pyvista.PolyData` of lines, with `arc` for each, and `scalars` of its points."""
        import pyvista

        embedding = self.embed(manner)
        sizes = [len(polyline) for polyline in embedding.arc_polylines]
        starts = np.cumsum([0, *sizes])
        lines = [np.r_[size, start : start + size] for size, start in zip(sizes, starts)]
        graph = pyvista.PolyData(
            np.concatenate([*embedding.arc_polylines, np.zeros((0, 3))]),
            lines=np.concatenate([*lines, np.zeros(0, dtype=np.int64)]).astype(np.int64),
        )
        graph.cell_data["arc"] = np.arange(self.n_arcs)
        graph.point_data["scalars"] = np.concatenate([*embedding.arc_values, np.zeros(0)])
        return graph

    # ---- of Python

    def __repr__(self) -> str:
        simplified = "simplified " if self._simplification else ""
        mesh = "surface" if self.is_surface else "complex"
        return (
            f"<{simplified}ReebGraph of a {mesh} with {self.n_vertices} vertices: {self.n_nodes} nodes, {self.n_arcs} arcs, "
            f"{self.n_loops} loops, {self.n_components} components>"
        )

    def __len__(self) -> int:
        return self.n_nodes

    def __copy__(self) -> ReebGraph:
        copy = ReebGraph.__new__(ReebGraph)
        copy.__dict__.update(self.__dict__)
        return copy

    def __deepcopy__(self, memo: dict[int, Any]) -> ReebGraph:
        return self.__copy__()  # nothing of it changes

    def __reduce__(self) -> tuple[Any, ...]:
        triangles, points, edges, tetrahedra, scalars = self._run("mesh_arrays")
        values = scalars.astype(self._field.dtype) if self._field.values is None else self._field.values
        arrays = {"points": points if self._has_points else None, "edges": edges, "tetrahedra": tetrahedra}
        return _rebuild, (triangles, values, {**arrays, **self._options}, self._simplification)

    # ---- what the methods share

    def _run(self, name: str, *arguments: Any, progress: Progress = None) -> Any:
        return getattr(self._core, name)(*arguments, self._threads, progress_function(progress, name))

    def _text(self, ending: str, **options: Any) -> str:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / ("graph" + ending)
            self.write(path, **options)
            return path.read_text(encoding="utf-8")

    @cached_property
    def _measures(self) -> dict[str, np.ndarray]:
        self._need_points("a length or an area")
        return dict(zip(*self._run("measures")))

    def _measure(self, name: str) -> np.ndarray:
        if name not in self._measures:
            raise ValueError(f"an arc has no {name} there, only {', '.join(self._measures)}")
        return self._measures[name].copy()

    def _need_points(self, what: str) -> None:
        if not self._has_points:
            raise ValueError(f"{what} needs the points of the vertices: compute(triangles, scalars, points=points)")

    @staticmethod
    def _number(number: int, count: int, name: str) -> int:
        number = operator.index(number)
        if not 0 <= number < count:
            raise NumberError(f"there is no {name} {number}: the graph has {count}, numbered from 0")
        return number

    def _contours(self, arc: int | None, t: float | None, level: float | None) -> list[Contour]:
        self._need_points("a contour")
        return [self._contour(contour) for contour in self._run("contours", arc, t, level)]

    def _contour(self, found: dict[str, Any]) -> Contour:
        points = found.pop("points")
        if self.is_surface and found["closed"]:
            points = np.concatenate([points, points[:1]])
        contour = points.view(Contour)
        contour.__dict__.update(found, value=found["value"] + float(self._field.base))
        return contour


def _manner(name: str | None) -> Any:
    if name is None:
        return None
    manners = {"centroids": _core.Manner.centroids, "on-surface": _core.Manner.on_surface, "straight": _core.Manner.straight}
    if name not in manners:
        raise ValueError(f"the manner of an embedding is one of {', '.join(manners)}, not {name!r}")
    return manners[name]


def _rebuild(triangles: Any, scalars: Any, arguments: dict[str, Any], simplification: dict[str, Any]) -> ReebGraph:
    graph = compute(triangles, scalars, **arguments)
    return graph.simplify(**simplification) if simplification else graph


def compute(
    triangles: Any, scalars: Any, *, points: Any = None, edges: Any = None, tetrahedra: Any = None, order: Any = None,
    ties: str = "perturb", keep_degree_2: bool = False, threads: int | None = None, progress: Progress = None,
) -> ReebGraph:
    """Compute the Reeb graph of a scalar field on a mesh.

    It is exact: only comparisons of the scalars decide it. What has no points has the graph all the same.

    Parameters
    ----------
    triangles : (m, 3) array of integers, a mesh, or None
        The numbers of the vertices of each triangle. Or a mesh of another package, as `mesh_arrays` takes it, whose
        points, edges and tetrahedra are those that are not given.
    scalars : (n,) array of real numbers
        The value of each vertex: n is the number of vertices. Integers that no double has are compared as they are. With
        a mesh, it can be the name of its data.
    points : (n, 3) array of real numbers, optional
        The points of the vertices, which contours and pictures need; the third coordinate may be left out.
    edges : (k, 2) array of integers, optional
        Edges that are on no triangle.
    tetrahedra : (l, 4) array of integers, optional
    order : (n,) array, optional
        The ranks of the vertices, which decide instead of the scalars. Where scalars do not ascend with them, thresholds,
        places on arcs, and files are in units of ranks.
    ties : {'perturb', 'contract'}
        Vertices of equal value are ordered by their numbers, or arcs of length zero are contracted.
    keep_degree_2 : bool
        Whether critical vertices that join one contour to one contour stay as nodes.
    threads : int, optional
        How many threads work; one per core by default. The graph is the same.
    progress : callable or bool, optional
        Is called with a fraction from 0 to 1 now and then; the work stops if it returns False. True shows a bar.

    Returns
    -------
    ReebGraph

    Raises
    ------
    MeshError
        a ValueError: a vertex does not exist, or a scalar is NaN; its attributes `vertex` and `face` tell which one
    ValueError
        for another shape than those above
    TypeError
        for another dtype
    StoppedError
        if `progress` returns False

    Notes
    -----
    The method: M. Hajij, P. Rosen, *An Efficient Data Retrieval Parallel Reeb Graph Algorithm*, 2020, and contour trees
    of the surface cut along contours that close loops (J. Tierny and others, 2009). Near-linear in time for any field.

    The interpreter's lock is released meanwhile. What another thread could write is copied before: indices, points, and
    scalars, but for contiguous ones of float64 that are read-only as all arrays that they are a view of.

    Examples
    --------
    >>> import numpy as np, reeb_graph
    >>> triangles = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
    >>> reeb_graph.compute(triangles, [0.0, 1.0, 2.0, 3.0]).arcs
    array([[0, 1]])
    """
    if ties not in ("perturb", "contract"):
        raise ValueError(f"ties is 'perturb' or 'contract', not {ties!r}")
    mesh = _arrays.take(triangles, points, edges, tetrahedra)
    order = None if order is None else np.array(order)
    field = Field(_arrays.scalars_of(mesh, scalars), order)
    number = _arrays.threads_number(threads)
    core = _core.compute(
        _arrays.to_core(mesh, field.size), field.doubles, ties == "contract", bool(keep_degree_2), number,
        progress_function(progress, "Reeb graph"),
    )
    field.doubles = None  # the extension has them
    graph = ReebGraph(core, field, number)
    graph._has_points = mesh.points is not None
    graph._options = {"order": order, "ties": ties, "keep_degree_2": keep_degree_2, "threads": threads}
    return graph
