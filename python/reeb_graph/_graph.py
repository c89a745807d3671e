"""The Reeb graph of arrays."""

from __future__ import annotations

import html
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
from ._results import Contour, CriticalSet, Embedding, Page, count
from ._run import Progress, run

KINDS = np.array(["isolated", "minimum", "saddle", "maximum", "degree-two"])
FILES = ("graph", "page", "mesh", "pairs", "diagram", "loop", "vertex_arcs", "simplified_scalars")
LARGEST_DRAWING = 2000  # arcs that a notebook shows without being asked


class ReebGraph:
    """The Reeb graph of a scalar field on a mesh, made by `compute`.

    Nodes, arcs, vertices and triangles are numbers from 0. The graph does not change; its arrays are read-only.
    Methods that can take long take `progress`, as `compute` does.

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
    vertex_arcs : (vertices,) array of int
        The segment of each vertex: the number of the arc that it belongs to, or -1 minus that of the node that it is at.
    vertex_places : (vertices,) array of int
        The same without negative numbers: the number of a node, or that of an arc plus the number of nodes.
    chains : list of arrays of int
        For each arc, the ascending path of vertices that begins at its lower node; the last edge crosses the level of
        the upper node.
    n_nodes, n_arcs, n_loops, n_leaves, n_components, n_vertices : int
        Counts.
    counts : dict
        What the program reports of mesh and graph. `thresholds` has those that matter for `simplify` as dicts of
        `threshold`, `gap`, `nodes`, `leaves`, `loops`, and `suggested`; `suggested_threshold` is that of `'auto'`.
    is_surface : bool
        Whether the mesh is an oriented manifold surface, or can be oriented as one.
    """

    def __init__(self, core: Any, field: Field, options: dict[str, Any], simplification: dict[str, Any]) -> None:
        self._core = core
        self._field = field
        self._options = options  # of compute(), and whether there are points
        self._simplification = simplification
        nodes, doubles, self.arcs = self._run("table")
        self.node_vertices, kinds, self._components = np.ascontiguousarray(nodes.T)
        self.node_values, self.node_kinds = field.of_vertices(self.node_vertices, doubles), KINDS[kinds]
        for array in (self.node_vertices, self.node_values, self.node_kinds, self.arcs):
            array.flags.writeable = False

    # ---- the graph

    @cached_property
    def vertex_places(self) -> np.ndarray:
        places = self._run("places")
        places.flags.writeable = False
        return places

    @cached_property
    def chains(self) -> list[np.ndarray]:
        return self._run("chains")

    @cached_property
    def counts(self) -> dict[str, Any]:
        return json.loads(self._run("write", _core.Files()))

    vertex_arcs = property(lambda self: np.where(
        self.vertex_places < self.n_nodes, -1 - self.vertex_places, self.vertex_places - self.n_nodes))
    is_surface = property(lambda self: self._core.is_surface)
    n_vertices = property(lambda self: self._field.size)
    n_nodes = property(lambda self: len(self.node_vertices))
    n_arcs = property(lambda self: len(self.arcs))
    n_leaves = property(lambda self: len(self.leaves()))
    n_loops = property(lambda self: self.n_arcs + self.n_components - self.n_nodes)
    n_components = property(lambda self: int(self._components.max(initial=-1)) + 1)

    def components(self) -> np.ndarray:
        """Return the number of the connected component of each node."""
        return self._components.copy()

    def leaves(self) -> np.ndarray:
        """Return the nodes at which one arc ends, ascending."""
        return np.flatnonzero(np.bincount(self.arcs.ravel(), minlength=self.n_nodes) == 1)

    def loops(self) -> list[np.ndarray]:
        """Return independent loops, each as an array of arcs in the order in which they follow each other."""
        return self._run("loops")

    def pairs(self) -> np.recarray:
        """Find the pairs of extended persistence, as a recarray with a row per pair.

        Its columns are `kind` (`minimum-saddle`, `saddle-maximum`, `minimum-maximum`, or `loop`), `lower_node`,
        `upper_node`, `lower_value`, `upper_value`, `persistence`, and as GUDHI has them `dimension`, `birth`, and
        `death`: saddles with maxima, and loops, have dimension 1, and are born at their upper node.
        """
        nodes, kinds = self._run("pairs")
        lower, upper = nodes.T
        low, high = self.node_values[lower], self.node_values[upper]
        is_upper = np.isin(kinds, ["saddle-maximum", "loop"])
        with np.errstate(invalid="ignore"):
            persistence = np.where(low == high, 0, np.maximum(low, high) - np.minimum(low, high)).astype(np.float64)
        birth, death = np.where(is_upper, [high, low], [low, high])
        columns = [np.array(kinds, dtype="U15"), lower, upper, low, high, persistence, is_upper.astype(int), birth, death]
        names = "kind,lower_node,upper_node,lower_value,upper_value,persistence,dimension,birth,death"
        return np.rec.fromarrays(columns, names=names)

    # ---- simplification

    def simplify(
        self, threshold: float | str | None = None, *, percent: float | None = None, leaves: int | None = None,
        cancel_loops: bool = False, progress: Progress = None,
    ) -> ReebGraph:
        """Remove branches of little persistence.

        It starts from the graph that has been computed, also if this one is simplified already. The simplified graph leads
        back to the mesh as this one does.

        Parameters
        ----------
        threshold : float or str, optional
            Removes what is less persistent, in units of the field, or as `'5 %'`; `'auto'` is the threshold that the
            graph suggests, `counts["suggested_threshold"]`.
        percent : float, optional
            The same in percent of the range of the field.
        leaves : int, optional
            The least persistent branches are removed until so many leaves are left.
        cancel_loops : bool
            Whether loops are removed as well; with a threshold only.
        """
        if percent is not None:
            if threshold is not None:
                raise ValueError("threshold and percent do not go together")
            threshold = f"{_arrays.real(percent, 'percent')!r}%"
        if threshold is None and (leaves is None or cancel_loops):
            raise ValueError("a threshold or a percentage is needed, or without cancel_loops a number of leaves")
        threshold = threshold.strip() if isinstance(threshold, str) else _arrays.measure(threshold, "the threshold")
        leaves = _arrays.count_of(leaves, "the number of leaves", 0)
        given = {"threshold": threshold, "leaves": leaves, "cancel_loops": cancel_loops}
        core = self._run("simplify", threshold, leaves, bool(cancel_loops), progress=progress)
        return ReebGraph(core, self._field, self._options, given)

    def simplified_scalars(self, *, progress: Progress = None) -> np.ndarray:
        """Compute a field on the mesh that has this simplified graph.

        Pieces that have been removed get values next to that of their saddle, or, where no field has the graph
        otherwise, that value itself: then there is a warning, and `ties='contract'` gives the graph. If nothing has been
        removed, it is the given field. It is a ValueError if the mesh is not a surface, or loops have been cancelled, or the
        scalars are ranked.
        """
        if not self._simplification:
            return self._scalars()
        if not self.is_surface or self._field.values is not None or self._simplification["cancel_loops"]:
            raise ValueError("only simplified graphs of surfaces and of doubles, with all their loops, have such a field")
        scalars, are_ties_contracted = self._run("simplified_scalars", progress=progress)
        if are_ties_contracted:
            warnings.warn("the simplified field has its graph with ties='contract' only", stacklevel=2)
        return scalars

    # ---- the way back to the mesh

    def contour(self, arc: int, t: float, parametrization: Any = None) -> Contour:
        """Trace the contour of an arc at the place `t` between its lower node, 0, and its upper one, 1, both excluded.

        The contour is an array of points that knows more, see `reeb_graph.Contour`.

        Parameters
        ----------
        arc : int
        t : float
        parametrization : 'unit-gradient' or (vertices,) array of numbers, optional
            The field whose absolute differences along the chain of the arc add up to `t`. By default `t` is linear in
            the values of the field of the graph. With its unit gradient field, which needs a surface, equal steps of `t`
            are about equal distances.
        """
        place = self._number(arc, self.n_arcs, "arc"), _arrays.real(t, "t")
        return self._contours(*place, parametrization=parametrization)[0]

    def contours(self, level: float) -> list[Contour]:
        """Trace all contours of the level of a value: those just above the last vertex whose scalar is at most `level`."""
        if np.isnan(_arrays.real(level, "the level")):
            raise ValueError("the level is not a number (NaN)")
        return self._contours(level=self._field.place(level))

    def contours_of_arcs(self, t: float = 0.5, parametrization: Any = None) -> list[Contour]:
        """Trace the contour of each arc at the place `t` between its nodes, parametrized as for `contour`."""
        return self._contours(t=_arrays.real(t, "t"), parametrization=parametrization)

    def critical_set(self, node: int) -> CriticalSet:
        """Return what a node stands for: the contours that meet there, and more."""
        self._need_points("a critical set")
        lower, upper, star, loop = self._run("critical_set", self._number(node, self.n_nodes, "node"))
        return CriticalSet([self._contour(c) for c in lower], [self._contour(c) for c in upper], star, loop)

    def measures(self) -> dict[str, np.ndarray]:
        """Measure the arcs: all numbers that a file of the graph has for them, by name, each as an array."""
        return {name: column.copy() for name, column in self._measures.items()}

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

        The manner is `'centroids'`, through the centroids of contours, `'on-surface'`, ascending there, or `'straight'`,
        from node to node. It is the first one by default, but the last one where contours are very long, or the mesh is
        no surface.
        """
        self._need_points("an embedding")
        manner_of_it, points, polylines, values = self._run("embed", _manner(manner), progress=progress)
        base = float(self._field.base)
        return Embedding(manner_of_it.name, points, polylines, [numbers + base for numbers in values])

    def longest_loop(self) -> np.ndarray:
        """Return the points of a shortest closed curve through both nodes of the most persistent loop."""
        self._need_points("a loop")
        return self._run("longest_loop")

    # ---- files and other packages

    def write(
        self, path: str | os.PathLike[str], *, what: str | None = None, title: str = "Reeb graph", name: str = "scalars",
        unit: str = "", embedding: str | None = None, progress: Progress = None,
    ) -> None:
        """Write a file; the end of its name tells which one.

        `.svg`, a drawing, `.graphml`, `.dot`, and in space `.vtp`, `.obj`, `.polylines.txt`, `.json`, and `.csv`, which
        stands for the tables `.nodes.csv` and `.arcs.csv`: the graph; `.html`: a page that shows it with the surface;
        `.ply`: the surface with the arc of each vertex, and colors; `.pers`: the pairs before it was simplified.

        Parameters
        ----------
        path : path
        what : {'graph', 'page', 'mesh', 'pairs', 'diagram', 'loop', 'vertex_arcs', 'simplified_scalars'}, optional
            What is written, if that is not what the end of the name stands for. The formats are those of the program.
        title : str
            The title of a page.
        name, unit : str
            What drawings call the field, and what it is measured in.
        embedding : {'centroids', 'on-surface', 'straight'}, optional
            Where arcs are in space, as for `embed`.

        Notes
        -----
        What needs points or a surface that are not there is a ValueError, and a file that cannot be written an OSError.
        What the format has no room for is a UserWarning.
        Pages, drawings, and meshes show large integers, which a double cannot hold, as differences from the least one;
        the name of the field tells so. Other files have the doubles next to the values.
        """
        path = Path(path)
        what = what or {".html": "page", ".ply": "mesh", ".pers": "pairs"}.get(path.suffix, "graph")
        in_space = path.name.endswith((".vtp", ".obj", ".polylines.txt", ".json", ".csv"))
        if what in ("page", "mesh", "loop") or (what == "graph" and in_space):
            self._need_points(path.suffix)
        is_seen = what in ("page", "mesh", "diagram") or path.suffix == ".svg"
        base = self._field.base
        files = _core.Files()
        setattr(files, _arrays.one_of(what, FILES, "what is written"), os.fsencode(path))
        files.base = 0 if is_seen else float(base)
        files.name = f"{name} - {base}" if is_seen and base != 0 else name
        files.title, files.unit, files.embedding = title, unit, _manner(embedding)
        for note in json.loads(self._run("write", files, progress=progress))["notes"]:
            warnings.warn(note, stacklevel=2)

    def show(self, **options: Any) -> Path:
        """Show the page in the browser. Returns its file, a temporary one. `options` are those of `write`."""
        import webbrowser

        path = Path(tempfile.mkdtemp(prefix="reeb_graph_")) / "reeb_graph.html"
        self.write(path, **options)
        webbrowser.open(path.as_uri())
        return path

    def to_iframe(self, width: str | int = "100%", height: int = 600, **options: Any) -> Page:
        """Return the page in a frame for notebooks. `options` are those of `write`."""
        page = html.escape(self._text(".html", **options))
        return Page(f'<iframe srcdoc="{page}" width="{width}" height="{height}" style="border: 0"></iframe>')

    def _repr_svg_(self) -> str | None:
        return self._text(".svg") if self.n_arcs <= LARGEST_DRAWING else None

    def to_networkx(self, directed: bool = False) -> Any:
        """Return the graph as a `networkx.MultiGraph`, or as a `MultiDiGraph` whose arcs ascend.

        Nodes are the numbers of nodes, with the attributes `vertex`, `value`, `kind`, and `point`; the key of an arc is
        its number, and its attributes are `index`, `lower_value`, `upper_value`, and with points its `measures`.
        """
        import networkx

        nodes = {"vertex": self.node_vertices, "value": self.node_values, "kind": self.node_kinds}
        lower_values, upper_values = self.node_values[self.arcs].T
        arcs = {"index": np.arange(self.n_arcs), "lower_value": lower_values, "upper_value": upper_values}
        graph = networkx.MultiDiGraph() if directed else networkx.MultiGraph()
        graph.add_nodes_from(enumerate(_rows(nodes)))
        if self._options["has_points"]:
            arcs.update(self._measures)
            points = self.embed("straight").node_points.tolist()
            networkx.set_node_attributes(graph, dict(enumerate(map(tuple, points))), "point")
        graph.add_edges_from((*ends, arc["index"], arc) for ends, arc in zip(self.arcs.tolist(), _rows(arcs)))
        return graph

    def to_pyvista(self, manner: str | None = None) -> Any:
        """Return the embedded graph as a `pyvista.PolyData` of lines, with `arc` for each, and `scalars` of its points."""
        import pyvista

        embedding = self.embed(manner)
        sizes = [len(polyline) for polyline in embedding.arc_polylines]
        starts = np.cumsum([0, *sizes])
        lines = np.insert(np.arange(starts[-1]), starts[:-1], sizes)  # each begins with its number of points
        graph = pyvista.PolyData(np.concatenate([*embedding.arc_polylines, np.zeros((0, 3))]), lines=lines)
        graph.cell_data["arc"] = np.arange(self.n_arcs)
        graph.point_data["scalars"] = np.concatenate([*embedding.arc_values, np.zeros(0)])
        return graph

    # ---- of Python

    def __repr__(self) -> str:
        simplified = "simplified " if self._simplification else ""
        mesh = "surface" if self.is_surface else "complex"
        parts = ", ".join(count(getattr(self, f"n_{noun}s"), noun) for noun in ("node", "arc", "loop", "component"))
        return f"<{simplified}ReebGraph of a {mesh} with {self.n_vertices} vertices: {parts}>"

    def __len__(self) -> int:
        return self.n_nodes

    def __copy__(self, memo: Any = None) -> ReebGraph:
        return self  # nothing of it changes

    __deepcopy__ = __copy__

    def __reduce__(self) -> tuple[Any, ...]:
        triangles, points, edges, tetrahedra, _ = self._run("mesh_arrays")
        arguments = {"edges": edges, "tetrahedra": tetrahedra, **self._options}
        arguments["points"] = points if arguments.pop("has_points") else None
        return _rebuild, (triangles, self._scalars(), arguments, self._simplification)

    # ---- what the methods share

    def _run(self, name: str, *arguments: Any, progress: Progress = None) -> Any:
        threads = self._options["threads"]
        return run(getattr(self._core, name), *arguments, threads=threads, progress=progress, name=name)

    def _scalars(self) -> np.ndarray:
        return self._field.of_vertices(slice(None), self._run("mesh_arrays")[-1])

    def _text(self, ending: str, **options: Any) -> str:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / ("graph" + ending)
            self.write(path, **options)
            return path.read_text(encoding="utf-8")

    @cached_property
    def _measures(self) -> dict[str, np.ndarray]:
        self._need_points("a length or an area")
        base = float(self._field.base)
        return {name: column + base if is_value else column for name, column, is_value in zip(*self._run("measures"))}

    def _measure(self, name: str) -> np.ndarray:
        if name not in self._measures:
            raise ValueError(f"an arc has no {name} there, only {', '.join(self._measures)}")
        return self._measures[name].copy()

    def _need_points(self, what: str) -> None:
        if not self._options["has_points"]:
            raise ValueError(f"{what} needs the points of the vertices: compute(triangles, scalars, points=points)")

    @staticmethod
    def _number(number: int, count: int, name: str) -> int:
        try:
            number = operator.index(number)
        except TypeError:
            raise TypeError(f"the number of {name} has to be an integer, not {number!r}") from None
        if not 0 <= number < count:
            raise NumberError(f"there is no {name} {number}: the graph has {count}, numbered from 0")
        return number

    @cached_property
    def _unit_gradient(self) -> np.ndarray:
        return self._run("unit_gradient")

    def _parametrization(self, given: Any) -> np.ndarray | None:
        if given is None:
            return None
        if isinstance(given, str):
            _arrays.one_of(given, ("unit-gradient",), "a parametrization that is no array")
            return self._unit_gradient
        values = _arrays.doubles(given, "parametrization")
        if len(values) != self.n_vertices:
            raise ValueError(f"parametrization has {len(values)} numbers for {self.n_vertices} vertices")
        return values

    def _contours(
        self, arc: int | None = None, t: float | None = None, level: float | None = None, parametrization: Any = None
    ) -> list[Contour]:
        self._need_points("a contour")
        found = self._run("contours", arc, t, level, self._parametrization(parametrization))
        return [self._contour(contour) for contour in found]

    def _contour(self, found: tuple[Any, ...]) -> Contour:
        arc, value, closed, edges, points, polylines, triangles = found
        if self.is_surface and closed:
            points = np.concatenate([points, points[:1]])
        return Contour._of(points, arc, value + float(self._field.base), closed, edges, polylines, triangles)


def _manner(name: str | None) -> Any:
    manners = _core.Manner.__members__
    return None if name is None else manners[_arrays.one_of(name, manners, "the manner of an embedding")]


def _rows(columns: dict[str, np.ndarray]) -> list[dict[str, Any]]:
    return [dict(zip(columns, row)) for row in zip(*(column.tolist() for column in columns.values()))]


def _rebuild(triangles: Any, scalars: Any, arguments: dict[str, Any], simplification: dict[str, Any]) -> ReebGraph:
    graph = compute(triangles, scalars, **arguments)
    return graph.simplify(**simplification) if simplification else graph


def compute(
    triangles: Any, scalars: Any, *, points: Any = None, edges: Any = None, tetrahedra: Any = None, order: Any = None,
    ties: str = "perturb", keep_degree_2: bool = False, threads: int | None = None, progress: Progress = None,
) -> ReebGraph:
    """Compute the Reeb graph of a scalar field on a mesh.

    It is exact: only comparisons of the scalars decide it. The graph needs no points.

    Parameters
    ----------
    triangles : (m, 3) array of integers, a mesh, the name of a file, or None
        The numbers of the vertices of each triangle. Or a file, as `read` takes it, or a mesh of another package, as
        `mesh_arrays` does, whose points, edges and tetrahedra are those that are not given.
    scalars : (n,) array of real numbers
        The value of each vertex: n is the number of vertices. Large integers, which a double cannot hold, are compared
        as they are. With a mesh, it can be the name of its data, or x, y, or z.
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
    ValueError, TypeError
        for another shape, or another dtype, than those above
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
    all_ties = _core.Ties.__members__
    _arrays.one_of(ties, all_ties, "ties")
    mesh = _arrays.take(triangles, points, edges, tetrahedra)
    if order is not None:
        _arrays.refuse_mask(order, "vertex")
        order = np.array(order)
    field = Field(_arrays.scalars_of(mesh, scalars), order)
    arguments = mesh.checked(field.size), field.doubles, all_ties[ties], bool(keep_degree_2)
    core = run(_core.compute, *arguments, threads=threads, progress=progress, name="Reeb graph")
    del field.doubles  # the extension has them
    options = {"order": order, "ties": ties, "keep_degree_2": keep_degree_2, "threads": threads}
    return ReebGraph(core, field, {**options, "has_points": mesh.points is not None}, {})
