// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_MESH_CHECK_FACES_H
#define CGAL_REEB_GRAPH_INTERNAL_MESH_CHECK_FACES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Throws if a face is no triangle with three vertices.
template <class FaceListGraph>
void check_faces(const FaceListGraph& mesh)
{
  std::size_t position = 0;
  for(const auto f : CGAL::make_range(faces(mesh)))
  {
    const auto h = halfedge(f, mesh);
    if(next(h, mesh) == h || next(next(h, mesh), mesh) == h || !is_triangle(h, mesh))
      throw Non_triangular_face_error(position);
    const auto a = source(h, mesh), b = target(h, mesh), c = target(next(h, mesh), mesh);
    if(a == b || b == c || c == a)
      throw Degenerate_face_error(position);
    ++position;
  }
}

template <class FaceListGraph>
void check_edges(const FaceListGraph& mesh)
{
  std::size_t position = 0;
  for(const auto e : CGAL::make_range(edges(mesh)))
  {
    const auto h = halfedge(e, mesh);
    if(is_border(h, mesh) && is_border(opposite(h, mesh), mesh))
      throw Edge_without_face_error(position);
    ++position;
  }
}

// A halfedge of a face that ends where h does, the null halfedge if there is none. The turn ends at an edge that nobody
// has joined to the other ones.
template <class FaceListGraph, class HalfedgeDescriptor>
HalfedgeDescriptor find_halfedge_of_face(const FaceListGraph& mesh, HalfedgeDescriptor h)
{
  const HalfedgeDescriptor null = boost::graph_traits<FaceListGraph>::null_halfedge();
  HalfedgeDescriptor around = h;
  while(around != null && is_border(around, mesh))
  {
    const HalfedgeDescriptor second = next(around, mesh);
    around = second == null ? null : opposite(second, mesh);
    if(around == h)
      return null;
  }
  return around;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_MESH_CHECK_FACES_H
