// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_CONTOUR_SHAPE_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_CONTOUR_SHAPE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

typedef Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;

inline constexpr double pi = 3.14159265358979323846;

inline double length(const Vector& v) { return std::sqrt(v.squared_length()); }
inline double distance(const Point& p, const Point& q) { return length(q - p); }

// Measures of a closed polygon in space.
struct Contour_shape
{
  Point centroid; // of the disc that the polygon spans, or of the polygon where that is flat
  Vector area;    // of that disc, seen from three sides
  double length = 0;

  // The radius of the circle of the same area.
  double radius() const { return std::sqrt(skeleton::length(area) / pi); }
};

// A polygon whose vector area is below this share of that of a circle as long is a fold: its disc has no centroid.
inline constexpr double least_share_of_circle = 0.15;

inline Contour_shape measure(const std::vector<Point>& polygon)
{
  const std::size_t size = polygon.size();
  const Point origin = polygon.front();
  Contour_shape shape = {origin, NULL_VECTOR, 0};
  Vector middle = NULL_VECTOR;
  for(std::size_t i = 0; i != size; ++i)
  {
    const Point &p = polygon[i], &q = polygon[(i + 1) % size];
    const double edge = distance(p, q);
    shape.length += edge;
    middle = middle + edge * ((p - origin) + (q - origin)) / 2;
    shape.area = shape.area + cross_product(p - origin, q - origin) / 2;
  }
  if(!(shape.length > 0))
    return shape;
  const Point center = origin + middle / shape.length;
  shape.centroid = center;
  const double area = length(shape.area);
  if(!(area > least_share_of_circle * shape.length * shape.length / (4 * pi)))
    return shape;
  const Vector normal = shape.area / area;
  Vector moment = NULL_VECTOR;
  for(std::size_t i = 0; i != size; ++i)
  {
    const Vector p = polygon[i] - center, q = polygon[(i + 1) % size] - center;
    moment = moment + (cross_product(p, q) * normal / 2) * (p + q) / 3;
  }
  shape.centroid = center + moment / area;
  return shape;
}

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_CONTOUR_SHAPE_H
