"""What a graph can tell: simplification, contours, files, other packages."""

import copy
import importlib.util
import pickle
import sys
import types
from pathlib import Path

import meshes
import numpy as np
import pytest
import reeb_graph


@pytest.fixture(scope="module")
def torus():
    triangles, points = meshes.grid(24, 16, True, True)
    scalars = points[:, 0] + 0.6 * np.random.default_rng(7).normal(size=len(points))
    return triangles, points, scalars, reeb_graph.compute(triangles, scalars, points=points)


def polylines(text):
    return [np.array(line.split()[1:], dtype=float).reshape(-1, 3) for line in text.splitlines()]


def test_simplify_as_the_program(tmp_path, torus):
    triangles, points, scalars, graph = torus
    meshes.write_off(tmp_path / "mesh.off", triangles, points)
    for arguments, options, of_program in (
        ((0.8,), {}, ["--simplify", "0.8"]),
        (("10%",), {}, ["--simplify", "10%"]),
        ((), {"percent": 30}, ["--simplify", "30%"]),
        (("30 %",), {}, ["--simplify", "30 %"]),
        ((), {"leaves": 4}, ["--leaves", "4"]),
        ((3,), {"cancel_loops": True}, ["--simplify", "3", "--cancel-loops"]),
    ):
        simplified = graph.simplify(*arguments, **options)
        expected, places = meshes.result_of_program(tmp_path, tmp_path / "mesh.off", scalars, *of_program)
        assert simplified.node_vertices.tolist() == [node["vertex"] for node in expected["nodes"]]
        assert simplified.arcs.tolist() == [[arc["source"], arc["target"]] for arc in expected["edges"]]
        assert np.array_equal(simplified.vertex_places, places)
        assert np.array_equal(simplified.simplify(0.1).arcs, graph.simplify(0.1).arcs)


def test_simplified_scalars(tmp_path, torus):
    triangles, points, scalars, graph = torus
    simplified = graph.simplify(leaves=4)
    field = simplified.simplified_scalars()
    assert reeb_graph.compute(triangles, field).n_nodes == simplified.n_nodes
    assert np.array_equal(graph.simplified_scalars(), scalars)
    meshes.write_off(tmp_path / "mesh.off", triangles, points)
    meshes.result_of_program(tmp_path, tmp_path / "mesh.off", scalars, "--leaves", "4", "--simplified-scalars",
                             tmp_path / "simplified.npy")
    assert np.array_equal(np.load(tmp_path / "simplified.npy"), field)
    with pytest.raises(ValueError):
        graph.simplify(9, cancel_loops=True).simplified_scalars()


