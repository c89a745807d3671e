// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_REMOVE_SMALL_LOOPS_H
#define CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_REMOVE_SMALL_LOOPS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/simplification/Highest_forest.h>
#include <CGAL/Reeb_graph/internal/simplification/Leaf_pruning.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The arcs that are left and in loops, or between two of these, sorted by their upper nodes.
inline std::vector<Index> arcs_of_core(const Leaf_pruning& graph)
{
  struct Node
  {
    Index degree = 0;
    Index arcs = 0; // the exclusive or of their numbers
  };
  std::vector<Node> nodes(graph.number_of_nodes());
  std::vector<bool> is_in_core(graph.number_of_arcs(), false);
  const auto toggle = [&](Index arc, Index change) {
    is_in_core[arc] = !is_in_core[arc];
    for(const Index node : {graph.arc(arc).lower, graph.arc(arc).upper})
    {
      nodes[node].degree += change;
      nodes[node].arcs ^= arc;
    }
  };
  for(Index arc = 0; arc != graph.number_of_arcs(); ++arc)
  {
    if(graph.is_left(graph.place_of_arc(arc)))
      toggle(arc, 1);
  }
  for(Index leaf = 0; leaf != graph.number_of_nodes(); ++leaf)
  {
    Index node = leaf;
    while(nodes[node].degree == 1)
    {
      const Index arc = nodes[node].arcs;
      toggle(arc, static_cast<Index>(-1));
      node = graph.arc(arc).lower == node ? graph.arc(arc).upper : graph.arc(arc).lower;
    }
  }
  std::vector<Index> arcs;
  for(Index arc = 0; arc != graph.number_of_arcs(); ++arc)
  {
    if(is_in_core[arc])
      arcs.push_back(arc);
  }
  std::stable_sort(arcs.begin(), arcs.end(), [&](Index a, Index b) { return graph.arc(a).upper < graph.arc(b).upper; });
  return arcs;
}

// By arc, its place in the order of lower nodes, from below, and then of upper nodes, from above.
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
  const std::vector<Index> arcs = arcs_of_core(graph), ranks = rank_arcs(graph, arcs);
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

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_REMOVE_SMALL_LOOPS_H
