// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_TRIANGLE_COMPLEX_H
#define CGAL_REEB_GRAPH_INTERNAL_TRIANGLE_COMPLEX_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/Large_vector.h>
#include <CGAL/Reeb_graph/internal/parallel.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Vertices, edges and halfedges are numbered by 32-bit integers: half the memory traffic of the sweeps.
typedef std::uint32_t Index;
constexpr Index no_index = (std::numeric_limits<Index>::max)();

inline Index checked_index(std::size_t i)
{
  if(i >= no_index)
    throw Mesh_size_error();
  return static_cast<Index>(i);
}

struct Halfedge
{
  Index target;
  Index next; // in its triangle; no_index if it has none
};

// What a Triangle_complex is made from.
struct Halfedge_arrays
{
  Large_vector<Halfedge> halfedges;
  std::size_t number_of_halfedges_of_triangles = 0;
  Large_vector<Index> halfedges_of_vertices; // one of a triangle that ends there; no_index if there is none
};

// An oriented triangulated surface as flat arrays. The two halfedges of edge e are 2 e and 2 e + 1. A halfedge has its
// triangle on the left, or none, along the border.
class Triangle_complex
{
public:
  template <class ConcurrencyTag>
  Triangle_complex(ConcurrencyTag, Halfedge_arrays arrays)
    : halfedges_(std::move(arrays.halfedges)),
      first_halfedges_(std::move(arrays.halfedges_of_vertices))
  {
    // A halfedge data structure leads to one fan of triangles per vertex only, but here all halfedges are known.
    if(begin_fans_at_border<ConcurrencyTag>() != arrays.number_of_halfedges_of_triangles)
      throw_non_manifold_vertex_error();
  }

  Index number_of_vertices() const { return static_cast<Index>(first_halfedges_.size()); }
  Index number_of_halfedges() const { return static_cast<Index>(halfedges_.size()); }
  Index number_of_edges() const { return number_of_halfedges() / 2; }

  static Index edge(Index halfedge) { return halfedge / 2; }
  static Index opposite(Index halfedge) { return halfedge ^ 1; }

  Index target(Index halfedge) const { return halfedges_[halfedge].target; }
  Index source(Index halfedge) const { return target(opposite(halfedge)); }

  bool has_triangle(Index halfedge) const { return next(halfedge) != no_index; }
  bool is_on_border_edge(Index halfedge) const { return !has_triangle(halfedge) || !has_triangle(opposite(halfedge)); }

  bool is_on_triangle(Index edge) const { return has_triangle(2 * edge) || has_triangle(2 * edge + 1); }
  // For an edge on a triangle.
  Index halfedge_of_triangle(Index edge) const { return has_triangle(2 * edge) ? 2 * edge : 2 * edge + 1; }

  // In the triangle of the halfedge.
  Index next(Index halfedge) const { return halfedges_[halfedge].next; }
  Index previous(Index halfedge) const { return next(next(halfedge)); }

  // A halfedge of a triangle that ends at `vertex`, no_index if there is none. At a border vertex it is the one from
  // which turning clockwise meets all others.
  Index first_halfedge(Index vertex) const { return first_halfedges_[vertex]; }

  // The next halfedge with the same target, clockwise. Behind the border it has no triangle.
  Index clockwise(Index halfedge) const { return opposite(next(halfedge)); }

  bool is_on_border(Index vertex) const
  {
    const Index halfedge = first_halfedge(vertex);
    return halfedge != no_index && !has_triangle(opposite(halfedge));
  }

  // Calls visit(neighbor, halfedge), where `halfedge` is a halfedge of a triangle on the edge to `neighbor`, for the
  // edges at `vertex`, turning clockwise, at a border vertex from border edge to border edge, until a call returns
  // true.
  template <class Visit>
  void visit_edges_around(Index vertex, const Visit& visit) const
  {
    const Index first = first_halfedge(vertex);
    for(Index halfedge = first; halfedge != no_index;)
    {
      if(visit(source(halfedge), halfedge))
        return;
      const Index turned = clockwise(halfedge);
      if(turned == first)
        return;
      if(!has_triangle(turned))
      {
        visit(source(turned), opposite(turned));
        return;
      }
      halfedge = turned;
    }
  }

  // The same for each edge at `vertex`.
  template <class Visit>
  void for_each_edge_around(Index vertex, const Visit& visit) const
  {
    visit_edges_around(vertex, [&](Index neighbor, Index halfedge) {
      visit(neighbor, halfedge);
      return false;
    });
  }

  // Calls visit(halfedge) for the halfedges of triangles that end at `vertex`, clockwise.
  template <class Visit>
  void for_each_halfedge_around(Index vertex, const Visit& visit) const
  {
    const Index first = first_halfedge(vertex);
    for(Index halfedge = first; halfedge != no_index;)
    {
      visit(halfedge);
      halfedge = clockwise(halfedge);
      if(halfedge == first || !has_triangle(halfedge))
        return;
    }
  }

private:
  // Lets the fan of each border vertex begin at the border. Returns the number of halfedges of all fans.
  template <class ConcurrencyTag>
  std::size_t begin_fans_at_border()
  {
    Shared_counter<ConcurrencyTag> number_of_halfedges_of_fans;
    for_each_block<ConcurrencyTag>(number_of_vertices(), [&](std::size_t begin, std::size_t end) {
      std::size_t sum = 0;
      for(std::size_t v = begin; v != end; ++v)
        sum += begin_fan_at_border(first_halfedges_[v]);
      number_of_halfedges_of_fans.add(sum);
    });
    return number_of_halfedges_of_fans.get();
  }

  // Returns the number of halfedges of the fan.
  std::size_t begin_fan_at_border(Index& first) const
  {
    if(first == no_index)
      return 0;
    std::size_t size = 1;
    Index halfedge = clockwise(first);
    for(; halfedge != first && has_triangle(halfedge); halfedge = clockwise(halfedge))
      ++size;
    if(halfedge == first)
      return size;
    for(; has_triangle(opposite(first)); ++size)
      first = previous(opposite(first));
    return size;
  }

  void throw_non_manifold_vertex_error() const
  {
    Large_vector<Index> unreached(number_of_vertices(), 0);
    for(Index h = 0; h != number_of_halfedges(); ++h)
      unreached[target(h)] += has_triangle(h) ? 1 : 0;
    for(Index v = 0; v != number_of_vertices(); ++v)
    {
      for_each_halfedge_around(v, [&](Index) { --unreached[v]; });
      if(unreached[v] != 0)
        throw Non_manifold_vertex_error(v);
    }
  }

  Large_vector<Halfedge> halfedges_; // both members in one line of the cache, with the opposite halfedge
  Large_vector<Index> first_halfedges_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_TRIANGLE_COMPLEX_H
