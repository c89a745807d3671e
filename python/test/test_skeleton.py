"""Curve skeletons: what they are made of, their files, and what is refused."""

import sys

import meshes
import numpy as np
import pytest
import reeb_graph

TORUS = meshes.grid(24, 12, True, True)
TUBE = meshes.grid(20, 12, False, True)


def two_parts():
    (a, of_a), (b, of_b) = TORUS, TUBE
    return np.concatenate([a, b + len(of_a)]), np.concatenate([of_a, of_b * [1, 1, 9] + 9, [[30.0, 30, 30]]])


@pytest.mark.parametrize("mesh, loops, ends, parts", [(TORUS, 1, None, 1), (TUBE, 0, 2, 1), (two_parts(), 1, None, 2)])
def test_parts_of_a_skeleton(mesh, loops, ends, parts):
    triangles, points = mesh
    skeleton = reeb_graph.skeleton(triangles, points)
    number = len(skeleton.points)
    assert skeleton.points.shape == (number, 3) and np.isfinite(skeleton.points).all()
    assert skeleton.radii.shape == skeleton.inscribed_radii.shape == (number,)
    assert (skeleton.radii > 0).all() and (skeleton.inscribed_radii >= 0).all()
    assert (skeleton.radii >= skeleton.inscribed_radii).all()
    assert skeleton.edges.tolist() == [list(pair) for arc in skeleton.arcs for pair in zip(arc[:-1], arc[1:])]
    assert skeleton.n_loops == skeleton.counts["loops"] == loops == len(skeleton.edges) + parts - number
    assert skeleton.counts["components"] == parts and skeleton.counts["arcs"] == len(skeleton.arcs)
    degrees = np.bincount(skeleton.edges.ravel(), minlength=number)
    assert np.count_nonzero(degrees == 1) == skeleton.counts["ends"]
    assert ends is None or skeleton.counts["ends"] == ends
    assert skeleton.counts["vertices_outside"] == skeleton.counts["crossing_edges"] == 0
    used = np.zeros(len(points), dtype=bool)
    used[triangles.ravel()] = True
    assert skeleton.vertex_map.shape == (len(points),)
    assert ((skeleton.vertex_map >= 0) == used).all() and skeleton.vertex_map.max() < number
    assert f"{number} points" in repr(skeleton)


def test_options():
    triangles, points = TORUS
    coarse = reeb_graph.skeleton(triangles, points, sampling_ratio=2)
    fine = reeb_graph.skeleton(triangles, points, sampling_ratio=0.25)
    assert len(fine.points) > 2 * len(coarse.points)
    equal = reeb_graph.skeleton(triangles, points, spacing=0.1)
    for arc in equal.arcs:
        steps = np.linalg.norm(np.diff(equal.points[arc], axis=0), axis=1)
        assert np.abs(steps[:-1] - 0.1).max() < 1e-3 and steps[-1] < 0.101
    of_field = reeb_graph.skeleton(triangles, points, points[:, 0], pruning_ratio=0)
    assert of_field.n_loops == 1 and of_field.counts["ends"] == 2
    triangles, points = meshes.grid(20, 12, False, True)
    filled = reeb_graph.skeleton(triangles, points * [1, 1, 9], ends_at_borders=False)
    assert filled.counts["ends"] == 2 and filled.counts["genus"] == 0


def test_networkx():
    networkx = pytest.importorskip("networkx")
    skeleton = reeb_graph.skeleton(*TORUS)
    graph = skeleton.to_networkx()
    assert graph.number_of_nodes() == len(skeleton.points) and graph.number_of_edges() == len(skeleton.edges)
    assert len(networkx.cycle_basis(networkx.Graph(graph))) == 1
    for number, of_node in graph.nodes(data=True):
        assert of_node["pos"] == tuple(skeleton.points[number])
        assert of_node["radius"] == skeleton.radii[number]
        assert of_node["inscribed_radius"] == skeleton.inscribed_radii[number]
    lengths = sum(np.linalg.norm(np.diff(skeleton.points[arc], axis=0), axis=1).sum() for arc in skeleton.arcs)
    assert np.isclose(sum(length for _, _, length in graph.edges(data="length")), lengths)
    assert {arc for _, _, arc in graph.edges(data="arc")} == set(range(len(skeleton.arcs)))


