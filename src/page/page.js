// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* global readPageData, GraphView, makeContourTracer, describeKind, Scene, Drawing, makeNodeShape, distinctColors,
   findPatchNeighbors, kindColors, viridis, toHex, niceTicks, formatNumber, formatValue */

// What the page does: it holds what is pointed at and kept, and tells the view, the drawing and the texts.

const themes = {
  light: {
    line: [0.13, 0.14, 0.18], dim: [0.86, 0.86, 0.88], outline: [0.1, 0.1, 0.12], curve: [0.1, 0.1, 0.12],
    contour: [0.93, 0.08, 0.38]
  },
  dark: {
    line: [0.95, 0.95, 0.97], dim: [0.25, 0.26, 0.3], outline: [0.05, 0.05, 0.07], curve: [0.97, 0.97, 0.97],
    contour: [1, 0.27, 0.5]
  }
};

function element(id) {
  return document.getElementById(id);
}

function addElement(parent, name, text, className) {
  const child = document.createElement(name);
  child.textContent = text;
  if (className)
    child.className = className;
  parent.appendChild(child);
  return child;
}

function plural(count, noun, nouns) {
  return count.toLocaleString("en") + " " + (count === 1 ? noun : nouns || noun + "s");
}

class Page {
  constructor(data) {
    this.data = data;
    this.unit = data.field.unit;
    this.trace = makeContourTracer(data);
    this.state = {
      level: 0, coloring: data.surface.facePatches ? "patches" : "field", opacity: 0.55, pointed: null, kept: null,
      place: 0.5, contour: null
    };
    this.views = data.levels.map(() => null);
    this.makeTexts();
    this.drawing = new Drawing(element("drawing"), data, {
      point: target => this.point(target),
      keep: target => this.keep(target),
      drag: (arc, value) => this.dragTo(arc, value)
    });
    try {
      this.scene = new Scene(element("canvas"), data);
    } catch (error) {
      this.scene = null;
      fail("This browser shows no WebGL, so that the surface cannot be drawn: " + error.message);
    }
    this.setUpControls();
    this.setUpView();
    this.setUpKeys();
    this.setUpTheme();
    this.setColoring(this.state.coloring);
    this.setOpacity(this.state.opacity);
    this.setLevel(0);
    new ResizeObserver(() => this.resize()).observe(element("canvas_frame"));
    new ResizeObserver(() => this.showDrawing()).observe(element("drawing_frame"));
  }

  get view() {
    const level = this.state.level;
    this.views[level] = this.views[level] || new GraphView(this.data, level);
    return this.views[level];
  }

  // Texts

  makeTexts() {
    const {title, field, surface, graph, generator} = this.data;
    document.title = title + " – Reeb graph";
    element("title").textContent = title;
    element("field_label").textContent = field.name || "field";
    element("generator").textContent = "Made by " + generator + ".";
    const triangles = surface.triangles.length / 3;
    element("notice").hidden = !surface.isDecimated;
    element("notice").textContent = "Shown with " + triangles.toLocaleString("en") + " of "
      + plural(surface.facesOfInput, "triangle") + ". The graph and its contours are those of all.";
    const kinds = Object.keys(kindColors).filter(kind => graph.nodes.some(node => node.kind === kind));
    const meanings = {
      minimum: "a contour begins", saddle: "contours join or split", maximum: "a contour ends",
      "degree-two": "a contour goes on", isolated: "a point alone"
    };
    kinds.forEach(kind => {
      const item = addElement(element("legend"), "li", "");
      const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
      svg.setAttribute("viewBox", "0 0 16 16");
      svg.setAttribute("aria-hidden", "true");
      makeNodeShape(kind, 8, 8, 6, svg);
      item.appendChild(svg);
      addElement(item, "span", kind + ": " + meanings[kind]);
    });
    this.makeColorBar();
  }

