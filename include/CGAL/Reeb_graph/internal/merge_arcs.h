// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_MERGE_ARCS_H
#define CGAL_REEB_GRAPH_INTERNAL_MERGE_ARCS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/Critical_arc.h>
#include <CGAL/Reeb_graph/internal/classify_vertices.h>
#include <CGAL/Reeb_graph_traits.h>

#include <algorithm>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

struct Flat_node
{
  Index vertex;
  Node_kind kind;
};

// The Reeb graph by indices: nodes in ascending order, arcs between positions of nodes, sorted.
struct Flat_graph
{
  std::vector<Flat_node> nodes;
  std::vector<Critical_arc> arcs;
};

inline Node_kind node_kind(Index in_degree, Index out_degree)
{
  if(in_degree == 0)
    return out_degree == 0 ? Node_kind::ISOLATED : Node_kind::MINIMUM;
  if(out_degree == 0)
    return Node_kind::MAXIMUM;
  return in_degree == 1 && out_degree == 1 ? Node_kind::DEGREE_TWO : Node_kind::SADDLE;
}

// Makes nodes of the critical vertices, and one arc of those that meet at a critical vertex that is no node.
template <class Order>
Flat_graph merge_arcs(const Order& order,
                      const Critical_vertices& critical_vertices,
                      const std::vector<Critical_arc>& arcs,
                      bool are_degree_two_nodes_kept)
{
  const Index size = critical_vertices.size();
  std::vector<Index> in_degrees(size, 0), out_degrees(size, 0), next_critical(size, no_index);
  for(const Critical_arc& arc : arcs)
  {
    ++in_degrees[arc.upper];
    ++out_degrees[arc.lower];
    next_critical[arc.lower] = arc.upper;
  }

  Flat_graph graph;
  std::vector<Index> node_of_critical(size, no_index);
  for(Index i = 0; i != size; ++i)
  {
    const Node_kind kind = node_kind(in_degrees[i], out_degrees[i]);
    if(kind == Node_kind::DEGREE_TWO && !are_degree_two_nodes_kept)
      continue;
    node_of_critical[i] = static_cast<Index>(graph.nodes.size());
    graph.nodes.push_back({critical_vertices.vertex(i), kind});
  }

  for(const Critical_arc& arc : arcs)
  {
    if(node_of_critical[arc.lower] == no_index)
      continue;
    Index upper = arc.upper;
    while(node_of_critical[upper] == no_index)
      upper = next_critical[upper];
    graph.arcs.push_back({node_of_critical[arc.lower], node_of_critical[upper], arc.first_step});
  }
  std::sort(graph.arcs.begin(), graph.arcs.end(), [&](const Critical_arc& a, const Critical_arc& b) {
    if(a.lower != b.lower || a.upper != b.upper)
      return std::tie(a.lower, a.upper) < std::tie(b.lower, b.upper);
    const Ascending_step &step_a = a.first_step, &step_b = b.first_step;
    return step_a.target != step_b.target ? order(step_a.target, step_b.target) : step_a.edge < step_b.edge;
  });
  return graph;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_MERGE_ARCS_H
