// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* global addElement, element, formatNumber, loopColors, measurePatches, normalized, plural, toHex */
/* exported setUpControls */

// What the controls, mouse, touch and keys call of the page.

function setUpControls(page) {
  setUpForm(page);
  element("drawing").addEventListener("keydown", event => pressKey(event, keysOfDrawing(page)));
  document.addEventListener("keydown", event => event.key === "Escape" && page.keep(null));
  if (!page.scene)
    return;
  setUpLayers(page.scene);
  setUpPointing(page);
  const {scene} = page;
  element("canvas").addEventListener("keydown", event => pressKey(event, keysOfView(scene.eye, event.shiftKey)));
  element("zoom_in").addEventListener("click", () => scene.eye.zoom(1.25));
  element("zoom_out").addEventListener("click", () => scene.eye.zoom(0.8));
  element("reset_view").addEventListener("click", () => scene.eye.reset());
  element("up").value = page.data.up;
  element("up").addEventListener("change", event => scene.setUp(event.target.value));
  setUpGraph(page);
  if (page.data.surface.facePatches)
    setUpPatches(page);
  if (page.data.loops.length > 0)
    setUpLoops(page);
}

// A list of what is on the surface: what its entry is pointed at or chosen for lights up. A row has a number, a color,
// a name, cells, and what a click does besides.
function setUpList(heading, columns, rows, light) {
  element("patches").hidden = false;
  element("patches_heading").textContent = heading;
  document.querySelectorAll("#patches thead th").forEach((cell, i) => {
    cell.textContent = columns[i];
  });
  rows.forEach(({number, color, name, cells, click}) => {
    const row = addElement(element("patches_list"), "tr", ""), cell = addElement(row, "th", "");
    const button = addElement(cell, "button", "");
    cell.scope = "row";
    button.type = "button";
    addElement(button, "i", "").style.background = toHex(color);
    button.append(" " + name);
    cells.forEach(text => addElement(row, "td", text));
    button.addEventListener("click", () => {
      light(number);
      click();
    });
    row.addEventListener("pointerenter", () => light(number));
    row.addEventListener("pointerleave", () => light(null));
    button.addEventListener("focus", () => light(number));
    button.addEventListener("blur", () => light(null));
  });
}

// The patches, the smallest first, which are hard to see: a click shows one from near.
function setUpPatches(page) {
  const {scene, data} = page;
  const patches = measurePatches(data.surface).sort((p, q) => p.area - q.area);
  setUpList(plural(patches.length, "patch", "patches"), ["patch", "area", "border"], patches.map(patch => ({
    number: patch.number, color: page.patchColors[patch.number], name: patch.number,
    cells: [patch.area, patch.borderLength].map(formatNumber),
    click: () => {
      page.setColoring("patches");
      scene.eye.showPart(patch.center.map((x, i) => x - scene.pose.center[i]), patch.size, patch.normal);
    }
  })), number => scene.setLitPatch(number));
}

// Where there are handles, the graph is hidden at first, as it lies on them.
function setUpGraph({scene, data}) {
  element("show_graph").checked = !data.loops.some(loop => loop.kind === "handle");
  element("show_surface").checked = !data.skeleton; // which is seen alone at first
  showLayers(scene);
}

function showLayers(scene) {
  const isShown = name => element("show_" + name).checked;
  scene.setLayers({surface: isShown("surface"), graph: isShown("graph"), curves: isShown("curves")});
}

// Handles, tunnels and other loops, the shortest first: a click shows one from near.
function setUpLoops(page) {
  const {scene, data} = page;
  const loops = data.loops.map((loop, number) => Object.assign({number}, loop)).sort((a, b) => a.length - b.length);
  const isOfGraph = loops.length === 1 && loops[0].kind === "loop"; // what --longest-loop writes
  const heading = isOfGraph ? "most persistent loop" : plural(loops.length, "loop");
  setUpList(heading, ["loop", "length", "persistence"], loops.map(loop => ({
    number: loop.number, color: loopColors[loop.kind], name: loop.kind + " " + loop.number,
    cells: [formatNumber(loop.length), loop.persistence === null ? "" : formatNumber(loop.persistence)],
    click: () => {
      const center = scene.centerOfCurve(loop.number);
      scene.eye.showPart(center, loop.length / Math.PI, normalized(center));
    }
  })), number => scene.setLitLoop(number));
}

// The thresholds that matter, as ticks of the slider.
function addTicks(ticks) {
  ticks.forEach(({level, is_suggested: isSuggested}) => {
    const option = addElement(element("level_ticks"), "option", "");
    option.value = level;
    option.label = isSuggested ? "suggested" : "";
  });
}

