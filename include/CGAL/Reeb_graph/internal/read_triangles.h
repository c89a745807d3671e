// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_READ_TRIANGLES_H
#define CGAL_REEB_GRAPH_INTERNAL_READ_TRIANGLES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/Descriptor_positions.h>
#include <CGAL/Reeb_graph/internal/Large_vector.h>
#include <CGAL/Reeb_graph/internal/Triangle_complex.h>
#include <CGAL/Reeb_graph/internal/parallel.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

struct Triangles
{
  Large_vector<Index> corner_vertices;
  Large_vector<Index> opposite_corners;
};

// The halfedges of a face, the one that faces corner i at place i. The corner is at the target of the i-th halfedge
// around the face.
template <class FaceListGraph, class FaceDescriptor>
auto halfedges_facing_corners(const FaceListGraph& mesh, FaceDescriptor f)
{
  typedef typename boost::graph_traits<FaceListGraph>::halfedge_descriptor halfedge_descriptor;
  const halfedge_descriptor h0 = halfedge(f, mesh), h1 = next(h0, mesh), h2 = next(h1, mesh);
  return std::array<halfedge_descriptor, 3>{h2, h0, h1};
}

template <class FaceListGraph, class Halfedges>
bool are_all_around_face(const FaceListGraph& mesh, const Halfedges& h)
{
  return h[1] != h[2] && h[0] != h[1] && next(h[0], mesh) == h[1];
}

// Calls visit(corner, h, (a, b, c)) for each face of the mesh, with its first corner, the halfedges that face its
// corners and the positions of their vertices.
template <class ConcurrencyTag, class FaceListGraph, class FaceDescriptor, class VertexPositions, class Visit>
void visit_triangles(const FaceListGraph& mesh,
                     const Large_vector<FaceDescriptor>& faces,
                     const VertexPositions& vertex_positions,
                     const Visit& visit)
{
  const Index end = static_cast<Index>(faces.size());
  Shared_value<ConcurrencyTag, Index> first_bad_face(end);
  for_each_block<ConcurrencyTag>(faces.size(), [&](std::size_t begin, std::size_t end_of_block) {
    for(std::size_t i = begin; i != end_of_block; ++i)
    {
      const auto h = halfedges_facing_corners(mesh, faces[i]);
      const std::array<Index, 3> corners = {vertex_positions[target(h[1], mesh)], vertex_positions[target(h[2], mesh)],
                                            vertex_positions[target(h[0], mesh)]};
      if(are_all_around_face(mesh, h) && corners[0] != corners[1] && corners[1] != corners[2]
         && corners[2] != corners[0])
        visit(static_cast<Index>(3 * i), h, corners);
      else
        first_bad_face.lower_to(static_cast<Index>(i));
    }
  });
  if(first_bad_face.get() == end)
    return;
  if(are_all_around_face(mesh, halfedges_facing_corners(mesh, faces[first_bad_face.get()])))
    throw Degenerate_face_error(first_bad_face.get());
  throw Non_triangular_face_error(first_bad_face.get());
}

template <class FaceListGraph, class EdgeIndexMap>
std::size_t end_of_edge_indices(const FaceListGraph& mesh, const EdgeIndexMap& edge_index_map)
{
  std::size_t end = 0;
  for(const auto e : CGAL::make_range(edges(mesh)))
    end = (std::max)(end, static_cast<std::size_t>(get(edge_index_map, e)) + 1);
  return end;
}

