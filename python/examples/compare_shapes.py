"""Compare shapes by the persistence of their handles: a matrix of distances, and the arcs of two that are partners."""

import numpy as np
import reeb_graph
import shapes


def graph_of(name, picture):
    """Return the graph of a shape along its x-axis, in parts of its length."""
    triangles, points = shapes.read_off(name)
    x = reeb_graph.height(triangles, points, direction=(1, 0, 0))
    graph = reeb_graph.compute(triangles, (x - x.min()) / np.ptp(x), points=points)
    graph.write(picture, what="diagram", name=f"x of {name}")
    return graph


first, second = graph_of("double_torus.off", "double_torus.svg"), graph_of("genus_3.off", "compare_shapes.svg")
print(reeb_graph.distances([first, second]).round(4))
comparison = reeb_graph.compare(first.simplify("auto"), second.simplify("auto"))
print({kind: round(distance, 4) for kind, distance in comparison.by_kind.items()})
print("arcs that are partners:", *(f"{a} and {b}" for a, b in comparison.pairs))
