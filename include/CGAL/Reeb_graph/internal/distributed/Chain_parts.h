// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_CHAIN_PARTS_H
#define CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_CHAIN_PARTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Side.h>
#include <CGAL/Reeb_graph/internal/distributed/Slab_complex.h>
#include <CGAL/Reeb_graph/internal/distributed/Slab_surface.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/walks/ascending_path.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A piece of a chain that has been walked as far as a vertex, and goes on up to the level just below another one.
template <class Scalar>
struct Climbing_piece
{
  Global_vertex vertex;
  Global_vertex upper_vertex;
  Scalar value_of_upper_vertex;
  Number piece;
};

// How many vertices follow in a part of a piece.
struct Part_of_piece
{
  Number piece;
  Number size;
};

// The parts of chains in the slab of a rank.
template <class Scalar, class Order>
class Chain_parts
{
public:
  Chain_parts(const Slab_surface<Scalar>& surface, const Slab_complex& complex, const Order& order)
    : surface_(surface),
      complex_(complex),
      order_(order)
  {}

  // Walks pieces, and returns those that go on above the slab. A path that has entered an arc cannot leave it below the
  // upper node, so comparisons tell the end.
  std::vector<Climbing_piece<Scalar>> walk(std::vector<Climbing_piece<Scalar>> pieces)
  {
    std::vector<Climbing_piece<Scalar>> leaving;
    for(Climbing_piece<Scalar>& piece : pieces)
    {
      const std::size_t size = vertices_.size();
      const auto is_inside = [&](Vertex_index v) { return surface_.slabs_of_vertices[v] == surface_.inside(); };
      const Vertex_index end = climb(
        complex_, order_, find_vertex(piece.vertex), [&](Vertex_index v) { return is_inside(v) && is_below(v, piece); },
        [&](Vertex_index, const Ascending_step& step) { vertices_.push_back(surface_.global_vertices[step.target]); });
      if(vertices_.size() != size)
        parts_.push_back({piece.piece, static_cast<Number>(vertices_.size() - size)});
      piece.vertex = surface_.global_vertices[end];
      if(is_below(end, piece))
        leaving.push_back(piece);
    }
    return leaving;
  }

  const std::vector<Part_of_piece>& parts() const { return parts_; }
  const std::vector<Global_vertex>& vertices() const { return vertices_; }

private:
  Vertex_index find_vertex(Global_vertex global) const
  {
    const auto& vertices = surface_.global_vertices;
    const auto place = std::lower_bound(vertices.begin(), vertices.end(), global);
    return Vertex_index(static_cast<std::size_t>(place - vertices.begin()));
  }

  // Whether the vertex is below the upper one of the piece, which may be on another rank.
  bool is_below(Vertex_index v, const Climbing_piece<Scalar>& piece) const
  {
    return order_.is_lower(v, piece.value_of_upper_vertex)
        || (!order_.is_higher(v, piece.value_of_upper_vertex) && surface_.global_vertices[v] < piece.upper_vertex);
  }

  const Slab_surface<Scalar>& surface_;
  const Slab_complex& complex_;
  const Order& order_;
  std::vector<Part_of_piece> parts_;
  std::vector<Global_vertex> vertices_; // of all parts
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_CHAIN_PARTS_H
