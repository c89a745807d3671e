# Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
#
# This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

"""The page in Chromium: what is seen, pointed at, and reached by keys and touch.

Usage: test_page_in_browser.py PROGRAM FOLDER
"""

import itertools
import json
import math
import pathlib
import subprocess
import sys
import time

from chromium import start_browser
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

program = pathlib.Path(sys.argv[1]).resolve()
neuron = pathlib.Path(__file__).resolve().parents[2] / "examples" / "Reeb_graph" / "data" / "neuron.off"
folder = pathlib.Path(sys.argv[2]).resolve()
browser = None


# Meshes and pages


def write_torus(name, rows, columns, holes=()):
    """A torus that stands upright, with bumps, so that it has a few more extrema; without the cells (row, column)."""
    lines = [f"OFF\n{rows * columns} {2 * (rows * columns - len(holes))} 0"]
    for i in range(rows):
        for j in range(columns):
            a, b = 2 * math.pi * i / rows, 2 * math.pi * j / columns
            radius = 1 + 0.15 * math.sin(5 * a) * math.cos(3 * b)
            r = 3 + radius * math.cos(b)
            lines.append(f"{r * math.cos(a)} {radius * math.sin(b)} {r * math.sin(a) + 0.3 * math.cos(a)}")
    for i in range(rows):
        for j in range(columns):
            p, q = i * columns, (i + 1) % rows * columns
            k = (j + 1) % columns
            if (i, j) in holes:
                continue
            lines.append(f"3 {p + j} {q + j} {q + k}\n3 {p + j} {q + k} {p + k}")
    (folder / name).write_text("\n".join(lines) + "\n")


def distance_out_of_torus(x, y, z):
    """How far a point is from what the torus encloses, about: negative inside."""
    a = math.atan2(z, x)
    for _ in range(4):
        a = math.atan2(z - 0.3 * math.cos(a), x)
    across = math.hypot(x, z - 0.3 * math.cos(a)) - 3
    return math.hypot(across, y) - 1 - 0.15 * math.sin(5 * a) * math.cos(3 * math.atan2(y, across))


def assert_lines_are_inside(data):
    """The lines of the arcs of a torus do not leave it, seen at their points and between these."""
    for number, arc in enumerate(data["graph"]["arcs"]):
        line = [arc["polyline"][i:i + 3] for i in range(0, len(arc["polyline"]), 3)]
        places = [[(1 - t) * x + t * y for x, y in zip(p, q)] for p, q in zip(line, line[1:]) for t in (0, 0.5)]
        worst = max(distance_out_of_torus(*place) for place in places)
        assert worst < 0.06, (number, worst)


def write_sphere_with_holes(name, rows, columns, holes):
    """A sphere from which disks around some directions have been cut."""
    points = [(0, 0, 1)]
    for i in range(1, rows):
        for j in range(columns):
            a, b = math.pi * i / rows, 2 * math.pi * j / columns
            points.append((math.sin(a) * math.cos(b), math.sin(a) * math.sin(b), math.cos(a)))
    points.append((0, 0, -1))

    def at(i, j):
        return 0 if i == 0 else len(points) - 1 if i == rows else 1 + (i - 1) * columns + j % columns

    triangles = []
    for i in range(rows):
        for j in range(columns):
            triangles += [(at(i, j), at(i + 1, j), at(i + 1, j + 1))] if i + 1 < rows else []
            triangles += [(at(i, j), at(i + 1, j + 1), at(i, j + 1))] if i > 0 else []

    def is_cut(triangle):
        center = [sum(points[v][k] for v in triangle) / 3 for k in range(3)]
        return any(sum(x * y for x, y in zip(center, hole)) > 0.93 * math.hypot(*hole) for hole in holes)

    triangles = [triangle for triangle in triangles if not is_cut(triangle)]
    numbers = {v: i for i, v in enumerate(sorted({v for triangle in triangles for v in triangle}))}
    (folder / name).write_text(f"OFF\n{len(numbers)} {len(triangles)} 0\n"
                               + "".join("%r %r %r\n" % points[v] for v in numbers)
                               + "".join(f"3 {numbers[a]} {numbers[b]} {numbers[c]}\n" for a, b, c in triangles))


def run(*arguments):
    subprocess.run([program, *map(str, arguments)], cwd=folder, check=True, stdout=subprocess.DEVNULL)


