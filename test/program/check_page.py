# Checks the data of a page against what the program has written beside it.
# Usage: check_page.py PAGE.html TITLE [mesh=FILE.off] [coordinate=NUMBER] [vertex_arcs=FILE] [patches=FILE]
#                      [curves=FILE.polylines.txt] [KEY=VALUE...]
# The coordinate is the one that the field is; it and the arcs of a decimated surface need the mesh before them.
# Each other KEY is a path of keys, with dots between them, to a value of the data as JSON; length counts.
import base64
import html.parser
import itertools
import json
import math
import struct
import sys


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.title, self.data, self.scripts, self.inside = None, None, 0, None
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.inside = tag
        self.scripts += tag == "script"
        for name in ("src", "href"):
            check(attributes.get(name, "data:").startswith("data:"), f"{tag} needs another file: {attributes}")
        if tag == "script" and attributes.get("id") == "reeb-graph-data":
            check(self.data is None, "the data are there twice")
            self.inside = "data"

    def handle_endtag(self, tag):
        self.inside = None

    def handle_data(self, text):
        if self.inside == "title":
            self.title = text
        if self.inside == "data":
            self.data = json.loads(text)


def check(is_true, message):
    if not is_true:
        sys.exit("check_page.py: " + message)


def numbers(text, letter):
    code = base64.b64decode(text, validate=True)
    check(len(code) % struct.calcsize("<" + letter) == 0, "a number is cut off")
    return [number for number, in struct.iter_unpack("<" + letter, code)]


def value_of(number):
    check(not isinstance(number, str) or number in ("Infinity", "-Infinity"), f"{number} is no number")
    return float(number)


def is_near(a, b, size):
    return all(abs(x - y) <= 1e-6 * size for x, y in zip(a, b)) and len(a) == len(b)


class Surface:
    def __init__(self, data):
        self.origin = data["origin"]
        positions = numbers(data["positions"], "f")
        self.points = list(zip(positions[::3], positions[1::3], positions[2::3]))
        self.values = numbers(data["values"], "d")
        corners = numbers(data["triangles"], "I")
        self.triangles = list(zip(corners[::3], corners[1::3], corners[2::3]))
        self.places = numbers(data["vertex_arcs"], "i")
        self.patches = numbers(data["face_patches"], "i") if data["face_patches"] else None
        self.origins = list(range(len(self.points)))  # the vertices of the mesh that these are
        self.size = max((max(xs) - min(xs) for xs in zip(*self.points)), default=0)
        check(len(positions) == 3 * len(self.values) == 3 * len(self.places), "the vertices are not as many each time")
        check(len(corners) == 3 * len(self.triangles), "a triangle lacks a corner")
        check(all(corner < len(self.points) for corner in corners), "a corner is no vertex")
        check(all(not math.isnan(value) for value in self.values), "a value is NaN")
        check(not self.patches or len(self.patches) == len(self.triangles), "the patches are not those of the faces")


# The names of what is told of each arc.
def columns_of(data):
    check(all(column["unit"] in ("field", "count", "") for column in data["columns"]), "the unit of a column")
    return {column["name"] for column in data["columns"]}


