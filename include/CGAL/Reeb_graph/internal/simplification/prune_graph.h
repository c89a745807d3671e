// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_PRUNE_GRAPH_H
#define CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_PRUNE_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/simplification/Leaf_pruning.h>
#include <CGAL/Reeb_graph/internal/simplification/persistence.h>
#include <CGAL/Reeb_graph/internal/simplification/remove_small_loops.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/simplification/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

template <class ReebGraph>
std::vector<Leaf_pruning::Arc> read_arcs(const ReebGraph& graph)
{
  std::vector<Leaf_pruning::Arc> arcs;
  arcs.reserve(num_edges(graph));
  checked_index(num_vertices(graph) + num_edges(graph));
  for(auto range = edges(graph); range.first != range.second; ++range.first)
  {
    const auto lower = source(*range.first, graph), upper = target(*range.first, graph);
    if(!(lower < upper))
      throw Arc_direction_error();
    arcs.push_back({static_cast<Index>(lower), static_cast<Index>(upper)});
  }
  return arcs;
}

template <class NamedParameters>
std::vector<double> read_piece_weights(std::size_t number_of_pieces, const NamedParameters& np)
{
  const auto parameter = parameters::get_parameter(np, piece_weights);
  std::vector<double> weights;
  if constexpr(is_given<decltype(parameter)>)
  {
    weights.assign(std::begin(parameter), std::end(parameter));
    if(weights.size() != number_of_pieces)
      throw Piece_count_error(weights.size(), number_of_pieces);
    if(std::any_of(weights.begin(), weights.end(), [](double weight) { return std::isnan(weight); }))
      throw Measure_error("weight of a piece");
  }
  else
    weights.assign(number_of_pieces, 0);
  return weights;
}

template <class Branch, class NamedParameters>
double measure_of_branch(const Branch& branch, const NamedParameters& np)
{
  const auto& measure = parameters::get_parameter(np, branch_measure);
  if constexpr(is_given<decltype(measure)>)
  {
    const double size = measure(branch);
    if(std::isnan(size))
      throw Measure_error("measure of a branch");
    return size;
  }
  else
    return is_given<decltype(parameters::get_parameter(np, piece_weights))> ? branch.weight : branch.persistence;
}

// The graph without its small branches and, if asked for, loops; see simplify().
template <class Branch, class ReebGraph, class NamedParameters>
Leaf_pruning prune_graph(const ReebGraph& graph, double threshold, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  if(!(threshold >= 0))
    throw Threshold_error("threshold of simplification");
  const std::size_t leaves = choose_parameter(get_parameter(np, number_of_leaves), std::size_t(0));
  const bool are_loops_cancelled = choose_parameter(get_parameter(np, cancel_loops), false);

  Leaf_pruning pruned(static_cast<Index>(num_vertices(graph)), read_arcs(graph),
                      read_piece_weights(num_vertices(graph) + num_edges(graph), np));
  const std::vector<double> values = numbers_of_nodes(graph, np);
  const auto difference = [&](Index lower, Index upper) { return persistence(values[lower], values[upper]); };
  const auto measure = [&](const Leaf_arc& arc) {
    const double size = persistence_of_leaf_arc(arc, difference);
    return measure_of_branch(Branch{arc.leaf, arc.saddle, arc.is_minimum, size, arc.weight}, np);
  };
  const auto prune = [&] {
    pruned(
      measure, [](const Leaf_arc&) { return true; },
      [&](double size) { return size < threshold || std::isinf(threshold); },
      [&](Index number) { return number > leaves; });
  };
  prune();
  const auto is_small = [&](Index split, Index join) { return difference(split, join) < threshold; };
  while(are_loops_cancelled && remove_small_loops(pruned, is_small))
    prune();
  return pruned;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_PRUNE_GRAPH_H
