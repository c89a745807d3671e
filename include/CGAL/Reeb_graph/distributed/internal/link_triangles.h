// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_LINK_TRIANGLES_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_LINK_TRIANGLES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/exceptions.h>
#include <CGAL/Reeb_graph/distributed/internal/Slab_surface.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/complex/surface_complexes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

struct Corner_tag;
typedef Index_of<Corner_tag> Corner_index; // corner i of triangle t is 3 t + i, as is the halfedge that leaves it

// Finds which halfedges of triangles belong to one edge, and numbers the edges in the order of their lower, then of
// their higher vertices: so ranks that hold the same edges have them in the same order. By counting, without a hash
// table.
class Triangle_linking
{
public:
  Triangle_linking(std::vector<std::array<Vertex_index, 3>> triangles,
                   const Indexed_vector<Vertex_index, Global_vertex>& global_vertices)
    : triangles_(std::move(triangles)),
      global_vertices_(global_vertices),
      halfedges_of_corners_(checked_index(3 * triangles_.size()))
  {}

  // Throws if an edge is on more than two triangles, or on two that are not oriented alike; of such edges, the error
  // names the first one.
  Halfedge_arrays operator()() &&
  {
    number_edges();
    return make_arrays();
  }

private:
  // A halfedge of a triangle at its lower vertex.
  struct Spoke
  {
    Vertex_index higher_end;
    Corner_index corner;

    friend bool operator<(const Spoke& a, const Spoke& b) { return a.higher_end < b.higher_end; }
  };

  Vertex_index source(Corner_index corner) const { return triangles_[corner.number() / 3][corner.number() % 3]; }
  Vertex_index target(Corner_index corner) const { return source(next(corner)); }
  static Corner_index next(Corner_index corner)
  {
    return Corner_index(corner.number() % 3 == 2 ? corner.number() - 2 : corner.number() + 1);
  }

  void number_edges()
  {
    const auto for_each_corner = [&](const auto& visit) {
      for(const Corner_index corner : halfedges_of_corners_.keys())
        visit((std::min)(source(corner), target(corner)), corner);
    };
    const Buckets<Vertex_index, Corner_index> corners(global_vertices_.size(), for_each_corner);
    std::vector<Spoke> spokes;
    for(const Vertex_index v : global_vertices_.keys())
    {
      spokes.clear();
      for(const Corner_index corner : corners[v])
        spokes.push_back({source(corner) == v ? target(corner) : source(corner), corner});
      std::sort(spokes.begin(), spokes.end());
      for(auto begin = spokes.begin(), end = begin; begin != spokes.end(); begin = end)
      {
        while(end != spokes.end() && end->higher_end == begin->higher_end)
          ++end;
        number_edge(v, begin, end);
      }
    }
    if(non_manifold_edge_)
      throw Non_manifold_edge_error(*non_manifold_edge_);
    if(inconsistent_edge_)
      throw Inconsistent_orientation_error(*inconsistent_edge_);
  }

  // The even halfedge of an edge leads to the higher vertex.
  template <class Iterator>
  void number_edge(Vertex_index v, Iterator begin, Iterator end)
  {
    const auto is_reversed = [&](const Spoke& spoke) { return source(spoke.corner) != v; };
    const std::pair<std::size_t, std::size_t> global_edge(global_vertices_[v], global_vertices_[begin->higher_end]);
    if(end - begin > 2 && !non_manifold_edge_)
      non_manifold_edge_ = global_edge;
    if(end - begin == 2 && is_reversed(begin[0]) == is_reversed(begin[1]) && !inconsistent_edge_)
      inconsistent_edge_ = global_edge;
    for(Iterator spoke = begin; spoke != end; ++spoke)
      halfedges_of_corners_[spoke->corner] =
        Halfedge_index(number_of_halfedges_ + (is_reversed(*spoke) ? std::size_t(1) : std::size_t(0)));
    number_of_halfedges_ += 2;
  }

  Halfedge_arrays make_arrays() const
  {
    Halfedge_arrays arrays;
    arrays.halfedges.resize(checked_index(number_of_halfedges_));
    arrays.halfedges_of_vertices.assign(global_vertices_.size(), no_index);
    for(const Corner_index corner : halfedges_of_corners_.keys())
      arrays.halfedges[opposite_of(halfedges_of_corners_[corner])] = {source(corner), no_index};
    for(const Corner_index corner : halfedges_of_corners_.keys())
    {
      const Halfedge_index halfedge = halfedges_of_corners_[corner];
      arrays.halfedges[halfedge] = {target(corner), halfedges_of_corners_[next(corner)]};
      arrays.halfedges_of_vertices[target(corner)] = halfedge;
    }
    return arrays;
  }

  const std::vector<std::array<Vertex_index, 3>> triangles_;
  const Indexed_vector<Vertex_index, Global_vertex>& global_vertices_;
  Indexed_vector<Corner_index, Halfedge_index> halfedges_of_corners_;
  std::size_t number_of_halfedges_ = 0;
  std::optional<std::pair<std::size_t, std::size_t>> non_manifold_edge_; // the first one
  std::optional<std::pair<std::size_t, std::size_t>> inconsistent_edge_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_LINK_TRIANGLES_H
