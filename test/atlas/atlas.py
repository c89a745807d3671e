#!/usr/bin/python3
"""The atlas: plain shapes, whose numbers a person knows, in each command of the program and each function of Python.

Without options, it runs the plain column, and of the others a tenth, drawn by the hash of the commit; --all runs all.
--shape, --column and --row, names or patterns such as 'torus*', run what they name only. REEB_GRAPH_PROGRAM is the
program, by default build/reeb_graph, and PYTHONPATH leads to the package.
"""

import argparse
import fnmatch
import hashlib
import os
import shutil
import subprocess
import sys
import tempfile
from collections import defaultdict
from pathlib import Path

import numpy as np

import measures
import meshes
from columns import COLUMNS
from rows import POWERS, PROGRAM, ROOMS, ROWS, RULES, read_off
from shapes import DEFAULTS, DIRECTION, SHAPES, About

# Patterns of SHAPE/COLUMN/ROW/NAME that are not mended yet, with their issues. It is a failure if one always passes.
KNOWN = dict.fromkeys(("tree/unwelded/skeleton/order",), 77)

def number_of(text):
    return int(hashlib.sha256(text.encode()).hexdigest()[:8], 16)

def write_mesh(path, triangles, points):
    number = lambda p: " ".join(map(repr, p.tolist()))
    with open(path, "w") as file:
        if path.endswith(".stl"):
            facet = "facet normal 0 0 0\nouter loop\n{}endloop\nendfacet\n"
            corners = ("".join(f"vertex {number(points[v])}\n" for v in face) for face in triangles)
            print("solid atlas\n" + "".join(map(facet.format, corners)) + "endsolid atlas", file=file)
        else:
            print(f"OFF\n{len(points)} {len(triangles)} 0", *map(number, points), sep="\n", file=file)
            print(*(f"3 {a} {b} {c}" for a, b, c in triangles.tolist()), sep="\n", file=file)

class Case:
    """A shape in a column: its file, and if it has to be repaired for that, the file that the other rows read."""
    def __init__(self, shape, column, folder):
        how = self.column = COLUMNS[column]
        self.name, self.folder, self.unit = f"{shape}/{column}", folder, how.unit
        mesh, truths = SHAPES[shape](how.fine)
        self.truths = DEFAULTS | truths
        self.truths["loops"] = self.truths["genus"]
        self.truths |= zip(("minima", "saddles", "maxima"), truths.get("critical", ()))
        random = np.random.default_rng(number_of(f"{shape} {column}"))
        triangles, points = how.change(*mesh, random)
        self.skeleton, self.raw, self.file = how.skeleton, *2 * [self.path(f"mesh.{how.ending}")]
        write_mesh(self.raw, triangles, points)
        self.repair = [*(self.truths["repair"] or ("--all",)), *how.repair]
        if "--stitch" in self.repair:
            self.repair[self.repair.index("--stitch") + 1] = repr(1e-6 * self.unit)
        self.is_self_repairing = not self.truths["repair"] or self.truths["repair"] == ("--all",)
        if self.truths["repair"]:
            self.file = self.path("ready.off")
            subprocess.run([PROGRAM, "repair", self.raw, *self.repair, "--output", self.file], capture_output=True)
            if os.path.exists(self.file):
                triangles, points = read_off(self.file)
        self.triangles, self.points = triangles, points
        self.measure(how)

    def measure(self, how):
        points, self.direction = self.points / self.unit, how.turn @ DIRECTION
        heights = points @ self.direction
        self.size, self.heights = np.linalg.norm(np.ptp(points, axis=0)), heights * self.unit
        level = np.median(heights)
        level += np.diff(np.unique(heights[heights >= level])[:2]).sum() / 2
        self.level = float(level * self.unit)
        found = measures.topology(self.triangles) | measures.section(self.triangles, points, heights, level)
        self.has_pants = found["components"] == 1 and found["euler"] < 0
        if found["borders"] == 0:
            found |= measures.critical(self.triangles, heights) | {"volume": meshes.volume(self.triangles, points)}
        found |= {"area": meshes.area(self.triangles, points), "range": np.ptp(heights)}
        self.measured = found | {"values": len(points), "faces": len(self.triangles)}

    def path(self, name):
        return os.path.join(self.folder, name)

def is_right(found, expected, room):
    if isinstance(expected, About):
        return bool(abs(found - expected.value) <= expected.tolerance)
    if isinstance(expected, float):
        return bool(abs(found - expected) <= room * abs(expected) + 1e-300)
    return bool(found == expected)

def text_of(expected):
    return f"{expected.value:.6g} ± {expected.tolerance:.2g}" if isinstance(expected, About) else f"{expected:.10g}" if isinstance(expected, float) else str(expected)

