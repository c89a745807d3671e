// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* exported Halfedges, levelAtPlace, levelAboveValue, traceContour */

// Contours on the triangles, traced as Augmentation::contour() of the library does.

// The triangles' halfedges: 3 f + i leads from corner i of triangle f to its next corner.
class Halfedges {
  constructor(triangles, numberOfVertices) {
    this.triangles = triangles;
    this.firstAt = new Uint32Array(numberOfVertices + 1);
    for (let h = 0; h < triangles.length; ++h)
      ++this.firstAt[triangles[h] + 1];
    for (let v = 0; v < numberOfVertices; ++v)
      this.firstAt[v + 1] += this.firstAt[v];
    this.outgoing = new Uint32Array(triangles.length);
    const places = this.firstAt.slice();
    for (let h = 0; h < triangles.length; ++h)
      this.outgoing[places[triangles[h]]++] = h;
  }

  source(h) {
    return this.triangles[h];
  }

  next(h) {
    return h % 3 === 2 ? h - 2 : h + 1;
  }

  target(h) {
    return this.triangles[this.next(h)];
  }

  // The halfedge from u to v, or -1 if no triangle has it.
  find(u, v) {
    for (let i = this.firstAt[u]; i < this.firstAt[u + 1]; ++i) {
      if (this.target(this.outgoing[i]) === v)
        return this.outgoing[i];
    }
    return -1;
  }
}

// A level: which vertices are below it, and its value.
function levelAboveValue(values, value) {
  return {value, isBelow: v => values[v] <= value};
}

function levelBelowValue(values, value) {
  return {value, isBelow: v => values[v] < value};
}

function levelAboveVertex(values, vertex) {
  const value = values[vertex];
  return {value, isBelow: v => values[v] < value || (values[v] === value && v <= vertex)};
}

// The level at the fraction t of the values of an arc with these ends. If no value lies between them, the vertices of
// the chain are counted.
function levelAtPlace(values, chain, lower, upper, t) {
  const value = lower + t * (upper - lower);
  if (value >= lower && value < upper)
    return levelAboveValue(values, value);
  const numberOfHalfedges = chain.length - 1;
  const vertex = chain[Math.min(Math.floor(t * numberOfHalfedges), numberOfHalfedges - 1)];
  return values[vertex] < upper && value >= upper && isFinite(value) ? levelBelowValue(values, upper)
                                                                     : levelAboveVertex(values, vertex);
}

// The ends of the last edge at which the chain crosses the level. Where a piece of a chain ends, the next vertex need
// not be a neighbour.
function findCrossing(halfedges, chain, isBelow) {
  for (let i = chain.length - 2; i >= 0; --i) {
    const u = chain[i], v = chain[i + 1];
    if (isBelow(u) && !isBelow(v) && (halfedges.find(u, v) >= 0 || halfedges.find(v, u) >= 0))
      return [u, v];
  }
  return null;
}

// The edges that the contour crosses beyond the edge between `above` and `below`, each as [vertex above, vertex below]:
// on the side of the triangle that has the edge from above to below, or on the other side.
function walk(halfedges, above, below, isBelow, isForward) {
  const crossed = [];
  const enter = () => isForward ? halfedges.find(above, below) : halfedges.find(below, above);
  const start = enter();
  let h = start;
  while (h >= 0 && crossed.length <= halfedges.triangles.length) {
    const apex = halfedges.target(halfedges.next(h));
    if (isBelow(apex))
      below = apex;
    else
      above = apex;
    crossed.push([above, below]);
    h = enter();
    if (h === start)
      return {crossed, isClosed: true};
  }
  return {crossed, isClosed: false};
}

function crossingPoint(surface, [above, below], value, points) {
  const low = surface.values[below], high = surface.values[above];
  const fraction = (value - low) / (high - low);
  const t = isFinite(fraction) ? Math.min(Math.max(fraction, 0), 1) : 0.5;
  for (let i = 0; i < 3; ++i) {
    const from = surface.positions[3 * below + i];
    points.push(from + t * (surface.positions[3 * above + i] - from));
  }
}

// The points of the contour at which the chain crosses the level, with the higher side on the left, or null if it does
// not cross it.
function traceContour(surface, halfedges, chain, level) {
  const crossing = findCrossing(halfedges, chain, level.isBelow);
  if (!crossing)
    return null;
  const [below, above] = crossing;
  const {crossed, isClosed} = walk(halfedges, above, below, level.isBelow, true);
  const before = isClosed ? [] : walk(halfedges, above, below, level.isBelow, false).crossed.reverse();
  const edges = before.concat([[above, below]], isClosed ? crossed.slice(0, -1) : crossed);
  const points = [];
  edges.forEach(edge => crossingPoint(surface, edge, level.value, points));
  return {points, isClosed, value: level.value};
}
