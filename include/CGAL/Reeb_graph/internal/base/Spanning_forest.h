// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_SPANNING_FOREST_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_SPANNING_FOREST_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/visitors.hpp>
#include <boost/pending/queue.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The arcs without their directions, numbered in the order of edges(graph): many algorithms of Boost.Graph need that.
typedef boost::adjacency_list<boost::vecS,
                              boost::vecS,
                              boost::undirectedS,
                              boost::no_property,
                              boost::property<boost::edge_index_t, std::size_t>>
  Undirected_graph;

template <class ReebGraph>
Undirected_graph make_undirected(const ReebGraph& graph)
{
  Undirected_graph result(num_vertices(graph));
  std::size_t number = 0;
  for(const auto arc : CGAL::make_range(edges(graph)))
    add_edge(source(arc, graph), target(arc, graph), number++, result);
  return result;
}

// A spanning forest of shortest paths: for each node the edge that leads to it and the number of edges from the root.
class Spanning_forest
{
  typedef boost::graph_traits<Undirected_graph>::edge_descriptor edge_descriptor;
  typedef boost::graph_traits<Undirected_graph>::vertex_descriptor vertex_descriptor;

public:
  explicit Spanning_forest(const Undirected_graph& graph)
    : graph_(graph),
      to_node_(num_vertices(graph)),
      depths_(num_vertices(graph), 0),
      is_in_forest_(num_edges(graph), false)
  {
    std::vector<boost::default_color_type> colors(num_vertices(graph), boost::white_color);
    const auto map_of = [&](auto& values) {
      return boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, graph));
    };
    boost::queue<vertex_descriptor> queue;
    const auto visitor =
      boost::make_bfs_visitor(std::make_pair(boost::record_edge_predecessors(map_of(to_node_), boost::on_tree_edge()),
                                             boost::record_distances(map_of(depths_), boost::on_tree_edge())));
    for(const vertex_descriptor root : CGAL::make_range(vertices(graph)))
    {
      if(colors[root] == boost::white_color)
        boost::breadth_first_visit(graph, root, queue, visitor, map_of(colors));
    }
    for(const vertex_descriptor v : CGAL::make_range(vertices(graph)))
    {
      if(depths_[v] != 0)
        is_in_forest_[get(boost::edge_index, graph, to_node_[v])] = true;
    }
  }

  bool contains(std::size_t arc) const { return is_in_forest_[arc]; }

  // The numbers of the arcs on the path between two nodes of one tree.
  std::vector<std::size_t> path(vertex_descriptor from, vertex_descriptor to) const
  {
    std::vector<std::size_t> begin, end;
    while(from != to)
    {
      const bool is_from_lower = depths_[from] >= depths_[to];
      vertex_descriptor& v = is_from_lower ? from : to;
      (is_from_lower ? begin : end).push_back(get(boost::edge_index, graph_, to_node_[v]));
      v = source(to_node_[v], graph_) == v ? target(to_node_[v], graph_) : source(to_node_[v], graph_);
    }
    begin.insert(begin.end(), end.rbegin(), end.rend());
    return begin;
  }

private:
  const Undirected_graph& graph_;
  std::vector<edge_descriptor> to_node_;
  std::vector<std::size_t> depths_;
  std::vector<bool> is_in_forest_;
};

} // namespace internal

} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_SPANNING_FOREST_H