def load(name, width=1300, height=800):
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                            {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
    browser.get((folder / name).as_uri())
    wait_for_drawing()


def data_of_page():
    return json.loads(browser.execute_script("return document.getElementById('reeb-graph-data').textContent"))


# What the page shows


def state():
    return browser.execute_script("return window.reebGraphPage.state()")


def wait_for_drawing():
    browser.execute_async_script(
        "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 0)))")


def picture():
    """The colours of a grid of pixels of the canvas, without those that let the page through."""
    wait_for_drawing()
    return browser.execute_script("""
        const source = document.getElementById('canvas'), copy = document.createElement('canvas');
        copy.width = 200; copy.height = 150;
        const context = copy.getContext('2d', {willReadFrequently: true});
        context.drawImage(source, 0, 0, 200, 150);
        const pixels = context.getImageData(0, 0, 200, 150).data, colors = [];
        for (let i = 0; i < pixels.length; i += 4)
          colors.push(pixels[i + 3] < 16 ? -1 : (pixels[i] << 16) + (pixels[i + 1] << 8) + pixels[i + 2]);
        return colors;""")


def difference(first, second):
    return sum(a != b for a, b in zip(first, second))


def in_drawing(arc, t):
    return browser.execute_script("return window.reebGraphPage.whereInDrawing(arguments[0], arguments[1])", arc, t)


def on_canvas(point):
    return browser.execute_script("return window.reebGraphPage.whereOnCanvas(arguments[0])", list(point))


def mouse(kind, x, y, buttons=0):
    browser.execute_cdp_cmd("Input.dispatchMouseEvent", {
        "type": kind, "x": x, "y": y, "button": "left" if kind != "mouseMoved" else "none", "buttons": buttons,
        "clickCount": 1})
    wait_for_drawing()


def click(x, y):
    mouse("mouseMoved", x, y)
    mouse("mousePressed", x, y, 1)
    mouse("mouseReleased", x, y)


def touch(kind, *points):
    browser.execute_cdp_cmd("Input.dispatchTouchEvent", {
        "type": kind, "touchPoints": [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)]})
    wait_for_drawing()


def press(*keys):
    ActionChains(browser, duration=0).send_keys(*keys).perform()
    wait_for_drawing()


def focus(identifier):
    browser.execute_script("document.getElementById(arguments[0]).focus()", identifier)


def middle(arc):
    polyline = arc["polyline"]
    i = len(polyline) // 3 // 2
    return polyline[3 * i:3 * i + 3]


def range_of_arc(data, arc):
    nodes = data["graph"]["nodes"]
    return nodes[arc["target"]]["value"] - nodes[arc["source"]]["value"]


def long_arcs(data):
    arcs = data["graph"]["arcs"]
    limit = 0.1 * (data["field"]["highest"] - data["field"]["lowest"])
    return [k for k, arc in enumerate(arcs) if range_of_arc(data, arc) > limit]


def longest_arc(data):
    return max(range(len(data["graph"]["arcs"])), key=lambda k: range_of_arc(data, data["graph"]["arcs"][k]))


# Tests. Each is given the data of the page of the torus, which is open.


def test_canvas_is_drawn(data):
    pixels = picture()
    assert len(set(pixels)) > 200, "colours"
    covered = sum(pixel >= 0 for pixel in pixels) / len(pixels)
    assert 0.1 < covered < 0.95, covered
    drawings = [-1, state()["drawings"]]
    while len(drawings) < 20 and drawings[-1] != drawings[-2]:
        time.sleep(0.2)
        drawings.append(state()["drawings"])
    assert drawings[-1] == drawings[-2], "it is drawn though nothing changes"


def test_another_size_is_drawn_at_once(data):
    drawings = browser.execute_async_script("""
        const [done] = arguments, frame = document.getElementById('canvas_frame');
        let before = null;
        const observer = new ResizeObserver(() => { // called behind that of the page
          const drawings = window.reebGraphPage.state().drawings;
          if (before === null) {
            before = drawings;
            requestAnimationFrame(() => { frame.style.flex = '0 0 300px'; });
          } else {
            observer.disconnect();
            frame.style.flex = '';
            done(drawings - before);
          }
        });
        observer.observe(frame);""")
    assert drawings == 1, "the canvas is empty until the next frame"
    wait_for_drawing()


def test_pointing_in_the_plane_lights_the_piece(data):
    arc = longest_arc(data)
    mouse("mouseMoved", 2, 2)
    before = picture()
    mouse("mouseMoved", *in_drawing(arc, 0.4))
    assert state()["pointed"] == {"arc": arc}, (state()["pointed"], arc)
    assert difference(before, picture()) > 1000
    assert f"Arc {arc}" in browser.find_element(By.ID, "facts").text
    assert browser.find_elements(By.CSS_SELECTOR, f"path.arc.lit[data-arc='{arc}']")
    mouse("mouseMoved", 2, 2)
    assert state()["pointed"] is None and difference(before, picture()) < 30


