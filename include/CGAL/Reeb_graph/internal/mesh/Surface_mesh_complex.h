// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_MESH_SURFACE_MESH_COMPLEX_H
#define CGAL_REEB_GRAPH_INTERNAL_MESH_SURFACE_MESH_COMPLEX_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Large_vector.h>
#include <CGAL/Reeb_graph/internal/mesh/Triangle_complex_base.h>
#include <CGAL/Reeb_graph/internal/mesh/check_faces.h>

#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>

#include <cstddef>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A Surface_mesh, which has its halfedges in arrays already and numbers them as a Triangle_complex does: to copy them
// took longer than all else on a smooth field. Removed elements keep their numbers.
template <class Point>
class Surface_mesh_complex : public Triangle_complex_base<Surface_mesh_complex<Point>>
{
  typedef Surface_mesh<Point> Mesh;
  typedef typename Mesh::Vertex_index Vertex_index;
  typedef typename Mesh::Halfedge_index Halfedge_index;
  typedef typename Mesh::Edge_index Edge_index;

public:
  explicit Surface_mesh_complex(const Mesh& mesh)
    : Triangle_complex_base<Surface_mesh_complex>(unset_numbers(mesh.num_vertices())),
      mesh_(&mesh)
  {
    checked_index(mesh.num_halfedges());
  }

  Index number_of_halfedges() const { return mesh_->num_halfedges(); }
  bool has_vertex(Index number) const { return !mesh_->has_garbage() || !mesh_->is_removed(Vertex_index(number)); }
  bool has_edge(Index number) const { return !mesh_->has_garbage() || !mesh_->is_removed(Edge_index(number)); }

  Index target(Index halfedge) const { return mesh_->target(Halfedge_index(halfedge)); }
  Index next(Index halfedge) const { return mesh_->next(Halfedge_index(halfedge)); }
  bool has_triangle(Index halfedge) const { return !mesh_->is_border(Halfedge_index(halfedge)); }

  std::size_t number_of_faces() const { return mesh_->number_of_faces(); }
  std::size_t number_of_live_edges() const { return mesh_->number_of_edges(); }
  Index halfedge_of_face_at(Index vertex) const
  {
    return has_vertex(vertex) ? find_halfedge_of_face(*mesh_, mesh_->halfedge(Vertex_index(vertex))).idx() : no_index;
  }
  void check_faces() const { internal::check_faces(*mesh_); }
  void check_edges() const { internal::check_edges(*mesh_); }

private:
  static Large_vector<Index> unset_numbers(std::size_t size)
  {
    Large_vector<Index> numbers;
    numbers.resize(checked_index(size));
    return numbers;
  }

  const Mesh* mesh_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_MESH_SURFACE_MESH_COMPLEX_H
