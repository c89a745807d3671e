// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_LAPLACIAN_GRAPH_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_LAPLACIAN_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/Field_report.h>
#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/fields/internal/Weighted_graph.h>
#include <CGAL/Reeb_graph/options.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

// The weights of the Laplacian.
inline Weighted_graph laplacian_graph(const Indexed_surface& surface, Laplacian_weights weights)
{
  return Weighted_graph(surface.number_of_vertices(), [&](const auto& visit) {
    const auto visit_both = [&](Position u, Position v, double weight) {
      visit(Weighted_graph::Contribution{u, v, weight});
      visit(Weighted_graph::Contribution{v, u, weight});
    };
    for(std::size_t t = 0; t != surface.triangles().size(); ++t)
    {
      const auto& [v, is_on_border] = surface.triangles()[t];
      const bool has_geometry = weights != Laplacian_weights::UNIFORM;
      const Triangle_geometry geometry = has_geometry ? triangle_geometry(surface, t) : Triangle_geometry();
      for(int i = 0; i != 3; ++i)
      {
        const int next = (i + 1) % 3, previous = (i + 2) % 3;
        if(weights == Laplacian_weights::UNIFORM) // w_ij = 1
          visit_both(v[i], v[next], is_on_border[i] ? 1 : 0.5);
        else if(weights == Laplacian_weights::COTANGENT) // the mean of the cotangents of the angles that face the edge
          visit_both(v[next], v[previous], geometry.cotangent(i) / 2);
        else // the tangents of half the angles at v_i on both sides of the edge, divided by its length
        {
          const double half_tangent = geometry.half_tangent(i);
          visit(Weighted_graph::Contribution{v[i], v[next], half_tangent / length(geometry.edges[i])});
          visit(Weighted_graph::Contribution{v[i], v[previous], half_tangent / length(geometry.edges[previous])});
        }
      }
    }
  });
}

// Calls solve(graph, fraction), with the fraction of the work that is done when its equations have been set up. If they
// have no finite solution, and the edges have their own lengths, it makes them longer, and calls it once more.
template <class Solve>
auto solve_or_lengthen_edges(Indexed_surface& surface,
                             const Weighted_graph& graph,
                             Laplacian_weights weights,
                             Field_report& report,
                             const Solve& solve)
{
  if(weights == Laplacian_weights::UNIFORM || surface.added_length() > 0)
    return solve(graph, 0.2);
  try
  {
    return solve(graph, 0.2);
  }
  catch(const Linear_solver_error&)
  {}
  catch(const Non_finite_scalar_error&)
  {}
  lengthen_edges(surface, report);
  return solve(laplacian_graph(surface, weights), 0.6);
}

// The vertex of least value of each component, the first one if there are several.
inline std::vector<Position> lowest_vertices_of_components(const Weighted_graph& graph,
                                                           const std::vector<double>& values)
{
  const std::vector<Position> labels = label_components(graph);
  std::vector<Position> lowest_vertices;
  for(Position v = 0; v != graph.number_of_vertices(); ++v)
    if(labels[v] == lowest_vertices.size())
      lowest_vertices.push_back(v);
    else if(values[v] < values[lowest_vertices[labels[v]]])
      lowest_vertices[labels[v]] = v;
  return lowest_vertices;
}

// Two vertices of each component: the one farthest from its first vertex along the edges, and the one farthest from
// that; of several the first one. They are the same only in a component of a single vertex.
inline std::vector<std::pair<Position, Position>> far_apart_vertices(const Indexed_surface& surface,
                                                                     const Weighted_graph& graph)
{
  typedef std::pair<double, Position> Entry;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> distances(graph.number_of_vertices(), infinity); // between two searches
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  const auto farthest_from = [&](Position source) {
    std::vector<Position> reached;
    const auto reach = [&](double distance, Position v) {
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
        reach(entry.first + length(surface.point(n.vertex) - surface.point(entry.second)), n.vertex);
    }
    for(const Position v : reached)
      distances[v] = infinity;
    return farthest.second;
  };
  const std::vector<Position> labels = label_components(graph);
  std::vector<std::pair<Position, Position>> pairs;
  for(Position v = 0; v != graph.number_of_vertices(); ++v)
    if(labels[v] == pairs.size())
    {
      const Position lowest = farthest_from(v), highest = farthest_from(lowest);
      const auto neighbors = graph.neighbors(lowest);
      const bool do_all_points_coincide = lowest == highest && !neighbors.empty();
      pairs.emplace_back(lowest, do_all_points_coincide ? neighbors.begin()->vertex : highest);
    }
  return pairs;
}

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_LAPLACIAN_GRAPH_H
