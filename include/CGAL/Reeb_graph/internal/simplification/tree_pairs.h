// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_TREE_PAIRS_H
#define CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_TREE_PAIRS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Disjoint_sets.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/simplification/Node_neighbors.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Sweeps over the nodes upwards. Calls visit_pair(minimum, saddle) where two components meet, for the one of higher
// minimum: the elder rule. The root of a component is its eldest node, the one that the sweep has met first. What is left
// are the components of the graph, by their lowest minima.
template <class VisitPair>
Disjoint_sets<Index> sweep_upwards(const Node_neighbors& lower_ends, const VisitPair& visit_pair)
{
  Disjoint_sets<Index> components(lower_ends.number_of_nodes());
  for(Index node = 0; node != lower_ends.number_of_nodes(); ++node)
  {
    Index root = node;
    for(const Index neighbor : lower_ends[node])
    {
      const Index other_root = components.find(neighbor);
      if(other_root == root)
        continue;
      const Index younger = (std::max)(root, other_root), elder = (std::min)(root, other_root);
      components.link(younger, elder);
      if(younger != node)
        visit_pair(younger, node);
      root = elder;
    }
  }
  return components;
}

// The same downwards: calls visit_pair(saddle, maximum).
template <class VisitPair>
void sweep_downwards(const Node_neighbors& upper_ends, const VisitPair& visit_pair)
{
  Disjoint_sets<Index> components(upper_ends.number_of_nodes());
  for(Index node = upper_ends.number_of_nodes(); node-- != 0;)
  {
    Index root = node;
    for(const Index neighbor : upper_ends[node])
    {
      const Index other_root = components.find(neighbor);
      if(other_root == root)
        continue;
      const Index younger = (std::min)(root, other_root), elder = (std::max)(root, other_root);
      components.link(younger, elder);
      if(younger != node)
        visit_pair(node, younger);
      root = elder;
    }
  }
}

// Calls visit_pair(lowest minimum, highest maximum) for each component.
template <class VisitPair>
void pair_ends_of_components(Disjoint_sets<Index> components, Index number_of_nodes, const VisitPair& visit_pair)
{
  std::vector<Index> highest(number_of_nodes);
  for(Index node = 0; node != number_of_nodes; ++node)
    highest[components.find(node)] = node;
  for(Index node = 0; node != number_of_nodes; ++node)
  {
    if(components.find(node) == node)
      visit_pair(node, highest[node]);
  }
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_TREE_PAIRS_H
