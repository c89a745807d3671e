"""What the examples share: reading a mesh, and drawing one."""

from pathlib import Path

import numpy as np

DATA = Path(__file__).parents[2] / "examples" / "Reeb_graph" / "data"
COLOURS = np.array([[68, 119, 170], [238, 102, 119], [34, 136, 51], [204, 187, 68], [102, 204, 238], [170, 51, 119], [187, 187, 187]])


def read_off(name):
    """Return the triangles and the points of a mesh beside the C++ examples."""
    numbers = (DATA / name).read_text().split()
    n, m = int(numbers[1]), int(numbers[2])
    points = np.array(numbers[4 : 4 + 3 * n], dtype=float).reshape(n, 3)
    triangles = np.array(numbers[4 + 3 * n : 4 + 3 * n + 4 * m], dtype=int).reshape(m, 4)[:, 1:]
    return triangles, points


def draw(path, triangles, points, pieces, lines=(), to_viewer=(0, -0.6, 1), both_sides=False):
    """Draw triangles in the colours of their pieces, and lines on them, from behind to the front, as SVG."""
    front = np.array(to_viewer) / np.linalg.norm(to_viewer)
    right = np.cross([0, 0, 1], front) / np.linalg.norm(np.cross([0, 0, 1], front))
    view = np.stack([right, -np.cross(front, right), front], axis=1)
    low, size = (points @ view).min(axis=0), np.ptp(points @ view, axis=0)
    scale = 480 / size[:2].max()
    place = lambda p: ((p @ view - low) * scale + 10).round(1)
    corners = place(points)[triangles]
    normals = np.cross(points[triangles[:, 1]] - points[triangles[:, 0]], points[triangles[:, 2]] - points[triangles[:, 0]])
    facing = normals @ front / np.linalg.norm(normals, axis=1)
    shown = np.flatnonzero(both_sides | (facing > 0))
    shapes = []
    for triangle in shown:
        colour = "#%02x%02x%02x" % tuple((COLOURS[pieces[triangle] % 7] * (0.45 + 0.55 * abs(facing[triangle]))).astype(int))
        path_of = "M" + "L".join(f"{x:g} {y:g}" for x, y, _ in corners[triangle]) + "Z"
        shapes.append((corners[triangle, :, 2].mean(), f'<path d="{path_of}" color="{colour}"/>'))
    for line in lines:
        for (x, y, z), (u, v, w) in zip(place(line)[:-1], place(line)[1:]):
            text = f'<path d="M{x:g} {y:g}L{u:g} {v:g}" style="stroke-width:3"/>'
            shapes.append(((z + w) / 2 + 4, text))
    width, height = size[:2] * scale + 20
    content = "".join(text for _, text in sorted(shapes))
    head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" width="{width:.0f}">'
    style = "<style>path{fill:currentColor;stroke:currentColor;stroke-width:.6;stroke-linecap:round}</style>"
    Path(path).write_text(f"{head}{style}\n{content}\n</svg>\n")