// For meshes that number their edges: the second corner that is met at an edge is opposite to the first one.
template <class ConcurrencyTag, class FaceListGraph, class FaceDescriptor, class VertexPositions>
Triangles read_triangles_by_edges(const FaceListGraph& mesh,
                                  const Large_vector<FaceDescriptor>& faces,
                                  const VertexPositions& vertex_positions)
{
  const auto edge_index_map = get(boost::edge_index_t(), mesh);
  typedef Shared_value<ConcurrencyTag, Index> Met_corner;
  Large_vector<Met_corner> met_corners(end_of_edge_indices(mesh, edge_index_map), Met_corner(no_index));
  Triangles triangles;
  triangles.corner_vertices.resize(3 * faces.size());
  triangles.opposite_corners.resize(3 * faces.size(), no_index);
  visit_triangles<ConcurrencyTag>(
    mesh, faces, vertex_positions, [&](Index corner, const auto& h, const std::array<Index, 3>& vertices) {
      for(Index i = 0; i != 3; ++i, ++corner)
      {
        triangles.corner_vertices[corner] = vertices[i];
        const std::size_t edge_index = static_cast<std::size_t>(get(edge_index_map, edge(h[i], mesh)));
        const Index opposite = met_corners[edge_index].exchange(corner);
        if(opposite == no_index)
          continue;
        triangles.opposite_corners[corner] = opposite;
        triangles.opposite_corners[opposite] = corner;
      }
    });
  return triangles;
}

// The corner of a triangle that faces its edge between the vertices u and v; no other edge of it joins them. Without
// a branch, as none of the three could be predicted.
inline Index corner_facing_edge(const Large_vector<Index>& corner_vertices, Index triangle, Index u, Index v)
{
  const Index corner = 3 * triangle, first = corner_vertices[corner], second = corner_vertices[corner + 1];
  const Index is_first_on_edge = (first == u) | (first == v), is_second_on_edge = (second == u) | (second == v);
  return corner + is_first_on_edge + (is_first_on_edge & is_second_on_edge);
}

// For meshes that number at most their faces.
template <class FaceListGraph, class FaceDescriptor, class VertexPositions, class FacePositions>
Triangles read_triangles_by_faces(const FaceListGraph& mesh,
                                  const Large_vector<FaceDescriptor>& faces,
                                  const VertexPositions& vertex_positions,
                                  const FacePositions& face_positions)
{
  Triangles triangles;
  triangles.corner_vertices.reserve(3 * faces.size());
  visit_triangles<Sequential_tag>(
    mesh, faces, vertex_positions, [&](Index, const auto&, const std::array<Index, 3>& vertices) {
      triangles.corner_vertices.insert(triangles.corner_vertices.end(), vertices.begin(), vertices.end());
    });
  triangles.opposite_corners.reserve(3 * faces.size());
  for(const FaceDescriptor f : faces)
  {
    for(const auto h : halfedges_facing_corners(mesh, f))
    {
      const auto across = face(opposite(h, mesh), mesh);
      triangles.opposite_corners.push_back(across == boost::graph_traits<FaceListGraph>::null_face()
                                             ? no_index
                                             : corner_facing_edge(triangles.corner_vertices, face_positions[across],
                                                                  vertex_positions[source(h, mesh)],
                                                                  vertex_positions[target(h, mesh)]));
    }
  }
  return triangles;
}

template <class ConcurrencyTag, class FaceListGraph, class FaceDescriptor, class VertexPositions, class NamedParameters>
Triangles read_triangles(const FaceListGraph& mesh,
                         const Large_vector<FaceDescriptor>& faces,
                         const VertexPositions& vertex_positions,
                         const NamedParameters& np)
{
  typedef std::decay_t<decltype(parameters::get_parameter(np, internal_np::face_index))> Face_index_parameter;
  constexpr bool has_face_indices = !std::is_same_v<Face_index_parameter, internal_np::Param_not_found>;
  // The edge indices of a Polyhedron_3 cannot be written, but come from ids of halfedges that can.
  constexpr bool has_edge_indices = Has_constant_index<FaceListGraph, boost::halfedge_index_t>::value
                                 && Has_constant_index<FaceListGraph, boost::edge_index_t>::value;
  if constexpr(has_edge_indices && !has_face_indices)
    return read_triangles_by_edges<ConcurrencyTag>(mesh, faces, vertex_positions);
  else
    return read_triangles_by_faces(mesh, faces, vertex_positions, make_face_positions(mesh, faces, np));
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_READ_TRIANGLES_H
