// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Meshes, as {points, triangles}.
"use strict";

// Numbers between 0 and 1 that are the same in each run.
function randomNumbers(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 4294967296;
  };
}

// A grid of rows and columns, which may be closed in either direction; point(u, v) places its vertices.
function grid(rows, columns, areRowsClosed, areColumnsClosed, point) {
  const points = [], triangles = [];
  for (let i = 0; i < rows; ++i) {
    for (let j = 0; j < columns; ++j)
      points.push(point(i / rows, j / columns));
  }
  const at = (i, j) => (i % rows) * columns + j % columns;
  for (let i = 0; i < rows - (areRowsClosed ? 0 : 1); ++i) {
    for (let j = 0; j < columns - (areColumnsClosed ? 0 : 1); ++j) {
      triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
      triangles.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
  }
  return {points, triangles};
}

// A torus that stands upright, bumpy so that it has a few more extrema.
function torus(rows, columns, bump) {
  return grid(rows, columns, true, true, (u, v) => {
    const a = 2 * Math.PI * u, b = 2 * Math.PI * v;
    const radius = 1 + bump * Math.sin(5 * a) * Math.cos(3 * b);
    const r = 3 + radius * Math.cos(b);
    return [r * Math.cos(a), radius * Math.sin(b), r * Math.sin(a) + 0.3 * Math.cos(a)];
  });
}

// A sheet with a border, and with values of which many are equal.
function sheet(rows, columns, seed) {
  const random = randomNumbers(seed);
  return grid(rows, columns, false, false, (u, v) => [u, v, Math.floor(4 * random()) / 4]);
}

function toOff(mesh) {
  return "OFF\n" + mesh.points.length + " " + mesh.triangles.length + " 0\n"
    + mesh.points.map(point => point.join(" ")).join("\n") + "\n"
    + mesh.triangles.map(triangle => "3 " + triangle.join(" ")).join("\n") + "\n";
}

module.exports = {randomNumbers, torus, sheet, toOff};
