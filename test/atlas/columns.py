"""The columns of the atlas: what may be done to a shape, so that what is true of it stays, but for what they say."""

from typing import Any, Callable, NamedTuple

import numpy as np

import measures

TURN = np.linalg.qr(np.array([[3, 1, -2], [1, 4, 1], [2, -1, 5]]))[0]
TURN *= np.sign(np.linalg.det(TURN))

class Column(NamedTuple):
    """How triangles and points change, and what follows from that."""
    change: Callable[..., Any] = lambda triangles, points, random: (triangles, points)
    unit: float = 1
    fine: int = 1
    turn: Any = np.eye(3)  # of the direction of the height
    ending: str = "off"
    exempt: tuple[str, ...] = ()
    repair: tuple[str, ...] = ()
    skeleton: tuple[str, ...] = ()
    room: float = 1e-6  # for lengths, areas and volumes, as a share

def renumber(triangles, points, random):
    order = random.permutation(len(points))
    numbers = np.argsort(order)[random.permutation(triangles)]
    starts = random.integers(0, 3, len(numbers))
    return np.stack([numbers[np.arange(len(numbers)), (starts + i) % 3] for i in range(3)], axis=1), points[order]

def leave_one_out(triangles, points, random):
    """Leave out a face inside, where all edges have two faces."""
    edges, counts = measures.edges_of(triangles)
    inside = ~np.isin(triangles, edges[counts != 2]).any(axis=1)
    return np.delete(triangles, random.choice(np.flatnonzero(inside)), axis=0), points

def cut_at_centers(triangles, points, random):
    """Cut each face into three; faces with the same corners have one center."""
    faces, numbers = np.unique(np.sort(triangles, axis=1), axis=0, return_inverse=True)
    centers = len(points) + numbers.reshape(-1)
    corners = [np.stack([triangles[:, i], triangles[:, (i + 1) % 3], centers], axis=1) for i in range(3)]
    return np.concatenate(corners), np.concatenate([points, points[faces].mean(axis=1)])

def move(triangles, points, random):
    return triangles, points + 1e6 * np.linalg.norm(np.ptp(points, axis=0)) * np.array([0.6, -0.48, 0.64])

COLUMNS = {
    "plain": Column(),
    "rotated": Column(lambda triangles, points, random: (triangles, points @ TURN.T), turn=TURN),
    "renumbered": Column(renumber),
    "in_large_units": Column(lambda triangles, points, random: (triangles, points * 1e150), 1e150),
    "in_small_units": Column(lambda triangles, points, random: (triangles, points * 1e-150), 1e-150),
    "moved": Column(move, exempt=("minima", "saddles", "maxima", "limbs", "values", "faces")),
    "unwelded": Column(ending="stl", exempt=("values", "are_right")),  # as points have other numbers
    "inside_out": Column(lambda triangles, points, random: (triangles[:, ::-1], points)),
    "one_face_missing": Column(leave_one_out, exempt=("faces", "reeb_loops"), repair=("--fill", "10"), skeleton=("--fill-borders",)),
    "cut_at_centers": Column(cut_at_centers, exempt=("values", "faces", "handle", "tunnel")),
    "twice_as_fine": Column(fine=2),
}
