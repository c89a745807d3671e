"""Segment a scan: each vertex gets the arc of the simplified graph of the distance from the top of the head."""

import reeb_graph
import shapes

triangles, points = shapes.read_off("figure.off")
distance = reeb_graph.geodesic(triangles, points, sources=int(points[:, 2].argmax()))
graph = reeb_graph.compute(triangles, distance, points=points).simplify("5%")
for arc, (length, area) in enumerate(zip(graph.lengths(), graph.areas())):
    print(f"piece {arc}: {(graph.vertex_arcs == arc).sum()} vertices, {length:.3g} long, {area:.3g} of area")
pieces = graph.vertex_arcs[triangles].max(axis=1)  # nodes are negative
shapes.draw("segment_scan.svg", triangles, points, pieces, to_viewer=(0.2, -1, 0.3))
graph.write("segment_scan_graph.svg", name="distance from the head")
graph.write("segment_scan.ply")
