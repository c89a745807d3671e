// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_DRAWING_SKYLINE_H
#define CGAL_REEB_GRAPH_INTERNAL_DRAWING_SKYLINE_H

#include <CGAL/license/Reeb_graph.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A closed interval of heights.
struct Height_range
{
  double low, high;

  bool has_inside(double height) const { return low < height && height < high; }
  void extend(const Height_range& other)
  {
    low = (std::min)(low, other.low);
    high = (std::max)(high, other.high);
  }
};

// How far what has been placed reaches at each height: a segment tree, in which what is said of a part holds for all of
// it. Asking for its maximum in an interval takes logarithmic time, raising it at most the square of that.
class Skyline
{
public:
  // `heights` are all those that intervals are told apart by, in ascending order.
  Skyline(const std::vector<double>& heights, double start) : heights_(heights), start_(start)
  {
    while(size_ < heights.size())
      size_ *= 2;
    highest_.assign(2 * size_, start);
    raised_.assign(2 * size_, start);
  }

  double highest(const Height_range& range) const
  {
    const auto [begin, end] = positions(range);
    double result = start_;
    visit(begin, end, [&](std::size_t part) { result = (std::max)(result, highest_[part]); });
    for(std::size_t bound : {begin, end - 1})
    {
      for(std::size_t part = (bound + size_) / 2; begin < end && part != 0; part /= 2)
        result = (std::max)(result, raised_[part]);
    }
    return result;
  }

  void raise(const Height_range& range, double value)
  {
    const auto [begin, end] = positions(range);
    visit(begin, end, [&](std::size_t part) {
      highest_[part] = (std::max)(highest_[part], value);
      raised_[part] = (std::max)(raised_[part], value);
      for(part /= 2; part != 0; part /= 2)
        highest_[part] = (std::max)(highest_[part], value);
    });
  }

private:
  std::pair<std::size_t, std::size_t> positions(const Height_range& range) const
  {
    const auto begin = std::lower_bound(heights_.begin(), heights_.end(), range.low);
    const auto end = std::upper_bound(begin, heights_.end(), range.high);
    return {begin - heights_.begin(), end - heights_.begin()};
  }

  // Calls visit(part) for the parts that an interval of positions consists of.
  template <class Visit>
  void visit(std::size_t begin, std::size_t end, const Visit& visit) const
  {
    for(begin += size_, end += size_; begin < end; begin /= 2, end /= 2)
    {
      if(begin % 2 != 0)
        visit(begin++);
      if(end % 2 != 0)
        visit(--end);
    }
  }

  const std::vector<double>& heights_;
  double start_;
  std::size_t size_ = 1;
  std::vector<double> highest_, raised_; // by part: in it, and for all of it
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DRAWING_SKYLINE_H