def test_pointing_in_space(data):
    arcs, nodes = data["graph"]["arcs"], data["graph"]["nodes"]
    for number in long_arcs(data):
        polyline = arcs[number]["polyline"]
        pointed = []
        for i in range(0, len(polyline), 9):
            mouse("mouseMoved", *on_canvas(polyline[i:i + 3]))
            pointed.append(state()["pointed"])
        assert {"arc": number} in pointed, (number, pointed)
    # The surface itself: just below its top is the arc that ends there.
    browser.execute_script("""const opacity = document.getElementById('opacity');
                              opacity.value = 1; opacity.dispatchEvent(new Event('input'))""")
    top = max(range(len(nodes)), key=lambda i: nodes[i]["value"])
    vertex = nodes[top]["vertex"]
    x, y = on_canvas(browser.execute_script("""
        const bytes = Uint8Array.from(atob(arguments[0]), c => c.charCodeAt(0));
        return Array.from(new Float32Array(bytes.buffer).slice(3 * arguments[1], 3 * arguments[1] + 3))""",
                                            data["surface"]["positions"], vertex))
    mouse("mouseMoved", x, y + 5)
    assert state()["pointed"] == {"arc": next(i for i, arc in enumerate(arcs) if arc["target"] == top)}
    browser.execute_script("""const opacity = document.getElementById('opacity');
                              opacity.value = 0.55; opacity.dispatchEvent(new Event('input'))""")
    mouse("mouseMoved", 2, 2)


def contour_of_program(arc, t):
    run("contour", "torus.off", "--field", "z", "--arc", arc, "--t", repr(t), "--output", "contour.polylines.txt")
    return [float(x) for x in (folder / "contour.polylines.txt").read_text().split()[1:]]


def assert_contour_is_that_of_the_program():
    shown = state()
    expected = contour_of_program(shown["contour"]["arc"], shown["place"])
    points = shown["contour"]["points"] + (shown["contour"]["points"][:3] if shown["contour"]["isClosed"] else [])
    assert len(points) == len(expected)
    assert max(abs(a - b) for a, b in zip(points, expected)) < 1e-5


def test_slider_moves_the_contour(data):
    arc = longest_arc(data)
    click(*in_drawing(arc, 0.5))
    assert state()["kept"] == {"arc": arc}
    mouse("mouseMoved", 2, 2)
    before = picture()
    focus("place")
    press(Keys.ARROW_RIGHT * 7)
    assert abs(state()["place"] - 0.57) < 0.02
    assert_contour_is_that_of_the_program()
    assert difference(before, picture()) > 20
    press(Keys.HOME)
    assert_contour_is_that_of_the_program()


def test_dragging_moves_the_contour(data):
    arc = longest_arc(data)
    mouse("mouseMoved", *in_drawing(arc, 0.6))
    mouse("mousePressed", *in_drawing(arc, 0.6), 1)
    mouse("mouseMoved", *in_drawing(arc, 0.3), 1)
    mouse("mouseReleased", *in_drawing(arc, 0.3))
    assert abs(state()["place"] - 0.3) < 0.02 and state()["kept"] == {"arc": arc}
    assert_contour_is_that_of_the_program()
    mouse("mouseMoved", 2, 2)
    press(Keys.ESCAPE)
    assert state()["kept"] is None and state()["contour"] is None


def test_turning_is_not_choosing(data):
    x, y = on_canvas(middle(data["graph"]["arcs"][longest_arc(data)]))
    eye = state()["eye"]
    mouse("mouseMoved", x, y)
    mouse("mousePressed", x, y, 1)
    mouse("mouseMoved", x + 60, y + 10, 1)
    mouse("mouseReleased", x + 60, y + 10)
    assert state()["kept"] is None and state()["eye"] != eye
    browser.find_element(By.ID, "reset_view").click()
    wait_for_drawing()
    assert max(abs(a - b) for a, b in zip(state()["eye"], eye)) < 1e-6


