// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_MESH_TRIANGLE_COMPLEX_H
#define CGAL_REEB_GRAPH_INTERNAL_MESH_TRIANGLE_COMPLEX_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/mesh/Triangle_complex_base.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

struct Halfedge
{
  Vertex_index target;
  Halfedge_index next; // in its face; no_index if it has none
};

// What a Triangle_complex is made from.
struct Halfedge_arrays
{
  Indexed_vector<Halfedge_index, Halfedge> halfedges;
  Indexed_vector<Vertex_index, Halfedge_index>
    halfedges_of_vertices; // one of a face that ends there; no_index if there is none
};

// A surface copied from a mesh of any type into flat arrays. All numbers belong to vertices and edges.
class Triangle_complex : public Triangle_complex_base<Triangle_complex>
{
public:
  // The faces have been checked before, as has been that each edge has one.
  Triangle_complex(Halfedge_arrays arrays, std::size_t number_of_faces)
    : Triangle_complex_base<Triangle_complex>(std::move(arrays.halfedges_of_vertices)),
      halfedges_(std::move(arrays.halfedges)),
      number_of_faces_(number_of_faces)
  {}

  Number number_of_halfedges() const { return static_cast<Number>(halfedges_.size()); }
  bool has_vertex(Vertex_index) const { return true; }
  bool has_edge(Edge_index) const { return true; }

  Vertex_index target(Halfedge_index halfedge) const { return halfedges_[halfedge].target; }
  Halfedge_index next(Halfedge_index halfedge) const { return halfedges_[halfedge].next; }
  bool has_triangle(Halfedge_index halfedge) const { return next(halfedge) != no_index; }

  std::size_t number_of_faces() const { return number_of_faces_; }
  std::size_t number_of_live_edges() const { return halfedges_.size() / 2; }
  bool is_next_in_triangle(Halfedge_index) const { return true; }
  Halfedge_index halfedge_of_face_at(Vertex_index vertex) const { return first_halfedge(vertex); }
  void check_faces() const {}
  void check_edges() const {}

private:
  Indexed_vector<Halfedge_index, Halfedge>
    halfedges_; // both members in one line of the cache, with the opposite halfedge
  std::size_t number_of_faces_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_MESH_TRIANGLE_COMPLEX_H
