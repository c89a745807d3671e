// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_FAR_APART_VERTICES_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_FAR_APART_VERTICES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/internal/Weighted_graph.h>

#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

// Finds the vertex of a component that is farthest from another one along the edges, the first one if there are
// several.
class Farthest_vertex_search
{
public:
  Farthest_vertex_search(const Indexed_surface& surface, const Weighted_graph& graph)
    : surface_(surface),
      graph_(graph),
      distances_(graph.number_of_vertices(), std::numeric_limits<double>::infinity())
  {}

  Position operator()(Position source)
  {
    Entry farthest(0, source);
    reach(farthest);
    while(!queue_.empty())
    {
      const Entry entry = queue_.top();
      queue_.pop();
      if(entry.first > distances_[entry.second])
        continue;
      if(entry.first > farthest.first)
        farthest = entry;
      for(const auto& n : graph_.neighbors(entry.second))
        reach({entry.first + length(surface_.point(n.vertex) - surface_.point(entry.second)), n.vertex});
    }
    for(const Position v : reached_)
      distances_[v] = std::numeric_limits<double>::infinity();
    reached_.clear();
    return farthest.second;
  }

private:
  typedef std::pair<double, Position> Entry;

  void reach(const Entry& entry)
  {
    if(!(entry.first < distances_[entry.second]))
      return;
    distances_[entry.second] = entry.first;
    reached_.push_back(entry.second);
    queue_.push(entry);
  }

  const Indexed_surface& surface_;
  const Weighted_graph& graph_;
  std::vector<double> distances_;
  std::vector<Position> reached_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue_;
};

// Two vertices of each component: the one farthest from its first vertex, and the one farthest from that. They are the
// same only in a component of a single vertex.
inline std::vector<std::pair<Position, Position>> far_apart_vertices(const Indexed_surface& surface,
                                                                     const Weighted_graph& graph)
{
  const std::vector<Position> labels = label_components(graph);
  Farthest_vertex_search farthest_vertex(surface, graph);
  std::vector<std::pair<Position, Position>> pairs;
  for(Position v = 0; v != graph.number_of_vertices(); ++v)
    if(labels[v] == pairs.size())
    {
      const Position lowest = farthest_vertex(v);
      const Position highest = farthest_vertex(lowest);
      const auto neighbors = graph.neighbors(lowest);
      const bool do_all_points_coincide = lowest == highest && !neighbors.empty();
      pairs.emplace_back(lowest, do_all_points_coincide ? neighbors.begin()->vertex : highest);
    }
  return pairs;
}

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_FAR_APART_VERTICES_H
