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
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/mesh/Triangle_complex_base.h>
#include <CGAL/Reeb_graph/internal/mesh/check_faces.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

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

public:
  explicit Surface_mesh_complex(const Mesh& mesh)
    : Triangle_complex_base<Surface_mesh_complex>(unset_halfedges(mesh.num_vertices())),
      mesh_(&mesh)
  {
    checked_index(mesh.num_halfedges());
  }

  Number number_of_halfedges() const { return mesh_->num_halfedges(); }
  bool has_vertex(Vertex_index v) const { return !mesh_->has_garbage() || !mesh_->is_removed(descriptor(v)); }
  bool has_edge(Edge_index e) const
  {
    return !mesh_->has_garbage() || !mesh_->is_removed(typename Mesh::Edge_index(e.number()));
  }

  Vertex_index target(Halfedge_index h) const { return Vertex_index(mesh_->target(descriptor(h))); }
  Halfedge_index next(Halfedge_index h) const { return Halfedge_index(mesh_->next(descriptor(h))); }
  bool has_triangle(Halfedge_index h) const { return !mesh_->is_border(descriptor(h)); }

  std::size_t number_of_faces() const { return mesh_->number_of_faces(); }
  std::size_t number_of_live_edges() const { return mesh_->number_of_edges(); }

  // Hides the other one, as it is known without a look at the next halfedge, which may be far away in memory.
  Halfedge_index previous(Halfedge_index h) const { return Halfedge_index(mesh_->prev(descriptor(h))); }

  // If so for all halfedges of faces, `next` and `previous` undo each other, and two steps onwards are one back: so
  // three steps lead around each face.
  bool is_next_in_triangle(Halfedge_index h) const
  {
    const Halfedge_index second = next(h);
    return second.number() < number_of_halfedges() && has_edge(edge_of(second)) && has_triangle(second) && second != h
        && previous(second) == h && next(second) == previous(h);
  }
  Halfedge_index halfedge_of_face_at(Vertex_index v) const
  {
    if(!has_vertex(v))
      return no_index;
    const auto h = find_halfedge_of_face(*mesh_, mesh_->halfedge(descriptor(v)));
    return h == mesh_->null_halfedge() ? Halfedge_index(no_index) : Halfedge_index(h);
  }
  void check_faces() const { internal::check_faces(*mesh_); }
  void check_edges() const { internal::check_edges(*mesh_); }

private:
  static typename Mesh::Vertex_index descriptor(Vertex_index v) { return typename Mesh::Vertex_index(v.number()); }
  static typename Mesh::Halfedge_index descriptor(Halfedge_index h)
  {
    return typename Mesh::Halfedge_index(h.number());
  }

  static Indexed_vector<Vertex_index, Halfedge_index> unset_halfedges(std::size_t size)
  {
    Indexed_vector<Vertex_index, Halfedge_index> halfedges;
    halfedges.resize(checked_index(size));
    return halfedges;
  }

  const Mesh* mesh_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_MESH_SURFACE_MESH_COMPLEX_H