def test_keys_reach_everything(data):
    focus("drawing")
    press(Keys.ENTER)
    reached = set()
    for _ in data["graph"]["arcs"]:
        press("n")
        reached.add(state()["kept"]["arc"])
        assert f"Arc {state()['kept']['arc']} of" in browser.find_element(By.ID, "announcement").get_attribute(
            "textContent")
    assert reached == set(range(len(data["graph"]["arcs"])))
    arcs = data["graph"]["arcs"]
    for key, shared in [(Keys.ARROW_UP, ("target", "source")), (Keys.ARROW_DOWN, ("source", "target"))]:
        for _ in range(3):
            before = state()["kept"]["arc"]
            press(key)
            after = state()["kept"]["arc"]
            assert after == before or arcs[before][shared[0]] == arcs[after][shared[1]]
    place = state()["place"]
    press(Keys.PAGE_UP)
    assert abs(state()["place"] - place - 0.05) < 1e-6
    browser.execute_script("document.activeElement.blur(); window.getSelection().removeAllRanges()")
    focused = set()
    for _ in range(16):
        press(Keys.TAB)
        focused.add(browser.execute_script("return document.activeElement.id || document.activeElement.name"
                                           " || document.activeElement.localName"))
    wanted = {"canvas", "zoom_in", "zoom_out", "reset_view", "drawing", "coloring", "opacity", "place", "level",
              "show_graph", "show_levels", "summary"}
    assert wanted <= focused, wanted - focused
    focus("canvas")
    for key in [Keys.ARROW_LEFT, Keys.ARROW_UP, "+", Keys.SHIFT + Keys.ARROW_RIGHT]:
        eye = state()["eye"]
        press(key)
        ActionChains(browser, duration=0).key_up(Keys.SHIFT).perform()
        assert state()["eye"] != eye, key
    press("0")
    press(Keys.ESCAPE)
    assert state()["kept"] is None


def test_switches_change_colors(data):
    before = picture()
    browser.find_element(By.CSS_SELECTOR, "input[value=arcs]").click()
    assert state()["coloring"] == "arcs" and difference(before, picture()) > 1000
    browser.find_element(By.CSS_SELECTOR, "input[value=field]").click()
    assert difference(before, picture()) < 30
    for identifier in ["show_levels", "show_graph"]:
        browser.find_element(By.ID, identifier).click()
        assert difference(before, picture()) > 100, identifier
        browser.find_element(By.ID, identifier).click()


def test_slider_simplifies(data):
    focus("level")
    press(Keys.END)
    simplified = state()
    assert simplified["arcs"] < len(data["graph"]["arcs"])
    assert len(browser.find_elements(By.CSS_SELECTOR, "path.arc")) == simplified["arcs"]
    assert simplified["threshold"] == data["levels"][-1]["threshold"]
    click(*in_drawing(0, 0.5))
    assert state()["kept"] == {"arc": 0} and len(state()["contour"]["points"]) >= 9
    focus("level")
    press(Keys.HOME)
    assert state()["arcs"] == len(data["graph"]["arcs"])
    ticks = browser.find_elements(By.CSS_SELECTOR, "#level_ticks option")
    assert [int(tick.get_attribute("value")) for tick in ticks] == [tick["level"] for tick in data["ticks"]] != []


def test_touch(data):
    arc = longest_arc(data)
    browser.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": True, "maxTouchPoints": 2})
    touch("touchStart", in_drawing(arc, 0.5))
    touch("touchMove", in_drawing(arc, 0.7))
    touch("touchEnd")
    assert state()["kept"] == {"arc": arc} and abs(state()["place"] - 0.7) < 0.02
    press(Keys.ESCAPE)
    place = on_canvas(middle(data["graph"]["arcs"][arc]))
    touch("touchStart", place)
    touch("touchEnd")
    assert state()["kept"] is not None
    left, top = browser.execute_script("const r = document.getElementById('canvas').getBoundingClientRect();"
                                       "return [r.left + r.width / 2, r.top + r.height / 2]")
    eye = state()["eye"]
    touch("touchStart", (left, top))
    touch("touchMove", (left + 50, top))
    touch("touchEnd")
    turned = state()["eye"]
    assert turned != eye and abs(math.hypot(*turned) - math.hypot(*eye)) < 1e-6
    touch("touchStart", (left - 20, top), (left + 20, top))
    touch("touchMove", (left - 60, top), (left + 60, top))
    touch("touchEnd")
    assert math.hypot(*state()["eye"]) < 0.8 * math.hypot(*turned)
    browser.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": False})


