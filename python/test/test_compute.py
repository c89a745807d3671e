"""compute() against the program, on all kinds of meshes, and with arrays of all kinds."""

import itertools
import json
import pydoc

import meshes
import numpy as np
import pytest
import reeb_graph
from reeb_graph import _arrays


def check_equal(graph, folder, expected, places):
    assert graph.node_vertices.tolist() == [node["vertex"] for node in expected["nodes"]]
    assert graph.node_values.tolist() == [node["value"] for node in expected["nodes"]]
    assert graph.node_kinds.tolist() == [node["kind"] for node in expected["nodes"]]
    assert graph.arcs.tolist() == [[arc["source"], arc["target"]] for arc in expected["edges"]]
    assert np.array_equal(graph.vertex_places, places)
    pairs = graph.pairs()
    rows = (folder / "pairs.csv").read_text().splitlines()[1:]
    assert len(pairs) == len(rows)
    for pair, row in zip(pairs, rows):
        kind, lower, upper, low, high, persistence = row.split(",")
        assert pair.kind == kind
        assert graph.node_vertices[[pair.lower_node, pair.upper_node]].tolist() == [int(lower), int(upper)]
        assert [pair.lower_value, pair.upper_value, pair.persistence] == [float(low), float(high), float(persistence)]


@pytest.mark.parametrize("name, triangles, points", meshes.surfaces(), ids=lambda x: x if isinstance(x, str) else "")
def test_surfaces_as_the_program(tmp_path, name, triangles, points):
    random = np.random.default_rng(1)
    meshes.write_off(tmp_path / "mesh.off", triangles, points)
    choices = [("perturb", False), ("contract", False), ("perturb", True), ("contract", True)]
    for (field, scalars), (ties, keep) in itertools.product(meshes.fields(random, points), choices):
        if field != "ties" and keep:
            continue  # ties have the most critical vertices that are no nodes
        graph = reeb_graph.compute(triangles, scalars, points=points, ties=ties, keep_degree_2=keep)
        assert graph.is_surface
        options = ["--ties", ties] + ["--keep-degree-2"] * keep
        check_equal(graph, tmp_path, *meshes.result_of_program(tmp_path, tmp_path / "mesh.off", scalars, *options))
        without = reeb_graph.compute(triangles, scalars, ties=ties, keep_degree_2=keep, threads=1)
        assert np.array_equal(without.arcs, graph.arcs)
        assert np.array_equal(without.node_vertices, graph.node_vertices)


def test_chains_as_the_program(tmp_path):
    triangles, points = meshes.grid(8, 6, True, True)
    meshes.write_off(tmp_path / "mesh.off", triangles, points)
    graph = reeb_graph.compute(triangles, points[:, 0], points=points)
    expected, _ = meshes.result_of_program(tmp_path, tmp_path / "mesh.off", points[:, 0])
    for chain, arc in zip(graph.chains, expected["edges"]):
        assert chain.tolist() == np.concatenate(arc["chain"]).tolist()


@pytest.mark.parametrize("seed", range(12))
def test_complexes_as_the_program(tmp_path, seed):
    random = np.random.default_rng(seed)
    triangles, points = meshes.random_soup(random, 14, 22)
    meshes.write_off(tmp_path / "mesh.off", triangles, points)
    for _, scalars in meshes.fields(random, points):
        graph = reeb_graph.compute(triangles, scalars, points=points)
        check_equal(graph, tmp_path, *meshes.result_of_program(tmp_path, tmp_path / "mesh.off", scalars))


def test_tetrahedra_as_the_program(tmp_path):
    random = np.random.default_rng(2)
    tetrahedra, points = meshes.tetrahedra_of_cubes(3)
    meshes.write_medit(tmp_path / "mesh.mesh", tetrahedra, points)
    for _, scalars in meshes.fields(random, points):
        graph = reeb_graph.compute(None, scalars, tetrahedra=tetrahedra, points=points)
        assert not graph.is_surface
        check_equal(graph, tmp_path, *meshes.result_of_program(tmp_path, tmp_path / "mesh.mesh", scalars))


def test_edges():
    graph = reeb_graph.compute(None, [0.0, 1, 2, 3], edges=[[0, 1], [1, 3], [1, 2], [2, 3]])
    assert graph.arcs.tolist() == [[0, 1], [1, 2], [1, 2]] or graph.n_loops == 1
    assert reeb_graph.compute([[0, 1, 2]], [0, 1, 2, 3], edges=[[1, 3]]).n_leaves == 3


def same(a, b):
    return np.array_equal(a.arcs, b.arcs) and np.array_equal(a.node_vertices, b.node_vertices)