def test_networkx_that_is_missing(monkeypatch):
    monkeypatch.setitem(sys.modules, "networkx", None)
    with pytest.raises(ImportError):
        reeb_graph.skeleton(*TORUS).to_networkx()


def test_files_as_those_of_the_program(tmp_path):
    triangles, points = TORUS
    points = points.astype(np.float32).astype(float)
    meshes.write_off(tmp_path / "mesh.off", triangles, points)
    names = [f"s{suffix}" for suffix in (".swc", ".vtp", ".polylines.txt", ".graphml", ".csv")]
    (tmp_path / "own").mkdir()
    reeb_graph.skeleton(triangles, points).write(*(tmp_path / "own" / name for name in names))
    outputs = [word for name in names for word in ("--output", tmp_path / name)]
    meshes.run("skeleton", tmp_path / "mesh.off", *outputs)
    for name in names:
        assert (tmp_path / "own" / name).read_bytes() == (tmp_path / name).read_bytes()
    with pytest.raises(ValueError, match="swc"):
        reeb_graph.skeleton(triangles, points).write(tmp_path / "s.txt")


@pytest.mark.parametrize("options", [{"root": "thickest"}, {"root": 7}, {"radius": "inscribed"}, {"swc_type": 5}])
def test_swc_as_that_of_the_program(tmp_path, options):
    triangles, points = TUBE
    points = points.astype(np.float32).astype(float)
    meshes.write_off(tmp_path / "mesh.off", triangles, points)
    reeb_graph.skeleton(triangles, points).write(tmp_path / "own.swc", **options)
    words = [word for name, value in options.items() for word in ("--" + name.replace("_", "-"), str(value))]
    meshes.run("skeleton", tmp_path / "mesh.off", *words, "--output", tmp_path / "s.swc")
    assert (tmp_path / "own.swc").read_bytes() == (tmp_path / "s.swc").read_bytes()
    records = np.loadtxt(tmp_path / "s.swc")
    other = options.get("swc_type", 3)
    assert (records[:, 5] > 0).all() and set(records[:, 1]) == ({1, 3} if options.get("root") == "thickest" else {other})


@pytest.mark.parametrize("options", [{"root": "tips"}, {"root": -1}, {"root": 10**6}, {"radius": "mean"}, {"swc_type": 0}])
def test_wrong_options_of_swc(tmp_path, options):
    with pytest.raises(ValueError):
        reeb_graph.skeleton(*TORUS).write(tmp_path / "s.swc", **options)
    assert not (tmp_path / "s.swc").exists()


def test_faces_of_a_repaired_copy():
    triangles, points = TORUS
    skeleton = reeb_graph.skeleton(np.vstack([triangles, triangles[:1, ::-1]]), points)
    assert skeleton.face_branches is skeleton.face_in_junction is None


@pytest.mark.parametrize("mesh", [TORUS, TUBE, two_parts()])
def test_branches(tmp_path, mesh):
    triangles, points = mesh
    skeleton = reeb_graph.skeleton(triangles, points)
    branches = skeleton.branches
    assert all(column.shape == (len(skeleton.arcs),) for column in branches.values())
    steps = [np.linalg.norm(np.diff(skeleton.points[arc], axis=0), axis=1) for arc in skeleton.arcs]
    assert np.allclose(branches["length"], [step.sum() for step in steps])
    assert np.isclose(skeleton.cable_length, np.concatenate(steps).sum())
    ends = np.array([[arc[0], arc[-1]] for arc in skeleton.arcs])
    assert np.array_equal(np.column_stack([branches["from"], branches["to"]]), ends)
    assert np.array_equal(np.isnan(branches["tortuosity"]), ends[:, 0] == ends[:, 1])
    corners = points[triangles]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
    assert np.isclose(branches["area"].sum(), areas.sum())
    a, b, c = (corners[:, i] - points.mean(axis=0) for i in range(3))
    volume = np.einsum("ij,ij->", a, np.cross(b, c)) / 6
    if skeleton.counts["border_ends"] == 0:
        assert np.isclose(branches["volume"].sum(), abs(volume), rtol=1e-9)
        assert skeleton.counts["inside_out_components"] == (1 if volume < 0 else 0)
    inside = np.bincount(skeleton.face_branches, areas * skeleton.face_in_junction, minlength=len(skeleton.arcs))
    assert np.allclose(branches["junction_area"], inside)
    sums = np.bincount(skeleton.face_branches, areas, minlength=len(skeleton.arcs))
    assert np.allclose(branches["area"], sums) and skeleton.face_in_junction.shape == (len(triangles),)
    junctions = np.bincount(skeleton.edges.ravel(), minlength=len(skeleton.points)) > 2
    assert skeleton.point_in_junction[junctions].all() and skeleton.edge_in_junction.shape == (len(skeleton.edges),)
    assert skeleton.point_in_junction.any() == skeleton.face_in_junction.any() == junctions.any()
    assert branches["parent"].max() < len(skeleton.arcs) and branches["parent"].min() == -1
    assert branches["component"].max() == skeleton.counts["components"] - 1
    skeleton.write(tmp_path / "s.csv")
    table = np.genfromtxt(tmp_path / "s.csv", delimiter=",", names=True)
    for name, column in branches.items():
        assert np.array_equal(np.nan_to_num(np.atleast_1d(table[name]), nan=-1), np.nan_to_num(column, nan=-1))


