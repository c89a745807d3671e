// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_DRAWING_ROUND_TICKS_H
#define CGAL_REEB_GRAPH_INTERNAL_DRAWING_ROUND_TICKS_H

#include <CGAL/license/Reeb_graph.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// At least so many round numbers of an interval, if rounding leaves so many there: in steps of 1, 2, or 5 times a power
// of ten. The lowest number of the interval if it has no length.
inline std::vector<double> round_ticks(double lowest, double highest, int number)
{
  const double largest_step = highest / number - lowest / number;
  if(!(largest_step > 0))
    return {lowest};
  const double power = std::pow(10, std::floor(std::log10(largest_step)));
  const double step = power * (largest_step >= 5 * power ? 5 : largest_step >= 2 * power ? 2 : 1);
  std::vector<double> ticks;
  for(double i = std::ceil(lowest / step); i * step <= highest && ticks.size() < 5 * static_cast<std::size_t>(number);
      ++i)
    ticks.push_back(i == 0 ? 0 : i * step);
  return ticks;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DRAWING_ROUND_TICKS_H
