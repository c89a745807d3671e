// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_FLATTEN_H
#define CGAL_REEB_GRAPH_INTERNAL_FLATTEN_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/Descriptor_positions.h>
#include <CGAL/Reeb_graph/internal/Large_vector.h>
#include <CGAL/Reeb_graph/internal/Triangle_complex.h>
#include <CGAL/Reeb_graph/internal/read_triangles.h>

#include <boost/graph/graph_traits.hpp>

#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A mesh with its field in flat arrays. Vertices and triangles are numbered by their positions in vertices(mesh)
// and faces(mesh); the handles lead back.
template <class FaceListGraph, class Scalar>
struct Flat_surface
{
  typedef typename boost::graph_traits<FaceListGraph>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<FaceListGraph>::face_descriptor face_descriptor;

  Triangle_complex complex;
  Large_vector<Scalar> values;
  Large_vector<vertex_descriptor> vertices;
  Large_vector<face_descriptor> faces;
};

// One of halfedges_facing_corners().
template <class FaceListGraph, class FaceDescriptor>
auto halfedge_facing_corner(const FaceListGraph& mesh, const Large_vector<FaceDescriptor>& faces, Index corner)
{
  auto h = halfedge(faces[corner / 3], mesh);
  switch(corner % 3)
  {
  case 0: return prev(h, mesh);
  case 1: return h;
  default: return next(h, mesh);
  }
}

template <class VertexDescriptor, class ScalarMap, class Traits>
Large_vector<typename Traits::Scalar> read_values(const Large_vector<VertexDescriptor>& vertices,
                                                  const ScalarMap& scalar_map,
                                                  const Traits& traits)
{
  const auto is_ordered = traits.is_ordered_object();
  Large_vector<typename Traits::Scalar> values;
  values.reserve(vertices.size());
  for(const auto v : vertices)
  {
    values.push_back(get(scalar_map, v));
    if(!is_ordered(values.back()))
      throw Unordered_scalar_error(values.size() - 1);
  }
  return values;
}

template <class ConcurrencyTag, class FaceListGraph, class ScalarMap, class Traits, class NamedParameters>
Flat_surface<FaceListGraph, typename Traits::Scalar> flatten(const FaceListGraph& mesh,
                                                             const ScalarMap& scalar_map,
                                                             const Traits& traits,
                                                             const NamedParameters& np)
{
  const auto vertex_range = vertices(mesh);
  const auto face_range = faces(mesh);
  Large_vector<typename boost::graph_traits<FaceListGraph>::vertex_descriptor> vertex_handles(vertex_range.first,
                                                                                              vertex_range.second);
  Large_vector<typename boost::graph_traits<FaceListGraph>::face_descriptor> face_handles(face_range.first,
                                                                                          face_range.second);
  const Index number_of_vertices = checked_index(vertex_handles.size());
  checked_index(3 * face_handles.size());

  auto values = read_values(vertex_handles, scalar_map, traits);
  Triangles triangles =
    read_triangles<ConcurrencyTag>(mesh, face_handles, make_vertex_positions(mesh, vertex_handles, np), np);
  return {Triangle_complex(ConcurrencyTag(), std::move(triangles.corner_vertices),
                           std::move(triangles.opposite_corners), number_of_vertices),
          std::move(values), std::move(vertex_handles), std::move(face_handles)};
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_FLATTEN_H
