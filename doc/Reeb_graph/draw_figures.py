# Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
#
# This file is part of the CGAL-style package Reeb_graph.
#
# SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

"""Draws the figures of README's wishes that are no pages, and of handles, from what the program makes of the surface of its
demo, and of surfaces that are generated here.

Usage: draw_figures.py PROGRAM FOLDER. It needs NumPy. The files that are drawn stay in FOLDER/files.
"""

import json
import pathlib
import shutil
import struct
import subprocess
import sys
import zlib

import numpy

program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
files = folder / "files"
files.mkdir(parents=True, exist_ok=True)
WIDTH, HEIGHT, SCALE = 360, 520, 2  # drawn at twice the size, for smooth edges


def run(*arguments):
    subprocess.run([pathlib.Path(program).absolute(), *arguments], cwd=files, check=True, stdout=subprocess.DEVNULL)


def read_ply(name):
    """The points, colours of vertices or faces, and triangles of a binary file of triangles."""
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
    coloured = faces if "red" in faces.dtype.names else vertices
    colours = numpy.stack([coloured[c] for c in ("red", "green", "blue")], axis=1).astype(float)
    corners = faces["corners"].astype(int)
    return points, corners, colours if coloured is faces else colours[corners].mean(axis=1)


class Picture:
    """A surface and lines, seen from the front, with a buffer of depths."""

    def __init__(self, points):
        self.size = numpy.array([WIDTH * SCALE, HEIGHT * SCALE])
        turned = self.turn(points)
        low, high = turned[:, :2].min(axis=0), turned[:, :2].max(axis=0)
        self.middle, self.zoom = (low + high) / 2, 0.94 * (self.size / (high - low)).min()
        self.image = numpy.full((self.size[1], self.size[0], 3), 255.0)
        self.depth = numpy.full((self.size[1], self.size[0]), numpy.inf)

    @staticmethod
    def turn(points):
        """To the right, down, and away from the eye."""
        p = numpy.asarray(points, dtype=float)
        angle = 0.35
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
            self.image[part][seen] = (1 - opacity) * 255 + opacity * numpy.minimum(colour * light, 255)

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
                self.image[part][disk & (z - bias * SCALE < self.depth[part])] = colour

    def write(self, name):
        small = self.image.reshape(HEIGHT, SCALE, WIDTH, SCALE, 3).mean(axis=(1, 3)).astype(numpy.uint8)
        rows = b"".join(b"\0" + row.tobytes() for row in small)

        def chunk(kind, data):
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

        (folder / name).write_bytes(
            b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def draw_mesh(mesh, name, lines=(), opacity=1.0, plain=False, bias=4.0):
    points, corners, colours = read_ply(mesh)
    picture = Picture(points)
    picture.draw_surface(points, corners, numpy.full_like(colours, 205) if plain else colours, opacity)
    for line in lines:
        picture.draw_line(line, (200, 30, 30), 3, bias)
    picture.write(name)


def read_off(name):
    words = (files / name).read_text().split()
    number, number_of_faces = int(words[1]), int(words[2])
    points = numpy.array(words[4:4 + 3 * number], dtype=float).reshape(-1, 3)
    return points, numpy.array(words[4 + 3 * number:4 + 3 * number + 4 * number_of_faces], dtype=int).reshape(-1, 4)


def write_off(name, points, triangles):
    with open(files / name, "w") as file:
        print(f"OFF\n{len(points)} {len(triangles)} 0", file=file)
        print("\n".join(" ".join(map(repr, p)) for p in numpy.asarray(points).tolist()), file=file)
        print("\n".join("3 " + " ".join(map(str, f)) for f in numpy.asarray(triangles).tolist()), file=file)


def cut_holes():
    """The scan with holes: the surface without the top of the head, the soles, and the tips of what points up."""
    points, faces = read_off(scan)
    number = len(points)
    low, high = points[:, 2].min(), points[:, 2].max()
    height = (points[faces[:, 1:]][:, :, 2].mean(axis=1) - low) / (high - low)
    faces = faces[(height > 0.02) & (height < 0.97)]
    used = numpy.unique(faces[:, 1:])
    numbers = numpy.full(number, -1)
    numbers[used] = numpy.arange(len(used))
    write_off("holes.off", points[used], numbers[faces[:, 1:]])


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
    write_off("knot.off", points.reshape(-1, 3), numpy.concatenate([numpy.stack([a, d, b], 1), numpy.stack([a, c, d], 1)]))


def add_noise(number=25):
    """The scan with false handles: thin bridges between two of its triangles."""
    points, faces = read_off(scan)
    faces = faces[:, 1:]
    points, triangles = points.tolist(), faces.tolist()
    corners = numpy.array(points)[faces]
    middles = corners.mean(axis=1)
    normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= numpy.linalg.norm(normals, axis=1, keepdims=True)
    random = numpy.random.default_rng(3)
    used, removed = [], []
    while len(removed) < 2 * number:
        a = random.integers(len(faces))
        distances = numpy.linalg.norm(middles - middles[a], axis=1)
        candidates = numpy.flatnonzero((distances > 0.06) & (distances < 0.08) & (normals @ normals[a] > 0.9))
        if len(candidates) == 0 or any(numpy.linalg.norm(middles[a] - m) < 0.16 for m in used):
            continue
        b = random.choice(candidates)
        used.append((middles[a] + middles[b]) / 2)
        removed += [a, b]
        # The corners of b, the other way around, from the one that is nearest to the first corner of a.
        end = faces[b][::-1]
        end = min((numpy.roll(end, k) for k in range(3)),
                  key=lambda order: numpy.linalg.norm(corners[a] - numpy.array(points)[order], axis=1).sum())
        rings = [list(faces[a])]
        for t in numpy.linspace(0, 1, 7)[1:-1]:
            lift = 0.035 * numpy.sin(numpy.pi * t) * normals[a]
            rings.append(list(range(len(points), len(points) + 3)))
            points += [((1 - t) * corners[a][k] + t * numpy.array(points[end[k]]) + lift).tolist() for k in range(3)]
        rings.append(list(end))
        for low, high in zip(rings, rings[1:]):
            for k in range(3):
                m = (k + 1) % 3
                triangles += [[low[k], low[m], high[m]], [low[k], high[m], high[k]]]
    write_off("noise.off", points, [t for f, t in enumerate(triangles) if f not in set(removed)])


def draw_loops(mesh, name):
    """The surface with handles in red, which shine through, and tunnels in blue."""
    report = json.loads(subprocess.run([pathlib.Path(program).absolute(), "handles", mesh, "--json", "--loops",
                                        "loops.polylines.txt"], cwd=files, check=True, capture_output=True).stdout)
    points, faces = read_off(mesh)
    picture = Picture(points)
    picture.draw_surface(points, faces[:, 1:], numpy.full((len(faces), 3), 205.0))
    for loop, line in zip(report["loops"], (files / "loops.polylines.txt").read_text().splitlines()):
        polyline = numpy.array(line.split()[1:], dtype=float).reshape(-1, 3)
        is_handle = loop["kind"] == "handle"
        picture.draw_line(polyline, (200, 30, 30) if is_handle else (20, 90, 200), 2.5, 1e9 if is_handle else 4.0)
    picture.write(name)


run("demo", "--out", "demo")
scan = "demo/surface.off"
run("compute", scan, "--field", "geodesic", "--simplify", "auto", "--graph", "limbs.svg")
run("curves", scan, "--field", "geodesic", "--type", "branch", "--simplify", "auto", "--mesh-out", "pieces.ply")
run("contour", scan, "--field", "geodesic", "--simplify", "auto", "--t", "0.5", "--output", "contours.json")
cut_holes()
make_knot()
add_noise()
run("handles", "noise.off", "--remove-below", "0.12", "--output", "clean.off")
for mesh, name in ("knot.off", "handles_of_a_knot.png"), ("noise.off", "noise.png"), ("clean.off", "clean.png"):
    draw_loops(mesh, name)
run("curves", "holes.off", "--type", "pants", "--mesh-out", "pants.ply")
run("compute", scan, "--field", "z", "--pairs", "pairs.csv", "--diagram", "diagram.svg")
run("compute", scan, "--field", "z", "--graph", "graph.json", "--mesh-out", "mesh.ply")
run("field", scan, "--type", "poisson", "--output", "field.txt")
run("compute", scan, "--scalars", "field.txt", "--mesh-out", "own_field.ply")
for drawing in ("limbs.svg", "diagram.svg"):
    shutil.copy(files / drawing, folder / drawing)
draw_mesh("pieces.ply", "segmentation.png")
draw_mesh("pants.ply", "pants.png")
contours = json.loads((files / "contours.json").read_text())["contours"]
draw_mesh("mesh.ply", "contours.png", [contour["polyline"] for contour in contours], plain=True)
arcs = json.loads((files / "graph.json").read_text())["edges"]
draw_mesh("mesh.ply", "paraview.png", [arc["polyline"] for arc in arcs], opacity=0.45, bias=1e9)
draw_mesh("own_field.ply", "own_field.png")
