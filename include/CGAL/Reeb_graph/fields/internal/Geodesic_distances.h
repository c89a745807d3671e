// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_GEODESIC_DISTANCES_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_GEODESIC_DISTANCES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/fields/internal/Intrinsic_triangulation.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

// Distances from the sources that grow from vertex to vertex, as those of Dijkstra's algorithm, along the edges and
// straight through the triangles (M. Novotni and R. Klein, Computing Geodesic Distances on Triangular Meshes, 2002).
// A way may bend at each vertex, and each vertex knows where that to it has last done so, its origin. Each vertex of a
// component with a source gets a finite distance. Vertices get theirs in ascending order, so that along an edge, of the
// surface or of the triangulation, they differ by no more than its length. None is less than that in space.
class Geodesic_distances
{
public:
  Geodesic_distances(const Indexed_surface& surface, const Intrinsic_triangulation& triangulation)
    : surface_(surface),
      triangulation_(triangulation),
      outgoing_(surface.number_of_vertices(), no_index),
      flipped_edges_(surface.number_of_vertices(),
                     [&](const auto& visit) {
                       for(const auto& e : triangulation.flipped_edges())
                       {
                         visit(Vertex_index(e.source), End{e.target, e.length});
                         visit(Vertex_index(e.target), End{e.source, e.length});
                       }
                     }),
      distances_(surface.number_of_vertices(), std::numeric_limits<double>::infinity()),
      origins_(surface.number_of_vertices(), no_index),
      is_final_(surface.number_of_vertices(), false)
  {
    for(Halfedge h = 0; h != triangulation.number_of_halfedges(); ++h)
    {
      Halfedge& outgoing = outgoing_[triangulation.source(h)];
      if(outgoing == no_index || triangulation.opposite(h) == no_index)
        outgoing = h;
    }
  }

  // The distances from the sources, for the points divided by surface.scale(): infinite where there is no source.
  std::vector<double> operator()(const std::vector<bool>& is_source, const Stage_progress& progress)
  {
    for(Index v = 0; v != surface_.number_of_vertices(); ++v)
      if(is_source[v])
        reach(v, 0, v);
    for(std::size_t step = 0; !queue_.empty();)
    {
      const Index v = queue_.top().second;
      queue_.pop();
      if(is_final_[v])
        continue;
      progress.report_step(step++, surface_.number_of_vertices());
      is_final_[v] = true;
      leave(v);
    }
    return std::move(distances_);
  }

private:
  typedef Intrinsic_triangulation::Halfedge Halfedge;
  typedef std::pair<double, Index> Entry;

  struct End
  {
    Index vertex;
    double length;
  };

  // Reaches the neighbors of a vertex that has just got its distance.
  void leave(Index v)
  {
    for(const End& end : flipped_edges_[Vertex_index(v)])
      reach(end.vertex, distances_[v] + end.length, v);
    // counterclockwise, at a border vertex from border to border
    const Halfedge first = outgoing_[v];
    for(Halfedge h = first; h != no_index;)
    {
      cross_triangle(h);
      h = triangulation_.opposite(triangulation_.previous(h));
      if(h == first)
        break;
    }
  }

  // Reaches the other corners of a triangle from the source of one of its halfedges.
  void cross_triangle(Halfedge h)
  {
    const Halfedge next = triangulation_.next(h), previous = triangulation_.previous(h);
    const Index v = triangulation_.source(h), a = triangulation_.source(next), b = triangulation_.source(previous);
    const double va = triangulation_.length(h), ab = triangulation_.length(next), bv = triangulation_.length(previous);
    reach(a, distances_[v] + va, v);
    reach(b, distances_[v] + bv, v);
    if(is_final_[a] && !is_final_[b])
      reach_through(v, a, va, b, bv, ab);
    if(is_final_[b] && !is_final_[a])
      reach_through(v, b, bv, a, va, ab);
  }

  // Reaches c through the edge from v, the last vertex with a distance, to a: straight from the one point in the plane
  // of the triangle, beyond the edge, that has the right distances from both, if there is one.
  void reach_through(Index v, Index a, double va, Index c, double vc, double ac)
  {
    const Index origin_of_v = origins_[a] == v ? v : origins_[v], origin_of_a = origins_[v] == a ? a : origins_[a];
    const Index origin = common_origin(origin_of_v, origin_of_a);
    const double offset = origin == no_index ? 0 : distances_[origin];
    const double from_v = distances_[v] - offset, from_a = distances_[a] - offset;
    if(from_v + from_a < va)
      return;
    const auto [x_of_source, y_of_source] = place_above(va, from_v, from_a);
    const auto [x, y] = place_above(va, vc, ac);
    const double crossing = x_of_source + (x - x_of_source) * (y_of_source / (y_of_source + y));
    if(!(crossing >= 0 && crossing <= va))
      return;
    // The point is too near where ways from both sides meet.
    const double bound_of_v = bound(origin_of_v, c), bound_of_a = bound(origin_of_a, c);
    const double distance = offset + std::hypot(x - x_of_source, y + y_of_source);
    reach(c, (std::max)({distance, (std::min)(bound_of_v, bound_of_a), distances_[v]}),
          origin != no_index ? origin : (bound_of_v < bound_of_a ? origin_of_v : origin_of_a));
  }

  // The origin that two of them have in common, if one is the other one's, or no_index.
  Index common_origin(Index a, Index b) const
  {
    if(a == b || origins_[a] == b)
      return b;
    return origins_[b] == a ? a : no_index;
  }

  // The length of no way by an origin is less.
  double bound(Index origin, Index v) const
  {
    return distances_[origin] + length(surface_.point(v) - surface_.point(origin));
  }

  void reach(Index v, double distance, Index origin)
  {
    if(is_final_[v] || !(distance < distances_[v]))
      return;
    distances_[v] = distance;
    origins_[v] = origin;
    queue_.push({distance, v});
  }

  const Indexed_surface& surface_;
  const Intrinsic_triangulation& triangulation_;
  std::vector<Halfedge> outgoing_; // of each vertex, at a border vertex from which all others come counterclockwise
  const Buckets<Vertex_index, End> flipped_edges_;
  std::vector<double> distances_;
  std::vector<Index> origins_;
  std::vector<bool> is_final_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue_;
};

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_GEODESIC_DISTANCES_H
