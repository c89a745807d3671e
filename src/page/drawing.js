// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* global element, formatNumber, kindColors, locate, makePlaneScale, nearestPlace, niceTicks, toHex, waysInPlane */
/* exported Drawing, makeNodeShape */

// The drawing of the graph in the plane, with an axis of values.

function makeSvg(name, attributes, parent, text) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  Object.keys(attributes).forEach(key => element.setAttribute(key, attributes[key]));
  if (text !== undefined)
    element.textContent = text;
  if (parent)
    parent.appendChild(element);
  return element;
}

// Kinds differ in shape as well as in colour.
function makeNodeShape(kind, x, y, r, parent) {
  const polygon = corners => makeSvg("polygon", {
    points: corners.map(([dx, dy]) => (x + r * dx).toFixed(2) + "," + (y + r * dy).toFixed(2)).join(" ")
  }, parent);
  const shapes = {
    minimum: () => polygon([[-1.15, -0.85], [1.15, -0.85], [0, 1.15]]),
    maximum: () => polygon([[-1.15, 0.85], [1.15, 0.85], [0, -1.15]]),
    "degree-two": () => polygon([[-0.75, -0.75], [0.75, -0.75], [0.75, 0.75], [-0.75, 0.75]]),
    isolated: () => polygon([[0, -1.2], [1.2, 0], [0, 1.2], [-1.2, 0]])
  };
  Object.assign(shapes, {end: shapes["degree-two"], loop: shapes.isolated});
  const shape = shapes[kind] ? shapes[kind]() : makeSvg("circle", {cx: x, cy: y, r}, parent);
  shape.setAttribute("fill", toHex(kindColors[kind] || kindColors.isolated));
  shape.setAttribute("class", "node");
  return shape;
}

class Drawing {
  // `on` has what is called: point(target or null, place), keep(target or null), and drag(arc, value, place). The place
  // is a share of the length of an arc.
  constructor(container, data, on) {
    this.container = container;
    this.data = data;
    this.on = on;
    this.dragged = null;
    this.pressed = null;
    this.isMoved = false; // by the mouse, beside the arcs
    container.addEventListener("pointermove", event => this.movePointer(event));
    container.addEventListener("pointerleave", () => this.dragged === null && on.point(null));
    container.addEventListener("pointerdown", event => this.pressPointer(event));
    // Scrolling by touch begins beside the graph too, and is no click.
    container.addEventListener("click", () => this.pressed === null && on.keep(null));
    ["pointerup", "pointercancel"].forEach(name => container.addEventListener(name, () => {
      this.dragged = null;
      this.isMoved = false;
    }));
    this.frame.addEventListener("scroll", () => this.showWhatIsBeyond());
    ["move_left", "move_right"].forEach((id, i) => element(id).addEventListener("click", () =>
      this.frame.scrollBy({left: (i - 0.5) * 1.4 * this.frame.clientWidth, behavior: "smooth"})));
  }

  get frame() {
    return this.container.parentElement;
  }

  move(pixels) {
    this.frame.scrollLeft -= pixels;
    if (pixels !== 0)
      this.pressed = {}; // This is no click.
  }

  // Shows on which sides the drawing goes on beyond its frame.
  showWhatIsBeyond() {
    const {scrollLeft, scrollWidth, clientWidth} = this.frame;
    this.frame.classList.toggle("is_wide", scrollWidth > clientWidth + 1);
    element("move_left").hidden = scrollLeft < 2;
    element("move_right").hidden = scrollLeft + clientWidth > scrollWidth - 2;
  }

  show(view, arcColors, frame) {
    this.view = view;
    this.scale = makePlaneScale(view, this.data.range, frame);
    const {width, height} = this.scale;
    const svg = makeSvg("svg", {width, height, "aria-hidden": "true"});
    const axis = makeSvg("svg", {width: this.scale.margin.left - 12, height, class: "axis", "aria-hidden": "true"});
    this.drawAxis(axis, svg);
    const arcs = makeSvg("g", {class: "arcs"}, svg), areas = makeSvg("g", {class: "areas"}, svg);
    this.arcPaths = view.arcs.map((arc, i) => {
      const d = this.pathOf(arc.plane);
      makeSvg("path", {d, class: "area", "data-arc": i}, areas);
      return makeSvg("path", {d, class: "arc", "data-arc": i}, arcs);
    });
    this.marker = makeSvg("circle", {class: "marker", r: this.scale.nodeRadius + 1, visibility: "hidden"}, svg);
    const nodes = makeSvg("g", {class: "nodes"}, svg);
    this.nodeShapes = view.nodes.map((node, i) => {
      const shape = makeNodeShape(node.kind, this.scale.x(node.column), this.scale.y(this.drawnValue(node.value)),
                                  this.scale.nodeRadius, nodes);
      shape.setAttribute("data-node", i);
      return shape;
    });
    this.container.replaceChildren(axis, svg);
    this.setArcColors(arcColors);
    this.setLit(null);
    this.showWhatIsBeyond();
  }

