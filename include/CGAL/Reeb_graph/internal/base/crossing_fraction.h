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

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The place of a value between two: 0 at the lower one, 1 at the upper one, in the middle if that is unclear.
inline double crossing_fraction(double lower, double upper, double value)
{
  const double fraction = (value - lower) / (upper - lower);
  return std::isfinite(fraction) ? (std::min)((std::max)(fraction, 0.), 1.) : 0.5;
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
