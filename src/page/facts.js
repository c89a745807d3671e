// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* global addElement, describeKind, element, formatNumber, formatValue, nameOfField, plural */
/* exported Facts */

// What is told of the graph, of an arc, and of a node.
class Facts {
  constructor(data) {
    this.data = data;
    this.unit = data.field.unit;
    this.nameOfVertex = data.skeleton ? "point" : "vertex"; // that of a node
  }

  setView(view) {
    this.view = view;
    this.loops = view.arcs.length - view.nodes.length + view.countComponents();
    const components = view.countComponents(), {skeleton} = this.data;
    if (this.data.partners) {
      element("summary").textContent = this.tellComparison();
      return;
    }
    const counts = skeleton ? [[skeleton.ends, "end"], [skeleton.junctions, "junction"]]
      : [[view.nodes.length, "node"]];
    counts.push([view.arcs.length, "arc"], [this.loops, "loop"]);
    element("summary").textContent = (skeleton ? "Skeleton: " : "Reeb graph of " + nameOfField(this.data) + ": ")
      + counts.map(([count, noun]) => plural(count, noun)).join(", ")
      + (components > 1 ? ", " + plural(components, "component") : "")
      + " on " + plural(this.data.surface.facesOfInput, "triangle");
  }

  tellComparison() {
    const {partners, distance} = this.data, alone = partners.filter(partner => partner === null).length;
    return "Compared by " + nameOfField(this.data) + ": distance " + formatValue(distance, this.unit) + ", "
      + plural((partners.length - alone) / 2, "pair") + " of arcs, " + plural(alone, "arc") + " without partner";
  }

  // Shows the facts of an arc {arc}, with its contour or ball, or of a node {node}, or how to read a graph.
  show(target, place) {
    const text = element("facts_text");
    text.replaceChildren();
    if (target === null)
      this.explain(text);
    else if (target.arc !== undefined)
      this.showArc(text, target.arc, place);
    else
      this.showNode(text, target.node, this.data.skeleton ? place : null);
  }

  // Tells those who do not see it.
  announce(target) {
    element("announcement").textContent = target.arc === undefined ? this.tellNode(target.node)
                                                                   : this.tellArc(target.arc);
  }

  explain(text) {
    element("facts_heading").textContent = "How to read it";
    const {skeleton} = this.data;
    const first = addElement(text, "p", skeleton ? "The skeleton runs inside of the surface, as the same graph here and"
      + " in the plane. Each of its lines is "
      : "Let the value rise, and follow the lines on which it is the same. Each line"
      + " in one piece is a contour. The surface that a contour sweeps, until it splits, joins or ends, is"
      + " a piece: ");
    addElement(first, "b", "an arc");
    first.append(skeleton ? ", with a piece of the surface around it. " : " of the graph. ");
    addElement(first, "b", "A node");
    first.append(skeleton ? " is where lines end or meet. In the plane, a node is as high as the way to it along the"
      + " lines is long, from the lowest node of its component." : " is where contours begin, join, split or end.");
    if (this.loops > 0) {
      addElement(text, "p", "A loop goes around a handle or hole of the surface. "
        + (this.data.partners ? "These surfaces have " : "This surface has ")
        + (this.loops === 1 ? "one." : this.loops.toLocaleString("en") + "."));
    }
    if (this.data.partners) {
      addElement(text, "p", "Arcs of one color are partners: they stand for the same part of both shapes. An arc"
        + " without a partner is gray.");
    }
    const canSimplify = this.view.arcs.length > 40 && this.data.levels.length > 1;
    addElement(text, "p", "Point at an arc, here or there, to see its piece; click to keep it"
      + (skeleton ? ", and move along it the largest ball in the surface." : ", and move its contour.")
      + (canSimplify ? " Simplify to see what matters most." : ""), "hint");
  }

