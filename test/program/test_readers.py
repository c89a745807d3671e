# Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
#
# This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

"""What the program writes, read by programs that know nothing of it.

Usage: test_readers.py PROGRAM MESH FOLDER python|contours|networkx|vtk
"""

import csv
import importlib
import json
import math
import os
import pathlib
import subprocess
import sys

SKIPPED = 77
program, mesh = map(os.path.abspath, sys.argv[1:3])
folder, reader = sys.argv[3:]
folder = pathlib.Path(folder)
folder.mkdir(parents=True, exist_ok=True)
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
    done = subprocess.run([program, *arguments, "--json"], cwd=folder, check=True, capture_output=True, text=True)
    return json.loads(done.stdout)


def compute(graph, *arguments):
    return run("compute", mesh, "--field", "x", "--graph", graph, *arguments)


def read_points():
    with open(mesh) as lines:
        words = lines.read().split()
    size = int(words[1])
    numbers = list(map(float, words[4:4 + 3 * size]))
    return [tuple(numbers[i:i + 3]) for i in range(0, 3 * size, 3)]


def are_close(a, b):
    return all(math.isclose(x, y, rel_tol=1e-12, abs_tol=1e-12) for x, y in zip(a, b))


def read_json(name):
    def refuse(constant):
        raise ValueError(f"{constant} is no JSON")

    with open(folder / name) as file:
        return json.load(file, parse_constant=refuse)


def check_by_python():
    points = read_points()
    for manner in ("centroids", "on-surface", "straight"):
        report = compute("graph.json", "--embedding", manner)
        graph = read_json("graph.json")
        compute("graph.csv", "--embedding", manner)
        with open(folder / "graph.nodes.csv", newline="") as file:
            nodes = list(csv.DictReader(file))
        with open(folder / "graph.arcs.csv", newline="") as file:
            arcs = list(csv.DictReader(file))
        check(len(nodes) == len(graph["nodes"]) == report["nodes"], "the numbers of nodes differ")
        check(len(arcs) == len(graph["edges"]), "the numbers of arcs differ")
        for row, node in zip(nodes, graph["nodes"]):
            check(int(row["vertex"]) == node["vertex"] and row["kind"] == node["kind"], "nodes differ")
            check([float(row[c]) for c in "xyz"] == node["point"], "points of nodes differ")
            check(float(row["value"]) == node["value"] == points[node["vertex"]][0], "values differ")
            if manner != "centroids":
                check(tuple(node["point"]) == points[node["vertex"]], "a node is not at its vertex")
        for row, arc in zip(arcs, graph["edges"]):
            ends = [graph["nodes"][arc[end]] for end in ("source", "target")]
            check([int(row["source"]), int(row["target"])] == [end["id"] for end in ends], "ends differ")
            check(arc["polyline"][0] == ends[0]["point"] and arc["polyline"][-1] == ends[1]["point"],
                  "a polyline does not end at its nodes")
            check(arc["values"] == sorted(arc["values"]) and len(arc["values"]) == len(arc["polyline"]),
                  "values do not ascend")
            # The field is the coordinate x, of centroids as well.
            if manner != "straight":
                check(are_close(arc["values"], [p[0] for p in arc["polyline"]]), "a point has not its value")
            for name in ("persistence", "length", "area", "vertices", "mean_value"):
                check(float(row[name]) == arc[name], f"{name} differs")
            chain = arc["chain"]
            check(chain[0][0] == ends[0]["vertex"], "a chain does not begin at its node")
            check(all(points[u][0] <= points[v][0] for path in chain for u, v in zip(path, path[1:])),
                  "a chain falls")
    check(abs(sum(arc["vertices"] for arc in graph["edges"]) + len(graph["nodes"]) - len(points)) == 0,
          "the vertices of arcs and nodes are not those of the mesh")


def minus(u, v):
    return [x - y for x, y in zip(u, v)]


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def nearest_on_segment(p, a, b):
    along = minus(b, a)
    k = min(max(dot(minus(p, a), along) / dot(along, along), 0), 1) if a != b else 0
    return [(1 - k) * x + k * y for x, y in zip(a, b)]


