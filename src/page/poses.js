// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* global boxOf, cross, dot, normalized, rangeOf */
/* exported findPose, distanceToSeeAll, cornerNormals */

// How a surface is looked at: where it is, which way is up, and its normals.

// The direction in which the field rises, if it is nearly a height, or null.
function findDirectionOfHeight(positions, values) {
  const count = values.length, means = [0, 0, 0, 0];
  for (let v = 0; v < count; ++v) {
    for (let i = 0; i < 3; ++i)
      means[i] += positions[3 * v + i] / count;
    means[3] += values[v] / count;
  }
  // Covariances of the coordinates, and with the field.
  const c = [[0, 0, 0], [0, 0, 0], [0, 0, 0]], b = [0, 0, 0];
  let variance = 0;
  const p = [0, 0, 0];
  for (let v = 0; v < count; ++v) {
    const f = values[v] - means[3];
    for (let i = 0; i < 3; ++i)
      p[i] = positions[3 * v + i] - means[i];
    for (let i = 0; i < 3; ++i) {
      for (let j = 0; j < 3; ++j)
        c[i][j] += p[i] * p[j];
      b[i] += p[i] * f;
    }
    variance += f * f;
  }
  // The gradient of the linear function nearest to the field, by Cramer's rule.
  const determinant = dot(c[0], cross(c[1], c[2]));
  const gradient = [0, 1, 2].map(i => dot(b, cross(c[(i + 1) % 3], c[(i + 2) % 3])) / determinant);
  const isLinear = gradient.every(isFinite) && dot(gradient, b) > 0.9 * variance && variance > 0;
  return isLinear ? normalized(gradient) : null;
}

// Away from the largest flat side that the surface stands on, of those that an axis is orthogonal to, or null: a side
// that has a fiftieth of the area, in the lowest hundredth of the surface.
function findStandingDirection(positions, triangles, ranges) {
  const areas = [0, 0, 0, 0, 0, 0];
  let wholeArea = 0;
  for (let k = 0; k < triangles.length; k += 3) {
    const [p, q, r] = [0, 1, 2].map(j => [0, 1, 2].map(i => positions[3 * triangles[k + j] + i]));
    const normal = cross([0, 1, 2].map(i => q[i] - p[i]), [0, 1, 2].map(i => r[i] - p[i]));
    const area = Math.sqrt(dot(normal, normal));
    wholeArea += area;
    for (let i = 0; i < 3; ++i) {
      if (Math.abs(normal[i]) < 0.95 * area)
        continue;
      const {low, high} = ranges[i], margin = 0.01 * (high - low);
      const isLow = Math.max(p[i], q[i], r[i]) < low + margin, isHigh = Math.min(p[i], q[i], r[i]) > high - margin;
      areas[i] += isLow ? area : 0;
      areas[i + 3] += isHigh ? area : 0;
    }
  }
  const largest = areas.indexOf(Math.max(...areas));
  // A box stands on each of its sides: none of them tells.
  const isOpposed = areas[(largest + 3) % 6] > 0.8 * areas[largest];
  if (!(areas[largest] > 0.02 * wholeArea) || isOpposed)
    return null;
  return [0, 1, 2].map(i => i === largest % 3 ? (largest < 3 ? 1 : -1) : 0);
}

// Which way is up: as named, that of a height, that in which the surface stands, or y if it is as tall in y as it is
// wide, as the models of most scanners are, else z.
function findUp({positions, values, triangles}, name) {
  if (name)
    return ["x", "y", "z"].map(axis => name.endsWith(axis) ? (name.startsWith("-") ? -1 : 1) : 0);
  const ranges = [0, 1, 2].map(i => rangeOf(positions, i, 3)), extents = ranges.map(({low, high}) => high - low);
  return findDirectionOfHeight(positions, values) || findStandingDirection(positions, triangles, ranges)
    || (extents[1] > 0.95 * Math.max(...extents) ? [0, 1, 0] : [0, 0, 1]);
}

