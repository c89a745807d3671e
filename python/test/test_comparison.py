"""Shapes compared: known distances, partners, matrices, and tips that are alike."""

import json

import numpy as np
import pytest

import meshes
import reeb_graph


def bumpy(seed, bumps=3):
    """Return a sphere with spikes, whose tips come last by distance from the middle."""
    triangles, points = meshes.sphere(3)
    random = np.random.default_rng(seed)
    tips = random.choice(len(points), bumps, replace=False)
    points = points * (1 + sum((1.5 + 0.3 * i) * np.exp(8 * (points @ points[tip] - 1)) for i, tip in enumerate(tips)))[:, None]
    return triangles, points


def graph_of(triangles, points, source=None):
    scalars = points[:, 0] if source is None else reeb_graph.geodesic(triangles, points, sources=source)
    return reeb_graph.compute(triangles, scalars, points=points)


def test_known_distances():
    sphere, torus = meshes.sphere(3), meshes.grid(20, 24, True, True)
    thin = torus[0], torus[1] * [1, 1, 0.5]
    graphs = [graph_of(*mesh) for mesh in (sphere, torus, thin)]
    of_sphere = reeb_graph.compare(graphs[0], graphs[1])
    assert of_sphere.by_kind["loop"] == pytest.approx(2, abs=0.2)  # half of the hole, from -2 to 2
    assert of_sphere.distance == max(of_sphere.by_kind.values()) == pytest.approx(3)  # from a radius of 1 to one of 4
    assert reeb_graph.compare(graphs[1], graphs[2]).distance == 0
    matrix = reeb_graph.distances(graphs)
    assert matrix.shape == (3, 3) and np.array_equal(matrix, matrix.T) and not matrix.diagonal().any()
    assert matrix[0, 1] == of_sphere.distance
    assert reeb_graph.distances([]).shape == (0, 0)


def test_partners():
    mesh = bumpy(1)
    graph = graph_of(*mesh).simplify(0.1)
    same = reeb_graph.compare(graph, graph)
    assert np.array_equal(same.pairs, np.repeat(np.arange(graph.n_arcs), 2).reshape(-1, 2))
    assert same.distance == 0 and not len(same.alone[0]) and not len(same.alone[1])
    assert repr(same) == f"<Comparison: distance 0, {graph.n_arcs} pairs of arcs>"
    order = np.random.default_rng(0).permutation(len(mesh[1]))
    numbers = np.argsort(order)
    other = graph_of(numbers[mesh[0]], mesh[1][order] * 1e100).simplify(1e99)
    found = reeb_graph.compare(graph, other)
    assert len(found.pairs) == graph.n_arcs
    for a, b in found.pairs:
        assert np.array_equal(order[other.node_vertices[other.arcs[b]]], graph.node_vertices[graph.arcs[a]])
    assert np.array_equal(reeb_graph.compare(other, graph).pairs[:, ::-1].tolist(), found.pairs[np.argsort(found.pairs[:, 1])])
    none = reeb_graph.compare(graph, graph_of(*meshes.sphere(2)), price_alone=0)
    assert len(none.pairs) == 0 and len(none.alone[0]) == graph.n_arcs


def test_large_integers_are_compared_by_their_values():
    triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
    low, high = 2**60, 2**60 + 512
    a, b = (reeb_graph.compute(triangles, np.array([low, low, low, low + size])) for size in (512, 1024))
    assert reeb_graph.distances([a, b])[0, 1] == high - low


def test_tips_that_are_alike():
    mesh = bumpy(2)
    for unit in (1, 1e-100):
        assert len(set(reeb_graph.like_tips([mesh, mesh, (mesh[0], mesh[1] * unit)]))) == 1


def test_the_program_finds_the_same(tmp_path):
    first, second = bumpy(3), bumpy(4)
    for name, mesh in (("a.off", first), ("b.off", second)):
        meshes.write_off(tmp_path / name, *mesh)
    result = meshes.run("compare", tmp_path / "a.off", tmp_path / "b.off", "--field", "x", "--simplify", "auto", "--json")
    report = json.loads(result)
    found = reeb_graph.compare(*(graph_of(*mesh).simplify("auto") for mesh in (first, second)))
    assert found.distance == pytest.approx(report["distance"])
    assert found.pairs.tolist() == report["pairs"]
    assert [alone.tolist() for alone in found.alone] == report["without_partner"]


def test_errors():
    triangles, points = bumpy(0)
    graph = graph_of(triangles, points)
    with pytest.raises(TypeError, match="ReebGraph is needed"):
        reeb_graph.compare(graph, points)
    with pytest.raises(ValueError, match="points"):
        reeb_graph.compare(graph, reeb_graph.compute(triangles, points[:, 0]))
    with pytest.raises(ValueError, match="surfaces"):
        volume = reeb_graph.compute(None, np.arange(4.0), tetrahedra=[[0, 1, 2, 3]], points=points[:4])
        reeb_graph.compare(graph, volume)
    with pytest.raises(ValueError, match="price_alone"):
        reeb_graph.compare(graph, graph, price_alone=-1)
    noise = np.random.default_rng(0).normal(size=len(points))
    noisy = reeb_graph.compute(triangles, noise, points=points)
    if noisy.n_arcs > 300:
        with pytest.raises(ValueError, match="simplify it first"):
            reeb_graph.compare(noisy, noisy)
    ranked = reeb_graph.compute(triangles, points[:, 0], order=np.random.default_rng(0).permutation(len(points)))
    with pytest.raises(ValueError, match="order"):
        reeb_graph.distances([graph, ranked])
    with pytest.raises(ValueError, match="connected"):
        reeb_graph.like_tips([(triangles, points), ([[0, 1, 2], [3, 4, 5]], points[:6])])