def nearest_in_triangle(p, a, b, c):
    """The point that is nearest to p, inside the triangle or on its sides."""
    u, v, w = minus(b, a), minus(c, a), minus(p, a)
    uu, uv, vv, wu, wv = dot(u, u), dot(u, v), dot(v, v), dot(w, u), dot(w, v)
    s, t = (vv * wu - uv * wv) / (uu * vv - uv * uv), (uu * wv - uv * wu) / (uu * vv - uv * uv)
    places = [[(1 - s - t) * x + s * y + t * z for x, y, z in zip(a, b, c)]] if min(s, t, 1 - s - t) >= 0 else []
    places += [nearest_on_segment(p, a, b), nearest_on_segment(p, b, c), nearest_on_segment(p, c, a)]
    return min(places, key=lambda place: math.dist(p, place))


def contours(*arguments):
    report = run("contour", mesh, "--field", "x", *arguments, "--output", "contours.json")
    lines = read_json("contours.json")["contours"]
    check(report["contours"] == len(lines), "the numbers of contours differ")
    for line in lines:
        polyline = line["polyline"]
        check(are_close([p[0] for p in polyline], [line["value"]] * len(polyline)), "a contour is not at its value")
        check(line["closed"] and polyline[0] == polyline[-1], "a contour is not closed")
        check(are_close([line["length"]], [sum(map(math.dist, polyline, polyline[1:]))]), "a length is another")
    return lines


def check_contours():
    points = read_points()
    with open(mesh) as file:
        words = file.read().split()
    begin = 4 + 3 * len(points)
    triangles = [[points[int(v)] for v in words[i + 1:i + 4]] for i in range(begin, begin + 4 * int(words[2]), 4)]
    compute("graph.json")
    graph = read_json("graph.json")
    all_arcs = contours("--t", "0.25")
    check([line["arc"] for line in all_arcs] == list(range(len(graph["edges"]))), "there is not a contour for each arc")
    for line, arc in zip(all_arcs, graph["edges"]):
        low, high = (graph["nodes"][arc[end]]["value"] for end in ("source", "target"))
        check(are_close([line["value"]], [low + (high - low) / 4]), "the value of a place is another")
        check(contours("--t", "0.25", "--arc", str(line["arc"])) == [line], "the contour of an arc is another")
    low, high = min(points)[0], max(points)[0]
    steps = contours("--levels", "3")
    values = [low + (high - low) * i / 4 for i in (1, 2, 3)]
    check(are_close(sorted({line["value"] for line in steps}), values), "the steps are not equal")
    levels = [option for value in sorted({line["value"] for line in steps}) for option in ("--level", repr(value))]
    check(contours(*levels) == steps, "levels and steps differ")

    random = 1
    for number in range(40):
        point = []
        for axis in range(3):
            random = random * 1103515245 % 2147483647
            point.append((random / 2147483647 - 0.5) * 3 * max(abs(p[axis]) for p in points))
        if number >= 30:  # at a vertex, the first of them lowest and highest
            point = min(points) if number == 30 else max(points) if number == 31 else points[97 * number % len(points)]
        places = [nearest_in_triangle(point, *triangle) for triangle in triangles]
        place = min(places, key=lambda place: math.dist(point, place))
        lines = contours("--closest=" + ",".join(map(repr, point)))
        check(len(lines) == 1, "there is not one closest contour")
        polyline = lines[0]["polyline"]
        distance = min(math.dist(place, nearest_on_segment(place, a, b)) for a, b in zip(polyline, polyline[1:]))
        check(distance < 1e-6, f"the closest contour passes by {point} at {distance}")

    for arguments in (["--t", "0.25"], ["--levels", "5"]):
        lines = contours(*arguments)
        run("contour", mesh, "--field", "x", *arguments, "--output", "contours.polylines.txt")
        with open(folder / "contours.polylines.txt") as file:
            for line, text in zip(lines, file):
                numbers = list(map(float, text.split()))
                check(numbers[1:] == [x for p in line["polyline"] for x in p], "the formats differ")
        run("contour", mesh, "--field", "x", *arguments, "--output", "contours.obj")
        with open(folder / "contours.obj") as file:
            words = [row.split() for row in file]
        vertices = [list(map(float, row[1:])) for row in words if row[0] == "v"]
        drawn = [[vertices[int(i) - 1] for i in row[1:]] for row in words if row[0] == "l"]
        check(drawn == [line["polyline"] for line in lines], "the lines of the OBJ file are others")
        told = [row[2::2] for row in words if row[0] == "#"]
        check([(int(a), float(v), float(s), int(c)) for a, v, s, c in told]
              == [(line["arc"], line["value"], line["length"], int(line["closed"])) for line in lines],
              "the attributes of the OBJ file are others")


