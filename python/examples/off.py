"""Read the mesh of an OFF file of triangles, as the examples do."""

from pathlib import Path

import numpy as np

DATA = Path(__file__).parents[2] / "examples" / "Reeb_graph" / "data"


def read(name):
    """Return the triangles and the points of a mesh beside the C++ examples."""
    numbers = (DATA / name).read_text().split()
    n, m = int(numbers[1]), int(numbers[2])
    points = np.array(numbers[4 : 4 + 3 * n], dtype=float).reshape(n, 3)
    triangles = np.array(numbers[4 + 3 * n : 4 + 3 * n + 4 * m], dtype=int).reshape(m, 4)[:, 1:]
    return triangles, points
