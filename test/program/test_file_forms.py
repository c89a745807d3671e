# Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
#
# This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

"""Files of VTK and meshio in all their forms, read by the program; and its meshes, read by these and itself.

Usage: test_file_forms.py PROGRAM MESH FOLDER vtk|meshio
"""

import importlib
import itertools
import json
import math
import os
import pathlib
import random
import subprocess
import sys

SKIPPED = 77
program, mesh = map(os.path.abspath, sys.argv[1:3])
folder, reader = pathlib.Path(sys.argv[3]), sys.argv[4]
folder.mkdir(parents=True, exist_ok=True)
os.chdir(folder)
faults = []


def check(is_right, what):
    if not is_right:
        faults.append(what)


def load(name, package):
    try:
        return importlib.import_module(name)
    except ImportError:
        print(f"{package} is not installed: skipped")
        sys.exit(SKIPPED)


def run(*arguments):
    return subprocess.run([program, *arguments, "--json"], capture_output=True, text=True)


def counts(path, field="x"):
    """The numbers of points, faces, and tetrahedra that the program finds."""
    done = run("compute", path, "--field", field, "--triangulate")
    check(done.returncode == 0, f"{path} is refused: {done.stderr}")
    if done.returncode != 0:
        return None
    report = json.loads(done.stdout)
    return report["vertices"], report["faces"], report["complex"]["tetrahedra"] if report["complex"] else 0


def write_meshes():
    """The mesh in each format that repair writes."""
    paths = [f"mesh{ending}" for ending in (".off", ".obj", ".ply", ".stl", ".vtp")]
    for path in paths:
        check(run("repair", mesh, "--output", path).returncode == 0, f"{path} is not written")
        check(counts(path) == counts(mesh), f"{path} is another mesh")
    return paths


