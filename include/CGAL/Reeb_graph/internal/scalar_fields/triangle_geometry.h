// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_TRIANGLE_GEOMETRY_H
#define CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_TRIANGLE_GEOMETRY_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Indexed_surface.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

// The geometry of a triangle with the corners 0, 1, 2: `edges[i]` leads from corner i to corner i + 1.
struct Triangle_geometry
{
  std::array<Vector, 3> edges;
  Vector normal; // its length is twice the area
  double double_area;

  // The cotangent of the angle at corner i.
  double cotangent(int i) const { return -dot(edges[i], edges[(i + 2) % 3]) / double_area; }

  // The tangent of half the angle at corner i, without cancellation.
  double half_tangent(int i) const
  {
    const double product = length(edges[i]) * length(edges[(i + 2) % 3]);
    const double cosine = -dot(edges[i], edges[(i + 2) % 3]);
    return cosine > 0 ? double_area / (product + cosine) : (product - cosine) / double_area;
  }

  // The gradient of the function that is 1 at corner i and 0 at the other ones.
  Vector hat_gradient(int i) const { return (1 / double_area) * cross((1 / double_area) * normal, edges[(i + 1) % 3]); }
};

// Throws an exception if the triangle has no area, or one so small that cotangents are beyond the range of numbers.
template <class Surface>
Triangle_geometry triangle_geometry(const Surface& surface, std::size_t triangle)
{
  const auto& v = surface.triangles()[triangle].vertices;
  Triangle_geometry geometry;
  for(int i = 0; i != 3; ++i)
    geometry.edges[i] = surface.point(v[(i + 1) % 3]) - surface.point(v[i]);
  // The product of the two short edges is the one with the least cancellation.
  int longest = 0;
  for(int i = 1; i != 3; ++i)
    if(dot(geometry.edges[i], geometry.edges[i]) > dot(geometry.edges[longest], geometry.edges[longest]))
      longest = i;
  geometry.normal = cross(geometry.edges[(longest + 1) % 3], geometry.edges[(longest + 2) % 3]);
  geometry.double_area = length(geometry.normal);
  for(int i = 0; i != 3; ++i)
    if(!(geometry.double_area > 0) || !std::isfinite(geometry.cotangent(i)) || !std::isfinite(geometry.half_tangent(i))
       || !(geometry.half_tangent(i) > 0))
      throw Zero_area_error(triangle);
  return geometry;
}

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_TRIANGLE_GEOMETRY_H