def test_dtypes_and_memory_orders():
    triangles, points = meshes.grid(8, 7, True, True)
    scalars = np.random.default_rng(3).permutation(len(points)).astype(float)
    expected = reeb_graph.compute(triangles, scalars)
    for dtype in ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", ">i4", ">i8", ">u2"):
        if np.iinfo(dtype).max >= len(points):
            assert same(reeb_graph.compute(triangles.astype(dtype), scalars), expected), dtype
        graph = reeb_graph.compute(triangles, scalars.astype(dtype))
        assert same(graph, expected), dtype
        assert graph.node_values.dtype == np.dtype(dtype).newbyteorder("=")
    for dtype in ("f2", "f4", "f8", ">f8", "g"):
        assert same(reeb_graph.compute(triangles, scalars.astype(dtype)), expected), dtype
    wide = np.zeros((len(triangles), 7), dtype=np.int16)
    wide[:, 1::2] = triangles
    for form in (np.asfortranarray(triangles), wide[:, 1::2], triangles[::-1][::-1], triangles.tolist()):
        assert same(reeb_graph.compute(form, scalars), expected)
    unaligned = np.frombuffer(b"x" + triangles.tobytes(), dtype=np.uint8)[1:].view(triangles.dtype).reshape(-1, 3)
    frozen = scalars.copy()
    frozen.flags.writeable = False
    assert same(reeb_graph.compute(unaligned, frozen), expected)
    assert same(reeb_graph.compute(triangles, np.repeat(scalars, 2)[::2]), expected)
    assert same(reeb_graph.compute(triangles, scalars, points=points[:, :2].astype(np.float32)), expected)
    assert reeb_graph.compute(triangles, scalars > 7).n_nodes > 0


def test_integers_that_no_double_has(tmp_path):
    triangles, points = meshes.grid(8, 7, True, True)
    ranks = np.random.default_rng(4).permutation(len(points))
    expected = reeb_graph.compute(triangles, ranks, points=points)
    for base, dtype in ((2**62, np.int64), (2**63, np.uint64), (-(2**63), np.int64)):
        scalars = np.array([base + int(r) for r in ranks], dtype=dtype)
        graph = reeb_graph.compute(triangles, scalars, points=points)
        assert same(graph, expected)
        assert np.array_equal(graph.node_values, scalars[graph.node_vertices])
        assert graph.node_values.dtype == dtype
        pairs = graph.pairs()
        assert np.array_equal(pairs.persistence, expected.pairs().persistence)
        for threshold in (0, 3, 10):
            assert same(graph.simplify(threshold), expected.simplify(threshold))
        assert same(graph.simplify(percent=20), expected.simplify(percent=20))
        level = int(scalars[5])
        assert [c.arc for c in graph.contours(level)] == [c.arc for c in expected.contours(int(ranks[5]))]
        contour, same_contour = graph.contour(0, 0.5), expected.contour(0, 0.5)
        assert np.array_equal(contour.edges, same_contour.edges)
        assert np.array_equal(graph.vertex_places, expected.vertex_places)
        assert len(graph.embed().arc_polylines) == graph.n_arcs
        values = graph.embed().arc_values[0]
        assert np.all(np.abs(values - base) <= 2000) and abs(contour.value - base) <= 2000
        for ending in (".json", ".graphml", ".csv"):  # the doubles next to the values
            graph.write(tmp_path / f"graph{ending}")
        written = json.loads((tmp_path / "graph.json").read_text())
        assert [node["value"] for node in written["nodes"]] == graph.node_values.astype(float).tolist()
        assert repr(float(base))[:10] in (tmp_path / "graph.nodes.csv").read_text()
        graph.write(tmp_path / "graph.svg", name="time")
        assert f"time - {scalars.min()}" in (tmp_path / "graph.svg").read_text()
    tied = np.full(len(points), 2**62 + 1)
    assert reeb_graph.compute(triangles, tied, ties="contract").n_nodes == 1


def test_values_closer_than_doubles():
    """The range is so large that differences of neighbours are lost in doubles."""
    triangles, points = meshes.grid(8, 7, True, True)
    random = np.random.default_rng(6)
    ranks = random.permutation(len(points))
    far = np.array([(-1) ** int(r < 28) * 2**62 + int(r) for r in ranks])
    fine = np.longdouble(1) / 3 + ranks * np.finfo("g").eps
    for scalars in (far, fine):
        expected = reeb_graph.compute(triangles, ranks, points=points)
        for ties in ("perturb", "contract"):
            graph = reeb_graph.compute(triangles, scalars, points=points, ties=ties)
            assert same(graph, expected) and np.array_equal(graph.node_values, scalars[graph.node_vertices])
            assert np.array_equal(graph.vertex_places, expected.vertex_places)
        for rank in (0, 20, 27, 28, 40):
            level = scalars[ranks == rank][0]
            assert [c.arc for c in graph.contours(level)] == [c.arc for c in expected.contours(rank)]
    assert graph.contours(scalars.max()) == [] and graph.contours(-np.inf) == []