class Atlas:
    def __init__(self, options):
        self.options, self.failures, self.number, self.known, self.seconds = options, [], 0, defaultdict(list), {}

    def check(self, key, is_passed, message):
        self.number += 1
        for pattern in (patterns := [pattern for pattern in KNOWN if fnmatch.fnmatchcase(key, pattern)]):
            self.known[pattern].append(is_passed)
        if is_passed or patterns:
            return
        shape, column, row, _ = key.split("/")
        self.failures.append(key)
        print(f"{key}: {message}\n    PYTHONPATH={os.environ.get('PYTHONPATH', '')} REEB_GRAPH_PROGRAM={PROGRAM} "
              f"{sys.executable} {__file__} --shape {shape} --column {column} --row {row}", flush=True)

    def check_shape(self, shape, case):
        for name in {"area", "volume", "minima", "saddles", "maxima"} & {*case.truths} & {*case.measured}:
            found, truth = case.measured[name], case.truths[name]
            self.check(f"{shape}/plain/table/{name}", is_right(found, truth, 1e-9), f"{found}, not {text_of(truth)}")

    def run_row(self, case, row, key):
        started = sum(os.times()[:4])
        try:
            found = ROWS[row](case)
        except Exception as error:
            self.check(f"{key}/runs", False, f"{type(error).__name__}: {error}")
            return None
        self.check(f"{key}/runs", True, "")
        self.seconds[key] = sum(os.times()[:4]) - started
        return {name: value / case.unit ** POWERS[name] if name in POWERS else value for name, value in found.items()}

    def check_row(self, case, row, key, plain):
        found = self.run_row(case, row, key)
        how, is_own = case.column, plain is None or case.column.fine > 1
        for name, value in (found or {}).items():
            if name in how.exempt:
                continue
            is_rule = name.startswith(("is_", "are_"))
            expected, room = True if is_rule else case.truths.get(name, RULES.get(name)), max(how.room, ROOMS.get(row, 0))
            if is_own and expected is None and name in case.measured:
                expected, room = case.measured[name], 1e-9
            if not is_own and not is_rule and name not in RULES:
                is_measured = name in case.measured and row != "repair"
                expected = case.measured[name] if is_measured else plain.get(name)
            if expected is not None:
                self.check(f"{key}/{name}", is_right(value, expected, room), f"{text_of(value)}, not {text_of(expected)}")
        if plain is not None and found is not None:
            before, after = self.seconds["/".join((key.split("/")[0], "plain", row))], self.seconds[key]
            self.check(f"{key}/time", after <= 10 * max(before, 0.1), f"{before:.2f} CPU seconds became {after:.2f}")
        return found

    def run_shape(self, shape):
        rows = fnmatch.filter(ROWS, self.options.row)
        plain = {}
        for column in COLUMNS:
            is_drawn = number_of(f"{self.options.commit} {shape} {column}") % 10 == 0
            if column != "plain" and not (column in self.options.columns and (is_drawn or self.options.are_all)):
                continue
            with tempfile.TemporaryDirectory() as folder:
                case = Case(shape, column, folder)
                if column == "plain":
                    self.check_shape(shape, case)
                for row in rows if os.path.exists(case.file) else fnmatch.filter(rows, "repair"):
                    found = self.check_row(case, row, f"{shape}/{column}/{row}", plain.get(row))
                    if column == "plain":
                        plain[row] = found
            rows = [row for row in rows if plain.get(row) is not None]

def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--all", action="store_true", help="all columns, not only a tenth of them")
    for name in ("shape", "column", "row"):
        parser.add_argument(f"--{name}", default="*", help=f"the name of a {name}, or a pattern")
    options = parser.parse_args()
    options.columns, options.are_all = fnmatch.filter(COLUMNS, options.column), options.all or options.column != "*"
    git = ["git", "-C", str(Path(__file__).parent), "rev-parse", "HEAD"]
    options.commit = subprocess.run(git, capture_output=True, text=True).stdout.strip() if shutil.which("git") else ""
    atlas = Atlas(options)
    for shape in fnmatch.filter(SHAPES, options.shape):
        atlas.run_shape(shape)
    for pattern, passes in atlas.known.items():
        if all(passes) and options.shape == options.row == "*":
            print(f"{pattern}: passes now; take it out of the known failures, which are those of issue {KNOWN[pattern]}")
            atlas.failures.append(pattern)
    slowest = sorted(atlas.seconds.items(), key=lambda item: -item[1])[:5]
    print(f"{atlas.number} checks, {len(atlas.failures)} failures, {len(atlas.known)} known ones; commit {options.commit}; "
          f"{sum(os.times()[:4]):.0f} CPU seconds, most for " + ", ".join(f"{key} {seconds:.1f}" for key, seconds in slowest))
    return 1 if atlas.failures else 0

if __name__ == "__main__":
    sys.exit(main())