  makeColorBar() {
    const bar = element("color_bar");
    const {low, high} = this.data.range;
    const stops = [];
    for (let i = 0; i <= 16; ++i)
      stops.push(toHex(viridis(i / 16)));
    const name = this.data.field.name || "field";
    bar.setAttribute("aria-label", "Colours of " + name + ", from " + formatValue(low, this.unit) + " to "
      + formatValue(high, this.unit));
    addElement(bar, "div", name + (this.unit ? " (" + this.unit + ")" : ""), "bar_title");
    const scale = addElement(bar, "div", "", "bar_scale");
    scale.style.background = "linear-gradient(to top, " + stops.join(", ") + ")";
    niceTicks(low, high, 5).forEach(tick => {
      const label = addElement(scale, "span", formatNumber(tick), "bar_tick");
      label.style.bottom = (high > low ? 100 * (tick - low) / (high - low) : 50) + "%";
    });
    this.barMarker = addElement(scale, "div", "", "bar_marker");
  }

  showSummary() {
    const {view} = this, components = this.countComponents(view);
    const loops = view.arcs.length - view.nodes.length + components;
    element("summary").textContent = "Reeb graph of " + (this.data.field.name || "the field") + ": "
      + [plural(view.nodes.length, "node"), plural(view.arcs.length, "arc"), plural(loops, "loop")].join(", ")
      + (components > 1 ? ", " + plural(components, "component") : "")
      + " on " + plural(this.data.surface.facesOfInput, "triangle");
    this.loops = loops;
  }

  countComponents(view) {
    const root = view.nodes.map((_, i) => i);
    const find = i => {
      while (root[i] !== i)
        i = root[i] = root[root[i]];
      return i;
    };
    view.arcs.forEach(arc => {
      root[find(arc.source)] = find(arc.target);
    });
    return root.filter((r, i) => r === i).length;
  }

  showFacts(target) {
    const text = element("facts_text");
    text.replaceChildren();
    if (target === null)
      this.explain(text);
    else if (target.arc !== undefined)
      this.showFactsOfArc(text, target.arc);
    else
      this.showFactsOfNode(text, target.node);
  }

  explain(text) {
    element("facts_heading").textContent = "How to read it";
    const first = addElement(text, "p", "Let the value rise, and follow the lines on which it is the same. Each closed"
      + " line is a contour. What one contour sweeps until it meets another one is a piece of the surface: ");
    addElement(first, "b", "an arc");
    first.append(" of the graph. ");
    addElement(first, "b", "A node");
    first.append(" is where contours begin, join, split or end.");
    if (this.loops > 0)
      addElement(text, "p", "A loop goes around a handle or hole of the surface: here " + this.loops + ".");
    const canSimplify = this.view.arcs.length > 40 && this.data.levels.length > 1;
    addElement(text, "p", "Point at an arc, here or there, to see its piece; click to keep it, and move its contour."
      + (canSimplify ? " Simplify to see what matters most." : ""), "hint");
  }

  showFactsOfArc(text, number) {
    const {view} = this, arc = view.arcs[number];
    element("facts_heading").textContent = "Arc " + number;
    addElement(text, "p", "One piece of the surface. At its lower end " + this.tellEnd(arc.source)
      + ", at its upper end " + this.tellEnd(arc.target) + ".");
    const list = addElement(text, "dl", "");
    const add = (name, value) => {
      addElement(list, "dt", name);
      addElement(list, "dd", value);
    };
    const end = node => view.nodes[node].kind + " at " + formatValue(view.nodes[node].value, this.unit)
      + " (vertex " + view.nodes[node].vertex + ")";
    add("upper end", end(arc.target));
    add("lower end", end(arc.source));
    add("persistence", formatValue(arc.persistence, this.unit));
    add("length", formatNumber(arc.length));
    add("area", formatNumber(arc.area));
    add("vertices", plural(arc.vertices, "vertex", "vertices").split(" ")[0]);
    if (this.state.contour)
      add("contour at", formatValue(this.state.contour.value, this.unit));
  }

