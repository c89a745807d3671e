"""What is true of a mesh as it is, found by brute force: these functions share nothing with the program."""

import heapq
from collections import Counter, defaultdict

import numpy as np

def edges_of(triangles):
    """Return the edges, and the number of faces of each."""
    return np.unique(np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1), axis=0, return_counts=True)

def number_of_groups(pairs):
    """Return how many groups there are of what is in some pairs, where a pair is in one."""
    parents = {}

    def root(a):
        while parents.setdefault(a, a) != a:
            parents[a] = a = parents[parents[a]]
        return a

    for a, b in np.asarray(pairs).tolist():
        parents[root(a)] = root(b)
    return sum(a == parent for a, parent in parents.items())

def topology(triangles):
    edges, counts = edges_of(triangles)
    components, borders = number_of_groups(edges), number_of_groups(edges[counts == 1])
    euler = len(np.unique(triangles)) - len(edges) + len(triangles)
    genus = components - (euler + borders) / 2 if counts.max(initial=0) <= 2 else None
    return {"components": components, "borders": borders, "euler": euler, "genus": genus}

def critical(triangles, values):
    """Return how many minima, saddles, with their multiplicities, and maxima a closed surface has."""
    order = np.lexsort((np.arange(len(values)), values)).argsort()
    links = defaultdict(list)
    for a, b, c in triangles.tolist():
        for v, x, y in ((a, b, c), (b, c, a), (c, a, b)):
            links[v].append((x, y))
    found = Counter()
    for v, link in links.items():
        lower = [(x, y) for x, y in link if order[x] < order[v] and order[y] < order[v]]
        lower += [(x, x) for pair in link for x in pair if order[x] < order[v]]
        pieces = number_of_groups(lower) if lower else 0
        is_highest = all(order[x] < order[v] for pair in link for x in pair)
        found["maxima" if is_highest else "saddles" if pieces else "minima"] += 1 if is_highest else abs(pieces - 1)
    return {kind: found[kind] for kind in ("minima", "saddles", "maxima")}

def section(triangles, points, values, level):
    """Return how many curves the surface has at a level that no vertex has, and the sum of their lengths."""
    above = values[triangles] > level
    crossed = triangles[above.any(axis=1) & ~above.all(axis=1)]
    ends = []
    for i in range(3):
        a, b = crossed[:, i], crossed[:, (i + 1) % 3]
        low, high = np.minimum(a, b), np.maximum(a, b)
        t = (level - values[low]) / np.where(values[low] == values[high], 1, values[high] - values[low])
        place = points[low] + t[:, None] * (points[high] - points[low])
        ends.append((low * len(points) + high, (values[low] > level) != (values[high] > level), place))
    edges, crosses, places = (np.stack(columns, axis=1) for columns in zip(*ends))
    pairs, places = edges[crosses].reshape(-1, 2), places[crosses].reshape(-1, 2, 3)
    lengths = np.abs(places[:, 0] - places[:, 1]).max(axis=1)  # which squares would leave the range of, in some units
    differences = (places[:, 0] - places[:, 1]) / np.where(lengths > 0, lengths, 1)[:, None]
    return {"contours": number_of_groups(pairs), "contour_length": (lengths * np.linalg.norm(differences, axis=1)).sum()}

def distances(triangles, points, source):
    """Return the distance of each vertex from one along edges: at least that on the surface."""
    edges, _ = edges_of(triangles)
    neighbors = defaultdict(list)
    for (a, b), length in zip(edges.tolist(), np.linalg.norm(np.subtract(*points[edges.T]), axis=1).tolist()):
        neighbors[a].append((b, length))
        neighbors[b].append((a, length))
    found, queue = np.full(len(points), np.inf), [(0.0, source)]
    while queue:
        distance, v = heapq.heappop(queue)
        if distance < found[v]:
            found[v] = distance
            for w, length in neighbors[v]:
                if distance + length < found[w]:
                    heapq.heappush(queue, (distance + length, w))
    return found
