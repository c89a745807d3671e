"""Cut a surface into pairs of pants, and carry a color of the vertices over to the cut surface."""

import numpy as np
import reeb_graph
import shapes

triangles, points = shapes.read_off("genus_3.off")
colors = np.uint8(255 * (points - points.min(axis=0)) / np.ptp(points, axis=0))
field = reeb_graph.harmonic(triangles, points)
cut = reeb_graph.pants(triangles, field, points, vertex_arrays={"color": colors})
for patch in range(cut.n_patches):
    corners = cut.triangles[cut.patches == patch]
    print("pants", patch, "have", len(corners), "triangles of mean color", cut.vertex_arrays["color"][corners].mean((0, 1)))
assert len(cut.curves) == 3 * 3 - 3 and cut.n_patches == 2 * 3 - 2
shapes.draw("pants.svg", cut.triangles, cut.points, cut.patches, cut.curves)