# The graph of a skeleton: its counts are those of the report, arcs rise as far as one can walk along them.
def check_skeleton(data, surface):
    graph, known = data["graph"], data["skeleton"]
    nodes, arcs = graph["nodes"], graph["arcs"]
    degrees, roots = [0] * len(nodes), list(range(len(nodes)))

    def root(i):
        while roots[i] != i:
            i = roots[i]
        return i

    for arc in arcs:
        ends = arc["source"], arc["target"]
        low, high = (nodes[end]["value"] for end in ends)
        for end in ends:
            degrees[end] += 1
        roots[root(ends[0])] = root(ends[1])
        line, plane, heights = arc["polyline"], arc["plane"], arc["plane"][1::2]
        check(line[:3] == nodes[ends[0]]["point"] and line[-3:] == nodes[ends[1]]["point"], "an arc is not at its nodes")
        check([plane[:2], plane[-2:]] == [[nodes[end]["column"], nodes[end]["value"]] for end in ends], "in the plane")
        points = [line[i:i + 3] for i in range(0, len(line), 3)]
        steps = [0] + list(itertools.accumulate(math.dist(p, q) for p, q in zip(points, points[1:])))
        check(abs(steps[-1] - arc["length"]) < 1e-5 * steps[-1], "the length of an arc")
        top = heights.index(max(heights))
        check(heights == sorted(heights[:top]) + sorted(heights[top:], reverse=True), "an arc falls before it rises")
        farthest = max(min(low + step, high + steps[-1] - step) for step in steps)
        check(low <= high and abs(max(heights) - farthest) < 1e-5 * (farthest + steps[-1]), "the height of an arc")
        check(0 <= arc["least_radius"] <= arc["radius"] <= arc["greatest_radius"], "radii")
        check(len(arc["radii"]) == len(arc["inscribed_radii"]) == len(points) == len(arc["junctions"]) + 1, "points of an arc")
        check(all(0 <= b <= a for a, b in zip(arc["radii"], arc["inscribed_radii"])), "the radii of a point")
        outside = [i for i, is_in_junction in enumerate(arc["junctions"]) if not is_in_junction]
        check(set(arc["junctions"]) <= {0, 1} and (not outside or outside == list(range(outside[0], outside[-1] + 1))),
              "what lies in junctions is not at the ends of an arc")
        for end, segments in ((0, arc["junctions"][:1]), (1, arc["junctions"][-1:])):
            check(not any(segments) or nodes[ends[end]]["kind"] == "junction" or not outside, "a junction without a node")
    kinds = ["end" if degree == 1 else "loop" if degree == 2 else "junction" for degree in degrees]
    check(kinds == [node["kind"] for node in nodes], "the kinds of nodes")
    components = sum(root(i) == i for i in range(len(nodes)))
    counts = {"components": components, "arcs": len(arcs), "ends": kinds.count("end"),
              "junctions": kinds.count("junction"), "loops": len(arcs) - len(nodes) + components}
    check(counts == {key: known[key] for key in counts}, f"the counts are {counts}")
    check(sum(node["value"] == 0 for node in nodes) == components, "there is not one root for each component")
    if not data["surface"]["is_decimated"]:
        check(sum(arc["vertices"] for arc in arcs) == sum(place >= 0 for place in surface.places), "the vertices of arcs")
    check(all(-1 - len(nodes) < place < len(arcs) for place in surface.places), "there is no such node or arc")
    check(data["levels"] == [{"threshold": 0, "arcs": list(range(len(arcs)))}], "the levels of a skeleton")


def check_graph(graph, surface, columns, arc_numbers):
    nodes, arcs = graph["nodes"], graph["arcs"]
    for node in nodes:
        node["value"] = value_of(node["value"])
        check(node["kind"] in ("minimum", "maximum", "saddle", "degree-two", "isolated"), node["kind"])
        check(all(abs(x) <= 11 * surface.size for x in node["point"]), "a node is far away")
    for arc in arcs:
        lower, upper = nodes[arc["source"]], nodes[arc["target"]]
        check(lower["value"] <= upper["value"], "an arc does not ascend")
        line, plane = arc["polyline"], arc["plane"]
        check(line[:3] == lower["point"] and line[-3:] == upper["point"], "an arc does not lead from node to node")
        check(all(math.isfinite(x) for x in line + plane), "an infinite coordinate")
        check([plane[0], plane[-2]] == [lower["column"], upper["column"]], "a drawn arc is beside its nodes")
        for height, node in ((plane[1], lower), (plane[-1], upper)):
            check(height == node["value"] or math.isinf(node["value"]), "a node is not at its value")
        check(plane[1::2] == sorted(plane[1::2]), "a drawn arc does not ascend")
        for key in ("persistence", "length", "area", "vertices"):
            check(value_of(arc[key]) >= 0, key)
        check(columns <= arc.keys(), "an arc has no number for a column")
    check(all(-1 - len(nodes) < number < len(arcs) for number in arc_numbers), "there is no such node or arc")


