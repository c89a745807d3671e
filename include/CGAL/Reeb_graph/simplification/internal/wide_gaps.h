// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_WIDE_GAPS_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_WIDE_GAPS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/simplification/internal/Leaf_pruning.h>
#include <CGAL/Reeb_graph/simplification/internal/persistence.h>
#include <CGAL/Reeb_graph/simplification/internal/prune_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Between two persistences that follow each other.
struct Persistence_gap
{
  double lower, upper;
  std::size_t number_below; // of persistences

  double width() const { return upper / lower; } // on a logarithmic scale
  double middle() const { return std::sqrt(lower) * std::sqrt(upper); }
};

constexpr double least_width_of_gap = 1.25;
constexpr double least_visible_part = 0.001; // of the range: nobody sees what is smaller

// The gaps that are wide, ascending, up to the one below the range. What is not visible lies below all of them.
inline std::vector<Persistence_gap> find_wide_gaps(std::vector<double> persistences, double range)
{
  std::vector<Persistence_gap> gaps;
  double lower = least_visible_part * range;
  if(!(lower > 0) || !std::isfinite(range))
    return gaps;
  std::sort(persistences.begin(), persistences.end());
  persistences.push_back(range);
  for(std::size_t i = 0; i != persistences.size(); ++i)
  {
    const Persistence_gap gap = {lower, persistences[i], i};
    if(gap.width() >= least_width_of_gap && std::isfinite(gap.upper))
      gaps.push_back(gap);
    lower = (std::max)(lower, gap.upper);
  }
  return gaps;
}

// A graph while simplify() removes branches with ever larger thresholds.
struct Pruning_state
{
  std::size_t nodes, leaves;
};

// By number of branches that have been removed, what is left then; and for each of them its persistence, which is at
// least that of the one before.
struct Pruning_history
{
  std::vector<Pruning_state> states;
  std::vector<double> persistences;
};

// Counts nodes that two arcs have become one at.
struct Join_counter : No_rival
{
  std::size_t number_of_joins = 0;

  void see_joined_arc(Index) { ++number_of_joins; }
};

template <class ReebGraph>
Pruning_history prune_step_by_step(const ReebGraph& graph, const std::vector<double>& values)
{
  const std::size_t number_of_nodes = num_vertices(graph);
  Leaf_pruning pruned(static_cast<Index>(number_of_nodes), read_arcs(graph),
                      std::vector<double>(number_of_nodes + num_edges(graph)));
  Pruning_history history;
  Join_counter joins;
  const auto add_state = [&](std::size_t leaves) {
    history.states.push_back({number_of_nodes - joins.number_of_joins - history.persistences.size(), leaves});
  };
  const auto measure = [&](const Leaf_arc& arc) {
    return persistence_of_leaf_arc(arc,
                                   [&](Index lower, Index upper) { return persistence(values[lower], values[upper]); });
  };
  std::size_t last_number_of_leaves = 0;
  const auto see_leaves = [&](Index number) {
    last_number_of_leaves = number;
    return true;
  };
  const auto visit = [&](Index leaf) {
    const double size = measure(pruned.leaf_arc_of(leaf));
    add_state(last_number_of_leaves);
    history.persistences.push_back(history.persistences.empty() ? size : (std::max)(size, history.persistences.back()));
  };
  pruned(
    measure, [](const Leaf_arc&) { return true; }, [](double) { return true; }, see_leaves, visit, joins);
  std::size_t leaves = 0;
  for(Index node = 0; node != static_cast<Index>(number_of_nodes); ++node)
    leaves += pruned.is_left(node) && pruned.is_leaf(node) ? 1 : 0;
  add_state(leaves);
  return history;
}

// The logarithm of the probability, but for a constant, that a person means what is above a gap: the wider the gap, and
// the nearer the number of leaves to that of a body with a head or a tail, two ears or arms, and some legs.
inline double plausibility(double width_of_gap, std::size_t number_of_leaves)
{
  constexpr double expected_number_of_leaves = 7, power = 1.5;
  const double leaves = static_cast<double>((std::max)(number_of_leaves, std::size_t(1)));
  return std::log(width_of_gap) - power * std::abs(std::log(leaves / expected_number_of_leaves));
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_WIDE_GAPS_H
