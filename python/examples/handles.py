"""Find the handles of a model: the loops of the graph, and the curves along which they are cut open."""

import numpy as np
import off
import reeb_graph

triangles, points = off.read("genus_3.off")
field = reeb_graph.harmonic(triangles, points)
graph = reeb_graph.compute(triangles, field, points=points)
for loop in graph.loops():
    shortest = min((graph.contour(arc, 0.5) for arc in loop), key=len)
    print("a loop of", len(loop), "arcs, with a contour at", np.round(shortest.mean(axis=0), 2))
cut = reeb_graph.cutting_system(triangles, field, points, cut_open=True)
for curve in cut.curves:
    print("cut along a curve of length", np.round(np.linalg.norm(np.diff(curve, axis=0), axis=1).sum(), 3))
print("the surface has", len(cut.points) - len(points), "points more")
graph.write("handles.svg", name="harmonic field")
