# Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
#
# This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

"""Draws the figures of README and manual from what the program makes of the surface of its demo and of the examples.

Usage: draw_figures.py PROGRAM FOLDER [NAME...], all figures or those whose file names are given; FOLDER is fig/ beside
this script for the manual. It needs NumPy, for the figures of the page Chromium and Selenium, and for those of the page
on Python its package, by PYTHONPATH. The files that are drawn stay in a folder for them, FOLDER/files, to be deleted.
The three schemes, torus.svg, link_sectors.svg and chain.svg, are their own sources. All figures suit light and dark
pages: drawings follow the browser, and the ground of what is rendered is transparent.
"""

import colorsys
import itertools
import json
import pathlib
import re
import struct
import subprocess
import sys
import time
import zlib

import numpy

program, folder, wanted = sys.argv[1], pathlib.Path(sys.argv[2]).absolute(), sys.argv[3:]
data = pathlib.Path(__file__).resolve().parents[2] / "examples" / "Reeb_graph" / "data"
files = folder / "files"
files.mkdir(parents=True, exist_ok=True)
SCALE = 2  # drawn at twice the size, for smooth edges
PORTRAIT, LANDSCAPE = (360, 520), (520, 300)
PALETTE = [(86, 156, 214), (230, 145, 56), (106, 168, 79), (204, 65, 97), (142, 124, 195), (191, 173, 53),
           (69, 178, 178), (166, 121, 82), (217, 128, 190), (120, 133, 150), (61, 107, 175), (150, 190, 60)]


def run(*arguments):
    subprocess.run([pathlib.Path(program).absolute(), *arguments], cwd=files, check=True, stdout=subprocess.DEVNULL)


def read_ply(name, by_arc=False):
    """The points and triangles of a binary file, and the colours of triangles: of the field, or of patches or arcs."""
    header, body = (files / name).read_bytes().split(b"end_header\n", 1)
    types = {"double": "<f8", "float": "<f4", "int": "<i4", "uint": "<u4", "uchar": "u1"}
    elements = []
    for line in header.decode().splitlines():
        words = line.split()
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property" and words[1] == "list":
            elements[-1][2].extend([("size", types[words[2]]), ("corners", types[words[3]], 3)])
        elif words[0] == "property":
            elements[-1][2].append((words[2], types[words[1]]))
    tables = {}
    for name_of_element, number, fields in elements:
        dtype = numpy.dtype(fields)
        tables[name_of_element] = numpy.frombuffer(body, dtype, number)
        body = body[number * dtype.itemsize:]
    vertices, faces = tables["vertex"], tables["face"]
    points = numpy.stack([vertices[c] for c in "xyz"], axis=1).astype(float)
    corners = faces["corners"].astype(int)
    if by_arc or "patch" in faces.dtype.names:
        numbers = vertices["arc"][corners[:, 0]] if by_arc else faces["patch"]
        return points, corners, numpy.array(PALETTE, dtype=float)[numbers % len(PALETTE)]
    colours = numpy.stack([vertices[c] for c in ("red", "green", "blue")], axis=1).astype(float)
    return points, corners, colours[corners].mean(axis=1)


def follow_scheme(svg):
    """The drawing with a style for dark pages: greys have their lightness turned, colours are made light enough."""
    def turned(name):
        hexadecimal = {"white": "ffffff", "black": "000000"}.get(name, name[1:])
        hue, lightness, saturation = colorsys.rgb_to_hls(*(c / 255 for c in bytes.fromhex(hexadecimal)))
        is_grey = saturation * min(lightness, 1 - lightness) < 0.1
        lightness = 1 - 0.91 * lightness if is_grey else max(lightness, 0.5)  # white becomes the ground of the manual
        return "#" + bytes(round(255 * c) for c in colorsys.hls_to_rgb(hue, lightness, saturation)).hex()

    rules = "svg{fill:#fff;background:#171717}" + "".join(
        f'[{name}="{colour}"]{{{name}:{turned(colour)}}}'
        for name, colour in sorted(set(re.findall('(fill|stroke)="(white|black|#[0-9a-f]{6})"', svg))))
    return re.sub("(<svg [^>]*>)", rf"\1\n<style>@media (prefers-color-scheme: dark){{{rules}}}</style>", svg, count=1)


