// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_NODE_NEIGHBORS_H
#define CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_NODE_NEIGHBORS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/simplification/exceptions.h>

#include <CGAL/Iterator_range.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// For each node of a graph, the other ends of its arcs on one side, one for each arc.
class Node_neighbors
{
public:
  typedef Iterator_range<const Index*> Range;

  Index number_of_nodes() const { return static_cast<Index>(begins_.size() - 1); }
  Index number_of_arcs() const { return static_cast<Index>(neighbors_.size()); }
  Index degree(Index node) const { return begins_[node + 1] - begins_[node]; }
  Range operator[](Index node) const
  {
    return Range(neighbors_.data() + begins_[node], neighbors_.data() + begins_[node + 1]);
  }

  // To be called for one node after the other, and for each arc of it in between.
  void begin_node() { begins_.push_back(static_cast<Index>(neighbors_.size())); }
  void add(Index neighbor) { neighbors_.push_back(neighbor); }
  void end_nodes() { begin_node(); }

  void reserve(Index nodes, Index arcs)
  {
    begins_.reserve(nodes + std::size_t(1));
    neighbors_.reserve(arcs);
  }

private:
  std::vector<Index> begins_; // by node, and the end of the last one
  std::vector<Index> neighbors_;
};

// The ends of the arcs of a graph whose nodes are numbered in ascending order.
struct Flat_arc_ends
{
  Node_neighbors lower, upper; // the lower ends of the arcs below a node, the upper ends of those above
};

// The arcs of a Boost graph. Throws if one of them does not ascend.
template <class ReebGraph>
Flat_arc_ends read_arc_ends(const ReebGraph& graph)
{
  const Index number_of_nodes = checked_index(num_vertices(graph)), number_of_arcs = checked_index(num_edges(graph));
  Flat_arc_ends ends;
  ends.lower.reserve(number_of_nodes, number_of_arcs);
  ends.upper.reserve(number_of_nodes, number_of_arcs);
  for(Index node = 0; node != number_of_nodes; ++node)
  {
    ends.lower.begin_node();
    ends.upper.begin_node();
    for(auto arcs = in_edges(node, graph); arcs.first != arcs.second; ++arcs.first)
    {
      const auto lower = source(*arcs.first, graph);
      if(lower >= node)
        throw Arc_direction_error();
      ends.lower.add(static_cast<Index>(lower));
    }
    for(auto arcs = out_edges(node, graph); arcs.first != arcs.second; ++arcs.first)
      ends.upper.add(static_cast<Index>(target(*arcs.first, graph)));
  }
  ends.lower.end_nodes();
  ends.upper.end_nodes();
  return ends;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_NODE_NEIGHBORS_H
