"""Meshes of plain shapes: each function returns triangles, which face outwards, and points."""

import numpy as np

CORNERS = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1), (1, 1, 1)])
TETRAHEDRA = [(0, a, a + b, 7) for a in (1, 2, 4) for b in (1, 2, 4) if a != b]  # of a cube, along its diagonal

def area(triangles, points):
    return np.linalg.norm(np.cross(*(points[triangles[:, 1:]] - points[triangles[:, :1]]).swapaxes(0, 1)), axis=1).sum() / 2

def volume(triangles, points):
    return np.linalg.det(points[triangles] - points.mean(axis=0)).sum() / 6

def outwards(triangles, points):
    return (triangles if volume(triangles, points) > 0 else triangles[:, ::-1]), points

def united(*meshes):
    """Return all of the meshes as one, which share no point."""
    starts = np.cumsum([0, *(len(points) for _, points in meshes)])
    return np.concatenate([t + start for (t, _), start in zip(meshes, starts)]), np.concatenate([p for _, p in meshes])

def moved(mesh, by):
    return mesh[0], mesh[1] + by

def welded(triangles, points):
    points, numbers = np.unique(np.round(points, 9), axis=0, return_inverse=True)
    return numbers.reshape(-1)[triangles], points

def split(triangles, points, times):
    """Cut each triangle into four at the middles of its edges, several times."""
    for _ in range(times):
        edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]], axis=2)
        pairs, numbers = np.unique(edges.reshape(-1, 2), axis=0, return_inverse=True)
        (a, b, c), (d, e, f) = triangles.T, (numbers.reshape(-1, 3) + len(points)).T
        triangles = np.concatenate([np.stack(corners, 1) for corners in ((a, d, f), (d, b, e), (f, e, c), (d, e, f))])
        points = np.concatenate([points, points[pairs].mean(axis=1)])
    return triangles, points

def blocks(solid, fine=1):
    """Return the surface of the unit cubes whose places in an array of three dimensions are not 0."""
    solid, squares = np.pad(np.asarray(solid, dtype=bool), 1), []
    for axis in range(3):
        for side in (-1, 1):
            low = np.argwhere(solid & ~np.roll(solid, -side, axis)) - 1
            u, v = np.eye(3, dtype=int)[[(axis + 1) % 3, (axis + 2) % 3][::side]]
            corner = low + np.eye(3, dtype=int)[axis] * (side > 0)
            squares.append(np.stack([corner, corner + u, corner + u + v, corner + v], axis=1))
    points, numbers = np.unique(np.concatenate(squares).reshape(-1, 3), axis=0, return_inverse=True)
    numbers = numbers.reshape(-1, 4)
    return split(np.concatenate([numbers[:, [0, 1, 2]], numbers[:, [0, 2, 3]]]), points.astype(float), fine - 1)

def extruded(polygon, height, times=0):
    """Return what is above a polygon, with as few triangles as there can be, or cut again and again."""
    def turn(a, b, c):
        return np.cross(polygon[b] - polygon[a], polygon[c] - polygon[a])
    polygon, left, caps = np.asarray(polygon, dtype=float), list(range(len(polygon))), []
    while len(left) > 2:
        a, b, c = left[:3]
        inside = [v for v in left[3:] if turn(a, b, v) >= 0 and turn(b, c, v) >= 0 and turn(c, a, v) >= 0]
        is_ear = turn(a, b, c) > 0 and not inside
        caps += [(a, b, c)] if is_ear else []
        left = [a, *left[2:]] if is_ear else [*left[1:], a]
    n = len(polygon)
    low = np.arange(n)
    high, after = low + n, (low + 1) % n
    walls = [np.stack([low, after, after + n], axis=1), np.stack([low, after + n, high], axis=1)]
    triangles = np.concatenate([np.array(caps)[:, ::-1], np.array(caps) + n, *walls])
    return split(triangles, np.concatenate([np.c_[polygon, 0 * low], np.c_[polygon, 0 * low + height]]), times)

def tube(line, radii, corners, closed=False):
    """Return a tube around a line, which `closed` leads back to its first point; where the radius is 0, it is a point."""
    line, radii = np.asarray(line, dtype=float), np.broadcast_to(radii, len(line))
    moves = line - np.roll(line, 1, axis=0)
    moves = np.where(np.linalg.norm(moves, axis=1, keepdims=True) > 0, moves, np.roll(moves, -1, axis=0))
    tangents = moves + np.roll(moves, -1, axis=0) if closed else np.gradient(line, axis=0)
    if not closed:  # two rings at one place, the rim and the middle of a flat end, look into one direction
        steps = [b - a for a, b in zip(line, line[1:]) if (a != b).any()]
        tangents[0], tangents[1], tangents[-2], tangents[-1] = steps[0], *(tangents[[1, -2]]), steps[-1]
    tangents /= np.linalg.norm(tangents, axis=1, keepdims=True)
    normal, rings, numbers, count = np.cross(tangents[0], [0.31, 0.95, 0.02]), [], [], 0
    angles = 2 * np.pi * np.arange(corners) / corners
    for center, radius, tangent in zip(line, radii, tangents):
        normal = normal - tangent * (normal @ tangent)
        normal /= np.linalg.norm(normal)
        ring = np.outer(np.cos(angles), normal) + np.outer(np.sin(angles), np.cross(tangent, normal))
        rings.append(center + radius * ring[: corners if radius else 1])
        numbers.append(count + np.arange(corners) * (radius > 0))
        count += len(rings[-1])
    triangles = []
    for low, high in zip(numbers, numbers[1:] + numbers[:1] * closed):
        a, b, c, d = low, np.roll(low, -1), np.roll(high, -1), high
        triangles += [np.stack([a, b, c], axis=1)[a != b], np.stack([a, c, d], axis=1)[c != d]]
    return outwards(np.concatenate(triangles), np.concatenate(rings))