class Picture:
    """A surface and lines, seen from the front, with a buffer of depths. What they leave is transparent."""

    def __init__(self, points, size=PORTRAIT, view="figure"):
        self.size, self.view = numpy.array(size) * SCALE, view
        turned = self.turn(points)
        low, high = turned[:, :2].min(axis=0), turned[:, :2].max(axis=0)
        self.middle, self.zoom = (low + high) / 2, 0.94 * (self.size / (high - low)).min()
        self.image = numpy.zeros((self.size[1], self.size[0], 4))  # red, green, blue, and whether anything is there
        self.depth = numpy.full((self.size[1], self.size[0]), numpy.inf)

    def turn(self, points):
        """To the right, down, and away from the eye."""
        p = numpy.asarray(points, dtype=float)
        if self.view == "above":  # along z, a little from the front
            return numpy.stack([p[:, 0], -0.9 * p[:, 1] - 0.44 * p[:, 2], 0.44 * p[:, 1] - 0.9 * p[:, 2]], axis=1)
        angle = 0 if self.view == "front" else 0.35
        across = p[:, 0] * numpy.cos(angle) + p[:, 1] * numpy.sin(angle)
        away = p[:, 1] * numpy.cos(angle) - p[:, 0] * numpy.sin(angle)
        return numpy.stack([across, -p[:, 2], away], axis=1)

    def place(self, points):
        turned = self.turn(points)
        turned[:, :2] = (turned[:, :2] - self.middle) * self.zoom + self.size / 2
        turned[:, 2] *= self.zoom
        return turned

    def draw_surface(self, points, corners, colours, opacity=1.0):
        placed = self.place(points)
        for triangle, colour in zip(placed[corners], colours):
            normal = numpy.cross(triangle[1] - triangle[0], triangle[2] - triangle[0])
            length = numpy.linalg.norm(normal)
            low = numpy.maximum(numpy.floor(triangle[:, :2].min(axis=0)).astype(int), 0)
            high = numpy.minimum(numpy.ceil(triangle[:, :2].max(axis=0)).astype(int) + 1, self.size)
            if length == 0 or normal[2] == 0 or (low >= high).any():
                continue
            x, y = numpy.meshgrid(numpy.arange(low[0], high[0]), numpy.arange(low[1], high[1]))
            a, b, c = triangle
            wb = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / normal[2]
            wc = ((y - a[1]) * (b[0] - a[0]) - (x - a[0]) * (b[1] - a[1])) / normal[2]
            wa = 1 - wb - wc
            depth = wa * a[2] + wb * b[2] + wc * c[2]
            part = (slice(low[1], high[1]), slice(low[0], high[0]))
            seen = (numpy.minimum(numpy.minimum(wa, wb), wc) >= -1e-9) & (depth < self.depth[part])
            light = 0.45 + 0.55 * abs(normal @ numpy.array([0.3, -0.4, -0.87])) / length
            self.depth[part][seen] = depth[seen]
            self.image[part][seen, :3] = (1 - opacity) * 255 + opacity * numpy.minimum(colour * light, 255)
            self.image[part][seen, 3] = 255

    def draw_line(self, polyline, colour, width, bias):
        """A line that is drawn where it lies not deeper than `bias` points behind the surface."""
        placed = self.place(polyline)
        radius = width * SCALE / 2
        for a, b in zip(placed, placed[1:]):
            steps = max(int(numpy.abs(b - a)[:2].max() * 2), 1)
            for t in numpy.linspace(0, 1, steps + 1):
                x, y, z = (1 - t) * a + t * b
                low = numpy.maximum(numpy.array([x, y]) - radius, 0).astype(int)
                high = numpy.minimum(numpy.array([x, y]) + radius + 1, self.size).astype(int)
                columns, rows = numpy.meshgrid(numpy.arange(low[0], high[0]), numpy.arange(low[1], high[1]))
                part = (slice(low[1], high[1]), slice(low[0], high[0]))
                disk = (columns - x) ** 2 + (rows - y) ** 2 <= radius ** 2
                self.image[part][disk & (z - bias * SCALE < self.depth[part])] = (*colour, 255)

    def write(self, name):
        width, height = self.size // SCALE
        small = self.image.reshape(height, SCALE, width, SCALE, 4).mean(axis=(1, 3))
        small[..., :3] *= 255 / numpy.maximum(small[..., 3:], 1)  # as alpha is not multiplied into colours in files
        small = small.astype(numpy.uint8)
        rows = b"".join(b"\0" + row.tobytes() for row in small)

        def chunk(kind, data):
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

        (folder / name).write_bytes(
            b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def draw_mesh(mesh, name, lines=(), opacity=1.0, plain=False, bias=4.0, by_arc=False, **view):
    points, corners, colours = read_ply(mesh, by_arc)
    picture = Picture(points, **view)
    picture.draw_surface(points, corners, numpy.full_like(colours, 205) if plain else colours, opacity)
    for line in lines:
        picture.draw_line(line, (200, 30, 30), 3, bias)
    picture.write(name)


def read_off(path):
    """The points and triangles of a file without comments."""
    words = path.read_text().split()
    number, number_of_faces = int(words[1]), int(words[2])
    points = numpy.array(words[4:4 + 3 * number], dtype=float).reshape(-1, 3)
    corners = words[4 + 3 * number:4 + 3 * number + 4 * number_of_faces]
    return points, numpy.array(corners, dtype=int).reshape(-1, 4)[:, 1:]


def write_off(name, points, faces):
    with open(files / name, "w") as file:
        print(f"OFF\n{len(points)} {len(faces)} 0", file=file)
        print("\n".join(" ".join(map(repr, p)) for p in points.tolist()), file=file)
        print("\n".join("3 " + " ".join(map(str, f)) for f in faces.tolist()), file=file)


def cut_holes():
    """The scan with holes: the surface without the top of the head, the soles, and the tips of what points up."""
    points, faces = read_off(files / scan)
    low, high = points[:, 2].min(), points[:, 2].max()
    height = (points[faces][:, :, 2].mean(axis=1) - low) / (high - low)
    faces = faces[(height > 0.02) & (height < 0.97)]
    used, numbers = numpy.unique(faces, return_inverse=True)
    write_off("holes.off", points[used], numbers.reshape(-1, 3))


def read_polylines(name):
    lines = (files / name).read_text().splitlines()
    return [numpy.array(line.split()[1:], dtype=float).reshape(-1, 3) for line in lines]


def lines_of_json(name, kind):
    return [entry["polyline"] for entry in json.loads((files / name).read_text())[kind]]


def copy_drawing(path, name):
    (folder / name).write_text(follow_scheme((files / path).read_text()))


def draw_limbs(name):
    run("compute", scan, "--field", "geodesic", "--simplify", "auto", "--graph", name)
    copy_drawing(name, name)


def draw_segments(name):
    run("compute", scan, "--field", "geodesic", "--simplify", "auto", "--mesh-out", "segments.ply")
    draw_mesh("segments.ply", name, by_arc=True)


def draw_segmentation(name):
    run("curves", scan, "--field", "geodesic", "--type", "branch", "--simplify", "auto", "--mesh-out", "pieces.ply")
    draw_mesh("pieces.ply", name)


def draw_contours(name):
    run("contour", scan, "--field", "geodesic", "--simplify", "auto", "--t", "0.5", "--output", "contours.json")
    run("compute", scan, "--field", "geodesic", "--mesh-out", "mesh.ply")
    draw_mesh("mesh.ply", name, lines_of_json("contours.json", "contours"), plain=True)


def draw_pants(name):
    cut_holes()
    run("curves", "holes.off", "--type", "pants", "--mesh-out", "pants.ply")
    draw_mesh("pants.ply", name)


def draw_diagram(name):
    run("compute", scan, "--field", "z", "--pairs", "pairs.csv", "--diagram", name)
    copy_drawing(name, name)


def draw_paraview(name):
    run("compute", scan, "--field", "z", "--graph", "graph.json", "--mesh-out", "mesh.ply")
    draw_mesh("mesh.ply", name, lines_of_json("graph.json", "edges"), opacity=0.45, bias=1e9)


def draw_own_field(name):
    """A field that the program does not have: the distance from an axis."""
    points, _ = read_off(files / scan)
    numpy.savetxt(files / "field.txt", numpy.hypot(points[:, 0], points[:, 1]))
    run("compute", scan, "--scalars", "field.txt", "--mesh-out", "own_field.ply")
    draw_mesh("own_field.ply", name)


def draw_simplified(name):
    points, _ = read_off(files / scan)
    noise = numpy.random.default_rng(1).uniform(-1, 1, len(points)) * 0.01 * numpy.ptp(points[:, 2])
    numpy.savetxt(files / "noise.txt", points[:, 2] + noise)
    run("compute", scan, "--scalars", "noise.txt", "--simplify", "auto", "--graph", name)
    copy_drawing(name, name)


def draw_drawing(name):
    copy_drawing("demo/graph.svg", name)


def draw_cutting_system(name):
    run("curves", data / "double_torus.off", "--field", "x", "--type", "cutting-system", "--curves",
        "system.polylines.txt", "--mesh-out", "system.ply")
    draw_mesh("system.ply", name, read_polylines("system.polylines.txt"), plain=True, size=LANDSCAPE, view="above")


def draw_pants_decomposition(name):
    run("curves", data / "double_torus.off", "--field", "x", "--type", "pants", "--curves", "double.polylines.txt",
        "--mesh-out", "double.ply")
    draw_mesh("double.ply", name, read_polylines("double.polylines.txt"), size=LANDSCAPE, view="above")


def draw_levels_and_disks(name):
    """The bands between levels, and the surface cut to a disk."""
    torus = data / "double_torus.off"
    run("curves", torus, "--field", "x", "--type", "levels", "--levels", "12", "--curves", "levels.polylines.txt",
        "--mesh-out", "bands.ply")
    run("curves", torus, "--type", "disks", "--curves", "disk.polylines.txt", "--mesh-out", "disk.ply")
    points, corners, colours = read_ply("bands.ply")
    whole, corners_of_whole, _ = read_ply("disk.ply")
    away = numpy.array([1.1 * numpy.ptp(points[:, 0]), 0, 0])
    picture = Picture(numpy.concatenate([points, whole + away]), (760, 240), view="above")
    picture.draw_surface(points, corners, colours)
    picture.draw_surface(whole + away, corners_of_whole, numpy.full((len(corners_of_whole), 3), 205))
    for line in read_polylines("levels.polylines.txt"):
        picture.draw_line(line, (60, 60, 60), 1.5, 4.0)
    for line in read_polylines("disk.polylines.txt"):
        picture.draw_line(line + away, (200, 30, 30), 3, 4.0)
    picture.write(name)


def draw_reeb_graph_of_genus_3(name):
    """The surface and its level sets, and beside it the graph, which is put there by its embedding."""
    points, faces = read_off(data / "genus_3.off")
    angle = 1.15
    turned = numpy.stack([points[:, 0] * numpy.cos(angle) - points[:, 1] * numpy.sin(angle), points[:, 2],
                          points[:, 0] * numpy.sin(angle) + points[:, 1] * numpy.cos(angle)], axis=1)
    write_off("tilted.off", turned, faces)
    run("compute", "tilted.off", "--field", "z", "--graph", "tilted.json", "--mesh-out", "tilted.ply")
    run("contour", "tilted.off", "--field", "z", "--levels", "23", "--output", "levels.json")
    points, corners, colours = read_ply("tilted.ply")
    away = numpy.array([1.15 * numpy.ptp(points[:, 0]), 0, 0])
    picture = Picture(numpy.concatenate([points, points + away]), (720, 560), view="front")
    picture.draw_surface(points, corners, colours)
    for line in lines_of_json("levels.json", "contours"):
        picture.draw_line(line, (90, 90, 90), 1.2, 4.0)
    graph = json.loads((files / "tilted.json").read_text())
    for arc in graph["edges"]:
        picture.draw_line(numpy.array(arc["polyline"]) + away, (120, 144, 156), 4, 1e9)
    for node in graph["nodes"]:
        colour = {"minimum": (21, 101, 192), "maximum": (216, 67, 21)}.get(node["kind"], (251, 192, 45))
        for place in (numpy.array(node["point"]), numpy.array(node["point"]) + away):
            picture.draw_line([place, place + 1e-6], colour, 13, 1e9)
    picture.write(name)


def make_knot(along=240, around=20):
    """A tube around a trefoil, that stands upright."""
    t = numpy.linspace(0, 2 * numpy.pi, along, endpoint=False)

    def curve(t):
        return numpy.stack([numpy.sin(t) + 2 * numpy.sin(2 * t), -numpy.sin(3 * t),
                            numpy.cos(t) - 2 * numpy.cos(2 * t)], axis=1)

    def unit(a):
        return a / numpy.linalg.norm(a, axis=1, keepdims=True)

    tangent = unit(curve(t + 1e-3) - curve(t - 1e-3))
    normal = curve(t + 1e-3) + curve(t - 1e-3) - 2 * curve(t)
    normal = unit(normal - (normal * tangent).sum(axis=1, keepdims=True) * tangent)
    u = numpy.linspace(0, 2 * numpy.pi, around, endpoint=False)[None, :, None]
    points = curve(t)[:, None] + 0.4 * (numpy.cos(u) * normal[:, None]
                                         + numpy.sin(u) * numpy.cross(tangent, normal)[:, None])
    i, j = (k.ravel() for k in numpy.meshgrid(numpy.arange(along), numpy.arange(around), indexing="ij"))
    a, b = i * around + j, i * around + (j + 1) % around
    c, d = (i + 1) % along * around + j, (i + 1) % along * around + (j + 1) % around
    faces = numpy.concatenate([numpy.stack([a, d, b], 1), numpy.stack([a, c, d], 1)])
    write_off("knot.off", points.reshape(-1, 3), faces)


def surface_below(function, low, high, cell):
    """The surface where a function of points is 0, by marching tetrahedra, with normals towards greater values."""
    size = numpy.ceil((numpy.array(high) - low) / cell).astype(int) + 1
    grid = numpy.stack(numpy.meshgrid(*map(numpy.arange, size), indexing="ij"), -1).reshape(-1, 3)
    corners = low + cell * grid
    values = function(corners)
    strides = numpy.array([size[1] * size[2], size[2], 1])
    cubes = (grid[(grid < size - 1).all(axis=1)] * strides).sum(axis=1)
    pairs, insides, outsides = [], [], []  # of corners: three edges for each triangle, and where it has to face
    for order in itertools.permutations(strides):
        tetrahedra = cubes[:, None] + numpy.concatenate([[0], numpy.cumsum(order)])
        tetrahedra = numpy.take_along_axis(tetrahedra, numpy.argsort(values[tetrahedra] >= 0, axis=1, kind="stable"), 1)
        number_inside = (values[tetrahedra] < 0).sum(axis=1)
        for number, triangles in ((1, [(0, 1, 0, 2, 0, 3)]), (3, [(0, 3, 1, 3, 2, 3)]),
                                  (2, [(0, 2, 0, 3, 1, 3), (0, 2, 1, 3, 1, 2)])):
            found = tetrahedra[number_inside == number]
            for triangle in triangles:
                pairs.append(found[:, triangle].reshape(-1, 2))
                insides.append(found[:, 0])
                outsides.append(found[:, 3])
    pairs, inverse = numpy.unique(numpy.sort(numpy.concatenate(pairs), axis=1), axis=0, return_inverse=True)
    a, b = values[pairs].T
    t = numpy.clip(a / (a - b), 0.1, 0.9)[:, None]
    points, faces = (1 - t) * corners[pairs[:, 0]] + t * corners[pairs[:, 1]], inverse.reshape(-1, 3)
    p, q, r = points[faces].transpose(1, 0, 2)
    outwards = corners[numpy.concatenate(outsides)] - corners[numpy.concatenate(insides)]
    is_turned = (numpy.cross(q - p, r - p) * outwards).sum(axis=1) < 0
    faces[is_turned] = faces[is_turned][:, ::-1]
    return points, faces


def make_cup():
    """A cup, with thin bridges on its wall and tunnels in it, as a scan may have them."""
    random = numpy.random.default_rng(5)

    def ring(p, center, axis, radius, thickness):
        along = (p - center) @ axis
        across = numpy.sqrt(numpy.maximum(((p - center) ** 2).sum(axis=1) - along ** 2, 0))
        return numpy.hypot(across - radius, along) - thickness

    def cup(p):
        across = numpy.hypot(p[:, 0], p[:, 1])
        body = numpy.maximum(across - 1, numpy.abs(p[:, 2]) - 1.1)
        handle = numpy.maximum(ring(p, (1, 0, 0), (0, 1, 0), 0.6, 0.14), 0.85 - across)
        hollow = numpy.maximum(across - 0.7, -0.8 - p[:, 2])
        return numpy.maximum(numpy.minimum(body, handle), -hollow)

    rings = []
    while len(rings) < 12:
        angle, height, turn = random.uniform(-2.6, -0.55), random.uniform(-0.85, 0.85), random.uniform(0, numpy.pi)
        center = numpy.array([numpy.cos(angle), numpy.sin(angle), height])
        axis = numpy.array([-numpy.sin(angle) * numpy.cos(turn), numpy.cos(angle) * numpy.cos(turn), numpy.sin(turn)])
        if all(numpy.linalg.norm(center - other) > 0.42 for other, _ in rings):
            rings.append((center, axis))

    def with_noise(p):
        result = cup(p)
        for i, (center, axis) in enumerate(rings):
            distance = ring(p, center, axis, 0.13, 0.055)
            result = numpy.maximum(result, -distance) if i % 3 == 2 else numpy.minimum(result, distance)
        return result

    write_off("cup.off", *surface_below(with_noise, (-1.3, -1.4, -1.25), (1.9, 1.25, 1.25), 0.034))


def find_loops(mesh):
    """The loops of a mesh: whether it is a handle, and the polyline."""
    report = json.loads(subprocess.run([pathlib.Path(program).absolute(), "handles", mesh, "--json", "--loops",
                                        "loops.polylines.txt"], cwd=files, check=True, capture_output=True).stdout)
    return [(loop["kind"] == "handle", line)
            for loop, line in zip(report["loops"], read_polylines("loops.polylines.txt"))]


def draw_loops(picture, loops, offset=0):
    """Handles in red and tunnels in blue."""
    for is_handle, line in loops:
        picture.draw_line(line + offset, (200, 30, 30) if is_handle else (20, 90, 200), 3, 6.0)


def draw_handles_of_a_knot(name):
    make_knot()
    points, faces = read_off(files / "knot.off")
    picture = Picture(points, (420, 420))
    picture.draw_surface(points, faces, numpy.full((len(faces), 3), 205.0))
    draw_loops(picture, find_loops("knot.off"))
    picture.write(name)


def draw_false_handles(name):
    """The cup before, and beside it after removal."""
    make_cup()
    run("handles", "cup.off", "--remove-below", "0.7", "--output", "clean.off")
    surfaces = [read_off(files / mesh) for mesh in ("cup.off", "clean.off")]
    away = numpy.array([1.15, 0.42, 0]) * numpy.ptp(surfaces[0][0][:, 0])
    picture = Picture(numpy.concatenate([surfaces[0][0], surfaces[1][0] + away]), (720, 280))
    for i, (points, faces) in enumerate(surfaces):
        picture.draw_surface(points + i * away, faces, numpy.full((len(faces), 3), 205.0))
    for i, mesh in enumerate(("cup.off", "clean.off")):
        draw_loops(picture, find_loops(mesh), i * away)
    picture.write(name)


def write_tubes(name, limbs, cell, smoothness=0.03, cuts=()):
    """The smooth union of tubes, each from a point of a radius to another one, open where a ball of `cuts` is."""
    def distance(p):
        total = numpy.zeros(len(p))
        for start, end, at_start, at_end in limbs:
            along = numpy.subtract(end, start)
            t = numpy.clip((p - start) @ along / (along @ along), 0, 1)
            away = numpy.linalg.norm(p - start - t[:, None] * along, axis=1) - (1 - t) * at_start - t * at_end
            total += numpy.exp(-numpy.maximum(away, -40 * smoothness) / smoothness)
        return -smoothness * numpy.log(numpy.maximum(total, 1e-300))

    ends = numpy.array([limb[:2] for limb in limbs]).reshape(-1, 3)
    margin = max(max(limb[2:]) for limb in limbs) + 3 * cell
    points, faces = surface_below(distance, ends.min(axis=0) - margin, ends.max(axis=0) + margin, cell)
    for center, radius in cuts:
        faces = faces[(numpy.linalg.norm(points[faces].mean(axis=1) - center, axis=1) > radius)]
    for _ in range(3):  # no vertex keeps two fans
        sides = numpy.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        unique, counts = numpy.unique(sides, axis=0, return_counts=True)
        at_border = numpy.bincount(unique[counts == 1].ravel(), minlength=len(points))
        faces = faces[(at_border[faces] <= 2).all(axis=1)]
    used, numbers = numpy.unique(faces, return_inverse=True)
    write_off(name, points[used], numbers.reshape(-1, 3))


def make_vessel():
    """A trunk that forks, with a loop of two branches; its four ends are open."""
    limbs = [((0, 0, -3), (0.1, 0, -1), .42, .4), ((.1, 0, -1), (0, 0.1, .6), .4, .38),
             ((0, .1, .6), (-.9, 0, 1.5), .28, .26), ((-.9, 0, 1.5), (-.8, 0, 2.6), .26, .24),
             ((0, .1, .6), (.9, .1, 1.4), .28, .26), ((.9, .1, 1.4), (.7, 0, 2.5), .26, .24),
             ((.7, 0, 2.5), (-.8, 0, 2.6), .22, .24),
             ((.7, 0, 2.5), (1.2, -.1, 3.8), .22, .18), ((.1, 0, -1), (1.6, .2, -.3), .26, .2),
             ((.05, 0, -2), (-1.5, 0, -1.2), .26, .2)]
    cuts = [((0, 0, -3.1), .55), ((1.25, -.1, 3.9), .32), ((1.7, .2, -.27), .33), ((-1.6, 0, -1.15), .33)]
    write_tubes("vessel.off", limbs, 0.07, cuts=cuts)


def make_animal():
    """A trunk with four legs, a tail, and a head with two ears."""
    limbs = [((-1, 0, 0), (1, 0, .1), .42, .48), ((1, 0, .1), (1.6, 0, .8), .3, .24), ((1.6, 0, .85), (2.1, 0, .75), .27, .15),
             ((1.5, .15, 1), (1.4, .3, 1.4), .1, .05), ((1.5, -.15, 1), (1.4, -.3, 1.4), .1, .05),
             ((-1.2, 0, .1), (-1.9, 0, .6), .14, .1), ((-1.9, 0, .6), (-2.3, 0, 1.2), .1, .06)]
    for x, y in itertools.product((-1, 1), (-.3, .3)):
        limbs += [((x, y, -.1), (x + .1, y * 1.2, -.9), .2, .14), ((x + .1, y * 1.2, -.9), (x, y * 1.2, -1.7), .14, .11)]
    write_tubes("animal.off", limbs, 0.055)


def draw_skeleton(picture, mesh, offset=0, scale=1):
    """A pale surface, and its skeleton in front of it, with nodes as dots."""
    run("skeleton", mesh, "--output", "skeleton.polylines.txt")
    points, faces = read_off(files / mesh)
    picture.draw_surface(scale * points + offset, faces, numpy.full((len(faces), 3), 205.0), 0.75)
    for line in (scale * line + offset for line in read_polylines("skeleton.polylines.txt")):
        picture.draw_line(line, (200, 30, 30), 2, numpy.inf)
        for end in (line[:1], line[-1:]):
            picture.draw_line(numpy.concatenate([end, end]), (20, 60, 140), 5, numpy.inf)


def draw_skeletons(name):
    """A vessel, the neuron of the examples, and an animal, side by side; or without the neuron."""
    make_vessel()
    make_animal()
    (files / "neuron.off").write_bytes((data / "neuron.off").read_bytes())
    size, meshes = (760, 290), {"vessel.off": ((-7.2, 2.6, 0), 1), "neuron.off": ((0, 0, .5), 1),
                                "animal.off": ((8.2, -2.6, .2), 1.2)}
    if name == "skeleton.png":
        size, meshes = (520, 330), {"vessel.off": ((0, 0, 0), 1), "animal.off": ((5.9, 0, 0.2), 1.8)}
    places = [scale * read_off(files / mesh)[0] + offset for mesh, (offset, scale) in meshes.items()]
    picture = Picture(numpy.concatenate(places), size)
    for mesh, (offset, scale) in meshes.items():
        draw_skeleton(picture, mesh, numpy.array(offset), scale)
    picture.write(name)


def draw_bad_skeleton(name):
    """A plate."""
    write_tubes("plate.off", [((x, 0, z), (x, 0, z + .1), .25, .25) for x in numpy.arange(-1, 1.05, .25)
                              for z in numpy.arange(-.8, .85, .25)], 0.07)
    picture = Picture(read_off(files / "plate.off")[0], (360, 300))
    draw_skeleton(picture, "plate.off")
    picture.write(name)


def draw_python(name):
    """What an example in Python draws."""
    picture = name[len("python_"):]
    example = {"torus.svg": "first.py"}.get(picture, picture.replace(".svg", ".py"))
    subprocess.run([sys.executable, pathlib.Path(__file__).resolve().parents[2] / "python" / "examples" / example],
                   cwd=files, check=True, stdout=subprocess.DEVNULL)
    copy_drawing(picture, name)


def draw_page(name):
    """A picture of the page of the demo: its pieces, or the arc beside the bent arm and its contour."""
    from selenium import webdriver
    options = webdriver.ChromeOptions()
    for argument in ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-gl=angle",
                     "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]:
        options.add_argument(argument)
    browser = webdriver.Chrome(options=options)
    try:
        browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                {"width": 1200, "height": 740, "deviceScaleFactor": 1, "mobile": False})
        browser.get((files / "demo" / "page.html").as_uri())
        if name == "page_arcs.png":
            browser.execute_script("document.querySelector('input[name=coloring][value=arcs]').click()")
        else:
            x, y = browser.execute_script("return window.reebGraphPage.whereInDrawing(4, 0.5)")
            for kind, buttons in (("mouseMoved", 0), ("mousePressed", 1), ("mouseReleased", 0)):
                browser.execute_cdp_cmd("Input.dispatchMouseEvent", {
                    "type": kind, "x": x, "y": y, "clickCount": 1,
                    "button": "none" if kind == "mouseMoved" else "left", "buttons": buttons})
        time.sleep(2)
        browser.save_screenshot(str(folder / name))
    finally:
        browser.quit()


run("demo", "--out", "demo")
scan = "demo/surface.off"
figures = {
    "reeb_graph_of_genus_3.png": draw_reeb_graph_of_genus_3, "limbs.svg": draw_limbs, "segments.png": draw_segments,
    "segmentation.png": draw_segmentation, "contours.png": draw_contours, "pants.png": draw_pants,
    "diagram.svg": draw_diagram, "paraview.png": draw_paraview,
    "own_field.png": draw_own_field, "simplified.svg": draw_simplified, "drawing.svg": draw_drawing,
    "cutting_system.png": draw_cutting_system,
    "pants_decomposition.png": draw_pants_decomposition, "levels_and_disks.png": draw_levels_and_disks,
    "handles_of_a_knot.png": draw_handles_of_a_knot,
    "false_handles.png": draw_false_handles, "skeletons.png": draw_skeletons, "skeleton.png": draw_skeletons,
    "bad_skeleton.png": draw_bad_skeleton, "page_arcs.png": draw_page, "page_contour.png": draw_page}
figures |= {f"python_{picture}.svg": draw_python for picture in (
    "torus", "segment_scan", "handles", "compare_shapes", "pants", "tetrahedra")}
for figure in wanted or figures:
    figures[figure](figure)
