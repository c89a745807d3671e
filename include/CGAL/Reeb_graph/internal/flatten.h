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
#include <CGAL/Reeb_graph/internal/Triangle_complex.h>

#include <boost/graph/graph_traits.hpp>

#include <utility>
#include <vector>

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
  std::vector<Scalar> values;
  std::vector<vertex_descriptor> vertices;
  std::vector<face_descriptor> faces;
};

// The corner i of a triangle is at the target of the i-th halfedge around its face; the edge that the corner faces
// is then that of the halfedge before.
template <class FaceListGraph, class FaceDescriptor>
auto halfedge_facing_corner(const FaceListGraph& mesh, const std::vector<FaceDescriptor>& faces, Index corner)
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
std::vector<typename Traits::Scalar> read_values(const std::vector<VertexDescriptor>& vertices,
                                                 const ScalarMap& scalar_map,
                                                 const Traits& traits)
{
  const auto is_ordered = traits.is_ordered_object();
  std::vector<typename Traits::Scalar> values;
  values.reserve(vertices.size());
  for(const auto v : vertices)
  {
    values.push_back(get(scalar_map, v));
    if(!is_ordered(values.back()))
      throw Unordered_scalar_error(values.size() - 1);
  }
  return values;
}

template <class FaceListGraph, class FaceDescriptor, class VertexPositions>
std::vector<Index> read_corner_vertices(const FaceListGraph& mesh,
                                        const std::vector<FaceDescriptor>& faces,
                                        const VertexPositions& vertex_positions)
{
  std::vector<Index> corner_vertices;
  corner_vertices.reserve(3 * faces.size());
  for(const auto f : faces)
  {
    const std::size_t position = corner_vertices.size() / 3;
    const auto h = halfedge(f, mesh), h1 = next(h, mesh), h2 = next(h1, mesh);
    if(h1 == h || h2 == h || next(h2, mesh) != h)
      throw Non_triangular_face_error(position);
    const Index a = vertex_positions[target(h, mesh)];
    const Index b = vertex_positions[target(h1, mesh)];
    const Index c = vertex_positions[target(h2, mesh)];
    if(a == b || b == c || c == a)
      throw Degenerate_face_error(position);
    corner_vertices.insert(corner_vertices.end(), {a, b, c});
  }
  return corner_vertices;
}

// The corner of a triangle that faces its edge between the vertices u and v; no other edge of it joins them. Without
// a branch, as none of the three could be predicted.
inline Index corner_facing_edge(const std::vector<Index>& corner_vertices, Index triangle, Index u, Index v)
{
  const Index corner = 3 * triangle, first = corner_vertices[corner], second = corner_vertices[corner + 1];
  const Index is_first_on_edge = (first == u) | (first == v), is_second_on_edge = (second == u) | (second == v);
  return corner + is_first_on_edge + (is_first_on_edge & is_second_on_edge);
}

template <class FaceListGraph, class FaceDescriptor, class FacePositions>
std::vector<Index> read_opposite_corners(const FaceListGraph& mesh,
                                         const std::vector<FaceDescriptor>& faces,
                                         const FacePositions& face_positions,
                                         const std::vector<Index>& corner_vertices)
{
  std::vector<Index> opposite_corners(corner_vertices.size(), no_index);
  Index corner = 0;
  for(const auto f : faces)
  {
    auto h = prev(halfedge(f, mesh), mesh);
    for(int i = 0; i != 3; ++i, ++corner, h = next(h, mesh))
    {
      const auto across = face(opposite(h, mesh), mesh);
      if(across != boost::graph_traits<FaceListGraph>::null_face())
        opposite_corners[corner] = corner_facing_edge(corner_vertices, face_positions[across],
                                                      corner_vertices[Triangle_complex::next(corner)],
                                                      corner_vertices[Triangle_complex::previous(corner)]);
    }
  }
  return opposite_corners;
}

// Copies a mesh and its field into flat arrays, and checks all that the later stages rely on.
template <class FaceListGraph, class ScalarMap, class Traits, class NamedParameters>
Flat_surface<FaceListGraph, typename Traits::Scalar> flatten(const FaceListGraph& mesh,
                                                             const ScalarMap& scalar_map,
                                                             const Traits& traits,
                                                             const NamedParameters& np)
{
  const auto vertex_range = vertices(mesh);
  const auto face_range = faces(mesh);
  std::vector<typename boost::graph_traits<FaceListGraph>::vertex_descriptor> vertex_handles(vertex_range.first,
                                                                                             vertex_range.second);
  std::vector<typename boost::graph_traits<FaceListGraph>::face_descriptor> face_handles(face_range.first,
                                                                                         face_range.second);
  const Index number_of_vertices = checked_index(vertex_handles.size());
  checked_index(3 * face_handles.size());

  auto values = read_values(vertex_handles, scalar_map, traits);
  auto corner_vertices = read_corner_vertices(mesh, face_handles, make_vertex_positions(mesh, vertex_handles, np));
  auto opposite_corners =
    read_opposite_corners(mesh, face_handles, make_face_positions(mesh, face_handles, np), corner_vertices);
  return {Triangle_complex(std::move(corner_vertices), std::move(opposite_corners), number_of_vertices),
          std::move(values), std::move(vertex_handles), std::move(face_handles)};
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_FLATTEN_H
