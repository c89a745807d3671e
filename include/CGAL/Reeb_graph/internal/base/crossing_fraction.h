// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_CROSSING_FRACTION_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_CROSSING_FRACTION_H

#include <CGAL/license/Reeb_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The differences of finite numbers can be infinite. Where they are not, the results below are those without scaling.

// The place of a value between two: 0 at the lower one, 1 at the upper one, in the middle if that is unclear.
inline double crossing_fraction(double lower, double upper, double value)
{
  const bool is_too_large = std::isinf(upper - lower) || std::isinf(value - lower);
  const double scale = is_too_large ? 0.5 : 1;
  const double fraction = (scale * value - scale * lower) / (scale * upper - scale * lower);
  return std::isfinite(fraction) ? (std::min)((std::max)(fraction, 0.), 1.) : 0.5;
}

// The value at a fraction of the way from one value to another one.
template <class Value>
Value value_at_fraction(const Value& from, const Value& to, double fraction)
{
  if constexpr(std::is_floating_point_v<Value>)
  {
    if(std::isinf(to - from) && std::isfinite(from) && std::isfinite(to))
      return static_cast<Value>((1 - fraction) * from + fraction * to);
    return static_cast<Value>(from + fraction * (to - from));
  }
  else
    return from + fraction * (to - from);
}

// The difference of two values, divided by a number greater than 1.
template <class Value>
Value part_of_difference(const Value& from, const Value& to, int divisor)
{
  const Value difference = to - from;
  return std::isinf(difference) ? to / divisor - from / divisor : difference / divisor;
}

// The point at a fraction of the way from one point to another one.
template <class Point>
Point point_between(const Point& lower, const Point& upper, double fraction)
{
  return lower + fraction * (upper - lower);
}

// Point number `i` of a contour in a complex. `point_of` is called with the number of a vertex.
template <class CrossedEdges, class PointOf>
auto point_of_crossing(const CrossedEdges& contour, std::size_t i, const PointOf& point_of)
{
  const auto& edge = contour.edges[i];
  return point_between(point_of(edge.first), point_of(edge.second), contour.fractions[i]);
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_CROSSING_FRACTION_H
