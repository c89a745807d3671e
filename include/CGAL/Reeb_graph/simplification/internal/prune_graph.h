// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_PRUNE_GRAPH_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_PRUNE_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/graph/Leaf_pruning.h>
#include <CGAL/Reeb_graph/internal/graph/branch_measure.h>
#include <CGAL/Reeb_graph/internal/graph/read_graph.h>
#include <CGAL/Reeb_graph/internal/graph/remove_small_loops.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The graph without its small branches and, if asked for, loops; see simplify().
template <class Branch, class ReebGraph, class NamedParameters>
Leaf_pruning prune_graph(const ReebGraph& graph, double threshold, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  if(!(threshold >= 0))
    throw Parameter_error("the threshold of simplification is negative or not a number (NaN)");
  const std::size_t leaves = choose_parameter(get_parameter(np, number_of_leaves), std::size_t(0));
  const bool are_loops_cancelled = choose_parameter(get_parameter(np, cancel_loops), false);

  Leaf_pruning pruned(static_cast<Index>(num_vertices(graph)), read_arcs(graph),
                      read_place_weights(num_vertices(graph) + num_edges(graph), np));
  const std::vector<double> values = numbers_of_nodes(graph, np);
  const auto difference = [&](Index lower, Index upper) { return persistence(values[lower], values[upper]); };
  const auto measure = [&](const Leaf_arc& arc) {
    const double persistence = persistence_of_leaf_arc(arc, difference);
    const double size = measure_of_branch(Branch{arc.leaf, arc.saddle, arc.is_minimum, persistence, arc.weight}, np);
    return size < threshold || std::isinf(threshold) ? size : std::numeric_limits<double>::quiet_NaN();
  };
  const auto prune = [&] { pruned(measure, [&](Index, double) { return pruned.number_of_leaves() > leaves; }); };
  prune();
  const auto is_small = [&](Index split, Index join) { return difference(split, join) < threshold; };
  while(are_loops_cancelled && remove_small_loops(pruned, is_small))
    prune();
  return pruned;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_PRUNE_GRAPH_H
