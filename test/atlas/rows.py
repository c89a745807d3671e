"""The rows of the atlas: each command of the program, and each function of Python, once.

A row is a function that takes a case, a shape in a column, and returns what it finds by name. What has the name of a truth
of the shape, or of what `measures.py` finds of the mesh, has to be that; all else has to be the same in each column.
"""

import json
import os
import subprocess
import warnings
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import reeb_graph

import measures
import meshes

warnings.simplefilter("ignore", UserWarning)  # what files say of themselves
PROGRAM = os.environ.get("REEB_GRAPH_PROGRAM", str(Path(__file__).parents[2] / "build" / "reeb_graph"))
POWERS = {"area": 2, "length": 1, "handle": 1, "tunnel": 1, "radius": 1, "thickest": 1, "range": 1}
POWERS |= {"contour_length": 1, "spread": 1}
# How much may change where what is computed is no exact number of the shape, as a share.
ROOMS = {"skeleton": 0.1, "py_skeleton": 0.1, "handles": 0.03, "py_handles": 0.03}
# What holds for each shape, beside that what begins with is_ or are_ is true.
RULES = dict.fromkeys(("contractible_loops", "vertices_outside", "crossing_edges", "radii_of_0", "long_steps", "doubled_points", "vertices_wrong", "distances_to_itself"), 0)
CERTIFICATE = ("contractible_loops", "vertices_outside", "crossing_edges")
RULES |= {"borders_not_level": 0, "genus_left": 0, "range_of_it": 1.0}

def run(*arguments):
    """Run a command with --json, and return its report."""
    done = subprocess.run([PROGRAM, *map(str, arguments), "--json"], capture_output=True, text=True, timeout=900)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(done.stderr.split())[:300]} [exit code {done.returncode}]")
    return json.loads(done.stdout)

def read_off(path):
    _, sizes, *lines = filter(None, Path(path).read_text().splitlines())
    n, m = map(int, sizes.split()[:2])
    numbers = np.array(" ".join(lines[n:n + m]).split(), dtype=int).reshape(m, 4)
    return numbers[:, 1:], np.array(" ".join(lines[:n]).split(), dtype=float).reshape(n, 3)

def height(case):
    return "--field", "height", "--direction", ",".join(map(repr, case.direction.tolist()))

def largest(values):
    return float(np.abs(values).max(initial=0))

def length(case, lines):
    """Return the sum of the lengths of lines, whose squares need not have a place in numbers."""
    return sum(np.linalg.norm(np.diff(line / case.unit, axis=0), axis=1).sum() for line in lines) * case.unit

def repair(case):
    found = run("repair", case.raw, *case.repair, "--output", case.path("repaired.off"))
    triangles, points = read_off(case.path("repaired.off"))
    counts, volume = found["result"], meshes.volume(triangles, points / case.unit)
    result = {"components": counts["components"], "borders": counts["border_loops"], "faces": len(triangles)}
    result |= {"genus": counts["genus"]} if counts["components"] == 1 else {}
    return result | ({"volume": volume} if "volume" in case.truths else {})

def compute(case):
    found = run("compute", case.file, *height(case), "--table")
    result = {name: found[name] for name in ("components", "minima", "maxima", "genus")[: 4 if found["components"] == 1 else 3]}
    result |= {"borders": found["border_loops"], "euler": found["euler_characteristic"], "area": sum(arc["area"] for arc in found["arc_table"])}
    saddles = sum(int(multiplicity) * number for multiplicity, number in found["saddles"].items())
    return result | {"saddles": saddles, "reeb_loops": found["loops"] + (found["hidden_handles"] or 0)}

def field(case):
    found = run("field", case.file, "--type", "height", *height(case)[2:], "--output", case.path("field.txt"))
    values = np.loadtxt(case.path("field.txt"))
    return {"values": found["values"], "range": found["highest"] - found["lowest"], "are_right": largest(values - case.heights) / case.unit <= 1e-9 * case.size}

def contour(case):
    found = run("contour", case.file, *height(case), "--level", repr(case.level), "--output", case.path("contours.polylines.txt"))
    lines = [np.array(line.split()[1:], dtype=float).reshape(-1, 3) for line in open(case.path("contours.polylines.txt"))]
    return {"contours": found["contours"], "contour_length": length(case, lines)}

def pairs_of_loops(loops):
    """Return the number of pairs of loops that are no borders, and the shortest handle and tunnel, which need an inside."""
    kinds = [kind for kind, _ in loops]
    shortest = {name: min(length for kind, length in loops if kind == name) for name in {"handle", "tunnel"} & {*kinds}}
    return {"pairs": (len(kinds) - kinds.count("hole")) / 2} | shortest

