// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_DRAWING_BRANCH_COLUMNS_H
#define CGAL_REEB_GRAPH_INTERNAL_DRAWING_BRANCH_COLUMNS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/drawing/Branch_order.h>
#include <CGAL/Reeb_graph/internal/drawing/Branch_tree.h>
#include <CGAL/Reeb_graph/internal/drawing/Skyline.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Gives a column to each branch, the nearest to its trunk or to its parent that its place in the order leaves free at
// all of its heights. Components lie side by side, or above each other, the tallest at the left.
class Branch_columns
{
public:
  // `sorted_heights` are those of the nodes, each once.
  Branch_columns(const Branch_tree& tree, const Branch_order& order, const std::vector<double>& sorted_heights)
    : tree_(tree),
      order_(order),
      columns_(tree.branches.size(), 0)
  {
    std::vector<Index> trunks;
    for(Index branch = 0; branch != tree.branches.size(); ++branch)
    {
      if(tree.branches[branch].parent == no_index)
        trunks.push_back(branch);
    }
    const auto length = [&](Index trunk) { return order.extent(trunk).high - order.extent(trunk).low; };
    std::sort(trunks.begin(), trunks.end(), [&](Index a, Index b) {
      return length(a) != length(b) ? length(a) > length(b) : tree.branches[a].lower < tree.branches[b].lower;
    });
    Skyline components(sorted_heights, -gap_of_components);
    for(const Index trunk : trunks)
    {
      const std::vector<Index> branches = order.branches_of_trunk(trunk);
      place_component(branches, trunk);
      const Height_range extent = widened(order.extent(trunk));
      const double shift = components.highest(extent) + gap_of_components - columns_[leftmost(branches)];
      double right = 0;
      for(const Index branch : branches)
        right = (std::max)(right, columns_[branch] += shift);
      components.raise(extent, right);
    }
  }

  double operator[](Index branch) const { return columns_[branch]; }

  // The distance to the next branch on the way to its parent: short ones lie closer.
  double width(Index branch) const
  {
    constexpr double short_length = 1. / 40;
    const Height_range& extent = order_.extent(branch);
    return extent.high - extent.low < short_length ? 0.5 : 1;
  }

private:
  static constexpr double gap_of_components = 1.5; // in columns
  static constexpr double gap_of_ends = 1. / 60;   // in a column, of the whole height

  static Height_range widened(const Height_range& range) { return {range.low - gap_of_ends, range.high + gap_of_ends}; }

  Index leftmost(const std::vector<Index>& branches) const
  {
    return *std::min_element(branches.begin(), branches.end(),
                             [&](Index a, Index b) { return columns_[a] < columns_[b]; });
  }

  // The heights at which a branch is, with some distance to what lies above or below it in the same column.
  Height_range taken_heights(Index branch) const
  {
    const Drawn_branch& drawn = tree_.branches[branch];
    Height_range range = order_.own_extent(branch);
    range.low -= drawn.is_lower_attached ? 0 : gap_of_ends;
    range.high += drawn.is_upper_attached || drawn.is_closing ? 0 : gap_of_ends;
    return range;
  }

  void place_component(const std::vector<Index>& branches, Index trunk)
  {
    const auto middle = std::find(branches.begin(), branches.end(), trunk);
    const std::vector<Index> right(middle + 1, branches.end());
    const std::vector<Index> left(std::make_reverse_iterator(middle), branches.rend());
    place_side(right, 1);
    place_side(left, -1);
  }

  // Those of the nodes at the ends of branches, in ascending order, each once: branches are apart where these are.
  std::vector<double> heights_of_ends(const std::vector<Index>& branches) const
  {
    std::vector<double> heights;
    heights.reserve(2 * branches.size());
    for(const Index branch : branches)
    {
      heights.push_back(order_.own_extent(branch).low);
      heights.push_back(order_.own_extent(branch).high);
    }
    std::sort(heights.begin(), heights.end());
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    return heights;
  }

  // The branches at one side of the trunk, from the inside to the outside.
  void place_side(const std::vector<Index>& branches, int side)
  {
    const std::vector<double> heights = heights_of_ends(branches);
    Skyline inner(heights, 0);
    for(const Index branch : branches)
    {
      const Height_range range = taken_heights(branch);
      const double column = inner.highest(range) + width(branch);
      inner.raise(range, column);
      columns_[branch] = side * column;
    }
    draw_to_parents(branches, heights, side);
  }

  // Moves those branches outwards whose parents lie there.
  void draw_to_parents(const std::vector<Index>& branches, const std::vector<double>& heights, int side)
  {
    const double far_out = -2. - static_cast<double>(branches.size());
    Skyline outer(heights, far_out); // the columns, turned around
    for(auto branch = branches.rbegin(); branch != branches.rend(); ++branch)
    {
      const Height_range range = taken_heights(*branch);
      const double bound = outer.highest(range);
      if(order_.side(*branch) == -side && bound != far_out)
        columns_[*branch] = side * (std::max)(side * columns_[*branch], -bound - 1);
      outer.raise(range, -side * columns_[*branch]);
    }
  }

  const Branch_tree& tree_;
  const Branch_order& order_;
  std::vector<double> columns_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DRAWING_BRANCH_COLUMNS_H
