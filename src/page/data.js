// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* global joinShapes */
/* exported boxOf, readPageData, rangeOf */

// The data that the program has put into the page.

// Numbers in base64 of little-endian bytes, as all browsers' machines have them.
function decodeNumbers(text, NumberArray) {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i)
    bytes[i] = characters.charCodeAt(i);
  return new NumberArray(bytes.buffer);
}

function decodePolyline(polyline) {
  return {points: decodeNumbers(polyline.points, Float32Array), isClosed: polyline.is_closed};
}

function decodeContour(contour) {
  return Object.assign(decodePolyline(contour), {t: contour.t, value: Number(contour.value)});
}

// The drawing of an arc reaches the ends of what is drawn where its nodes have infinite values.
function decodePlane(plane, lower, upper, range) {
  const result = plane.slice();
  if (!isFinite(lower))
    result[1] = range.low;
  if (!isFinite(upper))
    result[result.length - 1] = range.high;
  return result;
}

// JSON has no infinite numbers: they are written as text.
function decodeGraph(graph, range, columns) {
  const nodes = graph.nodes.map(node => Object.assign({}, node, {value: Number(node.value)}));
  return {
    nodes,
    arcs: graph.arcs.map(arc => Object.assign({}, arc, ...columns.map(({name}) => ({[name]: Number(arc[name])})), {
      plane: decodePlane(arc.plane, nodes[arc.source].value, nodes[arc.target].value, range),
      inscribedRadii: arc.inscribed_radii, // of the points of lines of skeletons, as `radii`
      contours: arc.contours ? arc.contours.map(decodeContour) : null
    }))
  };
}

function decodeLevel(level, range, columns) {
  return Object.assign({}, level, {graph: level.graph ? decodeGraph(level.graph, range, columns) : null});
}

function decodeSurface(surface) {
  const positions = decodeNumbers(surface.positions, Float32Array);
  return {
    facesOfInput: surface.faces_of_input,
    isDecimated: surface.is_decimated,
    origin: surface.origin, // of all coordinates in the page
    positions,
    seenPositions: positions, // for an eye that is to see all
    values: decodeNumbers(surface.values, Float64Array),
    triangles: decodeNumbers(surface.triangles, Uint32Array),
    vertexArcs: decodeNumbers(surface.vertex_arcs, Int32Array),
    facePatches: surface.face_patches ? decodeNumbers(surface.face_patches, Int32Array) : null
  };
}

// The smallest and the largest of many numbers, or of each `step`th one from a place on.
function rangeOf(numbers, first = 0, step = 1) {
  let low = Infinity, high = -Infinity;
  for (let i = first; i < numbers.length; i += step) {
    low = Math.min(low, numbers[i]);
    high = Math.max(high, numbers[i]);
  }
  return low <= high ? {low, high} : {low: 0, high: 1};
}

// The center of the box of points, and its diagonal.
function boxOf(positions) {
  const ranges = [0, 1, 2].map(i => rangeOf(positions, i, 3));
  return {
    center: ranges.map(range => (range.low + range.high) / 2),
    size: Math.sqrt(ranges.reduce((sum, range) => sum + Math.pow(range.high - range.low, 2), 0)) || 1
  };
}

function readPageData(text) {
  const data = JSON.parse(text), shape = decodeData(data);
  return data.other ? joinShapes(shape, decodeData(data.other), data.partners, Number(data.distance)) : shape;
}

function decodeData(data) {
  if (data.version !== 1)
    throw new Error("This page cannot read data of version " + data.version + ".");
  const surface = decodeSurface(data.surface);
  // The values that are drawn, which are finite.
  const range = {low: data.field.lowest, high: data.field.highest};
  return {
    title: data.title,
    generator: data.generator,
    skeleton: data.skeleton, // its counts, or null for a Reeb graph
    field: data.field,
    surface,
    posedSurface: surface, // which tells what is up
    shapes: [{title: data.title, shift: 0, firstArc: 0, firstNode: 0}], // side by side
    partners: null, // of arcs, where two shapes are compared
    range,
    columns: data.columns, // what is told of each arc
    graph: decodeGraph(data.graph, range, data.columns),
    // The number of arcs of the graph that was asked for, if that is too large for a page and has been simplified.
    arcsOfInput: data.graph.is_simplified ? data.graph.arcs_of_input : null,
    threshold: data.graph.threshold,
    levels: data.levels.map(level => decodeLevel(level, range, data.columns)),
    curves: data.curves.map(decodePolyline),
    // What the curves are, if they are handles, tunnels and the like.
    loops: data.loops.map(loop => Object.assign({}, loop, {
      persistence: loop.persistence === null ? null : Number(loop.persistence)
    })),
    up: data.up, // the name of the direction, or ""
    ticks: data.ticks // of the slider that simplifies
  };
}