def test_contours_as_the_program(tmp_path, torus):
    triangles, points, scalars, graph = torus
    meshes.write_off(tmp_path / "mesh.off", triangles, points)
    np.save(tmp_path / "scalars.npy", scalars)
    file = tmp_path / "contours.polylines.txt"
    for arc, t in ((0, 0.5), (graph.n_arcs // 2, 0.2), (graph.n_arcs - 1, 0.9)):
        meshes.run("contour", tmp_path / "mesh.off", "--scalars", tmp_path / "scalars.npy", "--arc", arc, "--t", t,
                   "--output", file)
        contour = graph.contour(arc, t)
        assert np.allclose(contour, polylines(file.read_text())[0], rtol=0, atol=1e-12)
        assert contour.arc == arc and contour.closed and np.array_equal(contour[0], contour[-1])
        assert np.all(scalars[contour.edges[:, 0]] <= contour.value)
        assert np.all(scalars[contour.edges[:, 1]] > contour.value)
    meshes.run("contour", tmp_path / "mesh.off", "--scalars", tmp_path / "scalars.npy", "--level", "0.1", "--output", file)
    contours = graph.contours(0.1)
    expected = polylines(file.read_text())
    assert len(contours) == len(expected)
    assert all(np.allclose(a, b, rtol=0, atol=1e-12) for a, b in zip(contours, expected))
    assert [contour.arc for contour in graph.contours_of_arcs(0.4)] == list(range(graph.n_arcs))


def test_parametrized_contours(tmp_path):
    triangles, points = meshes.grid(81, 24, False, True)
    points[:, 2] = points[:, 2] * 81 / 40 - 1  # a tube from -1 to 1
    graph = reeb_graph.compute(triangles, points[:, 2] ** 3, points=points)
    assert graph.n_arcs == 1
    unit = reeb_graph.unit_gradient(triangles, points, graph._scalars())
    np.save(tmp_path / "field.npy", graph._scalars())
    np.save(tmp_path / "unit.npy", unit)
    meshes.write_off(tmp_path / "tube.off", triangles, points)
    places = np.arange(1, 10) / 10
    steps_of = {}
    for name, parametrization in (("unit-gradient", "unit-gradient"), ("unit.npy", unit), (None, None)):
        heights = [graph.contour(0, t, parametrization=parametrization)[:, 2].mean() for t in places]
        assert np.allclose([graph.contours_of_arcs(t, parametrization)[0][:, 2].mean() for t in places], heights)
        for t, height in zip(places, heights):
            options = () if name is None else ("--parametrize", name if name == "unit-gradient" else tmp_path / name)
            meshes.run("contour", tmp_path / "tube.off", "--scalars", tmp_path / "field.npy", "--t", t, *options,
                       "--output", tmp_path / "contour.polylines.txt")
            of_program = polylines((tmp_path / "contour.polylines.txt").read_text())
            assert len(of_program) == 1 and np.isclose(of_program[0][:, 2].mean(), height, rtol=0, atol=1e-6)
        steps_of[name] = np.diff([-1, *heights, 1])
    for name in ("unit-gradient", "unit.npy"):
        assert np.all(np.abs(steps_of[name] / 0.2 - 1) < 0.05)
    assert steps_of[None].max() > 5 * steps_of[None].min()


def test_parametrization_of_what_is_no_surface():
    triangles, points = meshes.random_soup(np.random.default_rng(3), 12, 30)
    graph = reeb_graph.compute(triangles, points[:, 0], points=points)
    assert np.array_equal(graph.contour(0, 0.3, points[:, 0]), graph.contour(0, 0.3))
    with pytest.raises(ValueError, match="the field unit-gradient needs an oriented manifold surface"):
        graph.contour(0, 0.3, "unit-gradient")
    for wrong in ("unit", points[1:, 0], points, np.full(12, np.nan)):
        with pytest.raises(ValueError):
            graph.contour(0, 0.3, wrong)


def test_contours_of_complexes():
    triangles = np.array([[0, 1, 2], [0, 1, 3], [0, 1, 4]])
    points = np.array([[0, 0, 0], [0, 0, 1], [1, 0, 2], [-1, 0, 2], [0, 1, 2.0]])
    graph = reeb_graph.compute(triangles, points[:, 2], points=points)
    contours = graph.contours(0.5)
    assert len(contours) == 1 and len(contours[0].polylines) == 3 and not contours[0].closed
    tetrahedra, points = meshes.tetrahedra_of_cubes(2)
    graph = reeb_graph.compute(None, points[:, 0] + 0.1 * points[:, 1], tetrahedra=tetrahedra, points=points)
    contour = graph.contour(0, 0.5)
    assert contour.triangles.shape[1] == 3 and contour.triangles.max() == len(contour) - 1
    assert not contour.closed  # its border is on that of the cubes
    assert len(graph.critical_set(0).star) > 0
    around_the_middle = reeb_graph.compute(None, ((points - 1) ** 2).sum(axis=1), tetrahedra=tetrahedra, points=points)
    (shell,) = around_the_middle.contours(0.5)
    assert shell.closed and len(shell.triangles) > 3


def test_critical_sets(torus):
    triangles, _, _, graph = torus
    for node in range(graph.n_nodes):
        found = graph.critical_set(node)
        assert sorted(c.arc for c in found.lower_contours) == np.flatnonzero(graph.arcs[:, 1] == node).tolist()
        assert sorted(c.arc for c in found.upper_contours) == np.flatnonzero(graph.arcs[:, 0] == node).tolist()
        vertex = graph.node_vertices[node]
        assert sorted(found.star) == np.flatnonzero((triangles == vertex).any(axis=1)).tolist()


def test_measures_and_embedding(torus):
    triangles, points, scalars, graph = torus
    sides = points[triangles]
    area_of_triangles = np.linalg.norm(np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0]), axis=1) / 2
    assert np.isclose(graph.areas().sum(), area_of_triangles.sum())
    assert np.all(graph.lengths() > 0)
    integral = area_of_triangles @ scalars[triangles].mean(axis=1)
    assert np.isclose(graph.areas() @ graph.measures()["mean_value"], integral)
    base = 2**60  # which is added to values, but not to differences
    moved = reeb_graph.compute(triangles, np.round(1e6 * scalars).astype(np.int64) + base, points=points).measures()
    assert np.allclose((moved["mean_value"] - base) / 1e6, graph.measures()["mean_value"], atol=1e-3)
    assert np.allclose(moved["persistence"] / 1e6, graph.measures()["persistence"], atol=1e-3)
    for manner in ("centroids", "on-surface", "straight"):
        embedding = graph.embed(manner)
        assert embedding.manner == manner and embedding.node_points.shape == (graph.n_nodes, 3)
        for (lower, upper), polyline, values in zip(graph.arcs, embedding.arc_polylines, embedding.arc_values):
            assert np.array_equal(polyline[[0, -1]], embedding.node_points[[lower, upper]])
            assert len(values) == len(polyline) and np.all(np.diff(values) >= 0)