  drawAxis(axis, svg) {
    const {width, height, margin, y} = this.scale;
    const {low, high} = this.data.range;
    const lines = makeSvg("g", {class: "axis"}, svg);
    niceTicks(low, high, Math.max(2, Math.floor(height / 60))).forEach(tick => {
      makeSvg("line", {x1: margin.left - 15, x2: width - 4, y1: y(tick), y2: y(tick)}, lines);
      makeSvg("text", {x: margin.left - 20, y: y(tick) + 4, "text-anchor": "end"}, axis, formatNumber(tick));
    });
  }

  drawnValue(value) {
    return Math.min(Math.max(value, this.data.range.low), this.data.range.high);
  }

  pathOf(plane) {
    let d = "";
    for (let i = 0; i < plane.length; i += 2)
      d += (i ? "L" : "M") + this.scale.x(plane[i]).toFixed(2) + " " + this.scale.y(plane[i + 1]).toFixed(2);
    return d;
  }

  // Colours of arcs, or null for that of the text.
  setArcColors(colors) {
    this.arcPaths.forEach((path, i) => {
      path.style.stroke = colors ? toHex(colors[i]) : "";
    });
  }

  setLit(target) {
    this.container.classList.toggle("has_lit", target !== null && target.arc !== undefined);
    const arcs = target !== null && target.arc !== undefined ? this.view.litWith(target.arc) : [];
    this.arcPaths.forEach((path, i) => path.classList.toggle("lit", arcs.includes(i)));
    this.nodeShapes.forEach((shape, i) => {
      const isEnd = arcs.some(arc => this.view.arcs[arc].source === i || this.view.arcs[arc].target === i);
      shape.classList.toggle("lit", isEnd || (target !== null && target.node === i));
    });
  }

  // The mark on an arc, or none.
  setMarker(point) {
    this.marker.setAttribute("visibility", point === null ? "hidden" : "visible");
    if (point === null)
      return;
    this.marker.setAttribute("cx", point[0]);
    this.marker.setAttribute("cy", point[1]);
  }

  pointAt(arc, value) {
    return [this.scale.x(this.view.column(arc, value)), this.scale.y(this.drawnValue(value))];
  }

  pointsOf({plane}) {
    return plane.filter((_, i) => i % 2 === 0).map((x, i) => [this.scale.x(x), this.scale.y(plane[2 * i + 1])]);
  }

  pointAtPlace(number, place) {
    const arc = this.view.arcs[number], points = this.pointsOf(arc);
    const {end, share} = locate(waysInPlane(arc.plane), place);
    return points[end].map((x, i) => points[end - 1][i] + share * (x - points[end - 1][i]));
  }

  // The place of an arc that is nearest to the pointer.
  placeAt(number, event) {
    const arc = this.view.arcs[number], {left, top} = this.container.getBoundingClientRect();
    return nearestPlace(this.pointsOf(arc), waysInPlane(arc.plane), [event.clientX - left, event.clientY - top]);
  }

  // Scrolls to the arc that is there longest.
  revealTrunk() {
    const range = arc => this.view.upper(arc).value - this.view.lower(arc).value;
    const longest = this.view.arcs.reduce((best, _, arc) => range(arc) > range(best) ? arc : best, 0);
    if (this.view.arcs.length > 0)
      this.reveal(longest);
  }

  // Scrolls so far that an arc is seen.
  reveal(arc) {
    const {frame} = this;
    const [x] = this.pointAt(arc, this.view.value(arc, 0.5));
    if (x < frame.scrollLeft + this.scale.margin.left + 20 || x > frame.scrollLeft + frame.clientWidth - 30)
      frame.scrollLeft = x - frame.clientWidth / 2;
  }

  targetOf(event) {
    const data = event.target.dataset || {};
    if (data.arc !== undefined)
      return {arc: Number(data.arc)};
    return data.node === undefined ? null : {node: Number(data.node)};
  }

  valueAt(event) {
    return this.scale.value(event.clientY - this.container.getBoundingClientRect().top);
  }

  movePointer(event) {
    const target = this.targetOf(event);
    if (this.dragged !== null)
      this.on.drag(this.dragged, this.valueAt(event), this.placeAt(this.dragged, event));
    else if (this.isMoved && event.buttons === 1)
      this.move(event.movementX);
    else if (event.pointerType !== "touch")
      this.on.point(target, target && target.arc !== undefined ? this.placeAt(target.arc, event) : undefined);
  }

  pressPointer(event) {
    this.pressed = this.targetOf(event);
    if (this.pressed === null) {
      this.isMoved = event.pointerType === "mouse";
      return;
    }
    this.on.keep(this.pressed);
    if (this.pressed.arc === undefined)
      return;
    this.dragged = this.pressed.arc;
    this.on.drag(this.dragged, this.valueAt(event), this.placeAt(this.dragged, event));
    this.container.setPointerCapture(event.pointerId);
  }
}