function setUpForm(page) {
  const {data} = page;
  element("controls").addEventListener("submit", event => event.preventDefault());
  element("patches_label").hidden = !data.surface.facePatches;
  element("curves_label").hidden = data.curves.length === 0;
  element("level_label").hidden = data.levels.length < 2;
  if (data.skeleton) { // Lines have no contours.
    element("place_name").textContent = "Ball";
    element("place_label").title = "Moves the ball along the arc that is kept";
  }
  element("level").max = data.levels.length - 1;
  addTicks(data.ticks);
  document.querySelectorAll("input[name=coloring]").forEach(input =>
    input.addEventListener("change", () => page.setColoring(input.value)));
  element("opacity").addEventListener("input", event => {
    if (!element("show_surface").checked)
      element("show_surface").click();
    page.setOpacity(Number(event.target.value));
  });
  element("place").addEventListener("input", event => page.setPlace(Number(event.target.value)));
  element("level").addEventListener("input", event => page.setLevel(Number(event.target.value)));
}

function setUpLayers(scene) {
  ["show_surface", "show_graph", "show_curves"].forEach(id =>
    element(id).addEventListener("change", () => showLayers(scene)));
  element("show_levels").addEventListener("change", event => scene.setLevelLines(event.target.checked ? 24 : 0));
}

// Moving the mouse points at things, once per picture; a click or a tap, which is no turn, keeps them.
function setUpPointing(page) {
  const {scene} = page, canvas = element("canvas");
  let pressed = null, isPickRequested = false, position = null;
  const place = event => {
    const rectangle = canvas.getBoundingClientRect();
    return [event.clientX - rectangle.left, event.clientY - rectangle.top];
  };
  const pick = (x, y) => {
    const target = scene.pick(x, y), isOnLine = page.data.skeleton && target !== null && target.arc !== undefined;
    return [target, isOnLine ? scene.placeNear(target.arc, x, y) : undefined];
  };
  canvas.addEventListener("pointerdown", event => {
    pressed = event.isPrimary ? place(event) : null;
  });
  canvas.addEventListener("pointerup", event => {
    const [x, y] = place(event);
    if (pressed && Math.hypot(x - pressed[0], y - pressed[1]) < 6)
      page.keep(...pick(x, y));
    pressed = null;
  });
  canvas.addEventListener("pointermove", event => {
    if (event.buttons !== 0 || event.pointerType === "touch")
      return;
    position = place(event);
    if (isPickRequested)
      return;
    isPickRequested = true;
    requestAnimationFrame(() => {
      isPickRequested = false;
      if (position)
        page.point(...pick(...position));
    });
  });
  canvas.addEventListener("pointerleave", () => {
    position = null;
    page.point(null);
  });
}

function pressKey(event, keys) {
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (event.ctrlKey || event.altKey || event.metaKey || !keys[key])
    return;
  event.preventDefault();
  keys[key]();
}

function keysOfView(eye, isShiftDown) {
  const go = (right, upwards) => () => isShiftDown ? eye.move(0.1 * right, 0.1 * upwards)
                                                   : eye.turn(0.12 * right, 0.12 * upwards);
  return {
    ArrowLeft: go(-1, 0), ArrowRight: go(1, 0), ArrowUp: go(0, 1), ArrowDown: go(0, -1),
    "+": () => eye.zoom(1.15), "=": () => eye.zoom(1.15), "-": () => eye.zoom(1 / 1.15),
    0: () => eye.reset()
  };
}

function keysOfDrawing(page) {
  const {view} = page;
  if (view.arcs.length === 0)
    return {};
  const walk = step => () => {
    const arc = page.state.kept === null ? 0 : step(page.keptArc === null ? view.arcAt(page.state.kept.node)
                                                                          : page.keptArc);
    page.keep({arc});
    page.drawing.reveal(arc);
  };
  const slide = step => () => page.keptArc !== null && page.setPlace(page.state.place + step);
  const zoomKeys = page.scene ? keysOfView(page.scene.eye, false) : {};
  return {
    ArrowUp: walk(arc => view.along(arc, true)), ArrowDown: walk(arc => view.along(arc, false)),
    ArrowRight: walk(arc => view.beside(arc, true)), ArrowLeft: walk(arc => view.beside(arc, false)),
    n: walk(arc => view.next(arc, 1)), p: walk(arc => view.next(arc, -1)),
    Home: walk(() => 0), End: walk(() => view.arcs.length - 1),
    PageUp: slide(0.05), PageDown: slide(-0.05),
    Enter: () => page.target && page.keep(page.target),
    "+": zoomKeys["+"], "-": zoomKeys["-"]
  };
}
