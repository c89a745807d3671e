"""Fields and curves against the program."""

import meshes
import numpy as np
import pytest
import reeb_graph

TRIANGLES, POINTS = meshes.grid(16, 12, True, True)


@pytest.fixture
def mesh_file(tmp_path):
    meshes.write_off(tmp_path / "mesh.off", TRIANGLES, POINTS)
    return tmp_path / "mesh.off"


@pytest.mark.parametrize("name, options, of_program", [
    ("harmonic", {}, []),
    ("harmonic", {"minimum": 3, "maximum": 90, "weights": "cotangent"}, ["--min", 3, "--max", 90, "--weights", "cotangent"]),
    ("poisson", {}, []),
    ("poisson", {"sources": 5}, ["--source", 5]),
    ("geodesic", {"sources": [5, 70]}, ["--source", "5,70"]),
    ("unit_gradient", {}, []),
    ("height", {"direction": (1, 2, 3)}, ["--direction", "1,2,3"]),
])
def test_fields_as_the_program(tmp_path, mesh_file, name, options, of_program):
    field = getattr(reeb_graph, name)(TRIANGLES, POINTS, **options)
    assert field.dtype == np.float64 and field.shape == (len(POINTS),)
    output = tmp_path / "field.npy"
    meshes.run("field", mesh_file, "--type", name.replace("_", "-"), "--output", output, *of_program)
    assert np.array_equal(field, np.load(output))


def test_unit_gradient_of_a_field():
    field = reeb_graph.unit_gradient(TRIANGLES, POINTS, POINTS[:, 0])
    assert abs(np.corrcoef(field, POINTS[:, 0])[0, 1]) > 0.8


def test_distances_in_complexes():
    tetrahedra, points = meshes.tetrahedra_of_cubes(2)
    distances = reeb_graph.geodesic(None, points, tetrahedra=tetrahedra, sources=0)
    assert distances[0] == 0 and np.isclose(distances.max(), 2 * np.sqrt(3))


def test_errors():
    with pytest.raises(ValueError, match="there is no vertex"):
        reeb_graph.geodesic(TRIANGLES, POINTS, sources=10**6)
    with pytest.raises(ValueError):
        reeb_graph.geodesic(TRIANGLES, POINTS, sources=-1)
    with pytest.raises(ValueError, match="together"):
        reeb_graph.harmonic(TRIANGLES, POINTS, minimum=1)
    with pytest.raises(ValueError, match="needs points"):
        reeb_graph.harmonic(TRIANGLES)
    with pytest.raises(ValueError):
        reeb_graph.height(TRIANGLES, POINTS, (0, 0, 0))
    with pytest.raises(ValueError, match="surface"):
        reeb_graph.harmonic([[0, 1, 2], [0, 1, 3], [0, 1, 4]], POINTS[:5])
    with pytest.raises(TypeError):
        reeb_graph.poisson(TRIANGLES, POINTS, sources=0.5)


def cut_mesh(tmp_path, mesh_file, kind, scalars):
    np.save(tmp_path / "scalars.npy", scalars)
    meshes.run("curves", mesh_file, "--scalars", tmp_path / "scalars.npy", "--type", kind, "--patches",
               tmp_path / "patches.txt", "--curves", tmp_path / "curves.polylines.txt")
    return np.loadtxt(tmp_path / "patches.txt", dtype=int), (tmp_path / "curves.polylines.txt").read_text().splitlines()


@pytest.mark.parametrize("name, kind", [("cutting_system", "cutting-system"), ("branches", "branch")])
def test_curves_as_the_program(tmp_path, mesh_file, name, kind):
    scalars = POINTS[:, 0] + 0.3 * np.sin(5 * POINTS[:, 1])
    cut = getattr(reeb_graph, name)(TRIANGLES, scalars, POINTS, vertex_arrays={
        "point": POINTS, "label": np.arange(len(POINTS), dtype=np.int32), "height": POINTS[:, 2].astype(np.float32)})
    patches, curves = cut_mesh(tmp_path, mesh_file, kind, scalars)
    assert np.array_equal(cut.patches, patches) and len(cut.curves) == len(curves)
    assert cut.n_patches == patches.max() + 1 and np.array_equal(cut.points[: len(POINTS)], POINTS)
    assert np.allclose(cut.vertex_arrays["point"], cut.points) and np.array_equal(cut.scalars[: len(POINTS)], scalars)
    assert cut.vertex_arrays["label"].dtype == np.int32 and cut.vertex_arrays["height"].dtype == np.float32
    assert cut.triangles.max() == len(cut.points) - 1 and len(cut.patches) == len(cut.triangles)
    for curve in cut.curves:
        assert np.array_equal(curve[0], curve[-1])


