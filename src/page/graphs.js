// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* global Halfedges, levelAtPlace, levelAboveValue, traceContour */
/* exported GraphView, locate, makeContourTracer, nearestPlace, describeKind, partsInJunctions, waysAlong,
   waysInPlane */

// How far the points of a line are from its first one, along it: in space, or in the plane upwards and downwards.
function waysAlong(polyline) {
  const ways = [0];
  for (let i = 3; i < polyline.length; i += 3)
    ways.push(ways[ways.length - 1] + Math.hypot(...[0, 1, 2].map(j => polyline[i + j] - polyline[i + j - 3])));
  return ways;
}

function waysInPlane(plane) {
  const ways = [0];
  for (let i = 3; i < plane.length; i += 2)
    ways.push(ways[ways.length - 1] + Math.abs(plane[i] - plane[i - 2]));
  return ways;
}

// The end of the segment at a place of a line, which is a share of its length, and the share of the segment before it.
function locate(ways, place) {
  const way = place * ways[ways.length - 1], end = Math.max(1, ways.findIndex(other => other >= way));
  const length = ways[end] - ways[end - 1];
  return {end, share: length > 0 ? (way - ways[end - 1]) / length : 0};
}

// The place of a line that is nearest to a point of a picture, in which its points are.
function nearestPlace(points, ways, [x, y]) {
  let way = 0, least = Infinity;
  for (let i = 1; i < points.length; ++i) {
    const [a, b] = points[i - 1], dx = points[i][0] - a, dy = points[i][1] - b, square = dx * dx + dy * dy;
    const share = square > 0 ? Math.min(Math.max(((x - a) * dx + (y - b) * dy) / square, 0), 1) : 0;
    const distance = Math.hypot(x - a - share * dx, y - b - share * dy);
    if (distance < least) {
      least = distance;
      way = ways[i - 1] + share * (ways[i] - ways[i - 1]);
    }
  }
  return way / ways[ways.length - 1] || 0;
}

// The parts of a line of a skeleton that lie in junctions.
function partsInJunctions({polyline, junctions}) {
  const parts = [];
  (junctions || []).forEach((isInJunction, i) => {
    if (!isInJunction)
      return;
    if (i === 0 || !junctions[i - 1])
      parts.push(polyline.slice(3 * i, 3 * i + 3));
    parts[parts.length - 1].push(...polyline.slice(3 * i + 3, 3 * i + 6));
  });
  return parts;
}

// The graph at a level of simplification: its nodes and arcs, what they stand for, and the ways along it.
class GraphView {
  constructor(data, number) {
    const level = data.levels[number];
    const graph = level.graph || data.graph;
    this.number = number;
    this.shapes = data.shapes;
    this.partners = data.partners;
    this.threshold = level.threshold;
    this.nodes = graph.nodes;
    this.arcs = graph.arcs.map((arc, i) => Object.assign({parts: [i]}, arc));
    this.arcsAbove = this.nodes.map(() => []);
    this.arcsBelow = this.nodes.map(() => []);
    this.arcs.forEach((arc, i) => {
      this.arcsAbove[arc.source].push(i);
      this.arcsBelow[arc.target].push(i);
    });
    this.placeOfGivenArc = level.arcs;
    this.placeOfGivenNode = makePlacesOfNodes(data.graph, level.arcs, this);
  }

  // The number of an arc for which the given arc or, with numbers beyond those of arcs, the given node stands, or that
  // of a node as -1 - number.
  placeOf(given) {
    const numberOfArcs = this.placeOfGivenArc.length;
    return given < numberOfArcs ? this.placeOfGivenArc[given] : this.placeOfGivenNode[given - numberOfArcs];
  }

  // What lights up with an arc: its partner does.
  litWith(arc) {
    return this.partners && this.partners[arc] !== null ? [arc, this.partners[arc]] : [arc];
  }

  // An arc or a node is named by its number in its shape, and by the shape where there are two.
  nameOf(number, first) {
    const shape = this.shapes.reduce((last, other) => number >= other[first] ? other : last);
    return number - shape[first] + (this.shapes.length > 1 ? " of " + shape.title : "");
  }

  value(arc, t) {
    const low = this.lower(arc).value, high = this.upper(arc).value;
    return low + t * (high - low);
  }

  lower(arc) {
    return this.nodes[this.arcs[arc].source];
  }

  upper(arc) {
    return this.nodes[this.arcs[arc].target];
  }

  // The horizontal place of an arc at a value, in columns. Near its ends it may go sideways, and hardly rise.
  column(arc, value) {
    const plane = this.arcs[arc].plane;
    if (value <= this.lower(arc).value)
      return plane[0];
    if (value >= this.upper(arc).value)
      return plane[plane.length - 2];
    for (let i = 2; i < plane.length; i += 2) {
      if (plane[i + 1] >= value) {
        const share = (value - plane[i - 1]) / (plane[i + 1] - plane[i - 1]);
        return plane[i - 2] + (isFinite(share) ? Math.max(share, 0) : 0) * (plane[i] - plane[i - 2]);
      }
    }
    return plane[plane.length - 2];
  }

  middleColumn(arc) {
    return this.column(arc, this.value(arc, 0.5));
  }

  // Arcs that share an end with each arc.
  neighbors() {
    return this.arcs.map((arc, i) => {
      const around = [arc.source, arc.target].map(node => this.arcsAbove[node].concat(this.arcsBelow[node]));
      return Array.from(new Set(around[0].concat(around[1]))).filter(j => j !== i);
    });
  }

