// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* global formatNumber, formatValue, kindColors, makeNodeShape, niceTicks, toHex, viridis */
/* exported addElement, element, nameOfField, plural, showFailure, showTexts, ColorBar */

// The elements of the page, and the texts around the view and the drawing.

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

function nameOfField(data) {
  return data.field.name || "field";
}

function nameWithUnit(data) {
  return nameOfField(data) + (data.field.unit ? " (" + data.field.unit + ")" : "");
}

function showFailure(message) {
  element("failure").textContent = message;
  element("failure").hidden = false;
}

const meaningsOfKinds = {
  minimum: "a contour begins", saddle: "contours join or split", maximum: "a contour ends",
  "degree-two": "a contour goes on", isolated: "a point alone",
  end: "a line ends", junction: "lines meet, gray near it", loop: "a line comes back"
};

// What the page does not show, as it would be too much.
function showNotice({surface, graph, field, arcsOfInput, threshold, shapes}) {
  const notices = [];
  if (shapes.length > 1)
    notices.push("Left " + shapes[0].title + ", right " + shapes[1].title + ", each as large as the other.");
  if (surface.isDecimated) {
    notices.push("Shown with " + (surface.triangles.length / 3).toLocaleString("en") + " of "
      + plural(surface.facesOfInput, "triangle") + ". The graph and its contours are those of all.");
  }
  if (arcsOfInput !== null) {
    notices.push("Simplified to " + graph.arcs.length.toLocaleString("en") + " of " + plural(arcsOfInput, "arc")
      + ": what is less persistent than " + formatValue(threshold, field.unit) + " is left out.");
  }
  element("notice").hidden = notices.length === 0;
  element("notice").textContent = notices.join(" ");
}

// What does not change.
function showTexts(data) {
  const {title, graph, generator} = data;
  document.title = title + (data.skeleton ? "" : " – Reeb graph");
  element("title").textContent = title;
  element("field_label").textContent = nameOfField(data);
  element("axis_name").textContent = "upwards: " + nameWithUnit(data);
  element("generator").textContent = "Made by " + generator + ".";
  showNotice(data);
  Object.keys(kindColors).filter(kind => graph.nodes.some(node => node.kind === kind)).forEach(kind => {
    const item = addElement(element("legend"), "li", "");
    const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    svg.setAttribute("viewBox", "0 0 16 16");
    svg.setAttribute("aria-hidden", "true");
    makeNodeShape(kind, 8, 8, 6, svg);
    item.appendChild(svg);
    addElement(item, "span", kind + ": " + meaningsOfKinds[kind]);
  });
}

// The colours of the field with values, and a mark at one of them.
class ColorBar {
  constructor(bar, data) {
    const {unit} = data.field, {low, high} = data.range, stops = [];
    for (let i = 0; i <= 16; ++i)
      stops.push(toHex(viridis(i / 16)));
    this.range = data.range;
    bar.setAttribute("aria-label", "Colors of " + nameOfField(data) + ", from " + formatValue(low, unit) + " to "
      + formatValue(high, unit));
    addElement(bar, "div", nameWithUnit(data), "bar_title");
    const scale = addElement(bar, "div", "", "bar_scale");
    scale.style.background = "linear-gradient(var(--upwards), " + stops.join(", ") + ")";
    niceTicks(low, high, 5).forEach(tick => {
      addElement(scale, "span", formatNumber(tick), "bar_tick").style.setProperty("--at", this.height(tick));
    });
    this.mark = addElement(scale, "div", "", "bar_marker");
  }

  height(value) {
    const {low, high} = this.range;
    return (high > low ? 100 * Math.min(Math.max((value - low) / (high - low), 0), 1) : 50) + "%";
  }

  // Marks a value, or none.
  setMark(value) {
    this.mark.hidden = value === null;
    if (value !== null)
      this.mark.style.setProperty("--at", this.height(value));
  }
}