# Each step of a chain ascends along an edge, but for those to where the next piece begins.
def check_chain(arc, nodes, surface, edges):
    chain = arc["chain"]
    order = [(surface.values[v], v) for v in chain]
    upper = nodes[arc["target"]]
    for i in range(len(chain) - 1):
        is_step = (chain[i], chain[i + 1]) in edges and order[i] < order[i + 1]
        check(is_step or surface.values[chain[i]] >= surface.values[chain[i + 1]], "a chain has a gap")
    check(surface.values[chain[0]] == nodes[arc["source"]]["value"], "a chain begins above its node")
    check(surface.values[chain[-1]] >= upper["value"], "a chain ends below its node")


def check_contours(arc, nodes):
    places = [contour["t"] for contour in arc["contours"]]
    check(places and places == sorted(places) and 0 < places[0] and places[-1] < 1, "the places of contours")
    for contour in arc["contours"]:
        check(len(numbers(contour["points"], "f")) % 3 == 0, "a point of a contour lacks a coordinate")
        value = value_of(contour["value"])
        check(nodes[arc["source"]]["value"] <= value <= nodes[arc["target"]]["value"], "a contour beyond its arc")


# Where arcs are joined, their mean is that of what they have taken up, weighted by area.
def check_means(arcs, level):
    for number, arc in enumerate(level["graph"]["arcs"]):
        taken_up = [arcs[i] for i, new_number in enumerate(level["arcs"]) if new_number == number]
        areas, means = zip(*([value_of(other[name]) for name in ("area", "mean_value")] for other in taken_up))
        area, mean = (value_of(arc[name]) for name in ("area", "mean_value"))
        if area > 0 and all(map(math.isfinite, means)):
            expected = sum(a * m for a, m in zip(areas, means)) / sum(areas)
            check(is_near([mean], [expected], max(map(abs, means))), "the mean of joined arcs")


def check_levels(data, surface):
    graph, levels = data["graph"], data["levels"]
    check(1 <= len(levels) <= 32 and levels[0]["threshold"] == 0 and "graph" not in levels[0], "the first level")
    check(levels[0]["arcs"] == list(range(len(graph["arcs"]))), "the arcs of the first level")
    number_of_arcs, threshold = len(graph["arcs"]), 0
    for level in levels[1:]:
        check(level["threshold"] > threshold and len(level["graph"]["arcs"]) < number_of_arcs, "the order of levels")
        threshold, number_of_arcs = level["threshold"], len(level["graph"]["arcs"])
        check(len(level["arcs"]) == len(graph["arcs"]), "the arcs of a level")
        check_graph(level["graph"], surface, columns_of(data), level["arcs"])
        if len(level["graph"]["nodes"]) == 2 and len(graph["nodes"]) < len(surface.places) == sum(
                arc["vertices"] for arc in graph["arcs"]) + len(graph["nodes"]):
            check(level["graph"]["arcs"][0]["vertices"] == len(surface.places) - 2, "vertices are lost")
        check_means(graph["arcs"], level)
        vertices = [node["vertex"] for node in graph["nodes"]]
        new_vertices = [node["vertex"] for node in level["graph"]["nodes"]]
        for number, arc in enumerate(level["graph"]["arcs"]):
            ends = [[vertices[graph["arcs"][part][end]] for part in arc["parts"]] for end in ("source", "target")]
            check(ends[0][0] == new_vertices[arc["source"]] and ends[1][-1] == new_vertices[arc["target"]]
                  and ends[0][1:] == ends[1][:-1], "the parts of an arc do not follow each other")
            check(all(level["arcs"][part] == number for part in arc["parts"]), "a part is of another arc")


def read_off(path):
    with open(path) as file:
        words = file.read().split()
    number_of_vertices, number_of_faces = int(words[1]), int(words[2])
    coordinates = [float(word) for word in words[4:4 + 3 * number_of_vertices]]
    corners = [int(word) for word in words[4 + 3 * number_of_vertices:]]
    return (list(zip(coordinates[::3], coordinates[1::3], coordinates[2::3])),
            [tuple(corners[4 * i + 1:4 * i + 4]) for i in range(number_of_faces)])


