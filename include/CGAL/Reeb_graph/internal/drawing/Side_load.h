// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_DRAWING_SIDE_LOAD_H
#define CGAL_REEB_GRAPH_INTERNAL_DRAWING_SIDE_LOAD_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/drawing/Skyline.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// About how many branches one side of a trunk has, in equal parts of the height, which is from 0 to 1.
class Side_load
{
public:
  void add(const Height_range& range, Index number_of_branches)
  {
    std::for_each(part(range.low), part(range.high) + 1, [&](Index& load) { load += number_of_branches; });
  }

  // What decides between two sides: the load where a branch would be, and then the load of all parts.
  std::pair<Index, std::size_t> load(const Height_range& range)
  {
    return {*std::max_element(part(range.low), part(range.high) + 1),
            std::accumulate(loads_.begin(), loads_.end(), std::size_t(0))};
  }

private:
  typedef std::array<Index, 32> Loads;

  Loads::iterator part(double height)
  {
    const auto size = static_cast<double>(loads_.size());
    return loads_.begin() + static_cast<std::ptrdiff_t>((std::clamp)(height * size, 0., size - 1));
  }

  Loads loads_ = {};
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DRAWING_SIDE_LOAD_H
