// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_ORACLE_PARTS_H
#define CGAL_REEB_GRAPH_TEST_ORACLE_PARTS_H

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <vector>

// What the oracles of Reeb graphs by definition have in common. It has nothing in common with the package.
namespace oracle_parts {
constexpr std::size_t none = static_cast<std::size_t>(-1);

// The vertices in the order by (value, index).
template <class Scalar>
std::vector<std::size_t> order_by_value(const std::vector<Scalar>& values)
{
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t u, std::size_t v) { return values[u] < values[v]; });
  return order;
}

// By vertex, its place in an order.
inline std::vector<std::size_t> ranks_in(const std::vector<std::size_t>& order)
{
  std::vector<std::size_t> ranks(order.size());
  for(std::size_t i = 0; i < order.size(); ++i)
    ranks[order[i]] = i;
  return ranks;
}

// A component between two levels. The points of a graph are the components at the levels.
struct Strip
{
  std::vector<std::size_t> edges; // ascending
  std::size_t lower, upper;       // points
  std::size_t arc;
};

struct Arc
{
  std::size_t lower, upper; // nodes
};

// A point that is a node: its level, its name, and its number.
typedef std::tuple<std::size_t, std::size_t, std::size_t> Node_key;

// Numbers the nodes, and returns their points.
template <class Point>
std::vector<std::size_t> number_nodes(std::vector<Node_key> keys, std::vector<Point>& points)
{
  std::vector<std::size_t> nodes;
  std::sort(keys.begin(), keys.end());
  for(const Node_key& key : keys)
  {
    points[std::get<2>(key)].node = nodes.size();
    nodes.push_back(std::get<2>(key));
  }
  return nodes;
}

// Follows the strips above each node up to the next ones, and numbers the arcs that they make up, in no particular
// order.
template <class Point>
std::vector<Arc> number_arcs(const std::vector<std::size_t>& nodes,
                             std::vector<Point>& points,
                             std::vector<Strip>& strips)
{
  std::vector<Arc> arcs;
  for(std::size_t node = 0; node < nodes.size(); ++node)
    for(std::size_t strip : points[nodes[node]].strips_above)
    {
      strips[strip].arc = arcs.size();
      while(points[strips[strip].upper].node == none)
      {
        Point& point = points[strips[strip].upper];
        point.arc = arcs.size();
        strip = point.strips_above.front();
        strips[strip].arc = arcs.size();
      }
      arcs.push_back({node, points[strips[strip].upper].node});
    }
  return arcs;
}

} // namespace oracle_parts

#endif // CGAL_REEB_GRAPH_TEST_ORACLE_PARTS_H
