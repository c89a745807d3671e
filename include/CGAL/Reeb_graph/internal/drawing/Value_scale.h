// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_DRAWING_VALUE_SCALE_H
#define CGAL_REEB_GRAPH_INTERNAL_DRAWING_VALUE_SCALE_H

#include <CGAL/license/Reeb_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

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

// Numbers that are drawn as the values of nodes: the values, if they all ascend or all fall from node to node; in any
// other order, where differences mean nothing, the numbers of the nodes.
inline std::vector<double> drawn_values(std::vector<double> values)
{
  if(!std::is_sorted(values.begin(), values.end()) && !std::is_sorted(values.rbegin(), values.rend()))
    std::iota(values.begin(), values.end(), 0.);
  return values;
}

// The values that are drawn, and their heights from 0 to 1, which ascend with the nodes, as the values do, or fall. An
// infinite value is drawn as a finite one, a tenth of the range of the finite ones beyond them.
class Value_scale
{
public:
  explicit Value_scale(const std::vector<double>& values)
  {
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    bool has_lowest = false, has_highest = false; // infinite values
    for(const double value : values)
    {
      if(std::isfinite(value))
      {
        lowest = (std::min)(lowest, value);
        highest = (std::max)(highest, value);
      }
      else
        (value < 0 ? has_lowest : has_highest) = true;
    }
    if(lowest > highest)
      lowest = highest = 0;
    // halves, as the range of finite values can be too large for a number
    const double range = highest / 2 - lowest / 2, beyond = range > 0 ? range / 5 : 1;
    constexpr double limit = (std::numeric_limits<double>::max)();
    lowest_finite_ = lowest;
    highest_finite_ = highest;
    lowest_ = has_lowest ? (std::max)(lowest - beyond, -limit) : lowest;
    highest_ = has_highest ? (std::min)(highest + beyond, limit) : highest;
    bottom_ = lowest_;
    top_ = highest_;
    if(!values.empty() && values.back() < values.front())
      std::swap(bottom_, top_);
  }

  double lowest() const { return lowest_; }
  double highest() const { return highest_; }

  // The range of the finite values.
  std::pair<double, double> finite_range() const { return {lowest_finite_, highest_finite_}; }

  double finite_value(double value) const { return (std::clamp)(value, lowest_, highest_); }

  double height(double value) const
  {
    const double range = top_ / 2 - bottom_ / 2;
    return range != 0 ? (std::clamp)((finite_value(value) / 2 - bottom_ / 2) / range, 0., 1.) : 0.5;
  }

  double value(double height) const { return (1 - height) * bottom_ + height * top_; }

private:
  double lowest_, highest_, lowest_finite_, highest_finite_;
  double bottom_, top_; // of the drawing
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_DRAWING_VALUE_SCALE_H