  // At a contour, or at a ball in a skeleton.
  showArc(text, number, place) {
    const {view, unit} = this, arc = view.arcs[number];
    const end = node =>
      node.kind + " at " + formatValue(node.value, unit) + " (" + this.nameOfVertex + " " + node.vertex + ")";
    element("facts_heading").textContent = "Arc " + view.nameOf(number, "firstArc");
    addElement(text, "p", (this.data.skeleton ? "A line and its" : "One") + " piece of the surface. At its lower end "
      + this.tellEnd(arc.source)
      + ", at its upper end " + this.tellEnd(arc.target) + ".");
    const rows = this.data.skeleton ? this.showBall(text, place) : [];
    const partner = view.partners && view.partners[number];
    this.addList(text, rows.concat(
      view.partners ? [["partner", partner === null ? "none" : "arc " + view.nameOf(partner, "firstArc")]] : [],
      [["upper end", end(view.upper(number))], ["lower end", end(view.lower(number))]],
      this.data.columns.map(({name, unit: kind}) => [name.replace(/_/g, " "), this.format(arc[name], kind)]),
      place && !this.data.skeleton ? [["contour at", formatValue(place.value, unit)]] : []));
  }

  // Says in which junction a ball is, and returns what else there is to say of it.
  showBall(text, {way, length, inscribedRadius, radius, junction}) {
    const {view, unit} = this;
    if (junction !== null) {
      addElement(text, "p", "This place lies in the junction at point " + view.nodes[junction].vertex + ", where "
        + this.tellEnd(junction) + ".");
    }
    return [
      ["radius of the ball", formatValue(inscribedRadius, unit)],
      ["radius there", formatValue(radius, unit)],
      ["place", formatNumber(way) + " of " + formatValue(length, unit)]
    ];
  }

  // A number of an arc, in the unit of the field, without one, or a count.
  format(number, kind) {
    return kind === "field" ? formatValue(number, this.unit)
      : kind === "count" ? number.toLocaleString("en") : formatNumber(number);
  }

  showNode(text, number, ball) {
    const {view} = this, node = view.nodes[number];
    element("facts_heading").textContent = "Node " + view.nameOf(number, "firstNode") + ": " + node.kind;
    addElement(text, "p", "Here " + this.tellEnd(number) + ".");
    this.addList(text, [
      ["value", formatValue(node.value, this.unit)],
      [this.nameOfVertex, String(node.vertex)]
    ].concat(ball ? [
      ["inscribed radius", formatValue(ball.inscribedRadius, this.unit)],
      ["radius", formatValue(ball.radius, this.unit)]
    ] : [], [
      ["arcs above", this.listArcs(view.arcsAbove[number])],
      ["arcs below", this.listArcs(view.arcsBelow[number])]
    ]));
  }

  listArcs(arcs) {
    return arcs.map(arc => this.view.nameOf(arc, "firstArc")).join(", ") || "none";
  }

  addList(text, rows) {
    const list = addElement(text, "dl", "");
    rows.forEach(([name, value]) => {
      addElement(list, "dt", name);
      addElement(list, "dd", value);
    });
  }

  tellEnd(node) {
    const {view} = this;
    return describeKind(view.nodes[node], view.arcsBelow[node].length, view.arcsAbove[node].length);
  }

  tellArc(number) {
    const {view, unit} = this, lower = view.lower(number), upper = view.upper(number);
    const name = view.partners ? view.nameOf(number, "firstArc") : number + " of " + view.arcs.length;
    return "Arc " + name + ", from a " + lower.kind + " at "
      + formatValue(lower.value, unit) + " to a " + upper.kind + " at " + formatValue(upper.value, unit) + ", "
      + plural(view.arcs[number].vertices, "vertex", "vertices");
  }

  tellNode(number) {
    const node = this.view.nodes[number];
    return "Node " + this.view.nameOf(number, "firstNode") + ", a " + node.kind + " at "
      + formatValue(node.value, this.unit) + ": here "
      + this.tellEnd(number);
  }
}
