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

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The place of a value between two: 0 at the lower one, 1 at the upper one, in the middle if that is unclear.
inline double crossing_fraction(double lower, double upper, double value)
{
  const double fraction = (value - lower) / (upper - lower);
  return std::isfinite(fraction) ? (std::min)((std::max)(fraction, 0.), 1.) : 0.5;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_CROSSING_FRACTION_H
