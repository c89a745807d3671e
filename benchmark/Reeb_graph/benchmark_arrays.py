"""Time compute() beside C++ from the same arrays. Usage: benchmark_arrays.py BENCHMARK_ARRAYS [RUNS [VERTICES]]"""

import subprocess
import sys
import time

import numpy as np
import reeb_graph


def torus(number):
    """Return the triangles and points of a torus with about so many vertices, twice as many rows as columns."""
    columns = round((number / 2) ** 0.5)
    u, v = np.meshgrid(np.arange(2 * columns), np.arange(columns), indexing="ij")
    at = lambda i, j: (u + i) % (2 * columns) * columns + (v + j) % columns
    a, b = np.pi * u.ravel() / columns, 2 * np.pi * v.ravel() / columns
    points = np.stack([(3 + np.cos(b)) * np.cos(a), (3 + np.cos(b)) * np.sin(a), np.sin(b)], axis=1)
    corners = [at(0, 0), at(1, 0), at(1, 1), at(0, 0), at(1, 1), at(0, 1)]
    return np.stack(corners, -1).reshape(-1, 3), points


def main(program, runs=7, number=1_000_000):
    triangles, points = torus(int(number))
    smooth = points @ np.array([1.0, 0.3, 0.2])
    for name, scalars in (("smooth", smooth), ("noise", np.random.default_rng(0).normal(size=len(points)))):
        process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        process.stdin.write(np.array([len(points), len(triangles)]).tobytes())
        process.stdin.write(scalars.tobytes() + points.tobytes() + triangles.tobytes())
        python, cpp = [], []
        for _ in range(int(runs)):
            process.stdin.write(b"\n")
            process.stdin.flush()
            *seconds, arcs = process.stdout.readline().split()
            start, cpu_start = time.perf_counter(), time.process_time()
            graph = reeb_graph.compute(triangles, scalars, points=points)
            python.append((time.perf_counter() - start, time.process_time() - cpu_start))
            cpp.append([float(number) for number in seconds])
            assert graph.n_arcs == int(arcs)
        process.stdin.close()
        for kind, p, c in zip(("wall", "CPU"), np.min(python, axis=0), np.min(cpp, axis=0)):
            print(f"{len(points)} vertices, {name}: {kind} time of Python {p:.3f} s, of C++ {c:.3f} s, "
                  f"ratio {p / c:.2f} (least of {runs} runs in turn)")


if __name__ == "__main__":
    main(*sys.argv[1:])
