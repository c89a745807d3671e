"""Cut a surface into pairs of pants, and carry a colour of the vertices over to the cut surface."""

import numpy as np
import off
import reeb_graph

triangles, points = off.read("genus_3.off")
colours = np.uint8(255 * (points - points.min(axis=0)) / np.ptp(points, axis=0))
field = reeb_graph.harmonic(triangles, points)
cut = reeb_graph.pants(triangles, field, points, vertex_arrays={"colour": colours})
for patch in range(cut.n_patches):
    of_patch = cut.triangles[cut.patches == patch]
    print("pants", patch, "have", len(of_patch), "triangles of mean colour", cut.vertex_arrays["colour"][of_patch].mean((0, 1)))
assert len(cut.curves) == 3 * 3 - 3 and cut.n_patches == 2 * 3 - 2
graph = reeb_graph.compute(cut.triangles, cut.scalars, points=cut.points).simplify("1%")
graph.write("pants.svg", name="harmonic field")
