// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* global addElement, element, formatNumber, measurePatches, plural, toHex */
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
  if (page.data.surface.facePatches)
    setUpPatches(page);
}

// The list of patches, the smallest first, which are hard to see: the one whose entry is pointed at or chosen lights
// up, and a click shows it from near.
function setUpPatches(page) {
  const {scene, data} = page, list = element("patches_list");
  const patches = measurePatches(data.surface).sort((p, q) => p.area - q.area);
  element("patches").hidden = false;
  element("patches_heading").textContent = plural(patches.length, "patch", "patches");
  patches.forEach(patch => {
    const row = addElement(list, "tr", ""), name = addElement(row, "th", ""), button = addElement(name, "button", "");
    name.scope = "row";
    button.type = "button";
    addElement(button, "i", "").style.background = toHex(page.patchColors[patch.number]);
    button.append(" " + patch.number);
    [patch.area, patch.borderLength].forEach(x => addElement(row, "td", formatNumber(x)));
    const light = number => () => scene.setLitPatch(number);
    button.addEventListener("click", () => {
      page.setColoring("patches");
      scene.setLitPatch(patch.number);
      scene.eye.showPart(patch.center.map((x, i) => x - scene.pose.center[i]), patch.size, patch.normal);
    });
    row.addEventListener("pointerenter", light(patch.number));
    row.addEventListener("pointerleave", light(null));
    button.addEventListener("focus", light(patch.number));
    button.addEventListener("blur", light(null));
  });
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
  element("level").max = data.levels.length - 1;
  addTicks(data.ticks);
  document.querySelectorAll("input[name=coloring]").forEach(input =>
    input.addEventListener("change", () => page.setColoring(input.value)));
  element("opacity").addEventListener("input", event => page.setOpacity(Number(event.target.value)));
  element("place").addEventListener("input", event => page.setPlace(Number(event.target.value)));
  element("level").addEventListener("input", event => page.setLevel(Number(event.target.value)));
}

function setUpLayers(scene) {
  ["show_graph", "show_curves"].forEach(id => element(id).addEventListener("change", () =>
    scene.setLayers({graph: element("show_graph").checked, curves: element("show_curves").checked})));
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
  canvas.addEventListener("pointerdown", event => {
    pressed = event.isPrimary ? place(event) : null;
  });
  canvas.addEventListener("pointerup", event => {
    const [x, y] = place(event);
    if (pressed && Math.hypot(x - pressed[0], y - pressed[1]) < 6)
      page.keep(scene.pick(x, y));
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
        page.point(scene.pick(...position));
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