  tellEnd(node) {
    const {view} = this;
    return describeKind(view.nodes[node], view.arcsBelow[node].length, view.arcsAbove[node].length);
  }

  showFactsOfNode(text, number) {
    const {view} = this, node = view.nodes[number];
    element("facts_heading").textContent = "Node " + number + ": " + node.kind;
    addElement(text, "p", "Here " + this.tellEnd(number) + ".");
    const list = addElement(text, "dl", "");
    const add = (name, value) => {
      addElement(list, "dt", name);
      addElement(list, "dd", value);
    };
    add("value", formatValue(node.value, this.unit));
    add("vertex", String(node.vertex));
    add("arcs above", view.arcsAbove[number].join(", ") || "none");
    add("arcs below", view.arcsBelow[number].join(", ") || "none");
  }

  announce(text) {
    element("announcement").textContent = text;
  }

  tellArc(number) {
    const {view} = this, arc = view.arcs[number];
    return "Arc " + number + " of " + view.arcs.length + ", from a " + view.lower(number).kind + " at "
      + formatValue(view.lower(number).value, this.unit) + " to a " + view.upper(number).kind + " at "
      + formatValue(view.upper(number).value, this.unit) + ", " + plural(arc.vertices, "vertex", "vertices");
  }

  tellNode(number) {
    const node = this.view.nodes[number];
    return "Node " + number + ", a " + node.kind + " at " + formatValue(node.value, this.unit) + ": here "
      + this.tellEnd(number);
  }

  // What is shown

  point(target) {
    const old = this.state.pointed;
    if (JSON.stringify(old) === JSON.stringify(target))
      return;
    this.state.pointed = target;
    this.showTarget();
  }

  keep(target) {
    this.state.kept = target;
    this.state.pointed = null;
    this.showTarget();
    if (target !== null)
      this.announce(target.arc === undefined ? this.tellNode(target.node) : this.tellArc(target.arc));
  }

  get target() {
    return this.state.pointed || this.state.kept;
  }

  get keptArc() {
    const {kept} = this.state;
    return kept !== null && kept.arc !== undefined ? kept.arc : null;
  }

  showTarget() {
    const {target} = this;
    element("place").disabled = this.keptArc === null;
    if (this.scene)
      this.scene.setLit(target);
    this.drawing.setLit(target);
    this.showContour();
  }

  showContour() {
    const {target, view, state} = this;
    const arc = target !== null && target.arc !== undefined ? target.arc : null;
    const contour = arc === null ? null : this.trace(view, arc, state.place);
    state.contour = contour ? Object.assign({arc}, contour) : null;
    if (this.scene)
      this.scene.setContour(contour);
    const value = arc === null ? 0 : contour ? contour.value : view.value(arc, state.place);
    this.drawing.setMarker(arc, value);
    const {low, high} = this.data.range;
    this.barMarker.hidden = arc === null;
    this.barMarker.style.bottom = (high > low ? 100 * (value - low) / (high - low) : 50) + "%";
    const text = arc === null ? "choose an arc" : "at " + formatValue(value, this.unit);
    element("place_output").textContent = text;
    element("place").setAttribute("aria-valuetext", text);
    this.showFacts(target);
  }

  setPlace(place) {
    this.state.place = isFinite(place) ? Math.min(Math.max(place, 0.01), 0.99) : 0.5;
    element("place").value = this.state.place;
    this.showContour();
  }

  dragTo(arc, value) {
    const low = this.view.lower(arc).value, high = this.view.upper(arc).value;
    this.setPlace(high > low ? (value - low) / (high - low) : 0.5);
  }

