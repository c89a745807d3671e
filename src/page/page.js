// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* global ColorBar, Drawing, Facts, GraphView, Scene, colorsOfPartners, distinctColors, element, findPatchNeighbors,
   formatValue, kindColors, makeContourTracer, plural, readPageData, setUpControls, showFailure, showTexts */

// What the page does: it holds what is pointed at and kept, and tells the view, the drawing and the texts.

const themes = {
  light: {
    line: [0.13, 0.14, 0.18], dim: [0.86, 0.86, 0.88], outline: [0.1, 0.1, 0.12], curve: [0.1, 0.1, 0.12],
    contour: [0.93, 0.08, 0.38], junction: [0.58, 0.6, 0.66]
  },
  dark: {
    line: [0.95, 0.95, 0.97], dim: [0.25, 0.26, 0.3], outline: [0.05, 0.05, 0.07], curve: [0.97, 0.97, 0.97],
    contour: [1, 0.27, 0.5], junction: [0.5, 0.52, 0.58]
  }
};

class Page {
  constructor(data) {
    this.data = data;
    this.trace = makeContourTracer(data);
    this.state = {
      level: 0, opacity: 0.55,
      coloring: data.skeleton || data.partners ? "arcs" : data.surface.facePatches ? "patches" : "field",
      pointed: null, kept: null, place: 0.5, pointedPlace: 0.5, contour: null, ball: null
    };
    this.views = data.levels.map(() => null);
    showTexts(data);
    this.facts = new Facts(data);
    this.colorBar = new ColorBar(element("color_bar"), data);
    this.drawing = new Drawing(element("drawing"), data, {
      point: (target, place) => this.point(target, place),
      keep: target => this.keep(target),
      drag: (arc, value, place) => data.skeleton ? this.setPlace(place) : this.dragTo(arc, value)
    });
    this.scene = this.makeScene();
    setUpControls(this);
    this.setUpTheme();
    this.setColoring(this.state.coloring);
    this.setOpacity(this.state.opacity);
    this.setLevel(0);
    new ResizeObserver(() => this.resize()).observe(element("canvas_frame"));
    new ResizeObserver(() => this.showDrawing()).observe(element("drawing_frame"));
  }

  // The view in space, or null in a browser that cannot show it.
  makeScene() {
    const {triangles, facePatches} = this.data.surface;
    try {
      const scene = new Scene(element("canvas"), this.data);
      if (facePatches) {
        this.patchColors = distinctColors(findPatchNeighbors(triangles, facePatches));
        scene.setPatchColors(this.patchColors);
      }
      return scene;
    } catch (error) {
      showFailure("This browser shows no WebGL, so that the surface cannot be drawn: " + error.message);
      return null;
    }
  }

  get view() {
    const level = this.state.level;
    this.views[level] = this.views[level] || new GraphView(this.data, level);
    return this.views[level];
  }

  // At a place of an arc, which is a share of its length.
  point(target, place = 0.5) {
    const {pointed, pointedPlace} = this.state;
    Object.assign(this.state, {pointed: target, pointedPlace: place});
    if (JSON.stringify(pointed) !== JSON.stringify(target))
      this.showTarget();
    else if (this.data.skeleton && place !== pointedPlace)
      this.showContour();
  }

  keep(target, place = this.state.place) {
    this.state.kept = target;
    this.state.pointed = null;
    this.state.place = Math.min(Math.max(place, 0.01), 0.99);
    element("place").value = this.state.place;
    this.showTarget();
    if (target !== null)
      this.facts.announce(target);
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

  // Of a skeleton, the ball at a place of a line, or at a node.
  showBall() {
    const {target, view, state, drawing} = this, {unit} = this.data.field;
    const ball = target === null ? null : target.arc === undefined ? view.ballAtNode(target.node)
      : view.ballAt(target.arc, state.pointed ? state.pointedPlace : state.place);
    state.ball = ball;
    if (this.scene)
      this.scene.setBall(ball);
    drawing.setMarker(ball ? drawing.pointAtPlace(ball.arc, ball.place) : null);
    this.colorBar.setMark(ball ? ball.value : null);
    const text = ball ? "inscribed radius " + formatValue(ball.inscribedRadius, unit) : "choose an arc";
    element("place_output").textContent = text;
    element("place").setAttribute("aria-valuetext", text + (ball ? " at " + formatValue(ball.way, unit) : ""));
    this.facts.show(target, ball);
  }

  showContour() {
    if (this.data.skeleton) {
      this.showBall();
      return;
    }
    const {target, view, state} = this;
    const arc = target !== null && target.arc !== undefined ? target.arc : null;
    const contour = arc === null ? null : this.trace(view, arc, state.place);
    state.contour = contour ? Object.assign({arc}, contour) : null;
    if (this.scene)
      this.scene.setContour(contour);
    const value = arc === null ? 0 : contour ? contour.value : view.value(arc, state.place);
    this.drawing.setMarker(arc === null ? null : this.drawing.pointAt(arc, value));
    this.colorBar.setMark(arc === null ? null : value);
    const text = arc === null ? "choose an arc" : "at " + formatValue(value, this.data.field.unit);
    element("place_output").textContent = text;
    element("place").setAttribute("aria-valuetext", text);
    this.facts.show(target, state.contour);
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
    this.arcColors = view.partners ? colorsOfPartners(view) : distinctColors(view.neighbors());
    if (this.scene)
      this.scene.setView(view, this.arcColors, node => kindColors[node.kind] || kindColors.isolated);
    this.facts.setView(view);
    this.showDrawing();
    this.drawing.revealTrunk();
    const text = level === 0 ? "all " + plural(view.arcs.length, "arc")
      : view.arcs.length + " of " + plural(data.graph.arcs.length, "arc") + ", ≥ "
        + formatValue(view.threshold, this.data.field.unit)
        + (data.ticks.some(tick => tick.level === level && tick.is_suggested) ? ", suggested" : "");
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

  setUpTheme() {
    const query = window.matchMedia("(prefers-color-scheme: dark)");
    const apply = () => this.scene && this.scene.setTheme(query.matches ? themes.dark : themes.light);
    query.addEventListener("change", apply);
    apply();
  }

  // For tests: what is shown, and where things are on the screen.
  describe() {
    const {state, view, scene} = this;
    return JSON.parse(JSON.stringify(Object.assign({}, state, {
      contour: state.contour && Object.assign({}, state.contour, {points: Array.from(state.contour.points)}),
      threshold: view.threshold, nodes: view.nodes.length, arcs: view.arcs.length,
      drawings: scene ? scene.drawings : 0, up: scene ? scene.pose.up : null,
      eye: scene ? scene.eye.camera.position.toArray() : null
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

  whereAtPlace(arc, place) {
    const {left, top} = element("drawing").getBoundingClientRect(), [x, y] = this.drawing.pointAtPlace(arc, place);
    return [left + x, top + y];
  }
}

function openPage() {
  try {
    const page = new Page(readPageData(element("reeb-graph-data").textContent));
    window.reebGraphPage = Object.freeze({
      state: () => page.describe(),
      whereOnCanvas: point => page.whereOnCanvas(point),
      whereInDrawing: (arc, t) => page.whereInDrawing(arc, t),
      whereAtPlace: (arc, place) => page.whereAtPlace(arc, place)
    });
  } catch (error) {
    showFailure("The page cannot be shown: " + error.message);
    throw error;
  }
}

openPage();
