// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* exported makeBands, findPatchNeighbors */

// The pieces of the surface within its triangles. All of a triangle at one value belongs to one place of the graph, an
// arc or a node, so that values cut it into bands. Places are numbered as arcs, then nodes.

class PlaceSearch {
  constructor(graph) {
    this.graph = graph;
    this.numberOfArcs = graph.arcs.length;
    this.arcsAbove = graph.nodes.map(() => []);
    graph.arcs.forEach((arc, i) => this.arcsAbove[arc.source].push(i));
  }

  nodeValue(place) {
    return this.graph.nodes[place - this.numberOfArcs].value;
  }

  // The places just above another one.
  above(place) {
    return place < this.numberOfArcs ? [this.numberOfArcs + this.graph.arcs[place].target]
                                     : this.arcsAbove[place - this.numberOfArcs];
  }

  // The ascending path between two places, with both, or null if there is none that is short.
  path(from, to) {
    let paths = [[from]];
    for (let length = 0; length < 8 && paths.length > 0 && paths.length < 64; ++length) {
      const found = paths.find(path => path[path.length - 1] === to);
      if (found)
        return found;
      const longer = [];
      paths.forEach(path => this.above(path[path.length - 1]).forEach(place => longer.push(path.concat(place))));
      paths = longer;
    }
    return null;
  }
}

// The bands along an ascending path, each with the value at which it ends. Nodes are bands at the ends of a path only:
// vertices of branches that have been simplified away belong to them.
function bandsOfPath(search, path) {
  const bands = [];
  path.forEach((place, i) => {
    if (place < search.numberOfArcs)
      bands.push({place, end: i + 1 < path.length ? search.nodeValue(path[i + 1]) : Infinity});
    else if (i === 0)
      bands.push({place, end: path.length > 1 ? search.nodeValue(place) : Infinity});
    else if (i + 1 === path.length)
      bands.push({place, end: Infinity});
  });
  return bands;
}

// Removes the band that takes the least of the values between two.
function removeNarrowest(bands, low, high) {
  const widths = bands.map((band, i) => Math.min(band.end, high) - Math.max(i > 0 ? bands[i - 1].end : low, low));
  bands.splice(widths.indexOf(Math.min(...widths)), 1);
  bands[bands.length - 1].end = Infinity;
}

// The three bands, of which some may be empty, of a triangle with corners of ascending places and values.
function bandsOfTriangle(search, places, values) {
  const lower = search.path(places[0], places[1]), upper = search.path(places[1], places[2]);
  if (!lower || !upper) {
    return [
      {place: places[0], end: (values[0] + values[1]) / 2}, {place: places[1], end: (values[1] + values[2]) / 2},
      {place: places[2], end: Infinity}
    ];
  }
  const bands = bandsOfPath(search, lower.concat(upper.slice(1)));
  while (bands.length > 3)
    removeNarrowest(bands, values[0], values[2]);
  while (bands.length < 3)
    bands.push({place: bands[bands.length - 1].place, end: Infinity});
  return bands;
}

// For each triangle, the places of its three bands from below, and the two values between them.
function makeBands(surface, graph) {
  const {triangles, values, vertexArcs} = surface;
  const search = new PlaceSearch(graph);
  const numberOfTriangles = triangles.length / 3;
  const places = new Uint32Array(3 * numberOfTriangles), ends = new Float64Array(2 * numberOfTriangles);
  const place = v => vertexArcs[v] >= 0 ? vertexArcs[v] : search.numberOfArcs - 1 - vertexArcs[v];
  for (let f = 0; f < numberOfTriangles; ++f) {
    const a = triangles[3 * f], b = triangles[3 * f + 1], c = triangles[3 * f + 2];
    if (vertexArcs[a] >= 0 && vertexArcs[a] === vertexArcs[b] && vertexArcs[a] === vertexArcs[c]) {
      places[3 * f] = places[3 * f + 1] = places[3 * f + 2] = vertexArcs[a];
      ends[2 * f] = ends[2 * f + 1] = Infinity;
      continue;
    }
    const corners = [a, b, c].sort((u, v) => values[u] - values[v] || u - v);
    const bands = bandsOfTriangle(search, corners.map(place), corners.map(v => values[v]));
    bands.forEach((band, i) => {
      places[3 * f + i] = band.place;
      if (i < 2)
        ends[2 * f + i] = band.end;
    });
  }
  return {places, ends};
}

// For each patch, the patches that share a vertex with it.
function findPatchNeighbors(triangles, facePatches) {
  const patchOfVertex = new Map();
  const neighbors = [];
  facePatches.forEach(patch => {
    neighbors[patch] = neighbors[patch] || new Set();
  });
  triangles.forEach((vertex, corner) => {
    const patch = facePatches[Math.floor(corner / 3)], other = patchOfVertex.get(vertex);
    if (other !== undefined && other !== patch) {
      neighbors[patch].add(other);
      neighbors[other].add(patch);
    }
    patchOfVertex.set(vertex, patch);
  });
  return Array.from(neighbors, around => Array.from(around || []));
}
