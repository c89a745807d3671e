"""The table of plain shapes: for each a mesh, and what is true of it, as functions of its parameters.

A truth is a number, or `about` one, where the smooth shape is known and the mesh is a sample of it, or a line is allowed
some room. `None` is a truth that a person does not know.

components, genus, borders   of the surface; the genus is also the number of loops of the skeleton
area, volume                 of the smooth shape
critical                     minima, saddles, maxima of the height along `DIRECTION`
limbs                        leaves of the graph of the distance from a tip, simplified automatically
ends, junctions, length, radius  of the skeleton: the sum of lengths, the mean of inscribed radii by length
order, thickest              its Strahler number, and the largest mean radius of a branch
handle, tunnel               the length of the shortest one
repair                       the options that make it a surface without self-contacts; the truths are those after it
"""

from collections import namedtuple

import numpy as np
from numpy import cos, pi, sin, sqrt

from meshes import blocks, capsule, extruded, implicit, moved, ring, rod, split, tube, union, united, welded

DIRECTION = np.array([0.31, 0.17, 1]) / sqrt(0.31**2 + 0.17**2 + 1)  # no edge of a lattice is level along it
DEFAULTS = {"components": 1, "genus": 0, "borders": 0, "repair": ()}

About = namedtuple("About", "value tolerance")

def about(value, share=0.08, by=0.0):
    """Return a truth with room for a share of it, or for a length; samples have 8 % less of area and volume at most."""
    return About(value, by or abs(value) * share)

SHAPES = {}  # functions of the fineness that return a mesh, and its truths

def plain(*values):
    """Add a shape for each value of a parameter to the table."""
    def add(function):
        for value in values:
            SHAPES[f"{function.__name__}_{value}"] = lambda fine, value=value: function(fine, value)
        if not values:
            SHAPES[function.__name__] = function
    return add

