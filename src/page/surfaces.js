// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* global THREE, cornerNormals, makeBands, makeMaterial, shaders */
/* exported makeSurfaceGeometry, makeSurfaceMaterials, normalizedValue */

// The surface as three.js draws it.

// Between 0 and 1 for the values that are drawn; what is beyond is cut to a little more.
function normalizedValue(value, {low, high}) {
  return high > low ? Math.min(Math.max((value - low) / (high - low), -0.01), 1.01) : 0.5;
}

function endOfBand(value, range) {
  return value === Infinity ? 2 : normalizedValue(value, range);
}

// The triangles with vertices of their own, as the bands are those of triangles.
function makeSurfaceGeometry(data, center) {
  const {positions, triangles, values, facePatches} = data.surface;
  const {places, ends} = makeBands(data.surface, data.graph);
  const corners = triangles.length;
  const sizes = {position: 3, value: 1, bands: 3, ends: 2, patchNumber: 1}, arrays = {};
  Object.keys(sizes).forEach(name => {
    arrays[name] = new Float32Array(sizes[name] * corners);
  });
  for (let corner = 0; corner < corners; ++corner) {
    const face = Math.floor(corner / 3), v = triangles[corner];
    for (let i = 0; i < 3; ++i) {
      arrays.position[3 * corner + i] = positions[3 * v + i] - center[i];
      arrays.bands[3 * corner + i] = places[3 * face + i];
    }
    arrays.value[corner] = normalizedValue(values[v], data.range);
    arrays.ends[2 * corner] = endOfBand(ends[2 * face], data.range);
    arrays.ends[2 * corner + 1] = endOfBand(ends[2 * face + 1], data.range);
    arrays.patchNumber[corner] = facePatches ? facePatches[face] : 0;
  }
  const geometry = new THREE.BufferGeometry();
  Object.keys(sizes).forEach(name =>
    geometry.setAttribute(name, new THREE.BufferAttribute(arrays[name], sizes[name])));
  geometry.setAttribute("normal", new THREE.BufferAttribute(cornerNormals(positions, triangles), 4, true));
  return geometry;
}

// What writes the depth, the colours, and the numbers of places. The surface is moved back a little for lines on it.
function makeSurfaceMaterials(uniforms) {
  const offset = {polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1};
  const depth = Object.assign({colorWrite: false, transparent: true}, offset);
  const color = Object.assign({transparent: true, depthWrite: false, extensions: {derivatives: true}}, offset);
  return {
    depth: makeMaterial(shaders.surfaceVertex, shaders.surfaceNumberFragment, {}, depth),
    color: makeMaterial(shaders.surfaceVertex, shaders.surfaceFragment, uniforms, color),
    number: makeMaterial(shaders.surfaceVertex, shaders.surfaceNumberFragment, {}, {})
  };
}