  setColoring(coloring) {
    this.state.coloring = coloring;
    document.querySelector("input[name=coloring][value=" + coloring + "]").checked = true;
    element("color_bar").hidden = coloring !== "field";
    if (this.scene)
      this.scene.setColoring(coloring);
    if (this.drawing.view)
      this.drawing.setArcColors(coloring === "arcs" ? this.arcColors : null);
  }

  setOpacity(opacity) {
    this.state.opacity = opacity;
    element("opacity").value = opacity;
    element("opacity_output").textContent = Math.round(100 * opacity) + " %";
    if (this.scene)
      this.scene.setOpacity(opacity);
  }

  setLevel(level) {
    const {state, data} = this;
    const parts = this.keptArc === null ? [] : this.view.arcs[this.keptArc].parts;
    state.level = level;
    state.pointed = state.kept = null;
    const {view} = this;
    const places = parts.map(part => view.placeOf(part)).filter(place => place >= 0);
    if (places.length > 0)
      state.kept = {arc: places[0]};
    this.arcColors = distinctColors(view.neighbors());
    if (this.scene)
      this.scene.setView(view, this.arcColors, node => kindColors[node.kind] || kindColors.isolated);
    this.showSummary();
    this.showDrawing();
    const text = level === 0 ? "all " + plural(view.arcs.length, "arc")
      : view.arcs.length + " of " + plural(data.graph.arcs.length, "arc") + ", ≥ "
        + formatValue(view.threshold, this.unit);
    element("level").value = level;
    element("level_output").textContent = text;
    element("level").setAttribute("aria-valuetext", text);
    this.showTarget();
  }

  showDrawing() {
    const frame = element("drawing_frame");
    this.drawing.show(this.view, this.state.coloring === "arcs" ? this.arcColors : null,
                      {width: frame.clientWidth, height: frame.clientHeight});
    this.showTarget();
  }

  resize() {
    const frame = element("canvas_frame");
    if (this.scene)
      this.scene.resize(frame.clientWidth, frame.clientHeight);
  }

  // Controls

  setUpControls() {
    const {data} = this;
    element("controls").addEventListener("submit", event => event.preventDefault());
    element("patches_label").hidden = !data.surface.facePatches;
    element("curves_label").hidden = data.curves.length === 0;
    element("level_label").hidden = data.levels.length < 2;
    element("level").max = data.levels.length - 1;
    document.querySelectorAll("input[name=coloring]").forEach(input =>
      input.addEventListener("change", () => this.setColoring(input.value)));
    element("opacity").addEventListener("input", event => this.setOpacity(Number(event.target.value)));
    element("place").addEventListener("input", event => this.setPlace(Number(event.target.value)));
    element("level").addEventListener("input", event => this.setLevel(Number(event.target.value)));
    if (!this.scene)
      return;
    ["show_graph", "show_curves"].forEach(id => element(id).addEventListener("change", () =>
      this.scene.setLayers({graph: element("show_graph").checked, curves: element("show_curves").checked})));
    element("show_levels").addEventListener("change", event => this.scene.setLevelLines(event.target.checked ? 24 : 0));
    if (data.surface.facePatches)
      this.scene.setPatchColors(distinctColors(findPatchNeighbors(data.surface.triangles, data.surface.facePatches)));
  }

