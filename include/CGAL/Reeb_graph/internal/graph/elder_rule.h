// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_GRAPH_ELDER_RULE_H
#define CGAL_REEB_GRAPH_INTERNAL_GRAPH_ELDER_RULE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/union_find.h>
#include <CGAL/Reeb_graph/internal/graph/read_graph.h>

#include <algorithm>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Sweeps over the nodes, from below or from above. Calls visit_pair(lower node, upper node) where two components meet,
// for the extremum of the younger one, which the sweep has met later, and the saddle: the elder rule. The root of a
// component is its eldest node. What is left are the components of the graph.
template <class VisitPair>
Disjoint_sets<Index> sweep_over_nodes(Side begin,
                                      const std::vector<Ascending_arc>& arcs,
                                      Index number_of_nodes,
                                      const VisitPair& visit_pair)
{
  const bool is_upwards = begin == Side::LOWER;
  const Buckets<Node_index, Index> earlier_ends(number_of_nodes, [&](const auto& visit) {
    for(const Ascending_arc& arc : arcs)
      visit(Node_index(is_upwards ? arc.upper : arc.lower), is_upwards ? arc.lower : arc.upper);
  });
  Disjoint_sets<Index> components(number_of_nodes);
  for(Index i = 0; i != number_of_nodes; ++i)
  {
    const Index node = is_upwards ? i : number_of_nodes - 1 - i;
    Index root = node;
    for(const Index end : earlier_ends[Node_index(node)])
    {
      const Index other_root = components.find(end);
      if(other_root == root)
        continue;
      const auto [lower, upper] = std::minmax(root, other_root);
      const Index younger = is_upwards ? upper : lower, elder = is_upwards ? lower : upper;
      components.link(younger, elder);
      if(younger != node)
        visit_pair((std::min)(younger, node), (std::max)(younger, node));
      root = elder;
    }
  }
  return components;
}

// By root, the highest node of each component.
inline std::vector<Index> highest_nodes(Disjoint_sets<Index>& components, Index number_of_nodes)
{
  std::vector<Index> highest(number_of_nodes);
  for(Index node = 0; node != number_of_nodes; ++node)
    highest[components.find(node)] = node;
  return highest;
}

// By node, the difference between the highest and the lowest value of its connected component.
inline std::vector<double> component_ranges(const std::vector<Ascending_arc>& arcs, const std::vector<double>& values)
{
  const Index number_of_nodes = static_cast<Index>(values.size());
  Disjoint_sets<Index> components = sweep_over_nodes(Side::LOWER, arcs, number_of_nodes, [](Index, Index) {});
  const std::vector<Index> highest = highest_nodes(components, number_of_nodes);
  std::vector<double> ranges;
  for(Index node = 0; node != number_of_nodes; ++node)
  {
    const Index lowest = components.find(node);
    ranges.push_back(persistence(values[lowest], values[highest[lowest]]));
  }
  return ranges;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_GRAPH_ELDER_RULE_H
