"""Prints what people wait for: each wish of the README, on surfaces of several sizes, or on a mesh that is given.

Usage: benchmark_wishes.py FOLDER_OF_THE_BUILD [VERTICES... | MESH]; scripts/benchmark --tables wishes calls it.
The surfaces are tori with bumps, numbered row by row, and with holes for pants. CPU seconds are those of one thread, also
in units of `std::sort` of the field; the share of the graph is that of the time on the clock. Wall seconds are those of
two threads.
"""

import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

build, *sizes = sys.argv[1:]
WISHES = {
    "graph": "compute {mesh} --field z --graph g.svg",
    "limbs": "compute {mesh} --field geodesic --simplify auto --graph g.svg",
    "page": "compute {mesh} --field z --html page.html",
    "segments": "curves {mesh} --field geodesic --type branch --simplify auto --mesh-out pieces.ply",
    "contours": "contour {mesh} --field geodesic --simplify auto --t 0.5 --output contours.vtp",
    "pants": "curves {holes} --type pants --mesh-out pants.ply",
    "skeleton": "skeleton {mesh} --output s.swc",
    "handles": "handles {mesh}",
    "clean": "handles {mesh} --remove-below 0.05 --output clean.ply",
    "ParaView": "compute {mesh} --field z --graph g.vtp --mesh-out mesh.vtp",
    "own field": "compute {mesh} --scalars field.txt --mesh-out mesh.ply",
    "harmonic": "field {mesh} --type harmonic --output f.txt",
    "Poisson": "field {mesh} --type poisson --output f.txt",
}


def write_torus(path, number_of_vertices, has_holes=False):
    rows = max(int(math.sqrt(number_of_vertices / 2)), 8)
    columns = 2 * rows
    turn = 2 * math.pi
    with open(path, "w") as file:
        faces = []
        for i in range(columns):
            for j in range(rows):
                a, b, c, d = (x % columns * rows + y % rows for x in (i, i + 1) for y in (j, j + 1))
                is_hole = has_holes and i % (columns // 3) == 0 and j % (rows // 2) == 0
                faces += [] if is_hole else [(a, c, d), (a, d, b)]
        file.write(f"OFF\n{rows * columns} {len(faces)} 0\n")
        for i in range(columns):
            for j in range(rows):
                u, v = turn * i / columns, turn * j / rows
                r = 2 + math.cos(v) + 0.15 * math.sin(5 * u + 2 * v) + 0.05 * math.sin(17 * u) * math.cos(11 * v)
                file.write(f"{r * math.cos(u):.9g} {0.9 * r * math.sin(u):.9g} {math.sin(v) + 0.3 * math.cos(2 * u):.9g}\n")
        file.writelines("3 %d %d %d\n" % face for face in faces)


def run(command, threads):
    """The report if there is one, seconds of CPU and on the clock, and bytes of memory."""
    with tempfile.TemporaryFile("w+") as output:
        process = subprocess.Popen([build + "/reeb_graph", *command.split(), "--json", *threads], stdout=output)
        _, status, usage = os.wait4(process.pid, 0)
        if status != 0:
            sys.exit(f"reeb_graph {command} has failed")
        output.seek(0)
        text = output.read()
    report = json.loads(text) if text.startswith("{") else {}
    spent = report.get("seconds", {})
    wall = sum(seconds for step, seconds in spent.items() if step not in ("flatten", "classify", "arcs", "write"))
    graph = f"{100 * spent['compute'] / wall:.0f}" if "compute" in spent else "-" # others do not tell it apart
    return usage.ru_utime + usage.ru_stime, wall, graph, usage.ru_maxrss / 1024


def main():
    columns = "{:<10} {:>9} {:>9} {:>9} {:>12} {:>8} {:>10}"
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for size in sizes or ["50000", "205000", "1000000"]:
            mesh, holes = "torus.off", "holes.off"
            if size.isdigit():
                write_torus(mesh, int(size))
                write_torus(holes, int(size), has_holes=True)
            else:
                mesh = holes = size
            subprocess.run([build + "/reeb_graph", "field", mesh, "--type", "height", "--output", "field.txt"], check=True,
                           stdout=subprocess.DEVNULL)
            sort = float(subprocess.run([build + "/benchmark/Reeb_graph/benchmark_sort", "field.txt"], check=True,
                                        capture_output=True, text=True).stdout)
            print(f"{size}, std::sort of the field takes {sort:.4f} s")
            print(columns.format("wish", "CPU [s]", "sorts", "MB", "graph [%]", "wall [s]", "threads 2"))
            for name, wish in WISHES.items():
                command = wish.format(mesh=mesh, holes=holes)
                takes_threads = not command.startswith("skeleton")
                cpu, wall, graph, memory = run(command, ["--threads", "1"] if takes_threads else [])
                wall_of_two = run(command, ["--threads", "2"])[1] if takes_threads else None
                print(columns.format(name, f"{cpu:.2f}", f"{cpu / sort:.0f}", f"{memory:.0f}", graph,
                                     f"{wall:.2f}", "-" if wall_of_two is None else f"{wall_of_two:.2f}"), flush=True)
            print()


if sizes and not sizes[0].isdigit():
    sizes = [str(pathlib.Path(size).resolve()) for size in sizes]
build = str(pathlib.Path(build).resolve())
if __name__ == "__main__":
    main()
