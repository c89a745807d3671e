"""Extract the skeleton of a neuron with a loop, with radii, and write it as SWC."""

import reeb_graph
import shapes

triangles, points = shapes.read_off("neuron.off")
skeleton = reeb_graph.skeleton(triangles, points)
print(skeleton)
print("outside of the surface:", skeleton.counts["vertices_outside"], "points,", skeleton.counts["crossing_edges"], "edges")
for arc in skeleton.arcs:
    print("an arc of", len(arc), "points, mean radius", skeleton.radii[arc].mean().round(3))
skeleton.write("neuron.swc", "neuron.vtp")
print(next(line for line in open("neuron.swc") if "CYCLE_BREAK" in line).strip())
arc_of_point = {point: number for number, arc in enumerate(skeleton.arcs) for point in arc.tolist()}
pieces = [arc_of_point[point] for point in skeleton.vertex_map[triangles[:, 0]].tolist()]
shapes.draw("neuron.svg", triangles, points, pieces, [skeleton.points[arc] for arc in skeleton.arcs], (0.2, -1, 0.6))