def test_swc_is_a_tree_with_a_cut(tmp_path):
    skeleton = reeb_graph.skeleton(*two_parts())
    skeleton.write(tmp_path / "s.swc")
    lines = (tmp_path / "s.swc").read_text().splitlines()
    records = [line.split() for line in lines if not line.startswith("#")]
    assert [int(record[0]) for record in records] == list(range(1, len(skeleton.points) + 2))
    parents = [int(record[6]) for record in records]
    assert parents.count(-1) == 2 and all(parent < number for number, parent in enumerate(parents, 1))
    copies = [line.split()[-2:] for line in lines if "CYCLE_BREAK" in line]
    assert len(copies) == 1
    duplicate, original = (records[int(number) - 1] for number in copies[0])
    assert duplicate[1:6] == original[1:6]


@pytest.mark.parametrize("options", [
    {"pruning_ratio": -1}, {"pruning_ratio": np.nan}, {"sampling_ratio": 0}, {"sampling_ratio": 1e9},
    {"spacing": -1}, {"spacing": 1e-9}, {"scalars": [1.0, 2]},
])
def test_wrong_numbers(options):
    with pytest.raises(ValueError):
        reeb_graph.skeleton(*TORUS, **options)


def test_wrong_meshes():
    triangles, points = TORUS
    with pytest.raises(ValueError, match="needs points"):
        reeb_graph.skeleton(triangles)
    with pytest.raises(ValueError, match="surface"):
        reeb_graph.skeleton([[0, 1, 2], [0, 1, 3], [0, 1, 4]], points[:5], strict=True)
    with pytest.raises(ValueError):
        reeb_graph.skeleton(triangles, np.where(np.arange(len(points))[:, None] == 7, np.nan, points))
    with pytest.raises((TypeError, ValueError)):
        reeb_graph.skeleton(triangles, points, pruning_ratio="much")


def test_what_is_no_surface():
    triangles, points = TORUS
    pressed = np.concatenate([triangles, [[0, 1, len(points)], [1, 0, len(points)]]])
    more = np.concatenate([points, [[9.0, 9, 9]]])
    with pytest.raises(ValueError, match="oriented manifold surface"):
        reeb_graph.skeleton(pressed, more, strict=True)
    skeleton, whole = reeb_graph.skeleton(pressed, more, more[:, 2]), reeb_graph.skeleton(triangles, points, points[:, 2])
    assert np.array_equal(skeleton.points, whole.points) and skeleton.n_loops == 1
    assert len(skeleton.vertex_map) == len(more) and skeleton.vertex_map[-1] == -1
    # vertex 0 twice, and cut apart: a copy of it has the same value, and the map is that of the vertices handed in
    fans = np.concatenate([triangles, [[0, len(points), len(points) + 1]]])
    more = np.concatenate([points, [[9.0, 9, 9], [9.0, 10, 9]]])
    skeleton = reeb_graph.skeleton(fans, more, more[:, 2])
    assert skeleton.counts["components"] == 2 and len(skeleton.vertex_map) == len(more)
    assert reeb_graph.skeleton(*two_parts(), least_piece=0.4).counts["components"] == 1
