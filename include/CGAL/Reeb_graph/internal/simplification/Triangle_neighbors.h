// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_TRIANGLE_NEIGHBORS_H
#define CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_TRIANGLE_NEIGHBORS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/vertex_graph.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Iterator_range.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The triangles of a mesh by the positions of their vertices, with the triangles next to them.
class Triangle_neighbors
{
public:
  typedef scalar_fields::Position Position;

  struct Triangle
  {
    std::array<Position, 3> vertices;
    std::array<Face_index, 3> neighbors; // each across the edge that faces the vertex; no_index at the border

    int corner(Position v) const { return vertices[0] == v ? 0 : vertices[1] == v ? 1 : 2; }
    bool contains(Position v) const { return vertices[0] == v || vertices[1] == v || vertices[2] == v; }
  };

  template <class Mesh>
  explicit Triangle_neighbors(const Mesh& mesh) : first_(num_vertices_of(mesh) + 1, 0)
  {
    read_triangles(mesh);
    for(const Triangle& triangle : triangles_)
      for(const Position v : triangle.vertices)
        ++first_[v + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    triangles_of_vertices_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for(const Face_index t : triangles_.keys())
      for(const Position v : triangles_[t].vertices)
        triangles_of_vertices_[next[v]++] = t;
  }

  const Triangle& operator[](Face_index t) const { return triangles_[t]; }

  Iterator_range<const Face_index*> triangles_at(Position v) const
  {
    return {triangles_of_vertices_.data() + first_[v], triangles_of_vertices_.data() + first_[v + 1]};
  }

private:
  // The number of those that have not been removed.
  template <class Mesh>
  static std::size_t num_vertices_of(const Mesh& mesh)
  {
    const auto range = vertices(mesh);
    return static_cast<std::size_t>(std::distance(range.first, range.second));
  }

  template <class Mesh>
  void read_triangles(const Mesh& mesh)
  {
    const auto positions = scalar_fields::make_position_map(mesh);
    const auto numbers = get(dynamic_face_property_t<Face_index>(), mesh);
    Face_index number(0);
    for(const auto f : CGAL::make_range(faces(mesh)))
    {
      put(numbers, f, number);
      ++number;
    }
    for(const auto f : CGAL::make_range(faces(mesh)))
    {
      Triangle triangle;
      auto h = halfedge(f, mesh);
      for(int i = 0; i != 3; ++i, h = next(h, mesh))
      {
        triangle.vertices[i] = get(positions, target(h, mesh));
        const auto neighbor = face(opposite(prev(h, mesh), mesh), mesh);
        triangle.neighbors[i] =
          neighbor == boost::graph_traits<Mesh>::null_face() ? Face_index(no_index) : get(numbers, neighbor);
      }
      triangles_.push_back(triangle);
    }
  }

  Indexed_vector<Face_index, Triangle> triangles_;
  std::vector<std::size_t> first_;
  std::vector<Face_index> triangles_of_vertices_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_TRIANGLE_NEIGHBORS_H
