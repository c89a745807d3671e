# Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
#
# This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

"""Holds the reports of all commands against the schema that is promised.

Usage: test_report_schema.py PROGRAM SCHEMA FOLDER
"""

import json
import os
import pathlib
import subprocess
import sys

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is not installed: skipped")
    sys.exit(77)

program, schema = os.path.abspath(sys.argv[1]), json.loads(pathlib.Path(sys.argv[2]).read_text())
folder = pathlib.Path(sys.argv[3])
folder.mkdir(parents=True, exist_ok=True)
os.chdir(folder)

# A tetrahedron, one with a sheet on it so that three faces meet, a square with borders, and two tetrahedra of a volume.
pathlib.Path("closed.off").write_text("OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0.5\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")
pathlib.Path("sheet.off").write_text(
    "OFF\n5 6 0\n0 0 0\n1 0 0\n0 1 0.5\n0 0 1\n2 2 2\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n3 1 2 4\n3 1 1 4\n")
pathlib.Path("open.off").write_text("OFF\n5 4 0\n0 0 0\n2 0 1\n2 2 0\n0 2 1\n1 1 5\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n")
pathlib.Path("volume.mesh").write_text(
    "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1 1 1 0\nTetrahedra\n2\n"
    "1 2 3 4 0\n2 3 4 5 0\nEnd\n")
for name, unit in (("large", "1e200"), ("small", "1e-200"), ("largest", "1.5e308")):
    pathlib.Path(f"{name}.off").write_text(f"OFF\n4 4 0\n0 0 0\n{unit} 0 0\n0 {unit} 0\n0 0 {unit}\n"
                                           "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")
# The torus of seven vertices, of which some faces cross.
pathlib.Path("crossed.off").write_text("OFF\n7 14 0\n0 0 0\n1 0 0\n1 1 0\n0 1 1\n0 0 2\n2 1 1\n1 2 0\n" + "".join(
    f"3 {i} {(i + 1) % 7} {(i + 3) % 7}\n3 {i} {(i + 3) % 7} {(i + 2) % 7}\n" for i in range(7)))
subprocess.run([program, "demo", "--out", "demo"], check=True, stdout=subprocess.DEVNULL)
surface = "demo/surface.off"
commands = [["compute", mesh, "--field", "z", "--table"] for mesh in ("closed.off", "sheet.off", "open.off", "volume.mesh")]
commands += [
    ["compute", surface, "--field", "geodesic", "--simplify", "auto", "--html", "page.html", "--graph", "graph.svg"],
    ["compute", surface, "--field", "z", "--leaves", "3", "--longest-loop", "loop.obj"],
    ["compute", surface, "--field", "harmonic", "--graph", "graph.vtp", "--mesh-out", "mesh.ply"],
    ["compute", "sheet.off", "--field", "z", "--html", "page.html"],
    ["contour", surface, "--field", "poisson", "--levels", "3", "--output", "contours.json"],
    ["contour", surface, "--field", "z", "--t", "0.5", "--parametrize", "unit-gradient", "--output", "contours.vtp"],
    ["contour", "sheet.off", "--field", "z", "--t", "0.5", "--html", "page.html"],
    ["contour", "volume.mesh", "--field", "z", "--t", "0.5", "--output", "contours.off"],
    ["handles", surface], ["handles", surface, "--remove", "1", "--output", "clean.ply"], ["handles", "sheet.off"],
    ["repair", "sheet.off", "--all", "--output", "repaired.ply"],
    ["repair", "open.off", "--fill", "9", "--least-piece", "0.1", "--output", "filled.ply"],
    ["skeleton", surface], ["skeleton", "open.off", "--output", "lines.swc", "lines.csv"],
    ["skeleton", "large.off"], ["skeleton", "small.off"], ["skeleton", "largest.off"],
    ["skeleton", "sheet.off", "--fill-borders"], ["skeleton", surface, "--from", "thickest", "--to", "tips"],
    ["handles", "crossed.off"], ["handles", "crossed.off", "--ignore-self-intersections"],
    ["handles", "volume.mesh"], ["skeleton", "volume.mesh", "--from", "0,0,0"], ["repair", "volume.mesh", "--output", "a.off"],
]
commands += [
    ["compare", surface, surface, "--field", "geodesic", "--simplify", "auto"], ["compare", "sheet.off", surface, "--field", "z"],
    ["compare", "closed.off", "open.off", "volume.mesh", "--field", "z"],
]
commands += [["field", surface, "--type", kind, "--output", "field.txt"]
             for kind in ("harmonic", "harmonic-between-borders", "poisson", "unit-gradient", "geodesic", "height")]
commands += [["curves", surface, "--type", kind, "--field", "z"] for kind in ("branch", "cutting-system", "disks")]
commands += [["curves", "open.off", "--type", "levels", "--levels", "2", "--field", "z"]]

faults = []
for command in commands:
    found = subprocess.run([program, *command, "--json"], capture_output=True, text=True)
    if found.returncode != 0:
        faults.append(f"{' '.join(command)}: {found.stderr}")
        continue
    report = json.loads(found.stdout, parse_constant=faults.append)
    for name, number, text in (("large.off", None, "volumes beyond double"), ("small.off", 0, "volumes too small")):
        if name in command and (report["arcs"][0]["volume"] != number or not any(text in n for n in report["notes"])):
            faults.append(f"{name}: {report['arcs'][0]['volume']}, {report['notes']}")
    part = {"$ref": f"#/$defs/{command[0]}", "$defs": schema["$defs"]}
    validator = jsonschema.Draft202012Validator(part)
    faults += [f"{' '.join(command)}: {error.json_path}: {error.message}" for error in validator.iter_errors(report)]
    # What is promised is refused when it is missing, or when there is more.
    for broken in ({**report, "other": 1}, {key: value for key, value in report.items() if key != "schema"}):
        if validator.is_valid(broken):
            faults.append(f"{' '.join(command)}: the schema takes anything")
jsonschema.Draft202012Validator.check_schema(schema)
print("\n".join(faults) or f"{len(commands)} reports")
sys.exit(1 if faults else 0)