FORMATS = (".graphml", ".dot", ".svg", ".vtp", ".obj", ".polylines.txt", ".json", ".csv")


@pytest.mark.parametrize("ending", FORMATS)
def test_files_as_the_program(tmp_path, torus, ending):
    triangles, points, scalars, graph = torus
    meshes.write_off(tmp_path / "mesh.off", triangles, points)
    np.save(tmp_path / "scalars.npy", scalars)
    (tmp_path / "a").mkdir()
    (tmp_path / "b").mkdir()
    meshes.run("compute", tmp_path / "mesh.off", "--scalars", tmp_path / "scalars.npy", "--graph",
               tmp_path / "a" / f"graph{ending}")
    graph.write(tmp_path / "b" / f"graph{ending}")
    files = sorted(path.name for path in (tmp_path / "a").iterdir())
    assert files == sorted(path.name for path in (tmp_path / "b").iterdir()) and files
    for name in files:
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes()


def test_drawings_and_pages(tmp_path, torus):
    *_, graph = torus
    assert graph._repr_svg_().lstrip().startswith("<")
    graph.write(tmp_path / "pairs.pers")
    graph.write(tmp_path / "mesh.ply")
    try:
        graph.write(tmp_path / "page.html", title="A torus")
    except ValueError as error:
        assert "three.js" in str(error)
        return
    assert "A torus" in (tmp_path / "page.html").read_text()
    assert graph.to_iframe(height=300)._repr_html_().startswith("<iframe")


def test_show(monkeypatch, torus):
    opened = []
    monkeypatch.setattr("webbrowser.open", opened.append)
    try:
        path = torus[3].show()
    except ValueError as error:
        assert "three.js" in str(error)
        return
    assert opened == [path.as_uri()] and path.exists()


def test_copies(torus):
    triangles, points, scalars, graph = torus
    big = np.argsort(np.argsort(scalars)) + 2**60
    tetrahedra, corners = meshes.tetrahedra_of_cubes(2)
    for given in (
        graph,
        graph.simplify(1),
        reeb_graph.compute(triangles, big, ties="contract", keep_degree_2=True),
        reeb_graph.compute(None, corners[:, 0], tetrahedra=tetrahedra, points=corners, edges=[[0, 9]]),
    ):
        for same in (copy.copy(given), copy.deepcopy(given), pickle.loads(pickle.dumps(given))):
            assert np.array_equal(same.arcs, given.arcs) and np.array_equal(same.node_values, given.node_values)
            assert same.node_values.dtype == given.node_values.dtype and repr(same) == repr(given)
            assert np.array_equal(same.vertex_places, given.vertex_places)
    with pytest.raises(ValueError):
        graph.arcs[0] = 0


