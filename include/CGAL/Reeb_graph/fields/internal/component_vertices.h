// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_COMPONENT_VERTICES_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_COMPONENT_VERTICES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>

#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

// The vertex of least value of each component, the first one if there are several.
inline std::vector<Index> lowest_vertices_of_components(const Weighted_graph& graph, const std::vector<double>& values)
{
  const std::vector<Index> labels = label_components(graph);
  std::vector<Index> lowest_vertices;
  for(Index v = 0; v != graph.number_of_vertices(); ++v)
    if(labels[v] == lowest_vertices.size())
      lowest_vertices.push_back(v);
    else if(values[v] < values[lowest_vertices[labels[v]]])
      lowest_vertices[labels[v]] = v;
  return lowest_vertices;
}

// Two vertices of each component: the one farthest from its first vertex along the edges, and the one farthest from
// that; of several the first one. They are the same only in a component of a single vertex.
inline std::vector<std::pair<Index, Index>> far_apart_vertices(const Indexed_surface& surface,
                                                               const Weighted_graph& graph)
{
  typedef std::pair<double, Index> Entry;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> distances(graph.number_of_vertices(), infinity); // between two searches
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  const auto farthest_from = [&](Index source) {
    std::vector<Index> reached;
    const auto reach = [&](double distance, Index v) {
      if(!(distance < distances[v]))
        return;
      distances[v] = distance;
      reached.push_back(v);
      queue.emplace(distance, v);
    };
    Entry farthest(0, source);
    for(reach(0, source); !queue.empty();)
    {
      const Entry entry = queue.top();
      queue.pop();
      if(entry.first > distances[entry.second])
        continue;
      if(entry.first > farthest.first)
        farthest = entry;
      for(const auto& n : graph.neighbors(entry.second))
        if(distances[n.vertex] > entry.first)
          reach(entry.first + length(surface.point(n.vertex) - surface.point(entry.second)), n.vertex);
    }
    for(const Index v : reached)
      distances[v] = infinity;
    return farthest.second;
  };
  const std::vector<Index> labels = label_components(graph);
  std::vector<std::pair<Index, Index>> pairs;
  for(Index v = 0; v != graph.number_of_vertices(); ++v)
    if(labels[v] == pairs.size())
    {
      const Index lowest = farthest_from(v), highest = farthest_from(lowest);
      const auto neighbors = graph.neighbors(lowest);
      const bool do_all_points_coincide = lowest == highest && !neighbors.empty();
      pairs.emplace_back(lowest, do_all_points_coincide ? neighbors.begin()->vertex : highest);
    }
  return pairs;
}

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_COMPONENT_VERTICES_H
