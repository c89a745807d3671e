"""Measures how the processor time of each command of the program grows from n to 4n.

Usage: test_growth_of_commands.py REEB_GRAPH TEST_GROWTH [PART_OF_A_NAME]; the second program writes the surfaces. Only
rows whose names have the part are measured. Fails if a command takes more than the bound says for the bytes that it
reads and writes.
"""

import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile

program, surfaces, *rest = sys.argv[1:]
name_part = rest[0] if rest else ""
vertices = 20000
near_linear = 1.75
doubled = 1.32  # 2.5 for twice as many
factorized = 1.85  # where a matrix is factorized instead of solved by multigrid
shortest = 0.1  # seconds; what takes less is mostly the start of the program

graph_files = ["graph.graphml", "graph.dot", "graph.svg", "graph.vtp", "graph.obj", "graph.json", "graph.csv",
               "graph.polylines.txt"]
compute = ["compute", "{mesh}", "--scalars", "{values}", "--no-table"]
commands = {f"compute --graph {file}": (compute + ["--graph", file], near_linear) for file in graph_files}
commands.update({
    "compute, table": (compute[:-1] + ["--table"], near_linear),
    "compute --pairs": (compute + ["--pairs", "pairs.csv"], near_linear),
    "compute --diagram": (compute + ["--diagram", "diagram.svg"], near_linear),
    "compute --vertex-arcs": (compute + ["--vertex-arcs", "arcs.txt"], near_linear),
    "compute --mesh-out .ply": (compute + ["--mesh-out", "out.ply"], near_linear),
    "compute --mesh-out .vtp": (compute + ["--mesh-out", "out.vtp"], near_linear),
    "compute --html": (compute + ["--html", "page.html"], near_linear),
    "compute --simplify": (compute + ["--simplify", "5%", "--simplified-scalars", "simple.txt"], near_linear),
    "contour --level": (["contour", "{mesh}", "--scalars", "{values}", "--level", "{level}", "--output",
                         "c.polylines.txt"], near_linear),
    "contour --arc": (["contour", "{mesh}", "--scalars", "{values}", "--arc", "0", "--t", "0.5", "--output",
                       "c.polylines.txt"], near_linear),
    "handles": (["handles", "{mesh}", "--scalars", "{values}", "--no-shortening", "--loops", "l.polylines.txt"],
                near_linear),
    "repair": (["repair", "{mesh}", "--all", "--least-piece", "0.01", "--fill", "50", "--output", "out.ply"],
               near_linear),
    "repair --fill": (["repair", "{mesh}", "--fill", "1000000", "--output", "out.ply"], near_linear),
    "skeleton": (["skeleton", "{mesh}", "--output", "s.swc", "s.vtp", "s.csv", "s.graphml", "--mesh-out", "mesh.vtp",
                  "--pieces", "pieces"], near_linear),
    "compare": (["compare", "{mesh}", "{mesh}", "--field", "geodesic", "--simplify", "auto", "--output", "m.csv", "--html",
                 "page.html"], doubled),
    "compare, three shapes": (["compare", "{mesh}", "{mesh}", "{mesh}", "--scalars", "{values}", "--output", "m.csv"],
                              doubled),
    "field height": (["field", "{mesh}", "--type", "height", "--output", "f.txt"], near_linear),
    "field geodesic": (["field", "{mesh}", "--type", "geodesic", "--output", "f.txt"], near_linear),
})
for field in ("harmonic", "poisson", "unit-gradient"):
    commands[f"field {field}"] = (["field", "{mesh}", "--type", field, "--output", "f.txt"], factorized)
for kind in ("cutting-system", "branch", "pants"):
    commands[f"curves {kind}"] = (["curves", "{mesh}", "--scalars", "{values}", "--type", kind, "--curves",
                                   "c.polylines.txt", "--cut-mesh", "cut.off"], near_linear)
commands["curves levels"] = (["curves", "{mesh}", "--scalars", "{values}", "--type", "levels", "--level", "{level}",
                              "--curves", "c.vtp", "--cut-mesh", "cut.off"], near_linear)
commands["curves disks"] = (["curves", "{mesh}", "--type", "disks", "--vertex-map", "map.txt", "--cut-mesh", "cut.off"],
                            near_linear)


rough_border = "rough border"


