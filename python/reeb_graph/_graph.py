"""The Reeb graph of arrays."""

from __future__ import annotations

import json
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
        self._options: dict[str, Any] = {}  # of compute()
        self._simplification: dict[str, Any] = {}
        self.node_vertices, values, kinds = core.nodes()
        self.node_values = values.astype(field.dtype) if field.values is None else field.values[self.node_vertices]
        self.node_kinds = KINDS[kinds]
        self.arcs = core.arcs()
        for array in (self.node_vertices, self.node_values, self.node_kinds, self.arcs):
            array.flags.writeable = False

    # ---- the graph

    @cached_property
    def vertex_places(self) -> np.ndarray:
        places = self._run(self._core.places)
        places.flags.writeable = False
        return places

    @property
    def vertex_arcs(self) -> np.ndarray:
        places = self.vertex_places
        return np.where(places < self.n_nodes, -1 - places, places - self.n_nodes)

    @cached_property
    def chains(self) -> list[np.ndarray]:
        return self._core.chains()

    @property
    def is_surface(self) -> bool:
        return self._core.is_surface

    @property
    def n_nodes(self) -> int:
        return len(self.node_vertices)

    @property
    def n_arcs(self) -> int:
        return len(self.arcs)

    @property
    def n_loops(self) -> int:
        return self.n_arcs + self.n_components - self.n_nodes

    @property
    def n_leaves(self) -> int:
        return len(self.leaves())

    @cached_property
    def n_components(self) -> int:
        return int(self.components().max(initial=-1)) + 1

    @property
    def n_vertices(self) -> int:
        return self._field.size

    @cached_property
    def counts(self) -> dict[str, Any]:
        return json.loads(self._run(self._core.report))

    def components(self) -> np.ndarray:
        """Return the number of the connected component of each node."""
        return self._core.components()

    def leaves(self) -> np.ndarray:
        """Return the nodes at which one arc ends, ascending."""
        return np.flatnonzero(np.bincount(self.arcs.ravel(), minlength=self.n_nodes) == 1)

    def loops(self) -> list[np.ndarray]:
        """Return independent loops, each as an array of arcs in the order in which they follow each other."""
        return self._core.loops()

    def pairs(self) -> np.recarray:
        """Find the pairs of extended persistence.

        Returns
        -------
        recarray
            A row per pair, with `kind` (`minimum-saddle`, `saddle-maximum`, `minimum-maximum`, or `loop`), `lower_node`,
            `upper_node`, `lower_value`, `upper_value`, `persistence`, and as GUDHI has them `dimension`, `birth`, and
            `death`: saddles with maxima, and loops, have dimension 1, and are born at their upper node.
        """
        lower, upper, kinds = self._core.pairs()
        low, high = self.node_values[lower], self.node_values[upper]
        is_upper = np.isin(kinds, ["saddle-maximum", "loop"])
        with np.errstate(invalid="ignore"):
            persistence = np.where(low == high, 0, np.maximum(low, high) - np.minimum(low, high)).astype(np.float64)
        columns = {
            "kind": np.array(kinds, dtype="U15"),
            "lower_node": lower,
            "upper_node": upper,
            "lower_value": low,
            "upper_value": high,
            "persistence": persistence,
            "dimension": is_upper.astype(np.int64),
            "birth": np.where(is_upper, high, low),
            "death": np.where(is_upper, low, high),
        }
        return np.rec.fromarrays(list(columns.values()), names=list(columns))

    # ---- simplification

    def simplify(
        self,
        threshold: float | str | None = None,
        *,
        percent: float | None = None,
        leaves: int | None = None,
        cancel_loops: bool = False,
        progress: Progress = None,
    ) -> ReebGraph:
        """Remove branches of little persistence.

        It starts from the graph that has been computed, also if this one is simplified already.

        Parameters
        ----------
        threshold : float or str, optional
            What is less persistent is removed, in units of the field, or as `'5%'`.
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
        if isinstance(threshold, str):
            if not threshold.strip().endswith("%") or percent is not None:
                raise ValueError(f"the threshold has to be a number, or one with %, not {threshold!r}")
            threshold, percent = None, float(threshold.strip()[:-1])
        if threshold is not None and percent is not None:
            raise ValueError("threshold and percent do not go together")
        if threshold is None and percent is None and leaves is None:
            raise ValueError("a threshold, a percentage, or a number of leaves is needed")
        if cancel_loops and threshold is None and percent is None:
            raise ValueError("cancel_loops goes with a threshold or a percentage only")
        number = None if threshold is None and percent is None else float(percent if threshold is None else threshold)
        if number is not None and not number >= 0:
            raise ValueError(f"the threshold must not be negative or NaN, as {number} is")
        if leaves is not None and operator.index(leaves) < 0:
            raise ValueError(f"the number of leaves must not be negative, as {leaves} is")
        core = self._core.simplify(
            number, percent is not None, leaves, bool(cancel_loops), progress_function(progress, "simplify")
        )
        simplified = ReebGraph(core, self._field, self._threads)
        simplified._options = self._options
        simplified._simplification = {
            "threshold": threshold, "percent": percent, "leaves": leaves, "cancel_loops": cancel_loops
        }
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
        if self._field.values is not None:
            if self._simplification:
                raise ValueError("there is no simplified field of scalars that are ranked, as they are no doubles")
            return self._field.values.copy()
        scalars, are_ties_contracted = self._run(self._core.simplified_scalars, progress=progress)
        if are_ties_contracted:
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
        arc = self._number(arc, self.n_arcs, "arc")
        self._need_points("a contour")
        t = float(t)
        if self._field.levels is None or not 0 < t < 1:
            return self._contour(self._run(self._core.contour_at_parameter, arc, t))
        lower, upper = self.node_vertices[self.arcs[arc]]
        lowest, highest = int(self._field.ranks[lower]), int(self._field.ranks[upper])
        if lowest == highest:
            return self._contour(self._run(self._core.contour_at_parameter, arc, t))
        value = self._field.value_between(self._field.values[lower], self._field.values[upper], t)
        rank = min(max(self._field.rank_of(value), lowest), highest - 1)
        return self._contour(self._run(self._core.contour_at_level, arc, rank, self._field.without_base(value)))

    def contours(self, level: float) -> list[Contour]:
        """Trace all contours at a level: those just above the last vertex whose scalar is at most `level`."""
        self._need_points("a contour")
        if np.isnan(level):
            raise ValueError("the level is not a number (NaN)")
        if self._field.values is None:
            return self._contours(self._run(self._core.contours_at_level, float(level), None))
        rank = self._field.rank_of(level)
        return self._contours(self._run(self._core.contours_at_level, rank, self._field.without_base(level)))

    def contours_of_arcs(self, t: float = 0.5) -> list[Contour]:
        """Trace the contour of each arc at the place `t` between its nodes."""
        return [self.contour(arc, t) for arc in range(self.n_arcs)]

    def critical_set(self, node: int) -> CriticalSet:
        """Return what a node stands for: the contours that meet there, and more."""
        self._need_points("a critical set")
        found = self._run(self._core.critical_set, self._number(node, self.n_nodes, "node"))
        lower, upper = self._contours(found["lower_contours"]), self._contours(found["upper_contours"])
        return CriticalSet(lower, upper, found["star"], found["border_loop"])

    def lengths(self) -> np.ndarray:
        """Measure the length of each arc along its chain, up to the level of its upper node."""
        return self._measures[0].copy()

    def areas(self) -> np.ndarray:
        """Measure the area of the surface that belongs to each arc."""
        return self._measures[1].copy()

    def embed(self, manner: str | None = None, *, progress: Progress = None) -> Embedding:
        """Put the graph into space.

        Parameters
        ----------
        manner : {'centroids', 'on-surface', 'straight'}, optional
            Through the centroids of contours, ascending on the surface, or straight from node to node. By default the
            first one, or the last one where contours are very long, or the mesh is no surface.
        """
        self._need_points("an embedding")
        found = self._run(self._core.embed, _manner(manner), progress=progress)
        found["manner"] = found["manner"].name.replace("_", "-")
        return Embedding(**found)

    # ---- files and other packages

    def write(
        self,
        path: str | os.PathLike[str],
        *,
        title: str = "Reeb graph",
        name: str = "scalars",
        unit: str = "",
        embedding: str | None = None,
        progress: Progress = None,
    ) -> None:
        """Write a file; the end of its name tells which one.

        `.graphml`, `.dot`, `.svg`, and in space `.vtp`, `.obj`, `.polylines.txt`, `.json`, and `.csv`, which stands for
        the tables `.nodes.csv` and `.arcs.csv`: the graph; `.html`: a page that shows it with the surface; `.ply`: the
        surface with the arc of each vertex, and colours; `.pers`: the pairs, as GUDHI has them.

        Parameters
        ----------
        path : path
        title : str
            The title of a page.
        name, unit : str
            What drawings call the field, and what it is measured in.
        embedding : {'centroids', 'on-surface', 'straight'}, optional
            Where arcs are in space, as for `embed`.

        Raises
        ------
        ValueError
            if there is no such format, or it needs points, or a surface
        OSError
            if the file cannot be written
        """
        path = Path(path)
        if path.name.endswith((".vtp", ".obj", ".polylines.txt", ".json", ".csv", ".html", ".ply")):
            self._need_points(path.suffix)
        self._core.write(
            path, title, name, unit, _manner(embedding), self._threads, progress_function(progress, path.name)
        )

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
        its number, and its attributes are `index`, `lower_value`, `upper_value`, and on a surface with points
        `persistence`, `length`, `area`, `vertices`.
        """
        import networkx

        graph = networkx.MultiDiGraph() if directed else networkx.MultiGraph()
        points = self._core.embed(_core.Manner.straight, self._threads, None)["node_points"] if self._has_points else None
        values = self.node_values.tolist()
        for node, vertex in enumerate(self.node_vertices.tolist()):
            graph.add_node(node, vertex=vertex, value=values[node], kind=str(self.node_kinds[node]))
            if points is not None:
                graph.nodes[node]["point"] = tuple(points[node].tolist())
        names = ("length", "area", "persistence", "vertices")
        measures = [m.tolist() for m in self._measures] if self._has_points and self.is_surface else []
        for arc, (lower, upper) in enumerate(self.arcs.tolist()):
            attributes = {name: column[arc] for name, column in zip(names, measures)}
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
        graph = pyvista.PolyData()
        graph.points = np.concatenate([*embedding.arc_polylines, np.zeros((0, 3))])
        graph.lines = np.concatenate([*lines, np.zeros(0, dtype=np.int64)]).astype(np.int64)
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
        triangles, points, edges, tetrahedra, scalars = self._core.mesh_arrays()
        values = scalars.astype(self._field.dtype) if self._field.values is None else self._field.values
        arrays = {"points": points if self._has_points else None, "edges": edges, "tetrahedra": tetrahedra}
        arguments = {**arrays, "order": self._field.ranks, **self._options}
        return _rebuild, (triangles, values, arguments, self._simplification)

    # ---- what the methods share

    def _run(self, function: Any, *arguments: Any, progress: Progress = None) -> Any:
        return function(*arguments, self._threads, progress_function(progress, function.__name__))

    def _text(self, ending: str, **options: Any) -> str:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / ("graph" + ending)
            self.write(path, **options)
            return path.read_text(encoding="utf-8")

    @property
    def _has_points(self) -> bool:
        return self._core.has_points

    @cached_property
    def _measures(self) -> tuple[np.ndarray, ...]:
        self._need_points("a length or an area")
        if not self.is_surface:
            raise ValueError("the measures of arcs need an oriented manifold surface, which the mesh is not")
        return self._run(self._core.measures)

    def _need_points(self, what: str) -> None:
        if not self._has_points:
            raise ValueError(f"{what} needs the points of the vertices: compute(triangles, scalars, points=points)")

    @staticmethod
    def _number(number: int, count: int, name: str) -> int:
        number = operator.index(number)
        if not 0 <= number < count:
            raise NumberError(f"there is no {name} {number}: the graph has {count}, numbered from 0")
        return number

    def _contours(self, found: list[dict[str, Any]]) -> list[Contour]:
        return [self._contour(contour) for contour in found]

    def _contour(self, found: dict[str, Any]) -> Contour:
        points = found.pop("points")
        if self.is_surface and found["closed"]:
            points = np.concatenate([points, points[:1]])
        contour = points.view(Contour)
        for name, value in found.items():
            setattr(contour, name, value)
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
    triangles: Any,
    scalars: Any,
    *,
    points: Any = None,
    edges: Any = None,
    tetrahedra: Any = None,
    order: Any = None,
    ties: str = "perturb",
    keep_degree_2: bool = False,
    threads: int | None = None,
    progress: Progress = None,
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
        The ranks of the vertices, which decide instead of the scalars.
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

    The interpreter's lock is released meanwhile. The arrays are copied before.

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
    field = Field(_arrays.scalars_of(mesh, scalars), order)
    number = _arrays.threads_number(threads)
    core = _core.compute(
        _arrays.to_core(mesh, len(field.doubles)),
        field.doubles if field.ranks is None else field.ranks,
        None if field.ranks is None else field.doubles,
        float(field.base),
        ties == "contract",
        bool(keep_degree_2),
        number,
        progress_function(progress, "Reeb graph"),
    )
    field.doubles = None  # the extension has a copy
    graph = ReebGraph(core, field, number)
    graph._options = {"ties": ties, "keep_degree_2": keep_degree_2, "threads": threads}
    return graph
