// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_RANDOM_GRAPHS_H
#define CGAL_REEB_GRAPH_TEST_RANDOM_GRAPHS_H

#include "random_meshes.h"

#include <CGAL/Reeb_graph_traits.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

// Graphs with ascending nodes that no mesh needs to have.
namespace random_graphs {
using random_meshes::Random;
typedef std::pair<std::size_t, std::size_t> Arc; // lower and upper node
typedef CGAL::Reeb_graph::Node<std::size_t, double> Node;
typedef CGAL::Reeb_graph::Arc<std::size_t> Arc_properties;
typedef boost::adjacency_list<boost::vecS, boost::vecS, boost::bidirectionalS, Node, Arc_properties> Graph;

// The values of the nodes are their numbers. Each arc has a chain of one halfedge, its number.
inline Graph make_graph(std::size_t number_of_nodes, std::vector<Arc> arcs)
{
  std::sort(arcs.begin(), arcs.end());
  Graph graph(number_of_nodes);
  std::vector<std::size_t> numbers;
  for(const Arc& arc : arcs)
  {
    numbers.push_back(numbers.size());
    add_edge(arc.first, arc.second, graph);
  }
  const auto storage = std::make_shared<const std::vector<std::size_t>>(numbers);
  std::size_t number = 0;
  for(auto range = edges(graph); range.first != range.second; ++range.first)
    graph[*range.first].chain = {storage, number++, 1};
  for(std::size_t node = 0; node < number_of_nodes; ++node)
  {
    const std::size_t below = in_degree(node, graph), above = out_degree(node, graph);
    using CGAL::Reeb_graph::Node_kind;
    graph[node] = {static_cast<double>(node), node,
                   below == 0                 ? (above == 0 ? Node_kind::ISOLATED : Node_kind::MINIMUM)
                   : above == 0               ? Node_kind::MAXIMUM
                   : below == 1 && above == 1 ? Node_kind::DEGREE_TWO
                                              : Node_kind::SADDLE};
  }
  return graph;
}

// Up to 14 nodes in several components, parallel arcs, and hubs where many arcs meet.
inline Graph random_graph(Random& random)
{
  const std::size_t size = random.below(15);
  std::vector<Arc> arcs;
  if(size < 2)
    return make_graph(size, arcs);
  const std::size_t hub = random.below(size), reach = 1 + random.below(size);
  for(std::size_t trial = random.below(3 * size); trial > 0; --trial)
  {
    const std::size_t u = random.below(4) == 0 ? hub : random.below(size);
    const std::size_t v = (u + 1 + random.below(reach)) % size;
    if(u != v)
      arcs.insert(arcs.end(), 1 + random.below(8) / 7, Arc((std::min)(u, v), (std::max)(u, v)));
  }
  return make_graph(size, arcs);
}

// A tree, or a few more arcs than that, of any number of nodes.
inline Graph random_sparse_graph(std::size_t size, std::size_t number_of_loops, Random& random)
{
  std::vector<Arc> arcs;
  std::vector<std::size_t> numbers(size);
  for(std::size_t i = 0; i < size; ++i)
    numbers[i] = i;
  random.shuffle(numbers);
  const auto add = [&](std::size_t i, std::size_t j) {
    arcs.emplace_back((std::min)(numbers[i], numbers[j]), (std::max)(numbers[i], numbers[j]));
  };
  const std::size_t reach = 1 + random.below(size);
  for(std::size_t i = 1; i < size; ++i)
    add(i, i - 1 - random.below((std::min)(i, reach)));
  for(; number_of_loops > 0 && size > 1; --number_of_loops)
  {
    const std::size_t i = 1 + random.below(size - 1);
    add(i, random.below(i));
  }
  return make_graph(size, arcs);
}

// Each arc the other way, each node with the number of its counterpart.
inline Graph upside_down(const Graph& graph)
{
  std::vector<Arc> arcs;
  const std::size_t last = num_vertices(graph) - 1;
  for(auto range = edges(graph); range.first != range.second; ++range.first)
    arcs.emplace_back(last - target(*range.first, graph), last - source(*range.first, graph));
  return make_graph(num_vertices(graph), arcs);
}

} // namespace random_graphs

#endif // CGAL_REEB_GRAPH_TEST_RANDOM_GRAPHS_H
