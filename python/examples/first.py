"""The first example of the manual: a torus, its Reeb graph by height, and the contour in the middle of an arc."""

import numpy as np
import reeb_graph

u, v = np.meshgrid(np.arange(40), np.arange(20), indexing="ij")
number = lambda i, j: (u + i) % 40 * 20 + (v + j) % 20
a, b = 2 * np.pi * u.ravel() / 40, 2 * np.pi * v.ravel() / 20
points = np.stack([(3 + np.cos(b)) * np.cos(a), np.sin(b), (3 + np.cos(b)) * np.sin(a)], axis=1)
corners = [number(0, 0), number(1, 0), number(1, 1), number(0, 0), number(1, 1), number(0, 1)]
graph = reeb_graph.compute(np.stack(corners, -1).reshape(-1, 3), points[:, 2], points=points)
print(graph, graph.node_kinds, graph.arcs, sep="\n")
print(graph.contour(1, 0.5).mean(axis=0))
graph.write("torus.svg", name="height")
