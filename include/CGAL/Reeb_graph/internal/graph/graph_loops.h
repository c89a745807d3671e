// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_GRAPH_GRAPH_LOOPS_H
#define CGAL_REEB_GRAPH_INTERNAL_GRAPH_GRAPH_LOOPS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/graph/Highest_forest.h>
#include <CGAL/Reeb_graph/internal/graph/read_graph.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The part of a graph that loops are in, its 2-core: the arcs that stay when leaves are removed one after the other,
// unless they are to be kept. They are sorted by their upper nodes. Of a noisy field they are few. `ends(arc)` are its
// nodes, `is_there` tells by arc which there are, and `is_kept` by node.
template <class Ends>
std::vector<Index> core_arcs(Index number_of_nodes,
                             std::vector<bool> is_there,
                             const Ends& ends,
                             const std::vector<bool>& is_kept = {})
{
  struct Node
  {
    Index degree = 0;
    Index arcs = 0; // the exclusive or of their numbers
  };
  std::vector<Node> nodes(number_of_nodes);
  const auto count = [&](Index arc, Index change) {
    for(const Index node : {ends(arc).lower, ends(arc).upper})
    {
      nodes[node].degree += change;
      nodes[node].arcs ^= arc;
    }
  };
  for(Index arc = 0; arc != is_there.size(); ++arc)
  {
    if(is_there[arc])
      count(arc, 1);
  }
  for(Index leaf = 0; leaf != number_of_nodes; ++leaf)
  {
    for(Index node = leaf; nodes[node].degree == 1 && (is_kept.empty() || !is_kept[node]);)
    {
      const Index arc = nodes[node].arcs;
      is_there[arc] = false;
      count(arc, static_cast<Index>(-1));
      node = ends(arc).lower == node ? ends(arc).upper : ends(arc).lower;
    }
  }
  std::vector<Index> arcs;
  for(Index arc = 0; arc != is_there.size(); ++arc)
  {
    if(is_there[arc])
      arcs.push_back(arc);
  }
  std::stable_sort(arcs.begin(), arcs.end(), [&](Index a, Index b) { return ends(a).upper < ends(b).upper; });
  return arcs;
}

// The core of a graph that is as it was given.
inline std::vector<Index> core_arcs(Index number_of_nodes,
                                    const std::vector<Ascending_arc>& arcs,
                                    const std::vector<bool>& is_kept = {})
{
  return core_arcs(
    number_of_nodes, std::vector<bool>(arcs.size(), true), [&](Index arc) { return arcs[arc]; }, is_kept);
}

// Calls visit_pair(split saddle, join saddle) for each independent loop: the upper node of an arc that closes a cycle
// is paired with the highest node that can be the lowest one of such a cycle. Arcs that meet at a node with one arc
// below and one above in the core count as one.
template <class VisitPair>
void pair_loops(const std::vector<Ascending_arc>& arcs, Index number_of_nodes, const VisitPair& visit_pair)
{
  struct Node
  {
    Index degree_below = 0, degree_above = 0;
    Index begin = no_index;  // of the arc that passes it, at first the lower end of the part below
    Index number = no_index; // among those that are not passed
  };
  const std::vector<Index> core = core_arcs(number_of_nodes, arcs);
  std::vector<Node> nodes(number_of_nodes);
  for(const Index arc : core)
  {
    ++nodes[arcs[arc].lower].degree_above;
    ++nodes[arcs[arc].upper].degree_below;
    nodes[arcs[arc].upper].begin = arcs[arc].lower;
  }
  Index size = 0;
  for(Index i = 0; i != number_of_nodes; ++i)
  {
    Node& node = nodes[i];
    if(node.degree_below == 1 && node.degree_above == 1)
      node.begin = nodes[node.begin].begin;
    else if(node.degree_below + node.degree_above != 0)
    {
      node.begin = i;
      node.number = size++;
    }
  }
  Highest_forest forest(checked_index(2 * std::size_t(size)) / 2);
  for(const Index arc : core)
  {
    const Node& upper = nodes[arcs[arc].upper];
    if(upper.number == no_index)
      continue;
    const Index begin = nodes[arcs[arc].lower].begin, number = nodes[begin].number;
    const Index partner = forest.add({number, upper.number, number, begin}).leaving;
    if(partner != no_index)
      visit_pair(partner, arcs[arc].upper);
  }
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_GRAPH_GRAPH_LOOPS_H
