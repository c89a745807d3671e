// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_CHAIN_PARTS_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_CHAIN_PARTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/internal/Slab_surface.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/engine/monotone_paths.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// A piece of a chain that has been walked as far as a vertex, up to the level just below another one.
template <class Scalar>
struct Climbing_piece
{
  Global_vertex vertex;
  Global_vertex vertex_before; // from which the first step has led there
  Global_vertex upper_vertex;
  Scalar value_of_upper_vertex;
  Number arc;
  Number piece;
  Number goes_on; // whether the upper vertex is above the one that has been reached
};

// How many vertices a part of a piece has.
struct Part_of_piece
{
  Number arc;
  Number piece;
  Number size;
};

// The parts of chains on a rank: the steps that begin in its slab, as sequences of vertices.
template <class Scalar, class Complex, class Order>
class Chain_parts
{
public:
  Chain_parts(const Slab_surface<Scalar>& surface, const Complex& complex, const Order& order)
    : surface_(surface),
      complex_(complex),
      order_(order)
  {}

  // Walks pieces that begin in the slab with the step that is known.
  void begin(const std::vector<Climbing_piece<Scalar>>& pieces)
  {
    for(const Climbing_piece<Scalar>& piece : pieces)
    {
      vertices_.push_back(piece.vertex_before);
      walk(piece);
    }
  }

  // Walks pieces that have come from below.
  void go_on(const std::vector<Climbing_piece<Scalar>>& pieces)
  {
    for(const Climbing_piece<Scalar>& piece : pieces)
      walk(piece);
  }

  // The pieces that go on above the slab; they are none then.
  std::vector<Climbing_piece<Scalar>> take_leaving() { return std::exchange(leaving_, {}); }

  const std::vector<Part_of_piece>& parts() const { return parts_; }
  const std::vector<Global_vertex>& vertices() const { return vertices_; } // of all parts

private:
  // A path that has entered an arc cannot leave it below the upper node, so comparisons tell the end. A part of one
  // vertex, where the piece only passes the slab, is none.
  void walk(Climbing_piece<Scalar> piece)
  {
    vertices_.push_back(piece.vertex);
    if(piece.goes_on != 0)
    {
      const auto is_below = [&](Vertex_index v) { return is_lower(v, piece); };
      const auto goes_on = [&](Vertex_index v) {
        return surface_.slabs_of_vertices[v] == surface_.inside() && is_below(v);
      };
      const auto add = [&](Vertex_index, const Ascending_step& step) {
        vertices_.push_back(surface_.global_vertices[step.target]);
      };
      const Vertex_index end = climb(complex_, order_, find_vertex(piece.vertex), goes_on, add);
      piece.vertex = surface_.global_vertices[end];
      if(is_below(end))
        leaving_.push_back(piece);
    }
    const std::size_t size = vertices_.size() - end_of_parts_;
    if(size == 1)
      return vertices_.pop_back();
    parts_.push_back({piece.arc, piece.piece, checked_index(size)});
    end_of_parts_ = vertices_.size();
  }

  Vertex_index find_vertex(Global_vertex global) const
  {
    const auto& vertices = surface_.global_vertices;
    const auto place = std::lower_bound(vertices.begin(), vertices.end(), global);
    return Vertex_index(static_cast<std::size_t>(place - vertices.begin()));
  }

  // Whether the vertex is below the upper one of the piece, which may be on another rank.
  bool is_lower(Vertex_index v, const Climbing_piece<Scalar>& piece) const
  {
    return order_.is_lower(v, piece.value_of_upper_vertex)
        || (!order_.is_higher(v, piece.value_of_upper_vertex) && surface_.global_vertices[v] < piece.upper_vertex);
  }

  const Slab_surface<Scalar>& surface_;
  const Complex& complex_;
  const Order& order_;
  std::vector<Climbing_piece<Scalar>> leaving_;
  std::vector<Part_of_piece> parts_;
  std::vector<Global_vertex> vertices_;
  std::size_t end_of_parts_ = 0; // among the vertices
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_CHAIN_PARTS_H
