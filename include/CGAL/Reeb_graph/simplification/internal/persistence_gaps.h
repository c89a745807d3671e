// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_PERSISTENCE_GAPS_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_PERSISTENCE_GAPS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/graph/Leaf_pruning.h>
#include <CGAL/Reeb_graph/internal/graph/read_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Reeb_graph::internal {

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

// Of what is left of a graph.
struct Pruning_state
{
  std::size_t nodes, arcs, leaves;
};

inline Pruning_state size_of_rest(const Leaf_pruning& pruned)
{
  return {pruned.number_of_nodes_left(), pruned.number_of_arcs_left(), pruned.number_of_leaves()};
}

// By number of branches that simplify() has removed with ever larger thresholds, what is left then; and for each of them
// its persistence, which is at least that of the one before.
struct Pruning_history
{
  std::vector<Pruning_state> states;
  std::vector<double> persistences;
};

template <class ReebGraph>
Pruning_history prune_step_by_step(const ReebGraph& graph, const std::vector<double>& values)
{
  Leaf_pruning pruned(static_cast<Index>(num_vertices(graph)), read_arcs(graph),
                      std::vector<double>(num_vertices(graph) + num_edges(graph)));
  Pruning_history history;
  const auto measure = [&](const Leaf_arc& arc) {
    return persistence_of_leaf_arc(arc,
                                   [&](Index lower, Index upper) { return persistence(values[lower], values[upper]); });
  };
  pruned(measure, [&](Index, double size) {
    history.states.push_back(size_of_rest(pruned));
    history.persistences.push_back(history.persistences.empty() ? size : (std::max)(size, history.persistences.back()));
    return true;
  });
  history.states.push_back(size_of_rest(pruned));
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

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_PERSISTENCE_GAPS_H