@plain()
def tetrahedron(fine):
    corners = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], dtype=float)
    mesh = split(np.array([(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]), corners, 1 + fine)
    return mesh, dict(area=1.5 + sqrt(3) / 2, volume=1 / 6, critical=(1, 0, 1))
@plain("4x4x4", "8x8x1", "1x1x20")
def cubes(fine, size):
    a, b, c = map(int, size.split("x"))
    truths = dict(area=2.0 * (a * b + b * c + c * a), volume=float(a * b * c), critical=(1, 0, 1))
    if size == "1x1x20":
        truths |= dict(limbs=2, ends=2, length=about(c, by=0.4), radius=about(0.5))
    return blocks(np.ones((a, b, c)), fine), truths

def ball(radius, fine, stretch=1.0):
    angles = pi * np.arange(8 * fine + 1) / (8 * fine)
    line = np.stack([0 * angles, 0 * angles, -radius * stretch * cos(angles)], axis=1)
    radii = radius * sin(angles) * (np.arange(8 * fine + 1) % (8 * fine) > 0)
    return tube(line, radii, 16 * fine)
@plain(1, 4)
def spheroid(fine, c):
    e = sqrt(1 - 1 / c**2)
    truths = dict(area=about(2 * pi * (1 + c * (np.arcsin(e) / e if e else 1))), volume=about(4 / 3 * pi * c), critical=(1, 0, 1))
    return ball(1, fine, c), truths | (dict(limbs=2, ends=2, length=about(2 * c, 0.1)) if c > 1 else {})
@plain()
def cone(fine):
    r, h, n = 2, 6, 8 * fine
    z = h * np.arange(n + 1) / n
    radii, line = np.array([0, *(r * (1 - z / h))]), np.outer([0, *z], [0, 0, 1])
    truths = dict(area=about(pi * r * (r + sqrt(r * r + h * h))), volume=about(pi * r * r * h / 3), critical=(1, 0, 1))
    return tube(line, radii, 16 * fine), dict(truths, limbs=2, ends=2, length=about(h, by=0.3 * r))

def round_tube(line, length, r, corners, **truths):
    """Return a tube with round ends, along which the inscribed radius falls to 0, around a line of this length."""
    truths |= dict(area=about(2 * pi * r * length + 4 * pi * r**2), volume=about(pi * r**2 * length + 4 / 3 * pi * r**3))
    radius = r * cos(pi / corners) * (length + r) / (length + 2 * r)
    truths |= dict(limbs=2, ends=2, length=about(length + 2 * r, 0.04), radius=about(radius, by=0.06 * r))
    return capsule(line, r, corners), truths
@plain(4, 10)
def straight_capsule(fine, length):
    line = np.outer(np.linspace(0, length, 2 * length * fine + 1), [0, 0, 1])
    return round_tube(line, length, 1, 16 * fine, critical=(1, 0, 1))
@plain("closed", "one_end_open", "open")
def cylinder(fine, ends):
    r, h, lids = 1, 10, {"closed": 2, "one_end_open": 1, "open": 0}[ends]
    z = np.linspace(0, h, 2 * h * fine + 1)
    line = np.outer([*z[:1][:lids], *z, *z[-1:][: max(0, lids - 1)]], [0, 0, 1])  # the middle of a lid is where its rim is
    radii = r * np.array([0] * (lids > 0) + [1] * len(z) + [0] * (lids > 1))
    truths = dict(borders=2 - lids, border_ends=2 - lids, area=about(2 * pi * r * h + lids * pi * r * r), limbs=2, ends=2)
    truths |= dict(volume=about(pi * r * r * h), critical=(1, 0, 1)) if lids == 2 else {}
    return tube(line, radii, 16 * fine), dict(truths, length=about(h, by=0.3), radius=about(r * (1 - lids * r / (2 * h)), by=0.05))
@plain()
def bent_tube(fine):
    angles, bend = np.linspace(0, pi, 20 * fine), 4
    line = bend * np.stack([cos(angles), 0 * angles, sin(angles)], axis=1)
    return round_tube(line, pi * bend, 1, 14 * fine, critical=(2, 1, 1))
@plain("one_end_open", "open")
def open_bend(fine, ends):
    """A bend that reaches its opening, beside which no way across that is short."""
    angles, bend = np.linspace(0, 3, 48 * fine), 3.5
    line = bend * np.stack([cos(angles), 0 * angles, sin(angles)], axis=1)
    borders, radii = 1 + (ends == "open"), np.ones(len(line))
    if borders == 1:
        line, radii = np.concatenate([line[:1], line]), np.concatenate([[0], radii])
    return tube(line, radii, 32 * fine), dict(borders=borders, border_ends=borders, limbs=2, ends=2, length=about(3 * bend, 0.1))
@plain()
def helix(fine):
    bend, rise, turns = 2.5, 3, 1.5
    angles = np.linspace(0, 2 * pi * turns, 40 * fine)
    line = np.stack([bend * cos(angles), bend * sin(angles), rise * angles / (2 * pi)], axis=1)
    return round_tube(line, turns * np.hypot(2 * pi * bend, rise), 0.6, 12 * fine)
@plain(0.1, 0.3, 0.5, 0.7, 0.9)
def torus(fine, ratio):
    bend, n = 3, 12 * fine
    r = ratio * bend
    steps = int(bend / r * n) if ratio < 0.5 else 2 * n
    angles = 2 * pi * np.arange(steps) / steps
    line = bend * np.stack([cos(angles), sin(angles), 0 * angles], axis=1)
    truths = dict(genus=1, area=about(4 * pi**2 * bend * r), volume=about(2 * pi**2 * bend * r**2), critical=(1, 2, 1))
    least, most = 2 * pi * (bend - r), 2 * pi * (bend - r * cos(pi / n))  # no line of vertices need lie at the inside
    truths.update(handle=about(2 * n * r * sin(pi / n), 1e-9), tunnel=about((least + most) / 2, by=(most - least) / 2 + 0.06 * most))
    # Where the tube is nearly as wide as the ring, one that is a tenth shorter is only a hundredth worse.
    truths.update(ends=0, length=about(2 * pi * bend, 0.1 if ratio < 0.9 else 0.12), radius=about(r * cos(pi / n), 0.1))
    return tube(line, r, n, closed=True), truths
@plain(3, 4, 6)
def ring_with_edges(fine, n):
    """A ring of triangular, square, or hexagonal section, whose edges lead around it."""
    bend, r, angles = 5, 1, 2 * pi * np.arange(24 * fine) / (24 * fine)
    line = bend * np.stack([cos(angles), sin(angles), 0 * angles], axis=1)
    return tube(line, r, n, closed=True), dict(genus=1, ends=0, length=about(2 * pi * bend, 0.1))
@plain("L", "T", "O", "P", "8", "plus", "H")
def letter(fine, name):
    """A letter of square bars, whose corners are no ends."""
    rows, ends, genus = {"L": ("o.. o.. o.. ooo", 2, 0), "T": ("ooooo ..o.. ..o.. ..o..", 3, 0), "O": ("ooo o.o o.o ooo", 0, 1),
                         "P": ("ooo o.o ooo o.. o..", 1, 1), "8": ("ooo o.o ooo o.o ooo", 0, 2),
                         "plus": ("...o... ...o... ...o... ooooooo ...o... ...o... ...o...", 4, 0), "H": ("o..o o..o oooo o..o o..o", 4, 0)}[name]
    solid = np.array([[[cell == "o"] for cell in row] for row in rows.split()])
    return blocks(solid, fine), dict(genus=genus, ends=ends, volume=float(solid.sum()))
@plain("T", "H")
def extruded_letter(fine, name):
    """A letter of few triangles, whose edges are as long as the arms."""
    polygon, ends, area = {
        "T": ([(-5, 0), (6, 0), (6, 1), (1, 1), (1, 9), (0, 9), (0, 1), (-5, 1)], 3, 19),
        "H": ([(0, 0), (0, -5), (1, -5), (1, 0), (6, 0), (6, -5), (7, -5), (7, 6), (6, 6), (6, 1), (1, 1), (1, 6), (0, 6)], 4, 27)}[name]
    return extruded(polygon, 1, fine - 1), dict(genus=0, ends=ends, volume=float(area))
@plain()
def double_torus(fine):
    function = union(ring((-2, 0, 0), 2, 0.7), ring((2, 0, 0), 2, 0.7))
    return implicit(function, (-5, -3, -1), (5, 3, 1), 0.5 / fine), dict(genus=2, ends=0)
@plain(30, 60, 90)
def pipe_with_branch(fine, degrees):
    angle, trunk, branch = np.radians(degrees), 12, 7
    tip = branch * np.array([cos(angle), 0, sin(angle)])
    function = union(rod((-5, 0, 0), (5, 0, 0), 1), rod((0, 0, 0), tip * (1 - 0.7 / branch), 0.7))
    mesh = implicit(function, (-7, -2, -2), (8, 2, 8), 0.5 / fine)
    return mesh, dict(limbs=3, ends=3, junctions=1, length=about(trunk + branch, 0.08), order=2)
@plain()
def thin_branch_on_thick_trunk(fine):
    function = union(rod((-5, 0, 0), (5, 0, 0), 3), rod((0, 0, 0), (0, 0, 8), 0.8))
    mesh = implicit(function, (-9, -4, -4), (9, 4, 10), 0.7 / fine)
    return mesh, dict(limbs=3, ends=3, junctions=1, thickest=about(2.9, by=0.1))  # round ends are thinner
@plain("V40", "V60", "N", "triangle")
def bars(fine, name):
    """Round bars that meet at acute angles: their corners are no ends."""
    angle = np.radians(float(name[1:])) if name[0] == "V" else 0
    corners = {"V": [(8 * cos(angle), 0, 8 * sin(angle)), (0, 0, 0), (8, 0, 0)], "N": [(0, 0, 0), (0, 0, 8), (5, 0, 0), (5, 0, 8)],
               "t": [(-4, 0, 0), (4, 0, 0), (0, 0, 7), (-4, 0, 0)]}[name[0]]
    function = union(*(rod(p, q, 0.8) for p, q in zip(corners, corners[1:])))
    is_closed = name == "triangle"
    return implicit(function, (-6, -2, -2), (10, 2, 10), 0.4 / fine), dict(genus=int(is_closed), ends=0 if is_closed else 2)
@plain()
def letter_y(fine):
    tips = [(0, 0, -4), (3.2, 0, 3.2), (-3.2, 0, 3.2)]
    function = union(*(rod((0, 0, 0), tip, 0.8) for tip in tips))
    length = sum(np.linalg.norm(tip) + 0.8 for tip in tips)
    truths = dict(limbs=3, ends=3, junctions=1, length=about(length, 0.08), order=2)
    return implicit(function, (-5, -2, -6), (5, 2, 5), 0.5 / fine), truths
@plain()
def star(fine):
    """Arms that meet at one place: junctions there become one, from which no two lines lead the same way."""
    tips = 4 * np.array([(0.5, 0.8, 0.3), (-0.9, 0.4, 0.2), (0.1, -0.6, 0.8), (0.4, -0.3, -0.9), (0.9, -0.4, 0.2)])
    function = union(*(rod((0, 0, 0), tuple(tip), 0.6) for tip in tips))
    length = about(sum(np.linalg.norm(tips, axis=1)) + 5 * 0.6, 0.1)
    return implicit(function, (-5, -5, -5), (5, 5, 5), 0.5 / fine), dict(limbs=5, ends=5, length=length)
@plain()
def foot(fine):
    """Toes on a flat sole, which is the end of none of them."""
    toes = [(1.9 * cos(angle), 1.9 * sin(angle), 0.2) for angle in (-0.8, 0, 0.8)]
    solid = union(rod((0, 0, 0.5), (0, 0, 7), 1.2), *(rod((0, 0, 0.2), toe, 0.4) for toe in toes))
    return implicit(lambda p: np.maximum(solid(p), -p[..., 2]), (-3, -4, -1), (5, 4, 9), 0.3 / fine), dict(ends=4)
@plain()
def hubs(fine):
    """Two places that four arms join."""
    middles = [(5, 5, 0), (5, 0, 5), (5, -5, 0), (5, 0, -5)]
    function = union(*(rod(place, middle, 0.55) for middle in middles for place in [(0, 0, 0), (10, 0, 0)]))
    return implicit(function, (-2, -7, -7), (12, 7, 7), 0.54 / fine), dict(genus=3, length=about(8 * sqrt(50), 0.1))
@plain()
def ring_with_two_branches(fine):
    function = union(ring((0, 0, 0), 3, 0.7), rod((3, 0, 0), (6, 0, 0), 0.7), rod((-3, 0, 0), (-4, 0, 3), 0.7))
    truths = dict(genus=1, ends=2, junctions=2, length=about(2 * pi * 3 + 3.7 + sqrt(10) + 0.7, 0.1))
    return implicit(function, (-6, -5, -2), (8, 5, 5), 0.5 / fine), truths
@plain("half_0.8", "half_0.5", "whole_0.5")
def ring_with_spoke(fine, name):
    """Half a spoke ends in the middle of the ring; opposite a spoke, the wall is no end."""
    part, radius = name.split("_")
    is_half, r = part == "half", float(radius)
    function = union(ring((0, 0, 0), 4, r), rod((-4, 0, 0), (0 if is_half else 4, 0, 0), r))
    length = about(2 * pi * 4 + (4 + r if is_half else 8), 0.1)
    return implicit(function, (-6, -6, -2), (6, 6, 2), 0.6 * r / fine), dict(genus=1 if is_half else 2, ends=1 if is_half else 0,
                                                                          length=length)
@plain(0.2, 0.3)
def mug(fine, radius):
    """A bar with a handle, whose line is there once; both ends of the bar stay."""
    function = union(rod((0, -3, 0), (0, 3, 0), 1), ring((1.2, 0, 0), 1.2, radius))
    return implicit(function, (-2, -5, -2), (4, 5, 2), radius / fine), dict(genus=1, ends=2)
@plain("1x1", "2x3")
def plate_with_holes(fine, holes):
    a, b = map(int, holes.split("x"))
    solid = np.ones((2 * a + 1, 2 * b + 1, 1))
    solid[1::2, 1::2] = 0
    flat, around = float(solid.sum()), 2 * (2 * a + 1 + 2 * b + 1) + 4 * a * b
    return blocks(solid, fine + 1), dict(genus=a * b, area=2 * flat + around, volume=flat)
@plain()
def cube_frame(fine):
    ends = np.isin(np.arange(5), (0, 4)).astype(int)
    solid = ends[:, None, None] + ends[:, None] + ends >= 2
    truths = dict(area=12 * 3 * 4.0 + 8 * 3, volume=12 * 3.0 + 8)
    return blocks(solid, fine), dict(truths, genus=12 - 8 + 1)  # edges and corners of a graph
@plain(1, 2)
def sponge(fine, k):
    """Channels lead through a cube, k by k in each direction: a graph of k^3 places and the outside."""
    ways = (np.arange(2 * k + 1) % 2).astype(int)
    solid = ways[:, None, None] + ways[:, None] + ways < 2
    edges, places = 3 * k**2 * (k - 1) + 6 * k**2, k**3 + 1
    return blocks(solid, fine), dict(genus=edges - places + 1, volume=float((2 * k + 1) ** 3 - places + 1 - 3 * k**2 * (k + 1)))
@plain("in", "out")
def nested_spheres(fine, side):
    outer, (triangles, points) = ball(3, fine), ball(1, fine)
    inner = (triangles[:, ::-1] if side == "in" else triangles), points
    truths = dict(components=2, critical=(2, 0, 2), area=about(4 * pi * 10))
    return united(outer, inner), dict(truths, volume=about(4 / 3 * pi * (27 - 1 if side == "in" else 27 + 1)))
@plain("vertex", "edge", "face")
def touching_cubes(fine, place):
    """Those that share an edge stay one, as the manual says; of a face that both have, nothing is left."""
    step = {"vertex": (2, 2, 2), "edge": (2, 0, 2), "face": (0, 0, 2)}[place]
    one, is_face = blocks(np.ones((2, 2, 2)), fine), place == "face"
    truths = dict(components=2 if place == "vertex" else 1, area=40.0 if is_face else 48.0, volume=16.0)
    truths |= dict(crossing_edges=None, long_steps=None) if place == "edge" else {}  # a line through it leaves the inside
    return welded(*united(one, moved(one, step))), dict(truths, repair=("--all",))

def flat_disk(radius, fine, bend=0.0):
    """Return a disk, or a part of a paraboloid."""
    radii = radius * np.arange(6 * fine + 1) / (6 * fine)
    triangles, points = tube(np.outer(radii, [0, 0, 1]), radii, 24 * fine)
    return triangles, np.stack([*points.T[:2], bend * (points[:, :2] ** 2).sum(axis=1)], axis=1)
@plain()
def disk(fine):
    return flat_disk(2, fine), dict(borders=1, area=about(pi * 4), crossing_edges=None, vertices_outside=None)  # of no inside
@plain()
def cube_beside_a_sheet(fine):
    r, bend = 9, -0.05
    mesh = united(blocks(np.ones((2, 2, 2)), fine), moved(flat_disk(r, fine, bend), (20, 0, 0)))
    area = 24 + pi / (6 * bend**2) * ((1 + 4 * bend**2 * r**2) ** 1.5 - 1)
    return mesh, dict(components=2, borders=1, area=about(area), repair=("--all", "--least-piece", "0.001"))
@plain()
def prism_with_t_junctions(fine):
    """A lid whose edges have points in their middles, which those of the walls have not."""
    solid, points = blocks(np.ones((1, 1, 3)), 1)
    is_lid = (points[solid][:, :, 2] == 3).all(axis=1)
    lid = split(solid[is_lid], points, fine)
    truths = dict(area=14.0, volume=3.0, repair=("--all", "--stitch", "1e-6"))
    return welded(*united((solid[~is_lid], points), lid)), truths
@plain()
def quadruped(fine):
    legs = [rod((x, 0.7 * x / abs(x) * s, 2), (x, 0.8 * s, 0), 0.4) for x in (-1.8, 1.8) for s in (-1, 1)]
    function = union(rod((-2, 0, 2.2), (2, 0, 2.2), 1), rod((2, 0, 2.2), (4, 0, 4), 0.5), rod((-2, 0, 2.5), (-4.5, 0, 3.5), 0.4), *legs)
    return implicit(function, (-6, -3, -1), (6, 3, 6), 0.35 / fine), dict(ends=6)  # the chest may be a limb
@plain()
def tree(fine):
    """Two branches on a trunk, and two twigs on each."""
    parts, length = [rod((0, 0, -5), (0, 0, 0), 0.8)], 5.8
    for side in (-1, 1):
        fork = np.array([3.0 * side, 0, 3])
        parts.append(rod((0, 0, 0), fork, 0.6))
        length += np.linalg.norm(fork)
        for way in (-1, 1):
            tip = fork + (1.2 * side, 2.5 * way, 1.5)
            parts.append(rod(fork, tip, 0.45))
            length += np.linalg.norm(tip - fork) + 0.45
    mesh = implicit(union(*parts), (-6, -5, -7), (6, 5, 6), 0.4 / fine)
    return mesh, dict(limbs=5, ends=5, order=3, length=about(length, 0.08))
@plain()
def moebius_band(fine):
    n, m = 30 * fine, 3 * fine
    i, j = np.divmod(np.arange((n + 1) * (m + 1)), m + 1)
    u, v = 2 * pi * i / n, 0.8 * (j / m - 0.5)
    points = np.stack([(2 + v * cos(u / 2)) * cos(u), (2 + v * cos(u / 2)) * sin(u), v * sin(u / 2)], axis=1)
    corner = (np.arange(n)[:, None] * (m + 1) + np.arange(m)).ravel()
    triangles = np.concatenate([np.stack([corner, corner + a, corner + b], 1) for a, b in ((1, m + 2), (m + 2, m + 1))])
    return welded(triangles, points), dict(genus=None, borders=1, area=about(2 * pi * 2 * 0.8), repair=("--all",))