def test_narrow_dark_and_still(data):
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [
        {"name": "prefers-color-scheme", "value": "dark"}, {"name": "prefers-reduced-motion", "value": "reduce"}]})
    load("torus.html", 390, 800)
    width, canvas, drawing, background, duration = browser.execute_script("""
        return [document.documentElement.scrollWidth,
                document.getElementById('canvas').getBoundingClientRect().bottom,
                document.getElementById('drawing').getBoundingClientRect().top,
                getComputedStyle(document.body).backgroundColor,
                getComputedStyle(document.querySelector('path.arc')).transitionDuration]""")
    assert width <= 390 and drawing >= canvas
    assert max(int(x) for x in background[4:-1].split(",")) < 60
    assert duration == "0s"
    assert len(set(picture())) > 200
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})


def test_patches_and_curves():
    run("curves", "torus.off", "--field", "z", "--type", "branch", "--html", "curves.html", "--unit", "mm")
    load("curves.html")
    assert state()["coloring"] == "patches"
    before = picture()
    browser.find_element(By.ID, "show_curves").click()
    assert difference(before, picture()) > 50
    browser.find_element(By.CSS_SELECTOR, "input[value=field]").click()
    assert difference(before, picture()) > 1000
    assert "mm" in browser.find_element(By.ID, "color_bar").text


def hue_counts(pixels):
    """How many of the colours are those of handles, and of tunnels: orange, and blue."""
    colours = [(pixel >> 16, pixel >> 8 & 255, pixel & 255) for pixel in pixels if pixel >= 0]
    return (sum(r > 1.6 * g and g > 1.3 * b for r, g, b in colours), sum(b > 1.3 * g and g > 1.5 * r for r, g, b in colours))


def test_loops():
    """What handles shows: a list of loops, the shortest first, of which each lights up when it is pointed at."""
    run("handles", "torus.off", "--html", "loops.html")
    load("loops.html")
    browser.execute_script("""const opacity = document.getElementById('opacity');
                              opacity.value = 0; opacity.dispatchEvent(new Event('input'))""")
    assert not browser.find_element(By.ID, "show_graph").is_selected()
    handles, tunnels = hue_counts(picture())
    assert handles > 20 and tunnels > 50, (handles, tunnels)
    browser.find_element(By.ID, "show_curves").click()
    assert hue_counts(picture()) == (0, 0)
    browser.find_element(By.ID, "show_curves").click()
    assert [loop["kind"] for loop in data_of_page()["loops"]] == ["handle", "tunnel"]
    rows = browser.find_elements(By.CSS_SELECTOR, "#patches_list tr")
    assert len(rows) == 2 and "2 loops" in browser.find_element(By.ID, "patches_heading").text
    lengths = [float(row.find_elements(By.TAG_NAME, "td")[0].text) for row in rows]
    assert lengths == sorted(lengths)
    before = picture()
    ActionChains(browser).move_to_element(rows[0]).perform()
    first = picture()
    ActionChains(browser).move_to_element(rows[1]).perform()
    assert difference(before, first) > 50 and difference(first, picture()) > 50
    ActionChains(browser).move_to_element(browser.find_element(By.ID, "title")).perform()
    assert difference(before, picture()) == 0
    eye = state()["eye"]
    rows[0].find_element(By.TAG_NAME, "button").click()
    assert state()["eye"] != eye and hue_counts(picture())[0] > 2 * handles
    run("compute", "torus.off", "--field", "z", "--longest-loop", "loop.vtp", "--html", "loop.html")
    load("loop.html")
    assert browser.find_element(By.ID, "patches_heading").text == "most persistent loop"


def test_removal():
    """The page of a mesh whose handle has been removed shows what is left: no loop, and a surface without a tunnel."""
    run("handles", "torus.off", "--remove", 1, "--output", "clean.off", "--html", "clean.html")
    load("clean.html")
    data = data_of_page()
    assert data["loops"] == [] and data["surface"]["faces_of_input"] > 2 * 48 * 24
    assert not browser.find_element(By.ID, "patches").is_displayed()
    assert len(data["graph"]["arcs"]) == len(data["graph"]["nodes"]) - 1
    assert len(set(picture())) > 200