def write_rough_border(stem, size):
    """A cylinder of three rings with noise, in whose borders few edges are those of a Delaunay triangulation; the height as
    field."""
    numbers = random.Random(size)
    edges = size // 3
    lines, values = [f"OFF\n{3 * edges} {4 * edges} 0"], []
    for ring in range(3):
        for i in range(edges):
            radius, angle = numbers.uniform(0.5, 1.2), 2 * math.pi * i / edges
            values.append(ring + numbers.uniform(0, 0.2))
            lines.append(f"{radius * math.cos(angle)} {radius * math.sin(angle)} {values[-1]}")
    for ring in range(2):
        for i in range(edges):
            a, b = ring * edges + i, ring * edges + (i + 1) % edges
            lines += [f"3 {a} {b} {b + edges}", f"3 {a} {b + edges} {a + edges}"]
    pathlib.Path(f"{stem}.off").write_text("\n".join(lines) + "\n")
    pathlib.Path(f"{stem}.txt").write_text("\n".join(map(str, values)) + "\n")
    pathlib.Path(f"{stem}.name").write_text(rough_border)


def is_meant(surface, command):
    """Curves on noise are much longer than the mesh is large, and so are pants of plates; other surfaces have none.
    Handles in their thousands take cubic time: the rows of functions have them on smaller surfaces."""
    if surface == rough_border:
        return command in ("repair --fill", "skeleton", "handles")
    if command == "handles":
        return "genus k^2" not in surface
    if command == "compare":  # of others, more than 300 arcs are left
        return surface == "genus 3, smooth"
    if command.startswith("curves"):
        return "noise" not in surface and ("genus k^2" in surface or "pants" not in command)
    return not command.startswith(("field", "skeleton")) or "noise" not in surface


def run(command, stem):
    """The seconds of the processor, the bytes of the mesh, and those with what has been written."""
    mesh, values = f"{stem}.off", f"{stem}.txt"
    numbers = sorted(pathlib.Path(values).read_text().split(), key=float)
    arguments = [part.format(mesh=mesh, values=values, level=numbers[len(numbers) // 2]) for part in command]
    best = math.inf
    for _ in range(2):
        with tempfile.TemporaryDirectory() as folder:
            process = subprocess.Popen([program, *arguments, "--threads", "1"] if command[0] not in ("contour", "repair") else
                                       [program, *arguments], cwd=folder, stdout=subprocess.DEVNULL)
            _, status, usage = os.wait4(process.pid, 0)
            if status != 0:
                sys.exit(f"{' '.join(arguments)} has failed")
            best = min(best, usage.ru_utime + usage.ru_stime)
            files = [file for file in pathlib.Path(folder).iterdir() if file.suffix != ".html"]  # a page does not grow
            written = sum(file.stat().st_size for file in files)
        if best > 1:
            break
    return best, os.path.getsize(mesh), written + os.path.getsize(mesh)


def main():
    number_of_failures = 0
    columns = "{:<20} {:<36} {:>8} {:>8} {:>8} {:>9} {:>6} {}"
    print(columns.format("input", "command", "n [ms]", "2n [ms]", "4n [ms]", "exponent", "bound", ""))
    with tempfile.TemporaryDirectory() as folder:
        for factor in (1, 2, 4):
            os.mkdir(f"{folder}/{factor}")
            subprocess.run([surfaces, "--write", f"{folder}/{factor}", str(factor * vertices)], check=True)
            write_rough_border(f"{folder}/{factor}/rough", factor * vertices)
        for name_file in sorted(pathlib.Path(folder, "1").glob("*.name")):
            surface = name_file.read_text()
            for name, (command, bound) in commands.items():
                if not is_meant(surface, name) or name_part not in f"{surface} {name}":
                    continue
                for _ in range(2):  # others may use the caches
                    runs = [run(command, f"{folder}/{factor}/{name_file.stem}") for factor in (1, 2, 4)]
                    # A larger graph can have a smaller file, where arcs become straight.
                    growth = max(runs[2][i] / runs[0][i] for i in (1, 2))
                    exponent = math.log(runs[2][0] / runs[0][0]) / math.log(growth)
                    is_too_short = runs[2][0] < shortest
                    if is_too_short or exponent <= bound:
                        break
                has_failed = not is_too_short and exponent > bound
                number_of_failures += has_failed
                note = "FAILS" if has_failed else "too short to tell" if is_too_short else ""
                print(columns.format(surface, name, *(f"{1000 * seconds:.0f}" for seconds, _, _ in runs),
                                     f"{exponent:.2f}", bound, note), flush=True)
    if number_of_failures:
        sys.exit(f"{number_of_failures} rows grow faster than their bounds")


main()