def handles(case):
    found = run("handles", case.raw if case.is_self_repairing else case.file, *height(case))
    return pairs_of_loops([(loop["kind"], loop["length"]) for loop in found["loops"]])

def skeleton(case):
    if case.skeleton and case.truths["borders"]:
        return {}  # which would not be borders any more
    root = ("--root", case.heights.argmin()) if "order" in case.truths else ()
    found = run("skeleton", case.raw if case.is_self_repairing else case.file, *case.skeleton, *root, "--output", case.path("lines.swc"))
    result = {name: found[name] for name in (*CERTIFICATE, "ends", "border_ends", "loops", "junctions") if name in case.truths or name in RULES}
    lengths, areas, radii, inscribed = np.array([[arc[name] for name in ("length", "area", "radius", "inscribed_radius")] for arc in found["arcs"]]).T
    means = {"length": lengths.sum(), "radius": lengths @ inscribed / lengths.sum(), "thickest": radii.max()}
    result |= {"area": areas.sum()} | {name: means[name] for name in means if name in case.truths}  # a ball has many lines
    result |= {"order": found["strahler_order"]} if root else {}
    if case.measured["borders"] == 0 and not case.truths["repair"]:
        result["is_turned_said"] = (((found["input"] or {}).get("inside_out_solids") or 0) > 0) == case.name.endswith("/inside_out")
    return result | {"radii_of_0": int((np.loadtxt(case.path("lines.swc"), ndmin=2)[:, 5] <= 0).sum())}

def compare(case):
    """A shape with itself, by the program and from Python."""
    found, graph = run("compare", case.file, case.file, *height(case)), reeb_graph.compute(case.triangles, case.heights, points=case.points)
    distances = found["distance"], reeb_graph.compare(graph, graph).distance
    return {"distances_to_itself": max(distances), "are_all_partners": not any(found["without_partner"])}

def demo(case):
    """Needs no shape: it runs for one only."""
    if case.name != "tetrahedron/plain":
        return {}
    subprocess.run([PROGRAM, "demo", "--out", case.path("demo")], check=True, capture_output=True)
    return {"has_a_surface": measures.topology(read_off(case.path("demo/surface.off"))[0])["components"] == 1}

def py_read(case):
    """A file, and a mesh of another package, which is repaired to itself."""
    mesh, other = reeb_graph.read(case.file), reeb_graph.mesh_arrays(SimpleNamespace(vertices=case.points, faces=case.triangles))
    found = reeb_graph.repair(other, all=True)
    return {"values": len(mesh.points), "faces": len(mesh.triangles), "are_same": len(found.points) == len(case.points)}

def py_compute(case):
    graph = reeb_graph.compute(case.triangles, case.heights, points=case.points)
    found = {"components": graph.n_components, "area": graph.areas().sum(), "spread": graph.pairs().persistence.max()}
    contours = [contour.points for contour in graph.contours(case.level)]
    found |= {"contours": len(contours), "contour_length": length(case, contours)}
    hidden = graph.counts["hidden_handles"]
    return found if hidden is None else found | {"genus": graph.n_loops + hidden}

def py_geodesic(case):
    """Nowhere less than through space, nowhere more than along edges; and limbs by it."""
    wrong, slack = 0, 1e-9 * case.size
    if case.measured["components"] == 1:
        source = int(case.heights.argmin())
        found = reeb_graph.geodesic(case.triangles, case.points, sources=source) / case.unit
        least = np.linalg.norm((case.points - case.points[source]) / case.unit, axis=1)
        wrong = ((found < least - slack) | (found > measures.distances(case.triangles, case.points / case.unit, source) + slack)).sum()
    if "limbs" not in case.truths:
        return {"vertices_wrong": int(wrong)}
    graph = reeb_graph.compute(case.triangles, reeb_graph.geodesic(case.triangles, case.points)).simplify("auto")
    return {"vertices_wrong": int(wrong), "limbs": graph.n_leaves}

def py_harmonic(case):
    """From 0 to 1, without another extremum."""
    found = reeb_graph.harmonic(case.triangles, case.points)
    leaves = reeb_graph.compute(case.triangles, found, ties="contract").n_leaves
    return {"range_of_it": float(np.ptp(found)), "are_two_a_component": leaves == 2 * case.measured["components"]}

