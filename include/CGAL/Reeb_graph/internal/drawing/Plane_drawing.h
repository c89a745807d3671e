// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_DRAWING_PLANE_DRAWING_H
#define CGAL_REEB_GRAPH_INTERNAL_DRAWING_PLANE_DRAWING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/drawing/Branch_columns.h>
#include <CGAL/Reeb_graph/internal/drawing/Branch_order.h>
#include <CGAL/Reeb_graph/internal/drawing/Branch_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

typedef std::array<double, 2> Plane_point; // column and height

// The curve by which an arc goes from a node at `from` to a point at `to` in another column: sideways first, and then
// in a rounded corner to the vertical. On the way it rises by a small part of `gap`, the less the farther it goes, so
// that arcs that go on at other columns do not meet it.
inline void add_corner(Plane_point from,
                       Plane_point to,
                       double largest_radius,
                       double gap,
                       std::vector<Plane_point>& curve)
{
  constexpr int steps = 8;
  constexpr double right_angle = 1.57079632679489661923;
  const double distance = to[0] - from[0], height = to[1] - from[1];
  const bool is_far = std::abs(distance) > largest_radius;
  const double radius = is_far ? std::copysign(largest_radius, distance) : distance;
  const double rise = is_far ? std::copysign(0.1 * gap / (1 + std::abs(distance)), height) : 0;
  curve.push_back(from);
  for(int i = is_far ? 0 : 1; i != steps; ++i)
  {
    const double angle = right_angle * i / steps;
    curve.push_back({to[0] - radius * (1 - std::sin(angle)), from[1] + rise + (height - rise) * (1 - std::cos(angle))});
  }
  curve.push_back(to);
}

// Where nodes and arcs lie, in columns and heights from 0 to 1.
class Plane_drawing
{
public:
  Plane_drawing(const std::vector<Leaf_pruning::Arc>& arcs, const std::vector<double>& heights)
    : heights_(heights),
      sorted_heights_(heights),
      tree_(arcs, heights),
      positions_(heights.size()),
      curves_(arcs.size())
  {
    std::sort(sorted_heights_.begin(), sorted_heights_.end());
    sorted_heights_.erase(std::unique(sorted_heights_.begin(), sorted_heights_.end()), sorted_heights_.end());
    const Branch_order order(tree_, heights);
    const Branch_columns columns(tree_, order, sorted_heights_);
    for(Index node = 0; node != positions_.size(); ++node)
      positions_[node] = columns[tree_.branch_of_node[node]];
    for(const Drawn_branch& branch : tree_.branches)
      spread_ties(branch, arcs);
    for(Index branch = 0; branch != tree_.branches.size(); ++branch)
    {
      const Drawn_branch& drawn = tree_.branches[branch];
      for(std::size_t i = drawn.first_arc; i != drawn.end_of_arcs; ++i)
        curves_[tree_.arcs[i]] = curve(arcs[tree_.arcs[i]], columns[branch], columns.width(branch));
    }
  }

  // By node and by arc.
  const std::vector<double>& positions() const { return positions_; }
  const std::vector<std::vector<Plane_point>>& curves() const { return curves_; }

private:
  static constexpr double corner_height = 0.05;
  static constexpr double node_height = 0.03; // nodes that are nearer hide each other

  // Nodes of a branch that are of one height, or nearly so, and that it has for itself, lie beside each other.
  void spread_ties(const Drawn_branch& branch, const std::vector<Leaf_pruning::Arc>& arcs)
  {
    std::vector<Index> run;
    const auto end_run = [&] {
      const double size = static_cast<double>(run.size()) - 1, width = (std::min)(0.4, 0.2 * size);
      for(std::size_t i = 0; i != run.size() && size > 0; ++i)
        positions_[run[i]] += width * (static_cast<double>(i) / size - 0.5);
      run.clear();
    };
    const Index number = static_cast<Index>(&branch - tree_.branches.data());
    const auto add = [&](Index node) {
      if(!run.empty() && heights_[node] - heights_[run.front()] > node_height)
        end_run();
      if(tree_.branch_of_node[node] == number)
        run.push_back(node);
    };
    for(std::size_t i = branch.first_arc; i != branch.end_of_arcs; ++i)
      add(arcs[tree_.arcs[i]].lower);
    add(branch.upper);
    end_run();
  }

  // The distances of a height to the next ones that nodes have.
  double gap_above(double height) const
  {
    const auto next = std::upper_bound(sorted_heights_.begin(), sorted_heights_.end(), height);
    return next == sorted_heights_.end() ? 0 : *next - height;
  }
  double gap_below(double height) const
  {
    const auto next = std::lower_bound(sorted_heights_.begin(), sorted_heights_.end(), height);
    return next == sorted_heights_.begin() ? 0 : height - *(next - 1);
  }

  // The curve of an arc that is vertical in a column, with corners where its nodes are not in this column.
  std::vector<Plane_point> curve(const Leaf_pruning::Arc& arc, double column, double radius) const
  {
    const Plane_point lower = {positions_[arc.lower], heights_[arc.lower]};
    const Plane_point upper = {positions_[arc.upper], heights_[arc.upper]};
    const bool is_bent_below = lower[0] != column, is_bent_above = upper[0] != column;
    const double height = (std::min)((upper[1] - lower[1]) / (is_bent_below && is_bent_above ? 2 : 1), corner_height);
    std::vector<Plane_point> points = {lower}, points_from_above = {upper};
    if(is_bent_below)
      add_corner(lower, {column, lower[1] + height}, radius, (std::min)(gap_above(lower[1]), corner_height), points);
    if(is_bent_above)
      add_corner(upper, {column, upper[1] - height}, radius, (std::min)(gap_below(upper[1]), corner_height),
                 points_from_above);
    points.insert(points.end(), points_from_above.rbegin(), points_from_above.rend());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if(points.size() == 1)
      points.push_back(upper);
    return points;
  }

  const std::vector<double>& heights_;
  std::vector<double> sorted_heights_;
  Branch_tree tree_;
  std::vector<double> positions_;
  std::vector<std::vector<Plane_point>> curves_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DRAWING_PLANE_DRAWING_H