def test_pants():
    with pytest.raises(ValueError, match="torus"):
        reeb_graph.pants(TRIANGLES, POINTS[:, 0], POINTS)
    holes = np.isin(np.arange(len(TRIANGLES)), [0, 40, 90], invert=True)
    cut = reeb_graph.pants(TRIANGLES[holes], POINTS[:, 0], POINTS)
    assert (cut.n_patches, len(cut.curves)) == (3, 3)
    level = reeb_graph.make_borders_level(TRIANGLES[holes], POINTS[:, 0])
    assert level[TRIANGLES[0]].min() == level[TRIANGLES[0]].max()
    with pytest.raises(ValueError, match="border"):
        reeb_graph.pants(TRIANGLES[holes], POINTS[:, 0], POINTS, borders="level")
    with pytest.raises(ValueError, match="more than are wanted"):
        reeb_graph.pants(TRIANGLES[holes], POINTS[:, 0], POINTS, max_triangles=1)
    assert len(reeb_graph.pants(TRIANGLES[holes], POINTS[:, 0], POINTS, cut_open=True).points) > len(cut.points)


def test_repair(tmp_path):
    corners = POINTS[TRIANGLES].reshape(-1, 3)
    repaired = reeb_graph.repair(np.arange(len(corners)).reshape(-1, 3), corners, merge=True)
    assert len(repaired.points) == len(POINTS) and np.array_equal(repaired.points[repaired.map], corners)
    assert np.array_equal(repaired.points[repaired.triangles], POINTS[TRIANGLES])
    noise = np.random.default_rng(1).uniform(-1e-10, 1e-10, corners.shape)
    triangles, points, numbers = reeb_graph.repair(np.arange(len(corners)).reshape(-1, 3), corners + noise, merge_within=1e-9)
    assert len(points) == len(POINTS) and np.array_equal(numbers, repaired.map)
    meshes.write_off(tmp_path / "soup.off", np.arange(len(corners)).reshape(-1, 3), corners)
    meshes.run("repair", tmp_path / "soup.off", "--merge", "--output", tmp_path / "merged.off", "--map", tmp_path / "map.txt")
    assert np.array_equal(repaired.map, np.loadtxt(tmp_path / "map.txt", dtype=int))

    book = [[0, 1, 2], [1, 0, 3], [0, 1, 4], [0, 1, 1], [0, 1, 4]]
    triangles, points, numbers = reeb_graph.repair(book, POINTS[:5], split=True, largest=True)
    kept = numbers >= 0
    assert len(triangles) == 2 and len(points) == 4 and np.array_equal(points[numbers[kept]], POINTS[:5][kept])
    assert len(reeb_graph.repair(book, POINTS[:5]).triangles) == 3
    turned = reeb_graph.repair([[0, 1, 2], [0, 1, 3]], POINTS[:4], orient=True).triangles
    assert sorted(turned[1]) == [0, 1, 3] and list(turned[1]) != [0, 1, 3]
    fin = [*TRIANGLES[1:], TRIANGLES[0], TRIANGLES[0][::-1], TRIANGLES[0]]
    assert len(reeb_graph.repair(fin, POINTS, cancel_opposite=True).triangles) == len(TRIANGLES)
    assert len(reeb_graph.repair(fin[:-2], POINTS, fill=3, least_piece=0.01, all=True).triangles) == len(TRIANGLES)
    # triangles with corners of their own, and a point of none
    pieces = [[0, 1, 2], [0, 2, 3], [1, 4, 2], [5, 3, 2], [5, 6, 3]]
    places = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0], [1, 1, 0], [0, 2, 1], [9, 9, 9]]
    for stitch in (1e-6, "0.1%"):
        assert len(reeb_graph.repair(pieces, places, stitch=stitch).points) == 7
        assert len(reeb_graph.repair(pieces, places, stitch=stitch, unused=True).points) == 6
    junction = [[0, 0, 0], [2, 0, 0], [0, 1, 1], [1, 0, 0], [1, -1, 0]]
    stitched = reeb_graph.repair([[0, 1, 2], [3, 0, 4], [1, 3, 4]], junction, stitch=1e-9)
    assert len(stitched.triangles) == 4 and np.array_equal(stitched.points, junction)
    for wrong in ({"stitch": 0}, {"stitch": "x"}, {"stitch": -1}, {"merge_within": 0}, {"merge_within": -1}, {"merge_within": np.nan}, {"merge": True, "merge_within": 1},
                  {"least_piece": 2}, {"fill": -1}):
        with pytest.raises(ValueError):
            reeb_graph.repair(TRIANGLES, POINTS, **wrong)
    with pytest.raises(ValueError, match="needs points"):
        reeb_graph.repair(TRIANGLES)