def assert_balls_follow(data):
    """Where a line is pointed at, in space and in the plane, is the ball there; in junctions the facts say so."""
    facts, arcs, nodes = browser.find_element(By.ID, "facts"), data["graph"]["arcs"], data["graph"]["nodes"]
    are_in_junctions = set()
    for number, arc in enumerate(arcs):
        last = len(arc["junctions"]) - 1
        for i in {1, (last + 1) // 2, last} - {0}:
            point = arc["polyline"][3 * i:3 * i + 3]
            mouse("mouseMoved", *on_canvas(point))
            if state()["pointed"] != {"arc": number}:
                continue
            ball = state()["ball"]
            step = max(math.dist(point, arc["polyline"][k:k + 3]) for k in (3 * i - 3, 3 * i + 3))
            assert math.dist(ball["point"], point) < 1.1 * step, (number, i)
            assert ball["inscribedRadius"] in arc["inscribed_radii"][i - 1:i + 2]
            assert (ball["junction"] is None) == ("the junction at point" not in facts.text), facts.text
            assert "radius of the ball" in facts.text
            are_in_junctions.add(ball["junction"] is not None)
    assert are_in_junctions == {False, True}
    number = max(range(len(arcs)), key=lambda k: arcs[k]["length"])
    for place in (0.2, 0.5, 0.7):
        mouse("mouseMoved", *browser.execute_script("return window.reebGraphPage.whereAtPlace(...arguments)", number, place))
        assert state()["pointed"] == {"arc": number} and abs(state()["ball"]["place"] - place) < 0.1
    node = next(k for k, node in enumerate(nodes) if node["kind"] == "junction")
    mouse("mouseMoved", *on_canvas(nodes[node]["point"]))
    assert state()["pointed"] == {"node": node} and math.dist(state()["ball"]["point"], nodes[node]["point"]) < 1e-6
    before = picture()
    mouse("mouseMoved", 2, 2)
    assert state()["ball"] is None and difference(before, picture()) > 30


def test_skeleton():
    """What skeleton shows: its own graph alone, as in its report, in space and in the plane; balls; and then the surface."""
    run("skeleton", "torus.off", "--html", "skeleton.html", "--unit", "mm")
    load("skeleton.html")
    data = data_of_page()
    nodes, arcs, known = data["graph"]["nodes"], data["graph"]["arcs"], data["skeleton"]
    assert len(browser.find_elements(By.CSS_SELECTOR, "#drawing .node")) == len(nodes)
    assert len(browser.find_elements(By.CSS_SELECTOR, "#drawing path.arc")) == len(arcs) == known["arcs"]
    assert browser.find_element(By.ID, "show_graph").is_selected() and state()["coloring"] == "arcs"
    alone, surface = picture(), browser.find_element(By.ID, "show_surface")
    assert 0.003 < sum(pixel >= 0 for pixel in alone) / len(alone) < 0.1 and not surface.is_selected()
    surface.click()
    assert sum(pixel >= 0 for pixel in picture()) > 0.15 * len(alone)
    surface.click()
    assert picture() == alone
    summary = browser.find_element(By.ID, "summary").text
    for name in ("ends", "junctions", "arcs", "loops"):
        assert any(f"{known[name]} {noun}" in summary for noun in (name, name[:-1])), (summary, name)
    before = picture()
    number = max(range(len(arcs)), key=lambda k: arcs[k]["length"])
    line = arcs[number]["polyline"]
    pointed = []
    for i in range(0, len(line), 3):
        mouse("mouseMoved", *on_canvas(line[i:i + 3]))
        pointed.append(state()["pointed"])
    assert {"arc": number} in pointed, pointed
    focus("drawing")
    press("n")
    assert state()["kept"] == {"arc": 0} and state()["contour"] is None and difference(before, picture()) > 50
    assert "least radius" in browser.find_element(By.ID, "facts").text and "mm" in browser.find_element(By.ID, "facts").text
    place, way = state()["place"], state()["ball"]["way"]
    press(Keys.PAGE_UP)
    assert abs(state()["place"] - place - 0.05) < 1e-6 and state()["ball"]["way"] > way
    assert "inscribed radius" in browser.find_element(By.ID, "place_output").text
    press(Keys.ESCAPE)
    assert state()["ball"] is None and picture() == before
    run("skeleton", neuron, "--html", "neuron.html")
    load("neuron.html")
    assert_balls_follow(data_of_page())


def test_wide_drawing():
    """Where a drawing is wider than its frame, buttons at its sides and the mouse move it; elsewhere there are none."""
    points, triangles = [], []
    for number in range(30):
        first = len(points)
        for i, j in itertools.product(range(12), range(8)):
            a, b = 2 * math.pi * i / 12, 2 * math.pi * j / 8
            points.append((9 * number + (3 + math.cos(b)) * math.cos(a), (3 + math.cos(b)) * math.sin(a), math.sin(b)))
            p, q, r, s = (first + 8 * (k % 12) + m % 8 for k, m in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
            triangles += [(p, q, r), (p, r, s)]
    (folder / "tori.off").write_text(f"OFF\n{len(points)} {len(triangles)} 0\n"
                                     + "".join("%r %r %r\n" % point for point in points)
                                     + "".join("3 %d %d %d\n" % triangle for triangle in triangles))
    run("skeleton", "tori.off", "--html", "tori.html")

    def scroll():
        wait_for_drawing()
        frame = "document.getElementById('drawing_frame')"
        return browser.execute_script(f"return [{frame}.scrollLeft, {frame}.scrollWidth, {frame}.clientWidth]")

    for width in (1300, 800, 400):
        load("tori.html", width, 900)
        left, right = (browser.find_element(By.ID, f"move_{side}") for side in ("left", "right"))
        browser.execute_script("document.getElementById('drawing_frame').scrollLeft = 0")
        position, inner, outer = scroll()
        assert inner > outer and not left.is_displayed() and right.is_displayed(), (width, inner, outer)
        browser.execute_script("arguments[0].click()", right)
        time.sleep(1)
        assert scroll()[0] > position + outer / 3 and left.is_displayed()
        browser.execute_script("document.getElementById('drawing_frame').scrollLeft = 1e6")
        assert scroll()[0] == inner - outer and not right.is_displayed()
    load("tori.html")
    browser.execute_script("document.getElementById('drawing_frame').scrollLeft = 0")
    start, top = browser.execute_script("const r = document.getElementById('drawing').getBoundingClientRect();"
                                        "return [r.left + 200, r.top + 5]")
    position = scroll()[0]
    mouse("mouseMoved", start, top)
    mouse("mousePressed", start, top, 1)
    mouse("mouseMoved", start - 30, top, 1)
    mouse("mouseMoved", start - 60, top, 1)
    mouse("mouseReleased", start - 60, top)
    assert scroll()[0] > position + 20
    load("skeleton.html")
    assert not any(browser.find_element(By.ID, f"move_{side}").is_displayed() for side in ("left", "right"))


def test_cut_scan():
    """What curves shows of a surface with holes: pieces, of which the list leads to each, curves, arcs, and up."""
    holes = [(0, 0, 1), (1, 0, 0.2), (-1, 0.3, 0), (0, 1, -0.3), (0.2, -1, -0.5)]
    write_sphere_with_holes("holes.off", 40, 60, holes)
    run("curves", "holes.off", "--field", "y", "--type", "pants", "--html", "holes.html", "--up", "-x")
    load("holes.html")
    assert state()["coloring"] == "patches" and state()["up"] == [-1, 0, 0]
    data = data_of_page()
    assert len(set(picture())) > 200 and len(data["curves"]) == len(holes) - 3
    rows = browser.find_elements(By.CSS_SELECTOR, "#patches_list tr")
    assert len(rows) == len(holes) - 2
    areas = [float(row.find_elements(By.TAG_NAME, "td")[0].text) for row in rows]
    assert areas == sorted(areas) and 8 < sum(areas) < 4 * math.pi
    assert all(float(row.find_elements(By.TAG_NAME, "td")[1].text) > 1 for row in rows)
    before, eye = picture(), state()["eye"]
    rows[0].find_element(By.TAG_NAME, "button").click()
    assert difference(before, picture()) > 1000 and state()["eye"] != eye
    browser.find_element(By.ID, "reset_view").click()
    browser.find_element(By.CSS_SELECTOR, "#up option[value='']").click()
    assert state()["up"][0] > -0.5  # the field was nearly a height along y
    assert difference(before, picture()) > 1000
    browser.find_element(By.CSS_SELECTOR, "input[value=arcs]").click()
    click(*in_drawing(longest_arc(data), 0.5))
    assert len(state()["contour"]["points"]) > 9
    assert state()["arcs"] == len(data["graph"]["arcs"])


def test_lines_inside_of_a_cut_scan():
    """Lines stay inside where curves has made the borders level, as those of a height do."""
    write_torus("pierced.off", 48, 24, [(5, 3), (20, 10), (33, 17), (40, 2)])
    run("curves", "pierced.off", "--type", "pants", "--html", "pierced.html")
    load("pierced.html")
    assert len(set(picture())) > 200
    assert_lines_are_inside(data_of_page())
    load("torus.html")
    assert_lines_are_inside(data_of_page())


def test_nothing_lies_on_the_surface(data):
    for width in [1400, 900, 400]:
        load("torus.html", width, 900)
        boxes = browser.execute_script("""
            const box = element => { const {left, top, right, bottom} = element.getBoundingClientRect();
                                     return [left, top, right, bottom]; };
            document.querySelector('input[value=arcs]').click();  // which hides the scale, but keeps its place
            return ['color_bar', 'view_buttons', 'canvas', 'plane'].map(id => box(document.getElementById(id)))""")
        assert boxes[0][2] > boxes[0][0]
        for a, b in itertools.combinations(boxes, 2):
            assert a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1], width
    load("torus.html")


def test_two_shapes():
    write_torus("first.off", 48, 24)
    write_torus("second.off", 40, 20)
    run("compare", "first.off", "second.off", "--field", "z", "--simplify", "20%", "--html", "two.html")
    load("two.html")
    data = data_of_page()
    assert "pairs of arcs" in browser.find_element(By.ID, "summary").text
    assert "An arc without a partner is gray." in browser.find_element(By.ID, "facts").text
    for shape in (0, 1):
        before, pair = picture(), data["partners"][0]
        arc = pair[shape] + shape * len(data["graph"]["arcs"])
        click(*in_drawing(arc, 0.5))
        assert f"Arc {pair[shape]} of {('first', 'second')[shape]}.off" in browser.find_element(By.ID, "facts").text
        assert len(browser.find_elements(By.CSS_SELECTOR, ".arc.lit")) == 2
        changed = [i % 200 // 100 for i, (old, new) in enumerate(zip(before, picture())) if old != new]
        assert min(changed.count(0), changed.count(1)) > 50  # in both halves
        press(Keys.ESCAPE)
    click(*on_canvas(middle(data["graph"]["arcs"][0])))
    assert state()["kept"] is not None and len(browser.find_elements(By.CSS_SELECTOR, ".arc.lit")) == 2


def test_least_surfaces():
    for name, off in [("vertex", "OFF\n1 0 0\n1 2 3\n"),
                      ("level", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 3 2\n")]:
        (folder / f"{name}.off").write_text(off)
        run("compute", f"{name}.off", "--field", "z", "--html", f"{name}.html")
        load(f"{name}.html")
        focus("drawing")
        press("n", Keys.PAGE_UP, Keys.ARROW_UP)
        assert state()["arcs"] == 0 or state()["contour"]["arc"] == 0
        assert_no_complaint(name)


def test_large_surface():
    write_torus("large.off", 500, 500)
    run("compute", "large.off", "--field", "z", "--html", "large.html")
    load("large.html")
    assert len(set(picture())) > 200
    data = data_of_page()
    assert data["surface"]["is_decimated"]
    assert "of 500,000 triangles" in browser.find_element(By.ID, "notice").text
    arc = longest_arc(data)
    click(*in_drawing(arc, 0.5))
    contour = state()["contour"]
    assert contour["arc"] == arc and len(contour["points"]) > 30


def assert_no_complaint(name):
    messages = [entry["message"] for entry in browser.get_log("browser")]
    assert not messages, f"{name}: {messages}"
    resources = browser.execute_script("return performance.getEntriesByType('resource').map(entry => entry.name)")
    assert all(resource.startswith("data:") for resource in resources), resources
    assert not browser.find_element(By.ID, "failure").is_displayed()


def test_all():
    write_torus("torus.off", 48, 24)
    run("compute", "torus.off", "--field", "z", "--html", "torus.html", "--unit", "mm")
    load("torus.html")
    data = data_of_page()
    for test in [test_canvas_is_drawn, test_another_size_is_drawn_at_once, test_pointing_in_the_plane_lights_the_piece,
                 test_pointing_in_space, test_slider_moves_the_contour, test_dragging_moves_the_contour, test_turning_is_not_choosing,
                 test_keys_reach_everything, test_switches_change_colors, test_slider_simplifies, test_touch,
                 test_nothing_lies_on_the_surface, test_narrow_dark_and_still]:
        test(data)
        assert_no_complaint(test.__name__)
        print(f"ok: {test.__name__}")
    for test in [test_patches_and_curves, test_loops, test_removal, test_skeleton, test_wide_drawing, test_cut_scan, test_lines_inside_of_a_cut_scan, test_two_shapes,
                 test_least_surfaces, test_large_surface]:
        test()
        assert_no_complaint(test.__name__)
        print(f"ok: {test.__name__}")


folder.mkdir(parents=True, exist_ok=True)
browser = start_browser()
try:
    browser.set_script_timeout(60)
    test_all()
finally:
    browser.quit()
