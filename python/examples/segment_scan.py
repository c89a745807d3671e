"""Segment a scan: each vertex gets the arc of the simplified graph of the distance from the top of the head."""

import numpy as np
import off
import reeb_graph

triangles, points = off.read("figure.off")
distance = reeb_graph.geodesic(triangles, points, sources=int(points[:, 2].argmax()))
graph = reeb_graph.compute(triangles, distance, points=points).simplify("5%")
arcs = graph.vertex_arcs
labels = np.where(arcs >= 0, arcs, graph.n_arcs)  # the nodes together are the last piece
for arc, size in enumerate(np.bincount(labels, minlength=graph.n_arcs)[: graph.n_arcs]):
    print(f"piece {arc}: {size} vertices, {graph.areas()[arc]:.3g} of area")
graph.write("segment_scan.svg", name="distance from the head")
graph.write("segment_scan.ply")