  setUpView() {
    if (!this.scene)
      return;
    const {scene} = this, canvas = element("canvas");
    element("zoom_in").addEventListener("click", () => scene.zoom(1.25));
    element("zoom_out").addEventListener("click", () => scene.zoom(0.8));
    element("reset_view").addEventListener("click", () => scene.resetCamera());
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
        this.keep(scene.pick(x, y));
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
          this.point(scene.pick(...position));
      });
    });
    canvas.addEventListener("pointerleave", () => {
      position = null;
      this.point(null);
    });
  }

  setUpKeys() {
    if (this.scene)
      element("canvas").addEventListener("keydown", event => this.pressKey(event, this.keysOfView(event.shiftKey)));
    element("drawing").addEventListener("keydown", event => this.pressKey(event, this.keysOfDrawing()));
    document.addEventListener("keydown", event => event.key === "Escape" && this.keep(null));
  }

  pressKey(event, keys) {
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (event.ctrlKey || event.altKey || event.metaKey || !keys[key])
      return;
    event.preventDefault();
    keys[key]();
  }

  keysOfView(isShiftDown) {
    const {scene} = this;
    const go = (right, upwards) => () => isShiftDown ? scene.move(0.1 * right, 0.1 * upwards)
                                                     : scene.turn(0.12 * right, 0.12 * upwards);
    return {
      ArrowLeft: go(-1, 0), ArrowRight: go(1, 0), ArrowUp: go(0, 1), ArrowDown: go(0, -1),
      "+": () => scene.zoom(1.15), "=": () => scene.zoom(1.15), "-": () => scene.zoom(1 / 1.15),
      0: () => scene.resetCamera()
    };
  }

  keysOfDrawing() {
    const {view} = this;
    if (view.arcs.length === 0)
      return {};
    const walk = step => () => {
      const arc = this.state.kept === null ? 0 : step(this.keptArc === null ? this.arcAt(this.state.kept.node)
                                                                            : this.keptArc);
      this.keep({arc});
      this.drawing.reveal(arc);
    };
    const slide = step => () => this.keptArc !== null && this.setPlace(this.state.place + step);
    const zoomKeys = this.scene ? this.keysOfView(false) : {};
    return {
      ArrowUp: walk(arc => view.along(arc, true)), ArrowDown: walk(arc => view.along(arc, false)),
      ArrowRight: walk(arc => view.beside(arc, true)), ArrowLeft: walk(arc => view.beside(arc, false)),
      n: walk(arc => view.next(arc, 1)), p: walk(arc => view.next(arc, -1)),
      Home: walk(() => 0), End: walk(() => view.arcs.length - 1),
      PageUp: slide(0.05), PageDown: slide(-0.05),
      Enter: () => this.target && this.keep(this.target),
      "+": zoomKeys["+"], "-": zoomKeys["-"]
    };
  }

  arcAt(node) {
    return this.view.arcsAbove[node].concat(this.view.arcsBelow[node], 0)[0];
  }

  setUpTheme() {
    const query = window.matchMedia("(prefers-color-scheme: dark)");
    const apply = () => this.scene && this.scene.setTheme(query.matches ? themes.dark : themes.light);
    query.addEventListener("change", apply);
    apply();
  }

  // For tests: what is shown, and where arcs are on the screen.
  describe() {
    const {state, view, scene} = this;
    return JSON.parse(JSON.stringify(Object.assign({}, state, {
      contour: state.contour && Object.assign({}, state.contour, {points: Array.from(state.contour.points)}),
      threshold: view.threshold, nodes: view.nodes.length, arcs: view.arcs.length,
      drawings: scene ? scene.drawings : 0, eye: scene ? scene.camera.position.toArray() : null
    })));
  }

  whereOnCanvas(point) {
    const {left, top} = element("canvas").getBoundingClientRect(), [x, y] = this.scene.project(point);
    return [left + x, top + y];
  }

  whereInDrawing(arc, t) {
    const {left, top} = element("drawing").getBoundingClientRect();
    const [x, y] = this.drawing.pointAt(arc, this.view.value(arc, t));
    return [left + x, top + y];
  }
}

function fail(message) {
  element("failure").textContent = message;
  element("failure").hidden = false;
}

function openPage() {
  try {
    const page = new Page(readPageData(element("reeb-graph-data").textContent));
    window.reebGraphPage = Object.freeze({
      state: () => page.describe(),
      whereOnCanvas: point => page.whereOnCanvas(point),
      whereInDrawing: (arc, t) => page.whereInDrawing(arc, t)
    });
  } catch (error) {
    fail("The page cannot be shown: " + error.message);
    throw error;
  }
}

openPage();
