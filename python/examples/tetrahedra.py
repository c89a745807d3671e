"""Isosurfaces in tetrahedra: a field in a cube, and the surface in the middle of each arc of its Reeb graph."""

import itertools

import numpy as np
import reeb_graph
import shapes

n = 12
numbers = np.arange((n + 1) ** 3).reshape((n + 1,) * 3)
paths = [np.cumsum([0, *steps]) for steps in itertools.permutations((1, n + 1, (n + 1) ** 2))]  # through the cube
tetrahedra = np.concatenate([numbers[:-1, :-1, :-1].reshape(-1, 1) + path for path in paths])
points = np.stack(np.unravel_index(numbers.ravel(), numbers.shape), axis=-1) / n
centers = np.array([[0.3, 0.3, 0.5], [0.7, 0.7, 0.5]])
field = -np.min(np.linalg.norm(points[:, None] - centers, axis=-1), axis=1)

graph = reeb_graph.compute(None, field, tetrahedra=tetrahedra, points=points).simplify("10%")
print(graph)
for contour in graph.contours_of_arcs(0.5):
    print(f"arc {contour.arc}: at {contour.value:.3f} a surface of {len(contour.triangles)} triangles")
contours = graph.contours_of_arcs(0.6)
corners = np.concatenate([contour[contour.triangles] for contour in contours])  # three points for each triangle
pieces = np.repeat([contour.arc for contour in contours], [len(contour.triangles) for contour in contours])
shapes.draw("tetrahedra.svg", np.arange(3 * len(pieces)).reshape(-1, 3), corners.reshape(-1, 3), pieces, both_sides=True)
graph.write("tetrahedra_graph.svg", name="nearness")