def check_by_networkx():
    networkx = load("networkx", "python3-networkx")
    report = compute("graph.json")
    compute("graph.graphml")
    data = read_json("graph.json")
    try:
        graph = networkx.node_link_graph(data, edges="edges")
    except TypeError:  # before version 3.4
        graph = networkx.node_link_graph(data, link="edges")
    other = networkx.read_graphml(folder / "graph.graphml", node_type=int, force_multigraph=True)
    check(graph.is_directed() and graph.is_multigraph(), "it is no directed graph with parallel arcs")
    check(sorted(graph.edges()) == sorted(other.edges()), "the arcs are not those of the GraphML file")
    check(all(graph.nodes[n]["vertex"] == other.nodes[n]["vertex"] for n in graph), "the nodes are others")
    loops = graph.number_of_edges() - graph.number_of_nodes() + networkx.number_weakly_connected_components(graph)
    check(loops == report["loops"], "the numbers of loops differ")
    measures = ("persistence", "length", "area", "vertices", "mean_value")
    check(sorted((u, v, *(d[name] for name in measures)) for u, v, d in graph.edges(data=True))
          == sorted((u, v, *(d[name] for name in measures)) for u, v, d in other.edges(data=True)),
          "the measures of arcs are others")
    check(networkx.is_directed_acyclic_graph(graph), "arcs do not ascend")
    # Paths along a skeleton are the shortest ones, from the place that is farthest from the surface to all ends.
    neuron = os.path.join(os.path.dirname(mesh), "neuron.off")
    report = run("skeleton", neuron, "--from", "thickest", "--output", "paths.vtp")
    run("skeleton", neuron, "--output", "skeleton.graphml")
    skeleton = networkx.Graph(networkx.read_graphml(folder / "skeleton.graphml", node_type=int))
    place = {v: [data[name] for name in "xyz"] for v, data in skeleton.nodes(data=True)}
    for a, b, data in skeleton.edges(data=True):
        data["length"] = math.dist(place[a], place[b])
    thickest = max(skeleton.nodes(data="inscribed_radius"), key=lambda node: (node[1], -node[0]))[0]
    lengths = networkx.single_source_dijkstra_path_length(skeleton, thickest, weight="length")
    tips = [v for v in skeleton if skeleton.degree(v) == 1]
    check([path["from"] for path in report["paths"]] == [thickest] * len(tips), "a path begins elsewhere")
    check([path["to"] for path in report["paths"]] == sorted(tips), "a path ends elsewhere")
    check(all(math.isclose(path["length"], lengths[path["to"]], rel_tol=1e-9) for path in report["paths"]),
          "a path is not the shortest one")


def read_by_vtk(vtk_io, name):
    messages = []
    xml = vtk_io.vtkXMLPolyDataReader()
    xml.AddObserver("ErrorEvent", lambda *_: messages.append("error"))
    xml.AddObserver("WarningEvent", lambda *_: messages.append("warning"))
    xml.SetFileName(str(folder / name))
    xml.Update()
    check(not messages, f"VTK complains of {name}")
    return xml.GetOutput()


def check_colours(vtk_rendering, data):
    """Each array can be coloured by."""
    for arrays, choose in ((data.GetPointData(), "SetScalarModeToUsePointFieldData"),
                           (data.GetCellData(), "SetScalarModeToUseCellFieldData")):
        for i in range(arrays.GetNumberOfArrays()):
            array = arrays.GetArray(i)
            mapper = vtk_rendering.vtkDataSetMapper()
            mapper.SetInputData(data)
            getattr(mapper, choose)()
            mapper.SelectColorArray(array.GetName())
            if array.GetNumberOfComponents() == 1:
                low, high = array.GetRange()
                check(math.isfinite(low) and math.isfinite(high), f"{array.GetName()} has no range")
                mapper.SetScalarRange(low, high)
                colours = mapper.MapScalars(data, 1)
                tuples = {colours.GetTuple(j) for j in range(colours.GetNumberOfTuples())}
                check(colours.GetNumberOfTuples() == array.GetNumberOfTuples(), f"{array.GetName()} is too short")
                check(low == high or len(tuples) > 1, f"{array.GetName()} has one colour")