# A vertex of a decimated surface is one of the mesh, whose points are distinct.
def check_decimated_mesh(surface, points):
    check(surface.origin == [0, 0, 0], "the mesh is far away")
    numbers_of_points = {struct.pack("<3f", *point): i for i, point in enumerate(points)}
    codes = [struct.pack("<3f", *point) for point in surface.points]
    check(all(code in numbers_of_points for code in codes), "a vertex is none of the mesh")
    surface.origins = [numbers_of_points[code] for code in codes]
    check(len(set(surface.origins)) == len(surface.origins), "a vertex is there twice")


def check_coordinate(surface, points, coordinate):
    expected = [points[origin][coordinate] for origin in surface.origins]
    check(surface.values == expected, "vertices have other values")


def check_mesh(surface, points, triangles):
    check(len(points) == len(surface.points), "the mesh has other vertices")
    for shown, point in zip(surface.points, points):
        check(is_near(shown, [x - o for x, o in zip(point, surface.origin)], surface.size), "a vertex elsewhere")
    smallest_first = [sorted((t, t[1:] + t[:1], t[2:] + t[:2]))[0] for t in triangles]
    shown_first = [sorted((t, t[1:] + t[:1], t[2:] + t[:2]))[0] for t in surface.triangles]
    check(smallest_first == shown_first, "the mesh has other faces")


def check_curves(data, surface, path):
    with open(path) as file:
        lines = [[float(word) for word in line.split()][1:] for line in file]
    check(len(lines) == len(data["curves"]), "there are not as many curves")
    for line, curve in zip(lines, data["curves"]):
        shown = numbers(curve["points"], "f")
        expected = line[:-3] if curve["is_closed"] else line
        expected = [x - surface.origin[i % 3] for i, x in enumerate(expected)]
        check(is_near(shown, expected, surface.size), "a curve is elsewhere")


def check_value(data, path, expected):
    value = data
    for key in path.split("."):
        value = len(value) if key == "length" else value[int(key) if isinstance(value, list) else key]
    check(value == json.loads(expected), f"{path} is {value}, not {expected}")


def check_reeb_graph(data, surface):
    graph = data["graph"]
    check_graph(graph, surface, columns_of(data), surface.places)
    edges = {(t[i], t[j]) for t in surface.triangles for i in range(3) for j in range(3) if i != j}
    for arc in graph["arcs"]:
        if data["surface"]["is_decimated"]:
            check(arc["chain"] is None, "a chain on another mesh")
            check_contours(arc, graph["nodes"])
        else:
            check(arc["contours"] is None, "contours that the page can trace")
            check_chain(arc, graph["nodes"], surface, edges)
    check_levels(data, surface)


def main(path, title, *arguments):
    with open(path, encoding="utf-8") as file:
        page = Page(file.read())
    data = page.data
    check(page.scripts == 3, f"{page.scripts} scripts")
    check(data["version"] == 1 and data["generator"].startswith("reeb_graph "), "the version")
    check(page.title == data["title"] == title, f"the title is {page.title}")
    surface = Surface(data["surface"])
    (check_skeleton if data.get("skeleton") else check_reeb_graph)(data, surface)
    low, high = data["field"]["lowest"], data["field"]["highest"]
    check(all(low <= value <= high for value in surface.values if math.isfinite(value)), "the range of the field")
    if data["surface"]["is_decimated"]:
        check(len(surface.triangles) < data["surface"]["faces_of_input"], "nothing is decimated")
    else:
        check(len(surface.triangles) == data["surface"]["faces_of_input"], "the number of faces")
    for argument in arguments:
        key, value = argument.split("=", 1)
        if key == "vertex_arcs":
            with open(value) as file:
                places = [int(number) if kind == "arc" else -1 - int(number) for kind, number in map(str.split, file)]
            check(surface.places == [places[origin] for origin in surface.origins], "vertices have other arcs")
        elif key == "mesh":
            points, triangles = read_off(value)
            if data["surface"]["is_decimated"]:
                check_decimated_mesh(surface, points)
            else:
                check_mesh(surface, points, triangles)
        elif key == "coordinate":
            check_coordinate(surface, points, int(value))
        elif key == "patches":
            with open(value) as file:
                check(surface.patches == [int(line) for line in file], "faces have other patches")
        elif key == "curves":
            check_curves(data, surface, value)
        else:
            check_value(data, key, value)


main(*sys.argv[1:])