def test_random_fields_of_large_integers():
    triangles, points = meshes.grid(5, 6, True, True)
    for seed in range(40):
        random = np.random.default_rng(seed)
        ranks = random.integers(0, 20, len(points))
        steps = np.cumsum(random.choice([1, 3, 2**20, 2**55], 20))
        scalars = np.uint64(2**60) + steps.astype(np.uint64)[ranks]
        for ties in ("perturb", "contract"):
            graph = reeb_graph.compute(triangles, scalars, ties=ties)
            assert same(graph, reeb_graph.compute(triangles, ranks, ties=ties))
            assert same(graph, reeb_graph.compute(triangles, np.zeros(len(points)), order=ranks, ties=ties))


def test_what_is_copied():
    triangles, points = meshes.grid(8, 7, True, True)
    scalars = points[:, 0].copy()
    view = scalars[:]
    view.flags.writeable = False
    assert not np.shares_memory(_arrays.settled(scalars), scalars) and not np.shares_memory(_arrays.settled(view), view)
    scalars.flags.writeable = False
    assert _arrays.settled(scalars) is scalars and _arrays.settled(view) is view
    frozen = np.frombuffer(scalars.tobytes())
    assert _arrays.settled(frozen) is frozen
    graphs = [reeb_graph.compute(triangles, given) for given in (points[:, 0], scalars, view, frozen)]
    assert all(same(graph, graphs[0]) for graph in graphs)
    field = np.arange(len(points), dtype=float)
    reeb_graph.compute(triangles, field)
    field[0] = 5  # it can be written as before


def test_order_decides():
    triangles, points = meshes.grid(8, 7, True, True)
    scalars = points[:, 0]
    random = np.random.default_rng(5)
    ranks = random.permutation(len(points))
    assert same(reeb_graph.compute(triangles, scalars, order=ranks), reeb_graph.compute(triangles, ranks))
    graph = reeb_graph.compute(triangles, scalars, order=np.argsort(np.argsort(-scalars)), points=points)
    assert np.all(np.diff(graph.node_values[graph.arcs], axis=1) <= 0)
    assert len(graph.contour(0, 0.5)) > 0
    with pytest.raises(ValueError, match="no levels"):
        graph.contours(0)
    with pytest.raises(ValueError, match="ranks for"):
        reeb_graph.compute(triangles, scalars, order=ranks[1:])


def test_small_ones():
    assert reeb_graph.compute([], []).n_nodes == 0
    assert reeb_graph.compute(np.zeros((0, 3)), np.zeros(0), points=np.zeros((0, 3))).n_arcs == 0
    assert reeb_graph.compute(None, [1.5]).node_kinds.tolist() == ["isolated"]
    assert reeb_graph.compute([[0, 1, 2]], [0, 1, 2]).arcs.tolist() == [[0, 1]]
    assert reeb_graph.compute([[0, 1, 2]], [np.inf, -np.inf, 0]).n_arcs == 1


def test_counts():
    triangles, points = meshes.grid(9, 8, True, True)
    graph = reeb_graph.compute(triangles, points[:, 0], points=points)
    assert (graph.n_loops, graph.n_leaves, graph.n_components, len(graph)) == (1, 2, 1, graph.n_nodes)
    assert graph.leaves().tolist() == np.flatnonzero(graph.node_kinds != "saddle").tolist()
    (loop,) = graph.loops()
    assert len(loop) == 2 and graph.counts["genus"] == 1
    assert " 1 loop, 1 component>" in repr(graph)
    cut, embedding = reeb_graph.cutting_system(triangles, points[:, 0], points), graph.embed()
    for result in cut, embedding, graph.critical_set(0):
        assert len(repr(result)) < 100, repr(result)
    assert " 1 patch, 1 curve>" in repr(cut) and f"{graph.n_arcs} arcs" in repr(embedding)
    assert len(pydoc.render_doc(reeb_graph).splitlines()) < 2300  # Python 3.13 wraps signatures
    assert np.array_equal(np.sort(np.unique(graph.vertex_places)), np.unique(graph.vertex_places))
    assert np.all((graph.vertex_arcs >= 0) == (graph.vertex_places >= graph.n_nodes))
