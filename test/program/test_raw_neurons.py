# Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
#
# This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

"""Neurons with all that raw ones have are repaired, and give the skeleton of the clean one: connected, inside, as long.

Usage: test_raw_neurons.py PROGRAM CLEAN_MESH FOLDER
"""

import json
import os
import pathlib
import random
import subprocess
import sys

program, clean = map(os.path.abspath, sys.argv[1:3])
folder = pathlib.Path(sys.argv[3])
folder.mkdir(parents=True, exist_ok=True)
os.chdir(folder)


def report_of(*arguments):
    return json.loads(subprocess.run([program, *arguments, "--json"], check=True, capture_output=True).stdout)


def read(path):
    lines = [line.split() for line in pathlib.Path(path).read_text().split("\n") if line and not line.startswith("#")]
    vertices = int(lines[1][0])
    return ([tuple(map(float, line)) for line in lines[2:2 + vertices]],
            [tuple(map(int, line[1:4])) for line in lines[2 + vertices:] if line])


def soiled(points, faces, chance):
    points, faces = list(points), list(faces)
    for _ in range(20):  # Sheets of two faces back to back on an edge, in several copies of each.
        a, b, _ = chance.choice(faces)
        points.append(tuple(p + chance.uniform(-0.05, 0.05) for p in points[a]))
        copies = chance.randint(1, 3)
        faces += [(a, b, len(points) - 1), (b, a, len(points) - 1)] * copies
    for face in chance.sample(faces[:1000], 10):  # Faces that are there once more, and once the other way round.
        faces += [face, face[::-1]]
    for _ in range(10):  # Small bubbles on an edge, which has four faces then.
        a, b, _ = chance.choice(faces[:1000])
        tips = [tuple(p + chance.uniform(-0.01, 0.01) for p in points[a]) for _ in range(2)]
        c, d = len(points), len(points) + 1
        points += tips
        faces += [(a, b, c), (b, a, d), (b, d, c), (a, c, d)]
    corner = chance.randrange(len(points))  # A cavity, or a crumb outside.
    n = len(points)
    points += [tuple(p + 1e-3 * offset for p, offset in zip(points[corner], way))
               for way in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))]
    faces += [(n, n + 1, n + 2), (n, n + 3, n + 1), (n + 1, n + 3, n + 2), (n + 2, n + 3, n)]
    for hole in sorted(chance.sample(range(1000), 5), reverse=True):
        del faces[hole]
    chance.shuffle(faces)
    for v in chance.sample(range(len(points)), 100):  # Doubled points, of which each face takes one or the other.
        points.append(points[v])
        faces = [tuple(chance.choice((v, len(points) - 1)) if u == v else u for u in face) for face in faces]
    return points, faces


def write(path, points, faces):
    pathlib.Path(path).write_text(f"OFF\n{len(points)} {len(faces)} 0\n" + "".join("%r %r %r\n" % p for p in points)
                                  + "".join("3 %d %d %d\n" % face for face in faces))


def torn(points, faces):
    """Each face with corners of its own, as in a file of STL."""
    return [points[v] for face in faces for v in face], [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(len(faces))]


clean_report = report_of("skeleton", clean, "--fill-borders")
faults = []
for seed in range(12):
    raw = soiled(*read(clean), random.Random(seed))
    write("raw.off", *(torn(*raw) if seed % 2 == 1 else raw))
    subprocess.run([program, "repair", "raw.off", "--all", "--least-piece", "0.01", "--fill", "100", "--output",
                    "repaired.off"], check=True, stdout=subprocess.DEVNULL)
    report = report_of("skeleton", "repaired.off", "--fill-borders")
    share = report["cable_length"] / clean_report["cable_length"]
    if report["components"] != 1 or report["vertices_outside"] != 0 or not 0.95 < share < 1.05:
        faults.append(f"seed {seed}: {report['components']} components, {report['vertices_outside']} points outside, "
                      f"{share} of the length, {report['loops']} loops")
print("\n".join(faults) or "as the clean one")
sys.exit(1 if faults else 0)