// The horizontal direction in which the surface is thinnest: from there most of it is seen.
function findThinDirection(positions, up) {
  const first = normalized(cross(up, Math.abs(up[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0])), second = cross(up, first);
  let best = first, least = Infinity;
  const step = 3 * Math.max(1, Math.floor(positions.length / 3 / 5000));
  for (let k = 0; k < 36; ++k) {
    const angle = Math.PI * k / 36;
    const direction = first.map((x, i) => Math.cos(angle) * x + Math.sin(angle) * second[i]);
    let low = Infinity, high = -Infinity;
    for (let j = 0; j < positions.length; j += step) {
      const x = direction[0] * positions[j] + direction[1] * positions[j + 1] + direction[2] * positions[j + 2];
      low = Math.min(low, x);
      high = Math.max(high, x);
    }
    if (high - low < 0.999 * least) {
      least = high - low;
      best = direction;
    }
  }
  return best;
}

// The direction or its opposite, whichever is that of the front of most models: -y where z is up, else z.
function faceForward(direction, up) {
  const ahead = Math.abs(up[2]) > 0.7 ? -direction[1] : direction[2];
  return ahead < 0 ? direction.map(x => -x) : direction;
}

// The center and size (of the diagonal) of the surface, which way is up, which can be named, and from where it is
// looked at.
function findPose(surface, nameOfUp = "") {
  const {positions} = surface;
  const {center, size} = boxOf(positions);
  const up = findUp(surface, nameOfUp);
  const thin = faceForward(findThinDirection(positions, up), up), side = cross(up, thin);
  const turn = 0.42, lift = 0.24;
  const towardsEye = normalized([0, 1, 2].map(i =>
    Math.cos(lift) * (Math.cos(turn) * thin[i] + Math.sin(turn) * side[i]) + Math.sin(lift) * up[i]));
  return {center, size, up, towardsEye};
}

// How far from its center an eye has to be that sees the whole surface, with a vertical field of view in degrees.
function distanceToSeeAll(positions, pose, fieldOfView, aspect) {
  const {center, towardsEye, up, size} = pose;
  const right = normalized(cross(up, towardsEye)), top = cross(towardsEye, right);
  const slope = 0.9 * Math.tan(fieldOfView * Math.PI / 360);
  let distance = 0.1 * size;
  const step = 3 * Math.max(1, Math.floor(positions.length / 3 / 20000));
  for (let j = 0; j < positions.length; j += step) {
    const p = [0, 1, 2].map(i => positions[j + i] - center[i]);
    const reach = Math.max(Math.abs(dot(p, top)), Math.abs(dot(p, right)) / aspect);
    distance = Math.max(distance, dot(p, towardsEye) + reach / slope);
  }
  return distance;
}

// The normals of the corners of all triangles as four bytes each: smooth, except across sharp edges.
function cornerNormals(positions, triangles) {
  const smooth = new Float64Array(positions.length), flat = new Float64Array(triangles.length);
  for (let k = 0; k < triangles.length; k += 3) {
    const a = 3 * triangles[k], b = 3 * triangles[k + 1], c = 3 * triangles[k + 2];
    const ux = positions[b] - positions[a], uy = positions[b + 1] - positions[a + 1];
    const uz = positions[b + 2] - positions[a + 2], vx = positions[c] - positions[a];
    const vy = positions[c + 1] - positions[a + 1], vz = positions[c + 2] - positions[a + 2];
    flat[k] = uy * vz - uz * vy;
    flat[k + 1] = uz * vx - ux * vz;
    flat[k + 2] = ux * vy - uy * vx;
    for (let i = 0; i < 3; ++i) {
      smooth[a + i] += flat[k + i];
      smooth[b + i] += flat[k + i];
      smooth[c + i] += flat[k + i];
    }
  }
  const normals = new Int8Array(4 * triangles.length);
  for (let k = 0; k < triangles.length; ++k) {
    const face = k - k % 3, v = 3 * triangles[k];
    const f = inverseLength(flat, face), s = inverseLength(smooth, v);
    const cosine = f * s * (flat[face] * smooth[v] + flat[face + 1] * smooth[v + 1] + flat[face + 2] * smooth[v + 2]);
    for (let i = 0; i < 3; ++i)
      normals[4 * k + i] = Math.round(127 * (cosine > 0.6 ? s * smooth[v + i] : f * flat[face + i]));
  }
  return normals;
}

// Of the vector that begins at a place of an array; 0 for the vector of length 0.
function inverseLength(coordinates, i) {
  const x = coordinates[i], y = coordinates[i + 1], z = coordinates[i + 2];
  const length = Math.sqrt(x * x + y * y + z * z);
  return length > 0 ? 1 / length : 0;
}
