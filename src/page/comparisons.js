// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* global boxOf, distinctColors */
/* exported colorsOfPartners, joinShapes */

// Two shapes as one of two components. The second one is as large as the first one, and so far away from it that no eye
// sees both; they are drawn side by side by two eyes that move together.

const distanceOfShapes = 40; // in sizes

// The second shape where the first one is, and where it is drawn.
function makeMoves(a, b) {
  const from = boxOf(b.surface.positions), to = boxOf(a.surface.positions), scale = to.size / from.size;
  const place = (points, shift) =>
    points.map((x, i) => scale * (x - from.center[i % 3]) + to.center[i % 3] + (i % 3 === 0 ? shift : 0));
  const shift = distanceOfShapes * to.size;
  return {place: points => place(points, 0), move: points => place(points, shift), shift};
}

function concatenate(a, b) {
  const joined = new a.constructor(a.length + b.length);
  joined.set(a);
  joined.set(b, a.length);
  return joined;
}

function joinGraphs(a, b, firstVertex, move) {
  const firstNode = a.nodes.length, columns = a.nodes.map(node => node.column);
  const shift = columns.length > 0 ? Math.max(...columns) + 1.5 : 0;
  return {
    nodes: a.nodes.concat(b.nodes.map(node => Object.assign({}, node, {
      point: move(node.point), column: node.column + shift
    }))),
    arcs: a.arcs.concat(b.arcs.map(arc => Object.assign({}, arc, {
      source: arc.source + firstNode, target: arc.target + firstNode, polyline: move(arc.polyline),
      plane: arc.plane.map((x, i) => i % 2 === 0 ? x + shift : x),
      chain: arc.chain && arc.chain.map(v => v + firstVertex),
      contours: arc.contours && arc.contours.map(contour => Object.assign({}, contour, {points: move(contour.points)}))
    })))
  };
}

function joinSurfaces(a, b, graph, firstVertex, {place, move}) {
  const places = b.vertexArcs.map(arc => arc >= 0 ? arc + graph.arcs.length : arc - graph.nodes.length);
  return Object.assign({}, a, {
    facesOfInput: a.facesOfInput + b.facesOfInput,
    isDecimated: a.isDecimated || b.isDecimated,
    positions: concatenate(a.positions, move(b.positions)),
    seenPositions: concatenate(a.positions, place(b.positions)),
    values: concatenate(a.values, b.values),
    triangles: concatenate(a.triangles, b.triangles.map(v => v + firstVertex)),
    vertexArcs: concatenate(a.vertexArcs, places)
  });
}

// The data of both, and of each arc its partner, or null.
function joinShapes(a, b, pairs, distance) {
  const moves = makeMoves(a, b), firstVertex = a.surface.values.length, firstArc = a.graph.arcs.length;
  const graph = joinGraphs(a.graph, b.graph, firstVertex, moves.move), partners = graph.arcs.map(() => null);
  pairs.forEach(([i, j]) => {
    partners[i] = j + firstArc;
    partners[j + firstArc] = i;
  });
  return Object.assign({}, a, {
    title: a.title + " and " + b.title,
    shapes: [a, b].map(({title}, i) => ({
      title, shift: i * moves.shift, firstArc: i * firstArc, firstNode: i * a.graph.nodes.length
    })),
    partners, distance, posedSurface: a.surface, graph,
    surface: joinSurfaces(a.surface, b.surface, a.graph, firstVertex, moves),
    range: {low: Math.min(a.range.low, b.range.low), high: Math.max(a.range.high, b.range.high)},
    levels: [{threshold: 0, arcs: graph.arcs.map((_, i) => i), graph: null}]
  });
}

// Partners have the same color, and arcs without one are gray.
function colorsOfPartners(view) {
  const colors = distinctColors(view.neighbors());
  return view.partners.map((partner, arc) => partner === null ? [0.6, 0.6, 0.6] : colors[Math.min(arc, partner)]);
}
