// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_MESH_VERTEX_LIST_H
#define CGAL_REEB_GRAPH_INTERNAL_MESH_VERTEX_LIST_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The vertices of a mesh by number: by their positions in vertices(mesh).
template <class FaceListGraph>
class Vertex_list
{
public:
  typedef typename boost::graph_traits<FaceListGraph>::vertex_descriptor vertex_descriptor;

  explicit Vertex_list(const FaceListGraph& mesh) : vertices_(vertices(mesh).first, vertices(mesh).second)
  {
    checked_index(vertices_.size());
  }

  // The first number behind those of the vertices, of which not all need belong to a vertex.
  std::size_t size() const { return vertices_.size(); }
  bool contains(Vertex_index) const { return true; }

  vertex_descriptor operator[](Vertex_index v) const { return vertices_[v]; }
  std::size_t position(Vertex_index v) const { return v.number(); }

private:
  Indexed_vector<Vertex_index, vertex_descriptor> vertices_;
};

// The vertices of a Surface_mesh are numbers. Removed ones keep theirs.
template <class Point>
class Vertex_list<Surface_mesh<Point>>
{
public:
  typedef typename Surface_mesh<Point>::Vertex_index vertex_descriptor;

  explicit Vertex_list(const Surface_mesh<Point>& mesh) : mesh_(&mesh) { checked_index(size()); }

  std::size_t size() const { return mesh_->num_vertices(); }
  bool contains(Vertex_index v) const { return !mesh_->has_garbage() || !mesh_->is_removed((*this)[v]); }

  vertex_descriptor operator[](Vertex_index v) const { return vertex_descriptor(v.number()); }
  std::size_t position(Vertex_index v) const
  {
    std::size_t position = 0;
    for(const Vertex_index i : Index_range<Vertex_index>(v.number()))
      position += contains(i) ? 1 : 0;
    return position;
  }

private:
  const Surface_mesh<Point>* mesh_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_MESH_VERTEX_LIST_H
