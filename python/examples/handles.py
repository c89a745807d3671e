"""Find the handles of a model: the loops of the graph, and the curves along which they are cut open."""

import numpy as np
import reeb_graph
import shapes

triangles, points = shapes.read_off("genus_3.off")
field = reeb_graph.harmonic(triangles, points)
graph = reeb_graph.compute(triangles, field, points=points)
print(graph)
contours = [min((graph.contour(arc, 0.5) for arc in loop), key=len) for loop in graph.loops()]
cut = reeb_graph.cutting_system(triangles, field, points, cut_open=True)
for contour, curve in zip(contours, cut.curves):
    length = np.linalg.norm(np.diff(curve, axis=0), axis=1).sum()
    print("a loop with a contour at", contour.mean(axis=0).round(2), "and a cut of length", length.round(3))
print("the surface has", len(cut.points) - len(points), "points more")
pieces = np.where(graph.vertex_arcs >= 0, graph.vertex_arcs, 6)[triangles].min(axis=1)
shapes.draw("handles.svg", triangles, points, pieces, contours)
graph.write("handles_graph.svg", name="harmonic field")
