"""Compare two shapes by the persistence of their handles: the bottleneck distance, if GUDHI is there."""

import numpy as np
import reeb_graph
import shapes


def diagram(name, picture):
    """Return where along the x-axis loops begin and end, in parts of the length of the shape."""
    triangles, points = shapes.read_off(name)
    x = reeb_graph.height(triangles, points, direction=(1, 0, 0))
    graph = reeb_graph.compute(triangles, (x - x.min()) / np.ptp(x), points=points)
    graph.write(picture, what="diagram", name=f"x of {name}")
    pairs = graph.pairs()
    pairs = pairs[(pairs.kind == "loop") & (pairs.persistence > 0.01)]
    return np.column_stack([pairs.lower_value, pairs.upper_value])


first, second = diagram("double_torus.off", "double_torus.svg"), diagram("genus_3.off", "compare_shapes.svg")
print(first.round(3), second.round(3), sep="\n")
try:
    import gudhi
except ImportError:
    print("GUDHI is not installed (python3-gudhi): no bottleneck distance")
else:
    print("bottleneck distance", round(gudhi.bottleneck_distance(first, second), 4))
