// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_GRAPH_REMOVE_SMALL_LOOPS_H
#define CGAL_REEB_GRAPH_INTERNAL_GRAPH_REMOVE_SMALL_LOOPS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/graph/Highest_forest.h>
#include <CGAL/Reeb_graph/internal/graph/Leaf_pruning.h>
#include <CGAL/Reeb_graph/internal/graph/graph_loops.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Ranks of arcs in the order of lower nodes, from below, and then of upper nodes, from above.
inline std::vector<Index> rank_arcs(const Leaf_pruning& graph, std::vector<Index> arcs)
{
  std::sort(arcs.begin(), arcs.end(), [&](Index a, Index b) {
    return std::make_tuple(graph.arc(a).lower, graph.arc(b).upper, a)
         < std::make_tuple(graph.arc(b).lower, graph.arc(a).upper, b);
  });
  std::vector<Index> ranks(graph.number_of_arcs(), no_index);
  for(Index i = 0; i != arcs.size(); ++i)
    ranks[arcs[i]] = i;
  return ranks;
}

// Removes one side of each loop that `is_small(split saddle, join saddle)` names and that has a single arc on this
// side. The arc is taken up by the lowest one of the other side. Returns whether there has been such a loop. As for
// pairs, a forest is maximal by lower ends; as no other loop has passed the arc by then, the other loops keep their
// nodes.
template <class IsSmall>
bool remove_small_loops(Leaf_pruning& graph, const IsSmall& is_small)
{
  bool is_changed = false;
  std::vector<bool> is_left(graph.number_of_arcs());
  for(Index arc = 0; arc != graph.number_of_arcs(); ++arc)
    is_left[arc] = graph.is_left(graph.place_of_arc(arc));
  const std::vector<Index> arcs =
    core_arcs(graph.number_of_nodes(), std::move(is_left), [&](Index arc) { return graph.arc(arc); });
  const std::vector<Index> ranks = rank_arcs(graph, arcs);
  Highest_forest forest(checked_index(2 * std::size_t(graph.number_of_nodes())) / 2);
  for(const Index arc : arcs)
  {
    const auto [lower, upper] = graph.arc(arc);
    const auto cycle = forest.add({lower, upper, ranks[arc], arc});
    if(cycle.leaving == no_index)
      continue;
    const auto [split, join] = graph.arc(cycle.leaving);
    if(join != upper || !is_small(split, join))
      continue;
    const bool is_other_known = cycle.lowest_other != cycle.leaving;
    const Index owner = is_other_known               ? graph.place_of_arc(cycle.lowest_other)
                      : graph.out_degree(split) == 2 ? graph.place_of_arc(graph.other_arc_above(split, cycle.leaving))
                                                     : split;
    graph.remove_arc(cycle.leaving, owner);
    is_changed = true;
  }
  return is_changed;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_GRAPH_REMOVE_SMALL_LOOPS_H