def vtk_points(core, number, is_double):
    points = core.vtkPoints()
    if is_double:
        points.SetDataTypeToDouble()
    for i in range(number):  # from 30 on, ten each on a circle
        angle = 2 * math.pi * (i % 10) / 10
        points.InsertNextPoint(*((i, i * i % 17, i * i * i % 23) if i < 30 else (math.cos(angle), math.sin(angle), i // 10)))
    return points


def add_arrays(core, data):
    """A field, and what the program leaves out."""
    number = data.GetNumberOfPoints()
    mass = core.vtkFloatArray()
    mass.SetName("mass of <a & b>")
    strings = core.vtkStringArray()
    strings.SetName("names")
    vectors = core.vtkDoubleArray()
    vectors.SetNumberOfComponents(3)
    vectors.SetName("force")
    bits = core.vtkBitArray()
    bits.SetName("bits")
    for i in range(number):
        mass.InsertNextValue(i * 0.5)
        strings.InsertNextValue("some text " * (i % 9))
        vectors.InsertNextTuple3(i, i, i)
        bits.InsertNextValue(i % 2)
    data.GetPointData().SetVectors(vectors)
    for array in (strings, bits, mass):
        data.GetPointData().AddArray(array)
    of_cells = core.vtkIdTypeArray()
    of_cells.SetName("cell")
    for i in range(data.GetNumberOfCells()):
        of_cells.InsertNextValue(i)
    data.GetCellData().AddArray(of_cells)


def polygonal_data(data_model, core):
    data = data_model.vtkPolyData()
    data.SetPoints(vtk_points(core, 60, True))
    cells = {"Verts": [[1], [2, 3]], "Lines": [[1, 2], [2, 3, 4, 5]], "Strips": [list(range(20, 29)), [50, 52, 55]],
             "Polys": [[3 * i, 3 * i + 1, 3 * i + 2] for i in range(5)] + [[30, 31, 32, 33], [40, 41, 42, 43, 44]]}
    for section, lists in cells.items():
        array = data_model.vtkCellArray()
        for numbers in lists:
            array.InsertNextCell(len(numbers), numbers)
        getattr(data, "Set" + section)(array)
    add_arrays(core, data)
    return data


def grid(data_model, core, types):
    sizes = {1: 1, 2: 3, 3: 2, 4: 5, 5: 3, 6: 6, 7: 5, 8: 4, 9: 4, 10: 4, 12: 8, 13: 6}
    random_numbers = random.Random(5)
    data = data_model.vtkUnstructuredGrid()
    data.SetPoints(vtk_points(core, 40, False))
    for kind in types:
        convex = {7: [30, 31, 32, 33, 34], 8: [35, 36, 38, 37], 9: [31, 33, 36, 38]}
        numbers = convex.get(kind) or random_numbers.sample(range(30), sizes[kind])
        data.InsertNextCell(kind, len(numbers), numbers)
    add_arrays(core, data)
    return data


def write_forms(name, data, xml, legacy):
    """Writes the data in all forms, and returns the paths of those that can be read, and of those that cannot."""
    kind = "UnstructuredGrid" if data.IsA("vtkUnstructuredGrid") else "PolyData"
    ending = ".vtu" if kind == "UnstructuredGrid" else ".vtp"
    read, refused = [], []
    for is_binary, version in itertools.product((False, True), (42, 51)):
        writer = getattr(legacy, f"vtk{kind}Writer")()
        writer.SetFileType(2 if is_binary else 1)
        writer.SetFileVersion(version)
        read.append(f"{name}_{is_binary}_{version}.vtk")
        writer.SetFileName(read[-1])
        writer.SetInputData(data)
        writer.Write()
    compressors = ("None", "ZLib", "LZ4", "LZMA")
    for mode, is_encoded, compressor, header, order in itertools.product(
            ("Ascii", "Binary", "Appended"), (0, 1), range(4), (32, 64), (0, 1)):
        writer = getattr(xml, f"vtkXML{kind}Writer")()
        getattr(writer, f"SetDataModeTo{mode}")()
        writer.SetEncodeAppendedData(is_encoded)
        writer.SetCompressorType(compressor)
        writer.SetHeaderType(header)
        writer.SetByteOrder(order)
        writer.SetBlockSize(256)
        path = f"{name}_{mode}{is_encoded}{compressors[compressor]}{header}{order}{ending}"
        (read if compressor < 2 else refused).append(path)
        writer.SetFileName(path)
        writer.SetInputData(data)
        writer.Write()
    return read, refused


def check_forms(name, data, xml, legacy, filters):
    tetrahedra = 0
    if data.IsA("vtkUnstructuredGrid"):
        of_types = [data.GetCellType(i) for i in range(data.GetNumberOfCells())]
        tetrahedra = of_types.count(10)
        faces = {5: 1, 6: 4, 7: 3, 8: 2, 9: 2, 10: 0}
        number = sum(faces.get(kind, 0) for kind in of_types) + 4 * tetrahedra  # with their faces
    else:
        triangles = filters.vtkTriangleFilter()
        triangles.PassVertsOff()
        triangles.PassLinesOff()
        triangles.SetInputData(data)
        triangles.Update()
        number = triangles.GetOutput().GetNumberOfPolys()
    read, refused = write_forms(name, data, xml, legacy)
    for path in read:
        for field in ("x", "mass of <a & b>"):
            expected = (data.GetNumberOfPoints(), number, tetrahedra)
            check(counts(path, field) == expected, f"{path} has {counts(path, field)} instead of {expected}")
    for path in refused:
        done = run("compute", path, "--field", "x")
        check(done.returncode == 1 and "DataCompressor" in done.stderr, f"{path} is not refused by its compressor")


def check_by_vtk():
    core = load("vtkmodules.vtkCommonCore", "python3-vtk9")
    data_model = load("vtkmodules.vtkCommonDataModel", "python3-vtk9")
    xml, legacy = load("vtkmodules.vtkIOXML", "python3-vtk9"), load("vtkmodules.vtkIOLegacy", "python3-vtk9")
    filters, geometry = load("vtkmodules.vtkFiltersCore", "python3-vtk9"), load("vtkmodules.vtkIOGeometry", "python3-vtk9")
    ply = load("vtkmodules.vtkIOPLY", "python3-vtk9")
    check_forms("poly", polygonal_data(data_model, core), xml, legacy, filters)
    check_forms("grid", grid(data_model, core, [1, 2, 3, 4, 5, 6, 7, 8, 9]), xml, legacy, filters)
    check_forms("tetrahedra", grid(data_model, core, [10, 3, 10]), xml, legacy, filters)
    hexahedra = grid(data_model, core, [12, 13, 10])
    for path in write_forms("hexahedra", hexahedra, xml, legacy)[0]:
        done = run("compute", path, "--field", "x")
        check(done.returncode == 1 and "12 (hexahedron), 13 (wedge)" in done.stderr and "vtkDataSetTriangleFilter" in done.stderr,
              f"{path} is not refused by its cells: {done.stderr}")
    readers = {".obj": geometry.vtkOBJReader, ".stl": geometry.vtkSTLReader, ".ply": ply.vtkPLYReader,
               ".vtp": xml.vtkXMLPolyDataReader}
    expected = counts(mesh)
    for path in write_meshes():
        ending = pathlib.Path(path).suffix
        if ending in readers:
            of_vtk = readers[ending]()
            of_vtk.SetFileName(path)
            of_vtk.Update()
            found = (of_vtk.GetOutput().GetNumberOfPoints(), of_vtk.GetOutput().GetNumberOfPolys(), 0)
            check(found == expected, f"VTK finds {found} in {path} instead of {expected}")


def check_by_meshio():
    meshio = load("meshio", "python3-meshio")
    points = [[float(i), i * i % 17, i * i * i % 23] for i in range(12)]
    triangles, tetrahedra = [[0, 1, 2], [2, 1, 3], [4, 5, 6]], [[7, 8, 9, 10]]
    fields = {"mass": [float(i) for i in range(12)]}
    cells = [("triangle", triangles)]
    for path in ("meshio.vtu", "meshio.vtk", "meshio.ply", "meshio.off", "meshio.obj", "meshio.stl"):
        has_tetrahedra = path in ("meshio.vtu", "meshio.vtk")
        has_fields = has_tetrahedra or path == "meshio.ply"
        meshio.Mesh(points, cells + ([("tetra", tetrahedra)] if has_tetrahedra else []),
                    point_data=fields if has_fields else {}).write(path)
        number = 7 if path == "meshio.stl" else 12
        for field in ("x", "mass") if has_fields else ("x",):
            expected = (number, 7, 1) if has_tetrahedra else (number, 3, 0)  # with the faces of the tetrahedron
            check(counts(path, field) == expected, f"{path} has {counts(path, field)}")
    for binary, version in ((True, "42"), (False, "51")):
        path = f"meshio{version}.vtk"
        meshio.vtk.write(path, meshio.Mesh(points, cells, point_data=fields), fmt_version="4.2" if version == "42" else "5.1",
                         binary=binary)
        check(counts(path, "mass") == (12, 3, 0), f"{path} has {counts(path, 'mass')}")
    for compression in (None, "zlib", "lzma"):
        path = f"meshio_{compression}.vtu"
        meshio.vtu.write(path, meshio.Mesh(points, cells, point_data=fields), compression=compression)
        if compression == "lzma":
            check("meshio decompress" in run("compute", path, "--field", "x").stderr, f"{path} is not refused")
        else:
            check(counts(path, "mass") == (12, 3, 0), f"{path} has {counts(path, 'mass')}")
    number_of_points, number_of_faces, _ = counts(mesh)
    for path in write_meshes():
        if not path.endswith(".vtp"):
            of_meshio = meshio.read(path)
            found = len(of_meshio.points), sum(len(block.data) for block in of_meshio.cells if block.type == "triangle")
            check(found[1] == number_of_faces and found[0] >= number_of_points, f"meshio finds {found} in {path}")


{"vtk": check_by_vtk, "meshio": check_by_meshio}[reader]()
for fault in sorted(set(faults)):
    print(f"wrong: {fault}")
sys.exit(1 if faults else 0)
