// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_MESH_HALFEDGE_LIST_H
#define CGAL_REEB_GRAPH_INTERNAL_MESH_HALFEDGE_LIST_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>

#include <boost/graph/graph_traits.hpp>

#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The halfedges of a mesh by the numbers that they have in a Triangle_complex.
template <class FaceListGraph>
class Halfedge_list
{
public:
  typedef typename boost::graph_traits<FaceListGraph>::halfedge_descriptor halfedge_descriptor;

  // The list is made of the halfedge with the even number of each edge.
  explicit Halfedge_list(Indexed_vector<Edge_index, halfedge_descriptor> even_halfedges)
    : even_halfedges_(std::move(even_halfedges))
  {}

  halfedge_descriptor operator()(const FaceListGraph& mesh, Halfedge_index halfedge) const
  {
    const halfedge_descriptor h = even_halfedges_[edge_of(halfedge)];
    return halfedge == even_halfedge(edge_of(halfedge)) ? h : opposite(h, mesh);
  }

  // The number of a halfedge, no_index if the mesh does not know it.
  Halfedge_index find(const FaceListGraph&, const halfedge_descriptor&) const { return no_index; }

private:
  Indexed_vector<Edge_index, halfedge_descriptor> even_halfedges_;
};

// The halfedges of a Surface_mesh are numbers.
template <class Point>
class Halfedge_list<Surface_mesh<Point>>
{
public:
  typedef typename Surface_mesh<Point>::Halfedge_index halfedge_descriptor;

  halfedge_descriptor operator()(const Surface_mesh<Point>&, Halfedge_index halfedge) const
  {
    return halfedge_descriptor(halfedge.number());
  }

  // The number of a halfedge, which may have been removed.
  Halfedge_index find(const Surface_mesh<Point>& mesh, halfedge_descriptor h) const
  {
    return mesh.has_garbage() && mesh.is_removed(h) ? Halfedge_index(no_index) : Halfedge_index(h);
  }
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_MESH_HALFEDGE_LIST_H
