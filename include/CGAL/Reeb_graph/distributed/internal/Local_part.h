// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_LOCAL_PART_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_LOCAL_PART_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/exceptions.h>
#include <CGAL/Reeb_graph/distributed/internal/Slab_surface.h>
#include <CGAL/Reeb_graph/distributed/internal/exchange.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The part of the surface that a rank has brought, and how large that of all ranks is.
template <class TriangleRange, class ScalarRange>
class Local_part
{
public:
  // Throws if the ranges of the ranks do not fit together, or a rank has not as many values as vertices. Collective.
  template <class VertexRange>
  Local_part(Exchange& exchange,
             const VertexRange& vertices,
             const TriangleRange& triangles,
             const ScalarRange& scalars)
    : triangles_(&triangles),
      scalars_(&scalars),
      number_of_local_triangles_(size_of(triangles)),
      ranges_({})
  {
    Sizes own = {0, size_of(vertices), size_of(scalars), number_of_local_triangles_};
    exchange.in_agreement([&] {
      if(own.vertices == own.scalars) // else the range may be anything
        own.begin = first_of_contiguous(vertices);
    });
    const std::vector<Sizes> all = exchange.all_gather(own);
    std::vector<Vertex_range> ranges;
    for(std::size_t rank = 0; rank != all.size(); ++rank)
    {
      if(all[rank].vertices != all[rank].scalars)
        throw Scalar_count_error(all[rank].scalars, all[rank].vertices);
      ranges.push_back({all[rank].begin, all[rank].begin + all[rank].vertices, rank});
      if(rank == exchange.rank())
        first_triangle_ = number_of_triangles_;
      number_of_triangles_ += all[rank].triangles;
    }
    ranges_ = Vertex_ranges(std::move(ranges));
    begin_ = own.begin;
    size_ = own.vertices;
  }

  // The vertices of this rank, and those of all.
  Global_vertex begin() const { return begin_; }
  std::size_t size() const { return size_; }
  const Vertex_ranges& ranges() const { return ranges_; }
  std::uint64_t number_of_vertices() const { return ranges_.number_of_vertices(); }

  const ScalarRange& scalars() const { return *scalars_; }
  const TriangleRange& triangles() const { return *triangles_; }
  std::size_t number_of_local_triangles() const { return number_of_local_triangles_; }
  std::uint64_t number_of_triangles() const { return number_of_triangles_; }

  // The value of a vertex of this rank.
  auto value(Global_vertex vertex) const
  {
    auto value = std::begin(*scalars_)[static_cast<std::ptrdiff_t>(vertex - begin_)];
    return value;
  }

  // Throws if a value is NaN.
  void check_scalars() const
  {
    for(Global_vertex v = begin_; v != begin_ + size_; ++v)
      if(!is_ordered(value(v)))
        throw Unordered_scalar_error(static_cast<std::size_t>(v));
  }

  // Calls visit(vertex) for each corner of each triangle. Throws if a triangle has not three different vertices, by its
  // position among those of all ranks, one rank behind the other.
  template <class Visit>
  void check_triangles(const Visit& visit) const
  {
    const Global_vertex end = ranges_.number_of_vertices();
    std::uint64_t position = first_triangle_;
    for_each_triangle([&](Global_vertex a, Global_vertex b, Global_vertex c) {
      if(a >= end || b >= end || c >= end)
        throw Vertex_out_of_range_error("face", static_cast<std::size_t>(position));
      if(a == b || b == c || c == a)
        throw Degenerate_face_error(static_cast<std::size_t>(position));
      visit(a);
      visit(b);
      visit(c);
      ++position;
    });
  }

  // Calls visit(a, b, c) for the vertices of each triangle. Negative indices become large ones.
  template <class Visit>
  void for_each_triangle(const Visit& visit) const
  {
    for(const auto& t : *triangles_)
      visit(static_cast<Global_vertex>(t[0]), static_cast<Global_vertex>(t[1]), static_cast<Global_vertex>(t[2]));
  }

private:
  struct Sizes
  {
    Global_vertex begin;
    std::uint64_t vertices, scalars, triangles;
  };

  template <class Range>
  static std::size_t size_of(const Range& range)
  {
    return static_cast<std::size_t>(std::distance(std::begin(range), std::end(range)));
  }

  template <class VertexRange>
  static Global_vertex first_of_contiguous(const VertexRange& vertices)
  {
    if(std::begin(vertices) == std::end(vertices))
      return 0;
    const Global_vertex first = static_cast<Global_vertex>(*std::begin(vertices));
    Global_vertex next = first;
    for(const auto vertex : vertices)
      if(static_cast<Global_vertex>(vertex) != next++)
        throw Vertex_ranges_error(static_cast<std::size_t>(next - 1));
    return first;
  }

  const TriangleRange* triangles_;
  const ScalarRange* scalars_;
  std::size_t number_of_local_triangles_;
  std::uint64_t first_triangle_ = 0;
  std::uint64_t number_of_triangles_ = 0;
  Vertex_ranges ranges_;
  Global_vertex begin_ = 0;
  std::size_t size_ = 0;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_LOCAL_PART_H
