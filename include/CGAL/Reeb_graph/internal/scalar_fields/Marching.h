// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_MARCHING_H
#define CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_MARCHING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/scalar_fields/Indexed_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

// Distances from the sources that grow from vertex to vertex, as those of Dijkstra's algorithm, along the edges and
// straight through the triangles (M. Novotni and R. Klein, Computing Geodesic Distances on Triangular Meshes, 2002).
// They depend on the lengths of edges only, no equation is solved, and each vertex of a component with a source gets a
// finite one. Along an edge they grow by no more than its length.
class Marching
{
public:
  Marching(const Indexed_surface& surface, const std::vector<bool>& is_source)
    : surface_(surface),
      first_(surface.number_of_vertices() + 1, 0),
      distances_(surface.number_of_vertices(), std::numeric_limits<double>::infinity()),
      is_final_(surface.number_of_vertices(), false)
  {
    list_triangles();
    for(Position v = 0; v != surface.number_of_vertices(); ++v)
      if(is_source[v])
        reach(v, 0);
    march();
  }

  // The distances for the points divided by surface.scale().
  const std::vector<double>& distances() const { return distances_; }

private:
  typedef std::pair<double, Position> Entry;

  void list_triangles()
  {
    for(const Indexed_triangle& t : surface_.triangles())
      for(const Position v : t.vertices)
        ++first_[v + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    triangles_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for(std::size_t t = 0; t != surface_.triangles().size(); ++t)
      for(const Position v : surface_.triangles()[t].vertices)
        triangles_[next[v]++] = t;
  }

  void march()
  {
    while(!queue_.empty())
    {
      const Position v = queue_.top().second;
      queue_.pop();
      if(is_final_[v])
        continue;
      is_final_[v] = true;
      for(std::size_t i = first_[v]; i != first_[v + 1]; ++i)
        cross_triangle(surface_.triangles()[triangles_[i]], v);
    }
  }

  // Reaches the other corners of a triangle from one that has just got its distance.
  void cross_triangle(const Indexed_triangle& triangle, Position v)
  {
    const auto& corners = triangle.vertices;
    const std::size_t i = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), v) - corners.begin());
    const Position a = corners[(i + 1) % 3], b = corners[(i + 2) % 3];
    for(const auto& [from, to] : {std::make_pair(a, b), std::make_pair(b, a)})
    {
      reach(to, distances_[v] + surface_.edge_length(v, to));
      if(is_final_[from])
        reach(to, distance_through(v, from, to));
    }
  }

  void reach(Position v, double distance)
  {
    if(is_final_[v] || !(distance < distances_[v]))
      return;
    distances_[v] = distance;
    queue_.push({distance, v});
  }

  // The distance of c through the edge from a to b, of one source of their distances that lies in the plane of the
  // triangle beyond the edge: infinite if there is none, or if the way misses the edge.
  double distance_through(Position a, Position b, Position c) const
  {
    const double ab = surface_.edge_length(a, b), ac = surface_.edge_length(a, c), bc = surface_.edge_length(b, c);
    const auto [x_of_source, y_of_source] = place(ab, distances_[a], distances_[b]);
    const auto [x, y] = place(ab, ac, bc);
    const double crossing = x_of_source + (x - x_of_source) * (y_of_source / (y_of_source + y));
    return crossing >= 0 && crossing <= ab ? std::hypot(x - x_of_source, y + y_of_source)
                                           : std::numeric_limits<double>::infinity();
  }

  // The point, above the x-axis, at these distances from the origin and from the point (base, 0).
  static std::pair<double, double> place(double base, double from_origin, double from_end)
  {
    const double x = (base + (from_origin - from_end) * ((from_origin + from_end) / base)) / 2;
    return {x, std::sqrt((std::max)((from_origin - x) * (from_origin + x), 0.))};
  }

  const Indexed_surface& surface_;
  std::vector<std::size_t> first_, triangles_; // the triangles of each vertex
  std::vector<double> distances_;
  std::vector<bool> is_final_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue_;
};

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_MARCHING_H