def test_networkx(torus):
    networkx = pytest.importorskip("networkx")
    *_, graph = torus
    undirected, directed = graph.to_networkx(), graph.to_networkx(directed=True)
    assert isinstance(undirected, networkx.MultiGraph) and isinstance(directed, networkx.MultiDiGraph)
    assert not undirected.is_directed()
    for result in (undirected, directed):
        assert result.number_of_nodes() == graph.n_nodes and result.number_of_edges() == graph.n_arcs
        assert networkx.number_of_nodes(result) == len(graph)
        for node, data in result.nodes(data=True):
            assert data["vertex"] == graph.node_vertices[node] and data["value"] == graph.node_values[node]
            assert data["kind"] == graph.node_kinds[node] and len(data["point"]) == 3
    for lower, upper, arc, data in directed.edges(keys=True, data=True):
        assert [lower, upper] == graph.arcs[arc].tolist() and data["index"] == arc
        assert data["length"] == graph.lengths()[arc] and data["area"] == graph.areas()[arc]
        assert all(data[name] == column[arc] for name, column in graph.measures().items())


def test_pyvista(torus):
    pyvista = pytest.importorskip("pyvista")
    mesh = torus[3].to_pyvista()
    assert isinstance(mesh, pyvista.PolyData) and mesh.n_cells == torus[3].n_arcs


def test_pyvista_by_a_stand_in(monkeypatch, torus):
    class PolyData:
        def __init__(self, points, lines):
            self.points, self.lines, self.cell_data, self.point_data = points, lines, {}, {}

    monkeypatch.setitem(sys.modules, "pyvista", types.SimpleNamespace(PolyData=PolyData))
    graph = torus[3]
    mesh, embedding = graph.to_pyvista("straight"), graph.embed("straight")
    assert mesh.lines.tolist() == np.column_stack([np.full(graph.n_arcs, 2), np.arange(2 * graph.n_arcs).reshape(-1, 2)]).ravel().tolist()
    assert np.array_equal(mesh.points, np.concatenate(embedding.arc_polylines))
    assert len(mesh.point_data["scalars"]) == len(mesh.points) and len(mesh.cell_data["arc"]) == graph.n_arcs


@pytest.mark.parametrize("kind", ["soup", "tetrahedra", "both"])
def test_complexes_have_measures_and_embeddings(tmp_path, kind):
    tetrahedra, corners = meshes.tetrahedra_of_cubes(3)
    fan = np.array([[0, 1, 2], [0, 1, 3], [0, 1, 4]])
    points = np.array([[0, 0, 0], [0, 0, 1], [1, 0, 2], [-1, 0, 2], [0, 1, 2.0]])
    graph = {
        "soup": lambda: reeb_graph.compute(fan, points[:, 2], points=points),
        "tetrahedra": lambda: reeb_graph.compute(None, corners[:, 0], points=corners, tetrahedra=tetrahedra),
        "both": lambda: reeb_graph.compute(fan, corners[:, 0], points=corners, tetrahedra=tetrahedra[5:]),
    }[kind]()
    assert not graph.is_surface and graph.lengths().max() > 0  # arcs between equal values have none
    if kind == "tetrahedra":
        assert np.isclose(graph.volumes().sum(), 27)
        with pytest.raises(ValueError, match="volume"):
            graph.areas()
    else:
        assert graph.areas().sum() > 0
    for manner in ("centroids", "on-surface", "straight"):
        embedding = graph.embed(manner)
        assert embedding.manner == manner and len(embedding.arc_polylines) == graph.n_arcs
    if kind == "tetrahedra" and importlib.util.find_spec("networkx"):
        assert all(data["volume"] >= 0 for *_, data in graph.to_networkx().edges(data=True))
    graph.write(tmp_path / "graph.vtp", embedding="centroids")
    with pytest.raises(ValueError, match="surface"):
        graph.write(tmp_path / "page.html")


