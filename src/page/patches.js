// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* global cross, dot, normalized */
/* exported measurePatches */

// The patches of the surface, by number: {area, borderLength, center, size, normal}, of which the last three tell where
// it is seen from. A border is where another patch or the border of the surface is.
function measurePatches({positions, triangles, facePatches}) {
  const patches = [], edges = new Map();
  const point = v => [positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]];
  const subtracted = (p, q) => [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
  facePatches.forEach((number, face) => {
    const corners = [0, 1, 2].map(i => triangles[3 * face + i]), [p, q, r] = corners.map(point);
    const patch = patches[number] = patches[number] || {
      number, area: 0, borderLength: 0, center: [0, 0, 0], normal: [0, 0, 0], size: 0
    };
    const normal = cross(subtracted(q, p), subtracted(r, p)), area = Math.sqrt(dot(normal, normal)) / 2;
    patch.area += area;
    for (let i = 0; i < 3; ++i) {
      patch.center[i] += area * (p[i] + q[i] + r[i]) / 3;
      patch.normal[i] += normal[i];
    }
    corners.forEach((u, i) => {
      const v = corners[(i + 1) % 3], key = Math.min(u, v) * positions.length + Math.max(u, v);
      const length = Math.hypot(...subtracted(point(u), point(v))), other = edges.get(key);
      if (other === undefined) {
        edges.set(key, number);
        patch.borderLength += length;
      } else {
        patch.borderLength += other === number ? -length : length;
      }
    });
  });
  const found = patches.filter(patch => patch);
  found.forEach(patch => {
    patch.center = patch.center.map(x => patch.area > 0 ? x / patch.area : 0);
    patch.normal = normalized(patch.normal);
    patch.size = Math.sqrt(patch.area);
    patch.borderLength = Math.max(patch.borderLength, 0); // which rounding can make less
  });
  return found;
}