  // The arc above or below an arc whose middle is nearest to it, or the arc itself at an end of the graph.
  along(arc, isUpwards) {
    const beyond = isUpwards ? this.arcsAbove[this.arcs[arc].target] : this.arcsBelow[this.arcs[arc].source];
    const distance = other => Math.abs(this.middleColumn(other) - this.middleColumn(arc));
    return beyond.reduce((best, other) => best === arc || distance(other) < distance(best) ? other : best, arc);
  }

  // The next arc to the right or to the left among those that have values in common with an arc.
  beside(arc, isRight) {
    const low = this.lower(arc).value, high = this.upper(arc).value;
    const position = other => {
      const from = Math.max(low, this.lower(other).value), to = Math.min(high, this.upper(other).value);
      return from <= to ? this.column(other, (from + to) / 2) - this.column(arc, (from + to) / 2) : NaN;
    };
    let best = arc, bestDistance = Infinity;
    this.arcs.forEach((_, other) => {
      const ahead = isRight ? position(other) : -position(other);
      const distance = ahead > 0 || (ahead === 0 && (other > arc) === isRight) ? ahead : Infinity;
      if (other !== arc && distance < bestDistance) {
        best = other;
        bestDistance = distance;
      }
    });
    return best;
  }

  // An arc at a node.
  arcAt(node) {
    return this.arcsAbove[node].concat(this.arcsBelow[node], 0)[0];
  }

  // The ball in the surface at the point of a line of a skeleton that is nearest to a place, with the radius of the
  // tube, the way up to there, the value, and the node of the junction that the place lies in, or null.
  ballAt(number, place) {
    const arc = this.arcs[number], ways = waysAlong(arc.polyline), length = ways[ways.length - 1];
    const {end, share} = locate(ways, place), i = share < 0.5 ? end - 1 : end, way = ways[i];
    const outside = arc.junctions.indexOf(0);
    const isAtSource = outside < 0 ? place < 0.5 : end - 1 < outside;
    return {
      arc: number, place: way / length || 0, way, length,
      point: arc.polyline.slice(3 * i, 3 * i + 3),
      radius: arc.radii[i],
      inscribedRadius: arc.inscribedRadii[i],
      value: Math.min(this.lower(number).value + way, this.upper(number).value + length - way),
      junction: arc.junctions[end - 1] ? (isAtSource ? arc.source : arc.target) : null
    };
  }

  ballAtNode(node) {
    const arc = this.arcAt(node);
    return this.ballAt(arc, this.arcs[arc].source === node ? 0 : 1);
  }

  countComponents() {
    const root = this.nodes.map((_, i) => i);
    const find = i => {
      while (root[i] !== i)
        i = root[i] = root[root[i]];
      return i;
    };
    this.arcs.forEach(arc => {
      root[find(arc.source)] = find(arc.target);
    });
    return root.filter((r, i) => r === i).length;
  }

  // The next or the previous arc by number.
  next(arc, step) {
    return (arc + step + this.arcs.length) % this.arcs.length;
  }
}

// What the given nodes belong to: nodes that are left keep themselves, other ones are where their arcs are.
function makePlacesOfNodes(given, placeOfGivenArc, view) {
  if (view.nodes === given.nodes)
    return given.nodes.map((_, i) => -1 - i);
  const numbers = new Map(view.nodes.map((node, i) => [node.vertex, i]));
  const places = given.nodes.map(node => numbers.has(node.vertex) ? -1 - numbers.get(node.vertex) : null);
  given.arcs.forEach((arc, i) => [arc.source, arc.target].forEach(node => {
    if (places[node] === null)
      places[node] = placeOfGivenArc[i];
  }));
  return places.map(place => place === null ? -1 : place);
}

// The part of an arc that has a value: the first given arc, from below, that ends above it.
function partAt(given, parts, value) {
  const isAlive = part => given.nodes[given.arcs[part].source].value <= value
    && value < given.nodes[given.arcs[part].target].value;
  const alive = parts.find(isAlive);
  return alive === undefined ? parts[parts.length - 1] : alive;
}

function nearest(contours, distance) {
  return contours.reduce((best, contour) => distance(contour) < distance(best) ? contour : best);
}

// A function that gives the contour of an arc of a view at a place between its ends, or null: traced on the surface, or
// the nearest of those that the program has found where the surface is decimated.
function makeContourTracer(data) {
  let halfedges = null;
  const trace = (chain, level) => {
    halfedges = halfedges || new Halfedges(data.surface.triangles, data.surface.values.length);
    return traceContour(data.surface, halfedges, chain, level);
  };
  return (view, arc, t) => {
    const value = view.value(arc, t), parts = view.arcs[arc].parts;
    const isWhole = parts.length === 1 && view.number === 0;
    const part = data.graph.arcs[isWhole ? parts[0] : partAt(data.graph, parts, value)];
    if (!part)
      return null;
    if (part.contours)
      return part.contours.length > 0 ? nearest(part.contours, contour => Math.abs(contour.value - value)) : null;
    if (!part.chain)
      return null;
    return trace(part.chain, isWhole
      ? levelAtPlace(data.surface.values, part.chain, view.lower(arc).value, view.upper(arc).value, t)
      : levelAboveValue(data.surface.values, value));
  };
}

// What happens at a node, in words.
function describeKind(node, numberBelow, numberAbove) {
  switch (node.kind) {
    case "minimum": return "a contour begins";
    case "maximum": return "a contour ends";
    case "isolated": return "is a point alone";
    case "end": return "a line ends";
    case "junction": return numberBelow + numberAbove + " lines meet";
    case "loop": return "a line comes back to where it begins";
    case "saddle":
      return numberBelow > 1 && numberAbove > 1 ? numberBelow + " contours meet and part into " + numberAbove
        : numberBelow > 1 ? numberBelow + " contours join" : "a contour splits into " + numberAbove;
    default: return "a contour goes on";
  }
}