def test_components_without_a_source():
    triangles, points = meshes.grid(4, 4)
    two = np.concatenate([triangles, triangles + 16]), np.concatenate([points, points + 5])
    for name, options in (("geodesic", {"sources": 0}), ("poisson", {"sources": 0}), ("harmonic", {"minimum": 0, "maximum": 15})):
        function = getattr(reeb_graph, name)
        with pytest.raises(ValueError, match="component 1, that of vertex 16, has no vertex whose value is given"):
            function(*two, **options)
        field = function(*two, unreached="nan", **options)
        assert np.allclose(field[:16], function(triangles, points, **options), atol=1e-12) and np.isnan(field[16:]).all()
        with pytest.raises(ValueError, match="unreached is one of error, nan, not 'zero'"):
            function(*two, unreached="zero", **options)
    distances = reeb_graph.geodesic([], np.zeros((3, 3)), edges=[[0, 1]], sources=0, unreached="nan")
    assert np.array_equal(distances, [0, 0, np.nan], equal_nan=True)


def test_borders_of_tetrahedra(tmp_path):
    tetrahedra, points = meshes.tetrahedra_of_cubes(2)
    meshes.write_medit(tmp_path / "cube.mesh", tetrahedra, points)
    cube = reeb_graph.read(tmp_path / "cube.mesh")
    border = reeb_graph.repair(cube, unused=True)
    assert len(border.triangles) == 48 and len(border.points) == 26  # of 27 points, one is inside
    a, b, c = np.moveaxis(border.points[border.triangles], 1, 0)
    assert np.isclose(np.einsum("ij,ij->", a, np.cross(b, c)) / 6, 8)
    meshes.run("repair", tmp_path / "cube.mesh", "--unused", "--output", tmp_path / "cube.off")
    assert np.array_equal(reeb_graph.read(tmp_path / "cube.off").triangles, border.triangles)
    assert reeb_graph.skeleton(cube).counts == reeb_graph.skeleton(border.triangles, border.points).counts
    for function, options in ((reeb_graph.skeleton, {"strict": True}), (reeb_graph.handles, {})):
        with pytest.raises(ValueError, match="the mesh has tetrahedra; reeb_graph repair takes their border"):
            function(cube, **options)


def test_levels(tmp_path, mesh_file):
    scalars = POINTS[:, 0] + 0.3 * np.sin(5 * POINTS[:, 1])
    level = [float(scalars[7]), 0.1, 50.0]
    cut = reeb_graph.cut_along_levels(TRIANGLES, scalars, POINTS, level=level, vertex_arrays={"point": POINTS})
    np.save(tmp_path / "scalars.npy", scalars)
    meshes.run("curves", mesh_file, "--scalars", tmp_path / "scalars.npy", "--type", "levels", "--patches",
               tmp_path / "patches.txt", *(word for value in level for word in ("--level", repr(value))))
    assert np.array_equal(cut.patches, np.loadtxt(tmp_path / "patches.txt", dtype=int))
    assert np.array_equal(cut.points[: len(POINTS)], POINTS) and np.array_equal(cut.scalars[: len(POINTS)], scalars)
    assert set(cut.scalars[len(POINTS):]) <= set(level) and set(cut.curve_values) <= set(level[:2])
    assert np.array_equal(cut.bands, (np.sort(level) < cut.scalars[cut.triangles].max(axis=1)[:, None]).sum(axis=1))
    assert len(cut.curves) == len(cut.curve_values) == len(cut.curve_arcs) == len(cut.curve_closed)
    assert cut.curve_closed.all() and np.allclose(cut.vertex_arrays["point"], cut.points)
    graph = reeb_graph.compute(cut.triangles, cut.scalars, points=cut.points)
    for value in set(cut.curve_values):
        expected = sorted(contour.arc for contour in graph.contours(level=value))
        assert sorted(set(cut.curve_arcs[cut.curve_values == value])) == expected
    assert len(reeb_graph.cut_along_levels(TRIANGLES, scalars, POINTS, levels=3).curve_values) >= 3
    spaced = reeb_graph.cut_along_levels(TRIANGLES, scalars, POINTS, spacing=0.25, cut_open=True)
    assert np.array_equal(spaced.curve_values, np.round(spaced.curve_values * 4) / 4)
    with pytest.raises(ValueError, match="is needed"):
        reeb_graph.cut_along_levels(TRIANGLES, scalars, POINTS)
    with pytest.raises(TypeError, match="given as level"):
        reeb_graph.cut_along_levels(TRIANGLES, scalars, POINTS, levels=[0.1])
    with pytest.raises(ValueError, match="more than are wanted"):
        reeb_graph.cut_along_levels(TRIANGLES, scalars, POINTS, level=0.1, max_triangles=1)


def test_disks():
    cut = reeb_graph.cut_to_disks(TRIANGLES, POINTS, vertex_arrays={"number": np.arange(len(POINTS))})
    assert np.array_equal(cut.points, POINTS[cut.original]) and np.array_equal(cut.original[cut.triangles], TRIANGLES)
    assert np.array_equal(cut.vertex_arrays["number"], cut.original) and cut.n_patches == 1
    edges = np.sort(cut.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    assert len(cut.points) - len(np.unique(edges, axis=0)) + len(cut.triangles) == 1
    assert len(reeb_graph.cut_to_disks(cut.triangles, cut.points).curves) == 0
