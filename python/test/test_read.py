"""Files, scenes and meshes of VTK in the place of triangles."""

import types
import warnings

import numpy as np
import pytest

import reeb_graph
from meshes import sphere, write_off


def test_a_file_is_what_the_program_reads(tmp_path):
    triangles, points = sphere()
    file = tmp_path / "sphere.off"
    write_off(file, triangles, points)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        mesh = reeb_graph.read(file)
        for given in (file, str(file), mesh):
            assert np.array_equal(reeb_graph.compute(given, "z").arcs, reeb_graph.compute(triangles, points[:, 2]).arcs)
            assert np.array_equal(reeb_graph.height(given), points[:, 2])
    assert np.array_equal(mesh.triangles, triangles) and np.array_equal(mesh.points, points)


def test_fields_of_a_file_have_their_types(tmp_path):
    file = tmp_path / "fields.ply"
    properties = "property float x\nproperty float y\nproperty float z\nproperty uchar label\nproperty double heat\n"
    file.write_text("ply\nformat ascii 1.0\nelement vertex 3\n" + properties + "element face 1\n"
                    "property list uchar int vertex_indices\nend_header\n0 0 0 1 0.5\n1 0 0 2 0.25\n0 1 0 255 2\n3 0 1 2\n")
    data = reeb_graph.read(file).point_data
    assert data["label"].dtype == np.uint8 and data["label"].tolist() == [1, 2, 255]
    assert data["heat"].dtype == np.float64 and reeb_graph.compute(file, "heat").node_values.tolist() == [0.25, 2]


def test_what_is_found_is_a_warning_and_polygons_are_cut_if_asked(tmp_path):
    file = tmp_path / "faces.obj"
    file.write_text("v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nv 0 0 0\nf 1 2 3 4\nf 1 5\n")
    with pytest.raises(ValueError, match=r"face 0 has 4 vertices .*read\(file, triangulate=True\)"):
        reeb_graph.read(file)
    with pytest.warns(UserWarning, match="1 with fewer than three corners"):
        mesh = reeb_graph.read(file, triangulate=True)
    assert len(mesh.triangles) == 2 and len(mesh.points) == 5
    with pytest.raises(FileNotFoundError):
        reeb_graph.read(tmp_path / "nothing.ply")


def test_tetrahedra_and_edges_of_a_file(tmp_path):
    file = tmp_path / "cells.mesh"
    vertices = "0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n5 5 5 0\n"
    file.write_text(f"MeshVersionFormatted 2\nDimension 3\nVertices 5\n{vertices}Tetrahedra 1\n1 2 3 4 0\nEdges 1\n4 5 0\nEnd\n")
    mesh = reeb_graph.read(file)
    assert mesh.tetrahedra.tolist() == [[0, 1, 2, 3]] and mesh.edges.tolist() == [[3, 4]]
    assert reeb_graph.compute(file, "z").n_components == 1


def test_what_a_format_has_no_room_for_is_a_warning(tmp_path):
    triangles, points = sphere()
    graph = reeb_graph.compute(triangles, points[:, 2], points=points)
    with pytest.warns(UserWarning, match=r"mesh\.stl: the field, .* and colors are left out"):
        graph.write(tmp_path / "mesh.stl", what="mesh")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        graph.write(tmp_path / "mesh.ply")


def test_a_scene_is_all_of_its_meshes():
    triangles, points = sphere()
    mesh = types.SimpleNamespace(vertices=points, faces=triangles, vertex_attributes={})
    for scene in (types.SimpleNamespace(geometry={"a": mesh}, dump=lambda concatenate: mesh),
                  types.SimpleNamespace(geometry={"a": mesh}, dump=None, to_mesh=lambda: mesh)):
        assert np.array_equal(reeb_graph.mesh_arrays(scene).triangles, triangles)
        assert len(reeb_graph.compute(scene, points[:, 2]).arcs) == 1


def test_polygonal_data_of_vtk():
    core = pytest.importorskip("vtkmodules.vtkFiltersSources")
    pytest.importorskip("vtkmodules.util.numpy_support")
    source = core.vtkSphereSource()
    source.Update()
    data = source.GetOutput()
    mesh = reeb_graph.mesh_arrays(data)
    assert mesh.triangles.shape == (data.GetNumberOfPolys(), 3) and len(mesh.points) == data.GetNumberOfPoints()
    assert "Normals" in mesh.point_data and reeb_graph.compute(data, "z").n_arcs == 1
    cube = core.vtkCubeSource()
    cube.Update()
    with pytest.raises(ValueError, match="vtkTriangleFilter"):
        reeb_graph.compute(cube.GetOutput(), "z")
