"""What the examples share: reading a mesh, and drawing one."""

from pathlib import Path

import numpy as np

DATA = Path(__file__).parents[2] / "examples" / "Reeb_graph" / "data"
COLORS = np.array([[68, 119, 170], [238, 102, 119], [34, 136, 51], [204, 187, 68], [102, 204, 238], [170, 51, 119], [187, 187, 187]])


def read_off(name):
    """Return the triangles and the points of a mesh beside the C++ examples."""
    _, sizes, *lines = filter(None, (DATA / name).read_text().splitlines())
    n = int(sizes.split()[0])
    return np.loadtxt(lines[n:], dtype=int)[:, 1:], np.loadtxt(lines[:n])


def draw(path, triangles, points, pieces, lines=(), to_viewer=(0, -0.6, 1), both_sides=False):
    """Draw triangles in the colors of their pieces, and lines on them, from behind to the front, as SVG."""
    front = np.array(to_viewer) / np.linalg.norm(to_viewer)
    right = np.cross([0, 0, 1], front) / np.linalg.norm(np.cross([0, 0, 1], front))
    view = np.stack([right, -np.cross(front, right), front], axis=1)
    low, size = (points @ view).min(axis=0), np.ptp(points @ view, axis=0)
    place = lambda p: (p @ view - low) * 480 / size[:2].max() + 10
    text = lambda corners, rest: f'<path d="M{"L".join(f"{x:.1f} {y:.1f}" for x, y, _ in corners)}{rest}/>'
    normals = np.cross(*(points[triangles[:, 1:]] - points[triangles[:, :1]]).swapaxes(0, 1))
    facing = normals @ front / np.linalg.norm(normals, axis=1)
    shapes = []
    for triangle in np.flatnonzero(both_sides | (facing > 0)):
        corners, shade = place(points[triangles[triangle]]), 0.45 + 0.55 * abs(facing[triangle])
        color = "#%02x%02x%02x" % tuple((COLORS[pieces[triangle] % 7] * shade).astype(int))
        shapes.append((corners[:, 2].mean(), text(corners, f'Z" color="{color}"')))
    for line in lines:
        for piece in np.stack([place(line)[:-1], place(line)[1:]], axis=1):
            shapes.append((piece[:, 2].mean() + 4, text(piece, '" style="stroke-width:3"')))
    width, height, _ = place(points).max(axis=0) + 10
    head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" width="{width:.0f}">'
    style = "<style>path{fill:currentColor;stroke:currentColor;stroke-width:.6;stroke-linecap:round}</style>"
    Path(path).write_text("\n".join([head + style, *(shape for _, shape in sorted(shapes)), "</svg>\n"]))
