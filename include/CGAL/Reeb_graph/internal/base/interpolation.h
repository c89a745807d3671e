// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_INTERPOLATION_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_INTERPOLATION_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

// Values and points between two others. The differences of finite numbers can be infinite; where they are not, the
// results are those without scaling.
namespace CGAL::Reeb_graph::internal {

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

typedef std::array<double, 3> Coordinates;

template <class Point>
Coordinates coordinates_of(const Point& point)
{
  return {CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z())};
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_INTERPOLATION_H
