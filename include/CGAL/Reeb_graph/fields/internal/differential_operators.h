// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_DIFFERENTIAL_OPERATORS_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_DIFFERENTIAL_OPERATORS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/fields/internal/laplacian_graph.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Weights/mixed_voronoi_region_weights.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

inline bool is_finite(const Vector& vector)
{
  return std::isfinite(vector.x()) && std::isfinite(vector.y()) && std::isfinite(vector.z());
}

// The gradients on the faces, for the points divided by surface.scale().
inline std::vector<Vector> scaled_gradients(const Indexed_surface& surface, const std::vector<double>& values)
{
  std::vector<Vector> gradients;
  gradients.reserve(surface.triangles().size());
  for(std::size_t t = 0; t != surface.triangles().size(); ++t)
  {
    const Triangle_geometry geometry = triangle_geometry(surface, t);
    const auto& v = surface.triangles()[t].vertices;
    // The hat functions add up to one, so a constant may be taken off; it makes constant fields have gradient zero.
    gradients.push_back((values[v[1]] - values[v[0]]) * geometry.hat_gradient(1)
                        + (values[v[2]] - values[v[0]]) * geometry.hat_gradient(2));
  }
  return gradients;
}

// The directions of these gradients, zero where a gradient is. Differences of values would be infinite, or lost, at the
// ends of their range: those of each face are divided by a power of two.
inline std::vector<Vector> unit_gradients(const Indexed_surface& surface, const std::vector<double>& values)
{
  std::vector<Vector> gradients;
  gradients.reserve(surface.triangles().size());
  for(std::size_t t = 0; t != surface.triangles().size(); ++t)
  {
    const Triangle_geometry geometry = triangle_geometry(surface, t);
    const auto& v = surface.triangles()[t].vertices;
    const double largest = (std::max)({std::abs(values[v[0]]), std::abs(values[v[1]]), std::abs(values[v[2]])});
    const int exponent = largest > 0 ? std::ilogb(largest) : 0;
    const auto value = [&](std::size_t i) { return std::scalbn(values[v[i]], -exponent); };
    gradients.push_back(
      normalized((value(1) - value(0)) * geometry.hat_gradient(1) + (value(2) - value(0)) * geometry.hat_gradient(2)));
  }
  return gradients;
}

// The integrated divergences at the vertices.
inline std::vector<double> integrated_divergences(const Indexed_surface& surface, const std::vector<Vector>& vectors)
{
  std::vector<double> divergences(surface.number_of_vertices(), 0);
  for(std::size_t t = 0; t != surface.triangles().size(); ++t)
  {
    const Triangle_geometry geometry = triangle_geometry(surface, t);
    for(int i = 0; i != 3; ++i)
    {
      const int next = (i + 1) % 3, previous = (i + 2) % 3;
      divergences[surface.triangles()[t].vertices[i]] +=
        (geometry.cotangent(previous) * (geometry.edges[i] * vectors[t])
         - geometry.cotangent(next) * (geometry.edges[previous] * vectors[t]))
        / 2;
    }
  }
  for(double& divergence : divergences)
    divergence *= surface.scale();
  return divergences;
}

// The corners of a triangle, or those of its lengthened geometry.
inline std::array<Simple_cartesian<double>::Point_3, 3> corner_points(const Indexed_surface& surface,
                                                                      std::size_t triangle)
{
  const auto& v = surface.triangles()[triangle].vertices;
  if(surface.added_length() == 0)
    return {ORIGIN + surface.point(v[0]), ORIGIN + surface.point(v[1]), ORIGIN + surface.point(v[2])};
  const Triangle_geometry geometry = triangle_geometry(surface, triangle);
  return {ORIGIN, ORIGIN + geometry.edges[0], ORIGIN + (geometry.edges[0] + geometry.edges[1])};
}

// The mixed Voronoi areas of the vertices, zero for isolated ones, for the points divided by surface.scale().
inline std::vector<double> scaled_mixed_areas(const Indexed_surface& surface)
{
  std::vector<double> areas(surface.number_of_vertices(), 0);
  for(std::size_t t = 0; t != surface.triangles().size(); ++t)
  {
    const auto points = corner_points(surface, t);
    for(int i = 0; i != 3; ++i)
      areas[surface.triangles()[t].vertices[i]] +=
        Weights::mixed_voronoi_area(points[(i + 2) % 3], points[i], points[(i + 1) % 3]);
  }
  return areas;
}

// The mean curvatures times the mixed areas, for the points divided by surface.scale(): half the lengths of the vectors
// sum_j w_ij (v_i - v_j) with cotangent weights.
inline std::vector<double> scaled_integrated_mean_curvatures(const Indexed_surface& surface,
                                                             const Weighted_graph& cotangents)
{
  std::vector<double> curvatures;
  curvatures.reserve(surface.number_of_vertices());
  for(Index v = 0; v != surface.number_of_vertices(); ++v)
  {
    Vector sum = NULL_VECTOR;
    for(const auto& n : cotangents.neighbors(v))
      sum = sum + n.weight * (surface.point(v) - surface.point(n.vertex));
    curvatures.push_back(length(sum) / 2);
  }
  return curvatures;
}

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_DIFFERENTIAL_OPERATORS_H