def capsule(line, radius, corners):
    """Return a tube with round ends around a line; the tips are a radius behind its ends."""
    line, steps = np.asarray(line, dtype=float), max(2, corners // 4)
    angles = np.pi / 2 * np.arange(1, steps + 1) / steps
    first, last = (d / np.linalg.norm(d) for d in (line[0] - line[1], line[-1] - line[-2]))
    low, high = (p + np.outer(radius * np.sin(angles), d) for p, d in ((line[0], first), (line[-1], last)))
    radii = radius * np.array([*np.cos(angles[:-1]), 0])
    return tube(np.concatenate([low[::-1], line, high]), [*radii[::-1], *np.full(len(line), radius), *radii], corners)

def rod(a, b, radius):
    """Return the distance from a capsule, as a function of points."""
    a, way = np.array(a, dtype=float), np.subtract(b, a)
    return lambda p: np.linalg.norm(p - a - np.clip((p - a) @ way / (way @ way), 0, 1)[..., None] * way, axis=-1) - radius

def ring(center, large, small):
    """Return the distance from a torus in a plane of equal height."""
    def distance(p):
        q = p - np.asarray(center)
        return np.hypot(np.hypot(q[..., 0], q[..., 1]) - large, q[..., 2]) - small
    return distance

def union(*functions):
    return lambda p: np.min([function(p) for function in functions], axis=0)

def implicit(function, low, high, cell):
    """Return the surface on which a function is 0, by cutting tetrahedra of a grid, made smooth."""
    size = ((np.subtract(high, low)) / cell).astype(int) + 2
    grid = np.stack(np.meshgrid(*(l + cell * np.arange(n) for l, n in zip(low, size)), indexing="ij"), -1).reshape(-1, 3)
    values, strides = function(grid), np.array([size[1] * size[2], size[2], 1])
    cubes = np.stack(np.meshgrid(*(np.arange(n - 1) for n in size), indexing="ij"), -1).reshape(-1, 3) @ strides
    cells = np.concatenate([cubes[:, None] + (CORNERS[list(corners)] @ strides)[None] for corners in TETRAHEDRA])
    inside = values[cells] < 0
    pairs = []  # of corners, the one inside first: three for each triangle
    for number, faces in ((1, [(0, 1, 0, 2, 0, 3)]), (2, [(0, 2, 0, 3, 1, 3), (0, 2, 1, 3, 1, 2)]), (3, [(0, 3, 1, 3, 2, 3)])):
        some = inside.sum(axis=1) == number
        order = np.argsort(~inside[some], axis=1, kind="stable")
        sorted_cells = np.take_along_axis(cells[some], order, axis=1)
        pairs += [sorted_cells[:, list(face)].reshape(-1, 3, 2) for face in faces]
    pairs = np.concatenate(pairs)
    edges, numbers = np.unique(pairs.reshape(-1, 2), axis=0, return_inverse=True)
    (a, b), triangles = edges.T, numbers.reshape(-1, 3)
    points = grid[a] + np.clip(values[a] / (values[a] - values[b]), 0.1, 0.9)[:, None] * (grid[b] - grid[a])
    normals = np.cross(*(points[triangles[:, 1:]] - points[triangles[:, :1]]).swapaxes(0, 1))
    is_turned = ((grid[b] - grid[a])[triangles].sum(axis=1) * normals).sum(axis=1) < 0
    triangles[is_turned] = triangles[is_turned, ::-1]
    for _ in range(3):  # to the middle of the neighbors, and back to the surface
        sums, degrees = np.zeros_like(points), np.bincount(triangles.ravel(), minlength=len(points))
        np.add.at(sums, triangles.ravel(), points[np.roll(triangles, -1, axis=1).ravel()])
        points = sums / degrees[:, None]
        steps = np.eye(3) * 1e-5
        gradients = np.stack([function(points + step) - function(points - step) for step in steps], axis=-1) / 2e-5
        points = points - (function(points) / np.maximum((gradients**2).sum(axis=1), 0.1))[:, None] * gradients
    return triangles, points
