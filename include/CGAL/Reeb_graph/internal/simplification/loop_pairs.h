// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_LOOP_PAIRS_H
#define CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_LOOP_PAIRS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/simplification/Highest_forest.h>
#include <CGAL/Reeb_graph/internal/simplification/Node_neighbors.h>

#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The part of a graph that loops are in, its 2-core: what is left when leaves are removed one after the other. Of a
// noisy field it is small.
class Graph_core
{
public:
  explicit Graph_core(const Flat_arc_ends& ends)
    : ends_(ends),
      is_in_(ends.lower.number_of_nodes(), true),
      degrees_(ends.lower.number_of_nodes())
  {
    for(Index node = 0; node != size(); ++node)
      degrees_[node] = ends.lower.degree(node) + ends.upper.degree(node);
    for(Index node = 0; node != size(); ++node)
      remove_leaves(node);
  }

  Index size() const { return static_cast<Index>(is_in_.size()); }
  bool contains(Index node) const { return is_in_[node]; }

  // Whether one arc of the core enters the node and one leaves it.
  bool is_passed(Index node) const { return degrees_[node] == 2 && degree_in_core(ends_.lower, node) == 1; }

  // Calls visit(lower end) for each arc of the core below a node, where arcs that meet at passed nodes are one.
  template <class Visit>
  void for_each_arc_below(Index node, const Visit& visit) const
  {
    for(const Index neighbor : ends_.lower[node])
    {
      if(!is_in_[neighbor])
        continue;
      Index lower = neighbor;
      while(is_passed(lower))
        lower = neighbor_in_core(lower);
      visit(lower);
    }
  }

private:
  void remove_leaves(Index node)
  {
    while(node != no_index && is_in_[node] && degrees_[node] <= 1)
    {
      is_in_[node] = false;
      const Index next = degrees_[node] == 0 ? no_index : any_neighbor_in_core(node);
      if(next != no_index)
        --degrees_[next];
      node = next;
    }
  }

  Index degree_in_core(const Node_neighbors& neighbors, Index node) const
  {
    Index degree = 0;
    for(const Index neighbor : neighbors[node])
      degree += is_in_[neighbor] ? 1 : 0;
    return degree;
  }

  Index neighbor_in_core(Index node) const { return first_in_core(ends_.lower[node]); }

  Index any_neighbor_in_core(Index node) const
  {
    const Index lower = first_in_core(ends_.lower[node]);
    return lower != no_index ? lower : first_in_core(ends_.upper[node]);
  }

  Index first_in_core(const Node_neighbors::Range& neighbors) const
  {
    for(const Index neighbor : neighbors)
    {
      if(is_in_[neighbor])
        return neighbor;
    }
    return no_index;
  }

  const Flat_arc_ends& ends_;
  std::vector<bool> is_in_;
  std::vector<Index> degrees_; // in the core
};

// Calls visit_pair(split saddle, join saddle) for each independent loop: the upper node of an arc that closes a cycle
// is paired with the highest node that can be the lowest one of such a cycle.
template <class VisitPair>
void pair_loops(const Flat_arc_ends& ends, const VisitPair& visit_pair)
{
  const Graph_core core(ends);
  std::vector<Index> nodes, numbers(core.size(), no_index);
  for(Index node = 0; node != core.size(); ++node)
  {
    if(!core.contains(node) || core.is_passed(node))
      continue;
    numbers[node] = static_cast<Index>(nodes.size());
    nodes.push_back(node);
  }
  Highest_forest forest(checked_index(2 * nodes.size()) / 2);
  for(const Index node : nodes)
  {
    core.for_each_arc_below(node, [&](Index lower) {
      const Index partner = forest.add({numbers[lower], numbers[node], numbers[lower], lower}).leaving;
      if(partner != no_index)
        visit_pair(partner, node);
    });
  }
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_LOOP_PAIRS_H
