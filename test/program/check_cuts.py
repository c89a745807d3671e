#!/usr/bin/env python3
"""Checks the files of test_levels_and_disks.cmake in a folder: bands, pieces, curves, and copies of vertices."""

import json
import pathlib
import struct
import sys

folder = pathlib.Path(sys.argv[1])
TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d",
         "int8": "b", "uint8": "B", "int32": "i", "uint32": "I", "float32": "f", "float64": "d"}


def read_off(name):
    words = (folder / name).read_text().split()
    vertices, faces = int(words[1]), int(words[2])
    numbers = words[4:]
    points = [tuple(map(float, numbers[3 * i:3 * i + 3])) for i in range(vertices)]
    corners = numbers[3 * vertices:]
    return points, [tuple(map(int, corners[4 * i + 1:4 * i + 4])) for i in range(faces)]


def read_ply(name):
    """The properties of the vertices and of the faces, each a list of dictionaries."""
    header, body = (folder / name).read_bytes().split(b"end_header\n", 1)
    elements = []
    for line in header.decode().splitlines():
        words = line.split()
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].append(words[1:])
    position, result = 0, {}

    def take(kind):
        nonlocal position
        number, = struct.unpack_from("<" + TYPES[kind], body, position)
        position += struct.calcsize(TYPES[kind])
        return number

    for element, number, properties in elements:
        result[element] = []
        for _ in range(number):
            row = {}
            for kind in properties:
                row[kind[-1]] = [take(kind[2]) for _ in range(take(kind[1]))] if kind[0] == "list" else take(kind[0])
            result[element].append(row)
    return result["vertex"], result["face"]


def check(condition, fault):
    if not condition:
        sys.exit(fault)


def check_levels():
    given, _ = read_off("surface.off")
    levels = [-0.05, 0.1, 9]
    vertices, faces = read_ply("bands.ply")
    pieces = [int(line) for line in (folder / "pieces.txt").read_text().split()]
    cut_points, cut_faces = read_off("cut.off")
    check(cut_points[:len(given)] == given, "a vertex has moved")
    check(all(point[2] in levels for point in cut_points[len(given):]), "a vertex is at no level")
    check(len(pieces) == len(faces) == len(cut_faces), "other faces")
    piece_bands = {}
    for face, piece in zip(faces, pieces):
        corners = next(face[name] for name in ("vertex_indices", "vertex_index") if name in face)
        values = [vertices[v]["scalar"] for v in corners]
        check(face["band"] == sum(level < max(values) for level in levels), "a face is in another band")
        check(all(not min(values) < level < max(values) for level in levels), "a face crosses a level")
        check(face["patch"] == piece, "other pieces")
        check(piece_bands.setdefault(piece, face["band"]) == face["band"], "a piece is in two bands")
    curves = json.loads((folder / "curves.json").read_text())["contours"]
    check({curve["value"] for curve in curves} == {-0.05, 0.1}, "other levels")
    for curve in curves:
        check(all(point[2] == curve["value"] for point in curve["polyline"]), "a point of a curve is not at its level")
        check(curve["closed"] and curve["polyline"][0] == curve["polyline"][-1], "a curve of a closed surface is open")
        check(curve["arc"] >= 0, "a curve has no arc")
    heights = [point[2] for point in given]
    spaced = {curve["value"] for curve in json.loads((folder / "spaced.json").read_text())["contours"]}
    check(spaced == {k / 8 for k in range(-80, 80) if min(heights) < k / 8 < max(heights)}, "other multiples")


def check_disks():
    given, given_faces = read_off("surface.off")
    points, faces = read_off("disks.off")
    originals = [int(line) for line in (folder / "map.txt").read_text().split()]
    check(points == [given[v] for v in originals], "a copy is elsewhere")
    turned = [{face, face[1:] + face[:1], face[2:] + face[:2]} for face in given_faces]
    check(all(tuple(originals[v] for v in face) in turns for face, turns in zip(faces, turned)), "a face has changed")
    check(len(faces) == len(given_faces), "there are other faces")
    vertices, _ = read_ply("disks.ply")
    check([v["original"] for v in vertices] == originals, "the property original is another one")
    check("scalar" not in vertices[0], "there is a field")
    vertices, _ = read_ply("disks_with_field.ply")
    check(all(v["scalar"] == given[v["original"]][0] for v in vertices), "a copy has another value")


check_levels()
check_disks()