def py_fields(case):
    height = reeb_graph.height(case.triangles, case.points, case.direction)
    others = reeb_graph.poisson(case.triangles, case.points), reeb_graph.unit_gradient(case.triangles, case.points)
    return {"are_right": largest(height - case.heights) / case.unit <= 1e-9 * case.size, "are_finite": bool(np.isfinite(others).all())}

def py_make_borders_level(case):
    found = reeb_graph.make_borders_level(case.triangles, case.heights)
    edges, counts = measures.edges_of(case.triangles)
    low, high = found[edges[counts == 1]].T
    return {"borders_not_level": int((low != high).sum()), "is_same_without": case.measured["borders"] > 0 or largest(found - case.heights) == 0}

def py_handles(case):
    return pairs_of_loops([(loop.kind, loop.length) for loop in reeb_graph.handles(case.triangles, case.points).loops])

def py_skeleton(case):
    """No step is longer than promised."""
    if case.skeleton and case.truths["borders"]:
        return {}
    lines = reeb_graph.skeleton(case.triangles, case.points, ends_at_borders="--fill-borders" not in case.skeleton)
    points = lines.points / case.unit
    steps = np.linalg.norm(np.subtract(*points[lines.edges].swapaxes(0, 1)), axis=1)
    sides = np.diff(case.points[case.triangles[:, [0, 1, 2, 0]]] / case.unit, axis=1)
    floor = min(np.linalg.norm(sides, axis=2).mean() / 2, case.size / 50)  # which the manual names
    allowed = 0.75 * np.maximum(lines.radii[lines.edges].max(axis=1) / case.unit, floor)
    result = {name: lines.counts[name] for name in ("ends", "loops", "junctions", *CERTIFICATE) if name in case.truths or name in RULES}
    result |= {"length": steps.sum() * case.unit} if "length" in case.truths else {}
    result |= {} if case.measured["borders"] or case.truths["repair"] else {"doubled_points": len(points) - len(np.unique(points, axis=0))}
    return result | {"long_steps": int((steps > allowed).sum())}

def cut_by_program(case, kind):
    options = {"levels": (*height(case), "--level", repr(case.level)), "disks": ()}.get(kind, (*height(case), "--cut-open"))
    found = run("curves", case.file, "--type", kind.replace("_", "-"), *options, "--cut-mesh", case.path("cut.off"))
    return *read_off(case.path("cut.off")), found["curves"], found["patches"]

def cut_by_python(case, kind):
    function = getattr(reeb_graph, {"branch": "branches", "levels": "cut_along_levels", "disks": "cut_to_disks"}.get(kind, kind))
    given = (case.triangles, case.points) if kind == "disks" else (case.triangles, case.heights, case.points)
    found = function(*given, **{"levels": {"level": case.level}, "disks": {}}.get(kind, {"cut_open": True}))
    return found.triangles, found.points, len(found.curves), found.n_patches

def cut(case, kind, by):
    if kind == "pants" and not case.has_pants:
        try:
            by(case, kind)
        except (RuntimeError, ValueError) as error:
            return {"is_refused": "pants" in str(error)}
    triangles, points, curves, patches = by(case, kind)
    found, n = measures.topology(triangles), case.measured
    results = {
        "cutting_system": {"genus_left": found["genus"], "is_one_for_each_handle": curves == n["genus"]},
        "pants": {"are_pants": found["borders"] == 3 * patches == -3 * found["euler"] == -3 * n["euler"]},
        "levels": {"contours": curves},
        "disks": {"are_disks": found["components"] == found["borders"] == found["euler"] == patches == n["components"]},
    }
    return {"area": meshes.area(triangles, points / case.unit) * case.unit**2} | results.get(kind, {})

def remove_handles(case):
    """None is left by the command, nor by the function."""
    if case.measured["borders"]:
        return {}
    run("handles", case.file, "--remove", 1000, "--output", case.path("without.off"))
    both = read_off(case.path("without.off"))[0], reeb_graph.remove_handles(case.triangles, case.points, number=1000).triangles
    return {"genus_left": sum(measures.topology(triangles)["genus"] for triangles in both)}

ALONE = (repair, compute, field, contour, compare, handles, skeleton, demo, py_read, py_compute, py_geodesic)
ALONE += (py_harmonic, py_fields, py_make_borders_level, py_handles, remove_handles, py_skeleton)
ROWS = {function.__name__: function for function in ALONE}
for kind in ("cutting_system", "pants", "branch", "levels", "disks"):
    ROWS[f"curves_{kind}"] = partial(cut, kind=kind, by=cut_by_program)
    ROWS[f"py_{kind}"] = partial(cut, kind=kind, by=cut_by_python)
