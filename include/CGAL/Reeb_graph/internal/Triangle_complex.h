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

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Vertices, triangles and corners are numbered by 32-bit integers: half the memory traffic of the sweeps.
typedef std::uint32_t Index;
constexpr Index no_index = (std::numeric_limits<Index>::max)();

inline Index checked_index(std::size_t i)
{
  if(i >= no_index)
    throw Mesh_size_error();
  return static_cast<Index>(i);
}

// An oriented triangulated surface as flat arrays. Corner 3 t + i is the corner i of triangle t. A corner also
// stands for the edge of its triangle that it faces; seen from there, that edge runs from the corner after it to
// the corner before it. An edge between two triangles is faced by two corners, which are opposite of each other.
class Triangle_complex
{
public:
  template <class ConcurrencyTag>
  Triangle_complex(ConcurrencyTag,
                   Large_vector<Index> corner_vertices,
                   Large_vector<Index> opposite_corners,
                   Index number_of_vertices)
    : corner_vertices_(std::move(corner_vertices)),
      opposite_corners_(std::move(opposite_corners)),
      first_corners_(number_of_vertices, no_index)
  {
    find_first_corners<ConcurrencyTag>();
    check_fans<ConcurrencyTag>();
  }

  Index number_of_vertices() const { return static_cast<Index>(first_corners_.size()); }
  Index number_of_corners() const { return static_cast<Index>(corner_vertices_.size()); }

  Index vertex(Index corner) const { return corner_vertices_[corner]; }

  // no_index on the border
  Index opposite(Index corner) const { return opposite_corners_[corner]; }

  static Index next(Index corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  static Index previous(Index corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

  // The ends of the edge that `corner` faces, in the orientation of its triangle.
  Index edge_source(Index corner) const { return vertex(next(corner)); }
  Index edge_target(Index corner) const { return vertex(previous(corner)); }

  // A corner at `vertex`, no_index if the vertex is isolated. At a border vertex it is the one from which turning
  // counterclockwise meets all others.
  Index first_corner(Index vertex) const { return first_corners_[vertex]; }

  // The corner at the same vertex in the triangle that is next clockwise, no_index behind the border.
  Index clockwise(Index corner) const
  {
    const Index across = opposite(previous(corner));
    return across == no_index ? no_index : previous(across);
  }

  // The corner at the same vertex in the triangle that is next counterclockwise, no_index behind the border.
  Index counterclockwise(Index corner) const
  {
    const Index across = opposite(next(corner));
    return across == no_index ? no_index : next(across);
  }

  // Calls visit(neighbor, corner), where `corner` faces the edge to `neighbor`, for the edges at `vertex`, turning
  // counterclockwise, at a border vertex from border edge to border edge, until a call returns true.
  template <class Visit>
  void visit_edges_around(Index vertex, const Visit& visit) const
  {
    const Index first = first_corner(vertex);
    for(Index corner = first; corner != no_index;)
    {
      if(visit(this->vertex(next(corner)), previous(corner)))
        return;
      const Index turned = counterclockwise(corner);
      if(turned == no_index && visit(this->vertex(previous(corner)), next(corner)))
        return;
      corner = turned == first ? no_index : turned;
    }
  }

  // The same for each edge at `vertex`.
  template <class Visit>
  void for_each_edge_around(Index vertex, const Visit& visit) const
  {
    visit_edges_around(vertex, [&](Index neighbor, Index corner) {
      visit(neighbor, corner);
      return false;
    });
  }

  // One of the two corners that face the same edge.
  Index representative_of_edge(Index corner) const { return (std::min)(corner, opposite(corner)); }

  bool is_on_border(Index vertex) const
  {
    const Index corner = first_corner(vertex);
    return corner != no_index && clockwise(corner) == no_index;
  }

private:
  // The lowest corner at each vertex, at a border vertex the one behind the border.
  template <class ConcurrencyTag>
  void find_first_corners()
  {
    if constexpr(is_parallel<ConcurrencyTag>())
    {
      typedef Shared_value<ConcurrencyTag, Index> Lowest_corner;
      Large_vector<Lowest_corner> lowest_corners(number_of_vertices(), Lowest_corner(no_index));
      for_each_block<ConcurrencyTag>(number_of_corners(), [&](std::size_t begin, std::size_t end) {
        for(std::size_t corner = begin; corner != end; ++corner)
          lowest_corners[corner_vertices_[corner]].lower_to(static_cast<Index>(corner));
      });
      for(Index v = 0; v != number_of_vertices(); ++v)
        first_corners_[v] = lowest_corners[v].get();
    }
    else
    {
      for(Index corner = number_of_corners(); corner != 0; --corner)
        first_corners_[vertex(corner - 1)] = corner - 1;
    }
    for(Index corner = 0; corner != number_of_corners(); ++corner)
    {
      if(opposite(corner) == no_index)
        first_corners_[edge_source(corner)] = next(corner);
    }
  }

  // The number of corners of the fan that a vertex is connected to its faces by.
  Index size_of_fan(Index v) const
  {
    Index size = 0;
    for(Index corner = first_corner(v); corner != no_index; ++size)
    {
      corner = counterclockwise(corner);
      if(corner == first_corner(v))
        corner = no_index;
    }
    return size;
  }

  // A halfedge data structure reaches one fan of triangles per vertex only; here all corners are known.
  template <class ConcurrencyTag>
  void check_fans() const
  {
    Shared_value<ConcurrencyTag, Index> number_of_reached_corners(0);
    for_each_block<ConcurrencyTag>(number_of_vertices(), [&](std::size_t begin, std::size_t end) {
      Index sum = 0;
      for(std::size_t v = begin; v != end; ++v)
        sum += size_of_fan(static_cast<Index>(v));
      number_of_reached_corners.add(sum);
    });
    if(number_of_reached_corners.get() == number_of_corners())
      return;
    Large_vector<Index> degrees(number_of_vertices(), 0);
    for(const Index v : corner_vertices_)
      ++degrees[v];
    for(Index v = 0; v != number_of_vertices(); ++v)
    {
      if(degrees[v] != size_of_fan(v))
        throw Non_manifold_vertex_error(v);
    }
  }

  Large_vector<Index> corner_vertices_;
  Large_vector<Index> opposite_corners_;
  Large_vector<Index> first_corners_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_TRIANGLE_COMPLEX_H
