// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* exported buildTubes */

// Tubes around polylines, as vertices, normals and triangles.

function subtract(p, q) {
  return [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
}

function cross(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function dot(a, b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function normalized(a) {
  const length = Math.sqrt(dot(a, a));
  return length > 0 ? a.map(x => x / length) : [0, 0, 0];
}

// Any unit vector that is orthogonal to a unit vector.
function orthogonalTo(a) {
  const axis = Math.abs(a[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0];
  return normalized(cross(a, axis));
}

// The points of a polyline without those that repeat their predecessor; a closed one ends with its first point.
function distinctPoints(coordinates, isClosed) {
  const points = [];
  for (let i = 0; i + 2 < coordinates.length; i += 3) {
    const point = [coordinates[i], coordinates[i + 1], coordinates[i + 2]];
    const last = points[points.length - 1];
    if (!last || point.some((x, j) => x !== last[j]))
      points.push(point);
  }
  if (isClosed && points.length > 2)
    points.push(points[0]);
  return points;
}

// The direction of the tube at a point: the mean of those of the segments before and behind it.
function directionAt(points, i, isClosed) {
  const last = points.length - 1;
  const before = i > 0 ? i - 1 : isClosed ? last - 1 : 0;
  const behind = i < last ? i + 1 : isClosed ? 1 : last;
  const into = normalized(subtract(points[i], points[before])), out = normalized(subtract(points[behind], points[i]));
  const mean = normalized([into[0] + out[0], into[1] + out[1], into[2] + out[2]]);
  return dot(mean, mean) > 0 ? mean : out;
}

// Tubes with `sides` sides around polylines {points, isClosed, id}. The result has the id, and the place between 0 and
// 1 along the polyline, of each vertex.
function buildTubes(polylines, radius, sides) {
  const positions = [], normals = [], ids = [], places = [], triangles = [];
  polylines.forEach(polyline => {
    const points = distinctPoints(polyline.points, polyline.isClosed);
    if (points.length < 2)
      return;
    const isClosed = polyline.isClosed && points.length > 3;
    let side = null;
    points.forEach((point, i) => {
      const direction = directionAt(points, i, isClosed);
      // The side is carried along, so that the tube does not twist.
      const carried = side ? normalized(subtract(side, direction.map(x => x * dot(side, direction)))) : [0, 0, 0];
      side = dot(carried, carried) > 0.5 ? carried : orthogonalTo(direction);
      const other = cross(direction, side);
      const first = positions.length / 3;
      for (let k = 0; k < sides; ++k) {
        const angle = 2 * Math.PI * k / sides, c = Math.cos(angle), s = Math.sin(angle);
        for (let j = 0; j < 3; ++j) {
          const normal = c * side[j] + s * other[j];
          normals.push(normal);
          positions.push(point[j] + radius * normal);
        }
        ids.push(polyline.id);
        places.push(i / (points.length - 1));
        if (i > 0) {
          const l = (k + 1) % sides;
          triangles.push(first - sides + k, first + l, first + k, first - sides + k, first - sides + l, first + l);
        }
      }
    });
  });
  return {
    positions: new Float32Array(positions),
    normals: new Float32Array(normals),
    ids: new Float32Array(ids),
    places: new Float32Array(places),
    triangles: new Uint32Array(triangles)
  };
}
