# Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
#
# This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

"""SWC files keep the rules that readers of neurons publish.

MorphIO refuses lines that are none of seven numbers, types that are not from 1 to 10, numbers that are there twice, parents that
are missing or the point itself, a second soma, and a soma that begins at a neurite. NeuroM checks that numbers ascend from parent
to child, and that no radius, no segment and no section between branching points is 0.

Usage: test_swc_rules.py PROGRAM CLOSED_MESH FOLDER
"""

import itertools
import math
import os
import pathlib
import subprocess
import sys

program, neuron = map(os.path.abspath, sys.argv[1:3])
folder = pathlib.Path(sys.argv[3])
folder.mkdir(parents=True, exist_ok=True)
os.chdir(folder)


def write(path, points, faces):
    pathlib.Path(path).write_text(f"OFF\n{len(points)} {len(faces)} 0\n" + "".join("%r %r %r\n" % p for p in points)
                                  + "".join("3 %d %d %d\n" % face for face in faces))


def turned(radii_and_heights, corners):
    """A closed surface of rings around an axis, between two points on it."""
    points = [(0.0, 0.0, radii_and_heights[0][1])]
    for radius, height in radii_and_heights[1:-1]:
        points += [(radius * math.cos(2 * math.pi * i / corners), radius * math.sin(2 * math.pi * i / corners), height)
                   for i in range(corners)]
    points.append((0.0, 0.0, radii_and_heights[-1][1]))
    faces = []
    for i in range(corners):
        j = (i + 1) % corners
        faces.append((0, 1 + j, 1 + i))
        for ring in range(len(radii_and_heights) - 3):
            a, b = 1 + ring * corners, 1 + (ring + 1) * corners
            faces += [(a + i, a + j, b + j), (a + i, b + j, b + i)]
        last = 1 + (len(radii_and_heights) - 3) * corners
        faces.append((last + i, last + j, len(points) - 1))
    return points, faces


def voxels(cells):
    """The surface of unit cubes, two triangles a square."""
    numbers, points, faces = {}, [], []
    for cell in sorted(cells):
        for axis, side in itertools.product(range(3), (0, 1)):
            beside = list(cell)
            beside[axis] += 2 * side - 1
            if tuple(beside) in cells:
                continue
            square = []
            for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                corner = list(cell)
                corner[axis] += side
                corner[(axis + 1) % 3] += a
                corner[(axis + 2) % 3] += b
                if tuple(corner) not in numbers:
                    numbers[tuple(corner)] = len(points)
                    points.append(tuple(map(float, corner)))
                square.append(numbers[tuple(corner)])
            p, q, r, s = square if side == 1 else square[::-1]
            faces += [(p, q, r), (p, r, s)]
    return points, faces


def sheet(columns, rows):
    """Two sheets on each other, without any inside."""
    points = [(float(x), float(y), 0.0) for y in range(rows + 1) for x in range(columns + 1)]
    rim = [v for v, (x, y, _) in enumerate(points) if x in (0, columns) or y in (0, rows)]
    below = {v: v if v in rim else len(points) + i for i, v in enumerate(range(len(points)))}
    faces = []
    for y, x in itertools.product(range(rows), range(columns)):
        a = y * (columns + 1) + x
        b, c, d = a + 1, a + columns + 1, a + columns + 2
        for face in ((a, b, d), (a, d, c)):
            faces += [face, tuple(below[v] for v in face[::-1])]
    points += [points[v] for v in range(len(points))]
    used = sorted({v for face in faces for v in face})
    place = {v: i for i, v in enumerate(used)}
    return [points[v] for v in used], [tuple(place[v] for v in face) for face in faces]


def faults_of(path, other_type):
    records, faults = {}, []
    for line in pathlib.Path(path).read_text().splitlines():
        if line.startswith("#"):
            continue
        words = line.split()
        if len(words) != 7:
            return [f"no seven numbers: {line}"]
        number, kind, parent = int(words[0]), int(words[1]), int(words[6])
        if number in records or number < 1 or not 1 <= kind <= 10 or parent == number:
            faults.append(f"refused: {line}")
        if parent != -1 and not parent < number or parent not in records and parent != -1:
            faults.append(f"no parent before: {line}")
        if kind == 1 and (parent != -1 or any(record[0] == 1 for record in records.values())):
            faults.append(f"a soma that is no root, or a second one: {line}")
        if kind not in (1, other_type):
            faults.append(f"type: {line}")
        point, radius = tuple(map(float, words[2:5])), float(words[5])
        if not (radius > 0 and math.isfinite(radius)):
            faults.append(f"radius: {line}")
        if parent != -1 and not math.dist(point, records[parent][2]) > 0:
            faults.append(f"no length: {line}")
        records[number] = (kind, parent, point)
    return faults if records else ["no points"]


ball = [(math.sin(math.pi * i / 8), -math.cos(math.pi * i / 8)) for i in range(9)]
capsule = [(min(1, r), z - 5 if z <= 0 else z + 5) for r, z in ball]
write("ball.off", *turned(ball, 12))
write("capsule.off", *turned(capsule, 12))
write("sheets.off", *sheet(9, 2))
cross = {(x, 4, 4) for x in range(9)} | {(4, y, 4) for y in range(9)} | {(4, 4, z) for z in range(9)}
frame = {cell for cell in itertools.product(range(7), repeat=3) if sum(c in (0, 6) for c in cell) >= 2}
write("cross.off", *voxels(cross))
write("frame.off", *voxels(frame))
point = [(9.0, 9.0, 9.0)] * 3
write("point.off", point, [(0, 1, 2)])
points, faces = turned(capsule, 12)
write("beside_a_point.off", points + point, faces + [tuple(len(points) + i for i in range(3))])
pathlib.Path("neuron.off").write_bytes(pathlib.Path(neuron).read_bytes())

faults = []
MESHES = ("ball", "capsule", "sheets", "cross", "frame", "point", "beside_a_point", "neuron")
settings = [([], 3), (["--radius", "inscribed"], 3), (["--smooth", "0"], 3), (["--root", "thickest"], 3),
            (["--radius", "inscribed", "--smooth", "0", "--swc-type", "7"], 7)]
for mesh, (options, other_type) in itertools.product(MESHES, settings):
    subprocess.run([program, "skeleton", f"{mesh}.off", *options, "--output", f"{mesh}.swc"], check=True,
                   stdout=subprocess.DEVNULL)
    faults += [f"{mesh} {' '.join(options)}: {fault}" for fault in faults_of(f"{mesh}.swc", other_type)]
    somata = sum(line.split()[1] == "1" for line in pathlib.Path(f"{mesh}.swc").read_text().splitlines()[1:]
                 if not line.startswith("#"))
    if somata != (1 if "thickest" in options else 0):
        faults.append(f"{mesh} {' '.join(options)}: {somata} somata")
wrong_types = [["--swc-type", wrong, "--output", "ball.swc"] for wrong in ("0", "1", "-1", "x", "2147483648")]
for wrong in [*wrong_types, ["--radius", "inscribed"], ["--swc-type", "4", "--output", "ball.csv"]]:
    if subprocess.run([program, "skeleton", "ball.off", *wrong], capture_output=True).returncode == 0:
        faults.append(f"{' '.join(wrong)} is taken")
if subprocess.run([program, "skeleton", "ball.off", "--from", "nan,0,0", "--output", "ball.vtp"], capture_output=True).returncode == 0:
    faults.append("no number is taken as a coordinate")
print("\n".join(faults[:50]) or "all rules are kept")
sys.exit(1 if faults else 0)
