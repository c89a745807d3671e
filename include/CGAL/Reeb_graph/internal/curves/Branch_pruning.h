// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CURVES_BRANCH_PRUNING_H
#define CGAL_REEB_GRAPH_INTERNAL_CURVES_BRANCH_PRUNING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/curves/Graph_retract.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Removes small leaf arcs from a Reeb graph with simple saddles, the least one first. The saddle at which one has been
// removed is no node any more: the two other arcs there become one, which is longer. An arc is not removed if it is
// the only one on its side of the saddle, as what is left would end there.
template <class ReebGraph>
class Branch_pruning
{
  typedef typename boost::graph_traits<ReebGraph>::edge_descriptor arc_descriptor;
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // An arc of the graph, or two arcs that have become one.
  struct Joined_arc
  {
    std::size_t lower, upper;
    double area;
    std::size_t lower_part, upper_part; // none for an arc of the graph
    bool is_left;
  };

public:
  typedef Arc_path<arc_descriptor> Path;

  struct Thresholds
  {
    double persistence, area;
  };

  // `values` and `is_border` are by node, `areas` by arc. A leaf at a border is no branch.
  Branch_pruning(const ReebGraph& graph,
                 const std::vector<double>& values,
                 const std::vector<bool>& is_border,
                 const std::vector<double>& areas,
                 Thresholds thresholds)
    : graph_arcs_(edges(graph).first, edges(graph).second),
      values_(values),
      is_border_(is_border),
      thresholds_(thresholds),
      lower_arcs_(num_vertices(graph)),
      upper_arcs_(num_vertices(graph))
  {
    for(std::size_t arc = 0; arc != graph_arcs_.size(); ++arc)
      add({source(graph_arcs_[arc], graph), target(graph_arcs_[arc], graph), areas[arc], none, none, true});
    while(!queue_.empty())
    {
      const std::size_t arc = queue_.top().second;
      queue_.pop();
      if(arcs_[arc].is_left && can_be_removed(arc))
        remove(arc);
    }
  }

  // The leaf arcs that are left, from the saddle to the leaf.
  std::vector<Path> branches() const
  {
    std::vector<Path> result;
    for(std::size_t arc = 0; arc != arcs_.size(); ++arc)
    {
      if(!arcs_[arc].is_left || !is_leaf_arc(arc) || !(relative_size(arc) >= 1))
        continue;
      Path path;
      append_pieces(arc, path);
      const bool is_leaf_lower = is_leaf(arcs_[arc].lower);
      if(is_leaf_lower)
        std::reverse(path.arcs.begin(), path.arcs.end());
      for(auto& piece : path.arcs)
        piece.is_passed_upwards = !is_leaf_lower;
      path.first_node = is_leaf_lower ? arcs_[arc].upper : arcs_[arc].lower;
      path.last_node = is_leaf_lower ? arcs_[arc].lower : arcs_[arc].upper;
      result.push_back(path);
    }
    return result;
  }

private:
  bool is_leaf(std::size_t node) const { return lower_arcs_[node].size() + upper_arcs_[node].size() == 1; }

  // One of its ends is a leaf inside of the surface, the other one a saddle.
  bool is_leaf_arc(std::size_t arc) const
  {
    const bool is_lower_leaf = is_leaf(arcs_[arc].lower), is_upper_leaf = is_leaf(arcs_[arc].upper);
    return is_lower_leaf != is_upper_leaf && !is_border_[is_lower_leaf ? arcs_[arc].lower : arcs_[arc].upper];
  }

  // Less than 1 if the arc does not reach one of the thresholds.
  double relative_size(std::size_t arc) const
  {
    const double persistence = values_[arcs_[arc].upper] - values_[arcs_[arc].lower];
    double size = std::numeric_limits<double>::infinity();
    if(thresholds_.persistence > 0)
      size = (std::min)(size, persistence / thresholds_.persistence);
    if(thresholds_.area > 0)
      size = (std::min)(size, arcs_[arc].area / thresholds_.area);
    return size;
  }

  void add(const Joined_arc& arc)
  {
    const std::size_t number = arcs_.size();
    arcs_.push_back(arc);
    upper_arcs_[arc.lower].push_back(number);
    lower_arcs_[arc.upper].push_back(number);
    const double size = relative_size(number);
    if(size < 1)
      queue_.emplace(size, number);
  }

  bool can_be_removed(std::size_t arc) const
  {
    const std::size_t lower = arcs_[arc].lower, upper = arcs_[arc].upper;
    return is_leaf_arc(arc) && (is_leaf(lower) ? lower_arcs_[upper] : upper_arcs_[lower]).size() > 1;
  }

  void detach(std::size_t arc)
  {
    arcs_[arc].is_left = false;
    auto& above = upper_arcs_[arcs_[arc].lower];
    auto& below = lower_arcs_[arcs_[arc].upper];
    above.erase(std::find(above.begin(), above.end(), arc));
    below.erase(std::find(below.begin(), below.end(), arc));
  }

  void remove(std::size_t arc)
  {
    const std::size_t saddle = is_leaf(arcs_[arc].lower) ? arcs_[arc].upper : arcs_[arc].lower;
    detach(arc);
    const std::size_t below = lower_arcs_[saddle].front(), above = upper_arcs_[saddle].front();
    detach(below);
    detach(above);
    add({arcs_[below].lower, arcs_[above].upper, arcs_[below].area + arcs_[above].area + arcs_[arc].area, below, above,
         true});
  }

  // From the lower to the upper end.
  void append_pieces(std::size_t arc, Path& path) const
  {
    std::vector<std::size_t> to_do(1, arc);
    while(!to_do.empty())
    {
      arc = to_do.back();
      to_do.pop_back();
      if(arcs_[arc].lower_part == none)
      {
        path.arcs.push_back({graph_arcs_[arc], true});
        continue;
      }
      to_do.push_back(arcs_[arc].upper_part);
      to_do.push_back(arcs_[arc].lower_part);
    }
  }

  typedef std::pair<double, std::size_t> Sized_arc;

  const std::vector<arc_descriptor> graph_arcs_;
  const std::vector<double>& values_;
  const std::vector<bool>& is_border_;
  const Thresholds thresholds_;
  std::vector<Joined_arc> arcs_; // those of the graph come first
  std::vector<std::vector<std::size_t>> lower_arcs_, upper_arcs_;
  std::priority_queue<Sized_arc, std::vector<Sized_arc>, std::greater<Sized_arc>> queue_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CURVES_BRANCH_PRUNING_H