def test_all_that_can_be_written(tmp_path, torus):
    simplified = torus[3].simplify("auto")
    for what, name in (("diagram", "d.svg"), ("pairs", "p.csv"), ("vertex_arcs", "arcs.npy"), ("mesh", "mesh.vtp"),
                       ("simplified_scalars", "s.npy"), ("loop", "loop.polylines.txt")):
        simplified.write(tmp_path / name, what=what)
    assert np.array_equal(np.load(tmp_path / "arcs.npy"), simplified.vertex_places)
    assert np.array_equal(np.load(tmp_path / "s.npy"), simplified.simplified_scalars())
    (loop,) = polylines((tmp_path / "loop.polylines.txt").read_text())
    assert np.allclose(loop, simplified.longest_loop(), rtol=0, atol=1e-12) and np.array_equal(loop[0], loop[-1])
    with pytest.raises(ValueError, match="the graph has no loop"):
        simplified.simplify(9, cancel_loops=True).longest_loop()
    with pytest.raises(ValueError, match="not 'x'"):
        simplified.write(tmp_path / "x.svg", what="x")


def test_meshio(torus):
    meshio = pytest.importorskip("meshio")
    triangles, points, scalars, graph = torus
    mesh = meshio.Mesh(points, [("triangle", triangles[:9]), ("triangle", triangles[9:])], {"f": scalars})
    assert np.array_equal(reeb_graph.compute(mesh, "f").arcs, graph.arcs)


def test_meshes_of_other_packages(torus):
    triangles, points, scalars, graph = torus
    padded = np.column_stack([np.full(len(triangles), 3), triangles]).ravel()
    tetrahedra, corners = meshes.tetrahedra_of_cubes(2)
    data = {"f": scalars}
    for mesh in (
        types.SimpleNamespace(vertices=points, faces=triangles, vertex_attributes=data),
        types.SimpleNamespace(points=points, faces=padded, lines=np.array([], dtype=int), point_data=data),
        types.SimpleNamespace(points=points, cells_dict={"triangle": triangles}, point_data=data),
        types.SimpleNamespace(points=points, cells_dict={5: triangles}, point_data=data),
    ):
        for given in (scalars, "f"):
            result = reeb_graph.compute(mesh, given)
            assert np.array_equal(result.arcs, graph.arcs) and len(result.contour(0, 0.5)) > 0
        assert np.array_equal(reeb_graph.mesh_arrays(mesh).triangles, triangles)
        assert np.array_equal(reeb_graph.height(mesh), points[:, 2])
    grid = types.SimpleNamespace(points=corners, cells_dict={10: tetrahedra}, point_data={})
    assert not reeb_graph.compute(grid, corners[:, 0]).is_surface
    with pytest.raises(ValueError, match="triangles"):
        reeb_graph.compute(types.SimpleNamespace(points=points, faces=np.array([4, 0, 1, 2, 3])), scalars)
    with pytest.raises(ValueError, match="hexahedron"):
        reeb_graph.compute(types.SimpleNamespace(points=points, cells_dict={"hexahedron": 0}), 0)
    with pytest.raises(FileNotFoundError):
        reeb_graph.mesh_arrays(Path("mesh.off"))
    with pytest.raises(TypeError, match="pass triangles and points as arrays"):
        reeb_graph.mesh_arrays(3)


def test_contours_keep_their_attributes(torus):
    contour = next(c for c in torus[3].contours_of_arcs() if c.closed)
    for other, points in (
        (pickle.loads(pickle.dumps(contour)), contour.points),
        (pickle.loads(pickle.dumps(contour, protocol=5)), contour.points),
        (copy.copy(contour), contour.points),
        (copy.deepcopy(contour), contour.points),
        (contour.copy(), contour.points),
        (contour * 2, 2 * contour.points),
        (contour - [1, 2, 3], contour.points - [1, 2, 3]),
        (contour[:], contour.points),
    ):
        assert type(other) is reeb_graph.Contour and np.array_equal(other, points)
        assert (other.arc, other.value, other.closed) == (contour.arc, contour.value, True)
        for name in ("edges", "polylines", "triangles"):
            assert np.array_equal(getattr(other, name), getattr(contour, name))
    assert contour.copy().points.base is not contour.points.base
    moved = copy.deepcopy(contour)
    moved += 1
    assert moved.arc == contour.arc and np.array_equal(moved, contour.points + 1)
    assert not hasattr(contour[1:], "edges")  # which are not those of the points that are left