def check_skeleton_by_vtk(vtk_io, vtk_ply):
    report = run("skeleton", mesh, "--output", "skeleton.vtp", "--output", "skeleton.polylines.txt", "skeleton.csv",
                 "--mesh-out", "faces.ply", "--pieces", "pieces")
    data = read_by_vtk(vtk_io, "skeleton.vtp")
    number_of_points, number_of_lines = data.GetNumberOfPoints(), data.GetNumberOfLines()
    check(number_of_points == report["points"] + report["loops"], "there is not a copy for each loop")
    check(number_of_lines == data.GetNumberOfCells(), "there are other cells than lines")
    of_points, of_cells = data.GetPointData(), data.GetCellData()
    for name in ("MaximumInscribedSphereRadius", "Radius"):
        array = of_points.GetArray(name)
        check(array.GetNumberOfTuples() == number_of_points, f"there is not a number for each point: {name}")
        check(all(array.GetValue(i) >= 0 for i in range(number_of_points)), f"a radius is negative: {name}")
    numbers = {name: [of_cells.GetArray(name).GetValue(i) for i in range(number_of_lines)]
               for name in ("GroupIds", "CenterlineIds", "TractIds", "Blanking", "BranchIds")}
    check(numbers["GroupIds"] == list(range(number_of_lines)), "there is not a line for each group")
    check(numbers["TractIds"].count(0) >= 1 and set(numbers["Blanking"]) <= {0, 1}, "tracts have no root")
    # Put together again, the lines of a branch are those of the other file. Without loops, they are trees.
    polylines = [[float(x) for x in line.split()[1:]]
                 for line in (folder / "skeleton.polylines.txt").read_text().splitlines()]
    polylines = [[tuple(line[i:i + 3]) for i in range(0, len(line), 3)] for line in polylines]
    edges = 0
    for branch, polyline in enumerate(polylines):
        points, blanked = [], []
        for i in range(number_of_lines):
            if numbers["BranchIds"][i] == branch:
                ids = data.GetCell(i).GetPointIds()
                line = [data.GetPoint(ids.GetId(j)) for j in range(ids.GetNumberOfIds())]
                check(points == [] or points[-1] == line[0], "a branch has a gap")
                points += line[1:] if points else line
                blanked.append(numbers["Blanking"][i])
        check(points == polyline, "a branch is another line")
        is_cut = report["loops"] > 0  # there, a line can end outside of junctions
        check(is_cut or all(a != b for a, b in zip(blanked, blanked[1:])), "two groups are one")
        edges += len(points) - 1
    check(edges == number_of_points - report["components"], "the lines have loops")
    check(any(numbers["Blanking"]) == (report["junctions"] > 0), "junctions are not blanked")

    sizes = {int(path.stem.split("_")[1]): path for path in (folder / "pieces").iterdir()}
    with open(folder / "skeleton.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    number_of_faces = 0
    for number, path in sizes.items():
        reader = vtk_ply.vtkPLYReader()
        reader.SetFileName(str(path))
        reader.Update()
        piece = reader.GetOutput()
        area = 0
        for i in range(piece.GetNumberOfCells()):
            a, b, c = (piece.GetPoint(piece.GetCell(i).GetPointId(j)) for j in range(3))
            u, v = minus(b, a), minus(c, a)
            area += math.sqrt(max(dot(u, u) * dot(v, v) - dot(u, v) ** 2, 0)) / 2
        check(math.isclose(area, float(rows[number]["area"]), rel_tol=1e-4), "the area of a piece is another")
        number_of_faces += piece.GetNumberOfCells()
    header = (folder / "faces.ply").read_bytes().split(b"end_header")[0].decode()
    check(f"element face {number_of_faces}\n" in header, "pieces are not all faces")
    for name in ("branch", "arc", "junction"):
        check(f"property int {name}\n" in header, f"the mesh has no {name}")


def check_by_vtk():
    vtk_io = load("vtkmodules.vtkIOXML", "python3-vtk9")
    vtk_rendering = load("vtkmodules.vtkRenderingCore", "python3-vtk9")
    vtk_ply = load("vtkmodules.vtkIOPLY", "python3-vtk9")
    points = read_points()
    for manner in ("centroids", "on-surface", "straight"):
        compute("graph.json", "--embedding", manner)
        graph = read_json("graph.json")
        compute("graph.vtp", "--embedding", manner, "--mesh-out", "mesh.vtp")
        data = read_by_vtk(vtk_io, "graph.vtp")
        nodes, arcs = graph["nodes"], graph["edges"]
        check(data.GetNumberOfVerts() == len(nodes) and data.GetNumberOfLines() == len(arcs), "the cells are others")
        of_points, of_cells = data.GetPointData(), data.GetCellData()
        for i, node in enumerate(nodes):
            check(list(data.GetPoint(i)) == node["point"], "a node is elsewhere")
            check(of_points.GetArray("value").GetValue(i) == node["value"], "a node has another value")
            check(of_points.GetArray("vertex").GetValue(i) == node["vertex"], "a node has another vertex")
            check(of_cells.GetArray("arc").GetValue(i) == -1 and of_cells.GetArray("node").GetValue(i) == i,
                  "the cells of nodes are others")
        for i, arc in enumerate(arcs):
            ids = data.GetCell(len(nodes) + i).GetPointIds()
            numbers = [ids.GetId(j) for j in range(ids.GetNumberOfIds())]
            check([list(data.GetPoint(j)) for j in numbers] == arc["polyline"], "a line is another")
            check([of_points.GetArray("value").GetValue(j) for j in numbers] == arc["values"], "values are others")
            check([numbers[0], numbers[-1]] == [arc["source"], arc["target"]], "a line does not end at its nodes")
            check(of_cells.GetArray("arc").GetValue(len(nodes) + i) == i, "the cells of arcs are others")
            for name in ("persistence", "length", "area", "vertices", "mean_value"):
                check(of_cells.GetArray(name).GetValue(len(nodes) + i) == arc[name], f"{name} is another")
        check_colours(vtk_rendering, data)
    data = read_by_vtk(vtk_io, "mesh.vtp")
    check([data.GetPoint(i) for i in range(data.GetNumberOfPoints())] == points, "the points of the mesh are others")
    check([data.GetPointData().GetArray("value").GetValue(i) for i in range(len(points))] == [p[0] for p in points],
          "the field is another")
    check_colours(vtk_rendering, data)
    run("contour", mesh, "--field", "x", "--levels", "5", "--output", "contours.json")
    run("contour", mesh, "--field", "x", "--levels", "5", "--output", "contours.vtp")
    lines = read_json("contours.json")["contours"]
    data = read_by_vtk(vtk_io, "contours.vtp")
    check(data.GetNumberOfLines() == data.GetNumberOfCells() == len(lines), "the lines of contours are others")
    for i, line in enumerate(lines):
        ids = data.GetCell(i).GetPointIds()
        check([list(data.GetPoint(ids.GetId(j))) for j in range(ids.GetNumberOfIds())] == line["polyline"],
              "a contour is another")
        for name in ("arc", "value", "length", "closed"):
            check(data.GetCellData().GetArray(name).GetValue(i) == line[name], f"{name} of a contour is another")
    run("curves", mesh, "--field", "x", "--type", "pants", "--mesh-out", "cut.vtp")
    data = read_by_vtk(vtk_io, "cut.vtp")
    patches = data.GetCellData().GetArray("patch")
    check(patches.GetNumberOfTuples() == data.GetNumberOfPolys() > 0, "there is not a patch for each face")
    check_colours(vtk_rendering, data)
    check_skeleton_by_vtk(vtk_io, vtk_ply)
    compute("graph.dot", "--mesh-out", "mesh.ply")
    ply = vtk_ply.vtkPLYReader()
    ply.SetFileName(str(folder / "mesh.ply"))
    ply.Update()
    check(ply.GetOutput().GetNumberOfPoints() == len(points), "the PLY file has other points")
    check(ply.GetOutput().GetPointData().GetArray("RGBA") is not None, "the PLY file has no colours")


{"python": check_by_python, "contours": check_contours, "networkx": check_by_networkx, "vtk": check_by_vtk}[reader]()
for fault in sorted(set(faults)):
    print(f"wrong: {fault} ({faults.count(fault)} times)")
sys.exit(1 if faults else 0)
