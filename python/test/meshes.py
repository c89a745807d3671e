"""Generated meshes, and the results of the program for them."""

import itertools
import json
import os
import subprocess
from pathlib import Path

import numpy as np

PROGRAM = os.environ.get("REEB_GRAPH_PROGRAM", str(Path(__file__).parents[2] / "build" / "reeb_graph"))


def grid(rows, columns, closed_rows=False, closed_columns=False):
    """Return the triangles and points of a rectangle, an annulus, or a torus."""
    numbers = np.arange(rows * columns).reshape(rows, columns)
    wrapped = np.pad(numbers, ((0, closed_rows), (0, closed_columns)), mode="wrap")
    a, b, c, d = wrapped[:-1, :-1], wrapped[1:, :-1], wrapped[1:, 1:], wrapped[:-1, 1:]
    triangles = np.concatenate([np.stack([a, b, c], -1).reshape(-1, 3), np.stack([a, c, d], -1).reshape(-1, 3)])
    i, j = np.divmod(np.arange(rows * columns), columns)
    u, v = 2 * np.pi * i / rows, 2 * np.pi * j / columns
    if closed_rows and closed_columns:
        points = np.stack([(3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u), np.sin(v)], -1)
    elif closed_columns:
        points = np.stack([np.cos(v), np.sin(v), i / rows], -1)
    else:
        points = np.stack([i / rows, j / columns, 0.1 * np.sin(u) * np.sin(v)], -1)
    return triangles, points


def sphere(steps=2):
    """Return a subdivided octahedron."""
    points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    triangles = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    for _ in range(steps):
        middles, finer = {}, []

        def middle(a, b):
            key = min(a, b), max(a, b)
            if key not in middles:
                middles[key] = len(points)
                points.append(tuple(np.add(points[a], points[b]) / np.linalg.norm(np.add(points[a], points[b]))))
            return middles[key]

        for a, b, c in triangles:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        triangles = finer
    return np.array(triangles), np.array(points, dtype=float)


def random_soup(random, vertices, cells):
    """Return triangles of any vertices: no surface, most often."""
    triangles = np.array([random.choice(vertices, 3, replace=False) for _ in range(cells)])
    return triangles, random.normal(size=(vertices, 3))


def tetrahedra_of_cubes(n):
    """Return the tetrahedra and points of n cubes in each direction."""
    numbers = np.arange((n + 1) ** 3).reshape((n + 1,) * 3)
    paths = [np.cumsum([0, *steps]) for steps in itertools.permutations((1, n + 1, (n + 1) ** 2))]
    tetrahedra = np.concatenate([numbers[:-1, :-1, :-1].reshape(-1, 1) + path for path in paths])
    return tetrahedra, np.stack(np.unravel_index(np.arange((n + 1) ** 3), (n + 1,) * 3), -1).astype(float)


def surfaces():
    yield "sphere", *sphere()
    yield "torus", *grid(8, 6, True, True)
    yield "annulus", *grid(5, 9, False, True)
    yield "rectangle", *grid(6, 7)
    triangles, points = grid(7, 7, True, True)
    yield "torus without some triangles", triangles[(np.arange(len(triangles)) % 13) > 0], points
    sphere_triangles, sphere_points = sphere(1)
    yield (
        "two components, isolated vertices",
        np.concatenate([triangles, sphere_triangles + len(points)]),
        np.concatenate([points, sphere_points + 9, np.full((2, 3), 20.0)]),
    )
    flipped = triangles.copy()
    flipped[::3] = flipped[::3, ::-1]
    yield "oriented inconsistently", flipped, points


def fields(random, points):
    """Return smooth and noisy fields, with and without ties."""
    n = len(points)
    yield "height", points @ np.array([0.3, 0.5, 1.0])
    yield "noise", random.normal(size=n)
    yield "ties", random.integers(0, 5, n).astype(float)
    yield "constant", np.zeros(n)


def write_off(path, triangles, points):
    with open(path, "w") as file:
        print(f"OFF\n{len(points)} {len(triangles)} 0", file=file)
        for p in points:
            print(*(repr(float(x)) for x in p), file=file)
        for t in triangles:
            print(3, *t, file=file)


def write_medit(path, tetrahedra, points):
    with open(path, "w") as file:
        print(f"MeshVersionFormatted 2\nDimension 3\nVertices\n{len(points)}", file=file)
        for p in points:
            print(*(repr(float(x)) for x in p), 0, file=file)
        print(f"Tetrahedra\n{len(tetrahedra)}", file=file)
        for t in tetrahedra:
            print(*(t + 1), 0, file=file)
        print("End", file=file)


def run(*arguments):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def result_of_program(folder, mesh_file, scalars, *options):
    """Return the graph and the places of the vertices that the program finds."""
    np.save(folder / "scalars.npy", scalars)
    run("compute", mesh_file, "--scalars", folder / "scalars.npy", "--graph", folder / "graph.json", "--embedding",
        "straight", "--vertex-arcs", folder / "places.npy", "--pairs", folder / "pairs.csv", *options)
    return json.loads((folder / "graph.json").read_text()), np.load(folder / "places.npy")
