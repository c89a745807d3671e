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

#include <algorithm>
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

  // Faces have the numbers that they have in the mesh.
  Number end_of_faces() const { return mesh_->num_faces(); }
  bool has_face(Face_index f) const { return !mesh_->has_garbage() || !mesh_->is_removed(descriptor(f)); }

  // All is right with a face if all that the mesh tells of its halfedges agrees. Two such faces have no halfedge in
  // common, as each has one face. Without branches, as all is read in any case.
  bool read_triangle(Face_index f, Triangle_at_face& triangle) const
  {
    const Halfedge_index last(number_of_halfedges() - 1); // Nothing has been checked yet.
    const Halfedge_index first = (std::min)(Halfedge_index(mesh_->halfedge(descriptor(f))), last),
                         second = (std::min)(next(first), last), third = (std::min)(previous(first), last);
    const Vertex_index a = target(first), b = target(second), c = target(third);
    Number difference = 0;
    const auto compare = [&](auto u, auto v) { difference |= u.number() ^ v.number(); };
    compare(next(first), second);
    compare(next(second), third);
    compare(next(third), first);
    compare(previous(first), third);
    compare(previous(second), first);
    compare(previous(third), second);
    compare(this->source(first), c);
    compare(this->source(second), a);
    compare(this->source(third), b);
    for(const Halfedge_index h : {first, second, third})
    {
      compare(Face_index(mesh_->face(descriptor(h))), f);
      difference |= has_edge(edge_of(h)) ? 0 : 1;
    }
    triangle.halfedges[0] = first;
    triangle.halfedges[1] = second;
    triangle.halfedges[2] = third;
    triangle.vertices[0] = a;
    triangle.vertices[1] = b;
    triangle.vertices[2] = c;
    return (difference == 0) & (a != b) & (b != c) & (c != a)
         & ((std::max)({a, b, c}).number() < this->number_of_vertices());
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
  static typename Mesh::Face_index descriptor(Face_index f) { return typename Mesh::Face_index(f.number()); }
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
