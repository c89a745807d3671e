// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_MESH_READ_HALFEDGES_H
#define CGAL_REEB_GRAPH_INTERNAL_MESH_READ_HALFEDGES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/mesh/Triangle_complex.h>
#include <CGAL/Reeb_graph/internal/mesh/check_faces.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

template <class FaceListGraph>
struct Read_halfedges
{
  Halfedge_arrays arrays;
  Indexed_vector<Edge_index, typename boost::graph_traits<FaceListGraph>::halfedge_descriptor> even_halfedges;
  // The halfedges of each face, from the one that the mesh gives on.
  Indexed_vector<Face_index, std::array<Halfedge_index, 3>> halfedges_of_faces;
};

// Whether the mesh is a model of EdgeListGraph, which a FaceListGraph need not be.
template <class FaceListGraph, class = void>
struct Has_edge_list : std::false_type
{
};
template <class FaceListGraph>
struct Has_edge_list<FaceListGraph,
                     std::void_t<decltype(edges(std::declval<const FaceListGraph&>())),
                                 decltype(num_edges(std::declval<const FaceListGraph&>()))>> : std::true_type
{
};

// Numbers the edges as they are met, face by face.
template <class FaceListGraph, class FaceList, class VertexPositions, class FacePositions>
Read_halfedges<FaceListGraph> read_halfedges(const FaceListGraph& mesh,
                                             const FaceList& face_list,
                                             std::size_t number_of_vertices,
                                             const VertexPositions& vertex_positions,
                                             const FacePositions& face_positions)
{
  typedef boost::graph_traits<FaceListGraph> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  check_faces(mesh);
  Halfedge_arrays arrays;
  arrays.halfedges_of_vertices.assign(number_of_vertices, no_index);
  arrays.halfedges.reserve(3 * face_list.size()); // as many as a surface without border has
  Indexed_vector<Edge_index, halfedge_descriptor> even_halfedges;
  even_halfedges.reserve(arrays.halfedges.capacity() / 2);
  Indexed_vector<Face_index, std::array<Halfedge_index, 3>> halfedges_of_faces;
  halfedges_of_faces.reserve(face_list.size());

  const auto add_edge_of = [&](halfedge_descriptor h) {
    even_halfedges.push_back(h);
    for(const auto v : {target(h, mesh), source(h, mesh)})
      arrays.halfedges.push_back({vertex_positions[v], no_index});
    return Halfedge_index(checked_index(arrays.halfedges.size()) - 2);
  };
  const auto number = [&](halfedge_descriptor h) {
    const auto across = face(opposite(h, mesh), mesh);
    if(across == Graph_traits::null_face() || !halfedges_of_faces.contains(face_positions[across]))
      return add_edge_of(h);
    const std::array<Halfedge_index, 3>& numbers = halfedges_of_faces[face_positions[across]];
    const auto is_of_edge = [&](Halfedge_index i) { return even_halfedges[edge_of(i)] == opposite(h, mesh); };
    return opposite_of(is_of_edge(numbers[0]) ? numbers[0] : (is_of_edge(numbers[1]) ? numbers[1] : numbers[2]));
  };
  for(const Face_index f : face_list.keys())
  {
    const halfedge_descriptor h = halfedge(face_list[f], mesh);
    const std::array<Halfedge_index, 3> numbers = {number(h), number(next(h, mesh)), number(prev(h, mesh))};
    for(std::size_t i = 0; i != 3; ++i)
    {
      arrays.halfedges[numbers[i]].next = numbers[(i + 1) % 3];
      arrays.halfedges_of_vertices[arrays.halfedges[numbers[i]].target] = numbers[i];
    }
    halfedges_of_faces.push_back(numbers);
  }
  if constexpr(Has_edge_list<FaceListGraph>::value)
  {
    if(num_edges(mesh) != even_halfedges.size()) // It may count removed ones, too.
      check_edges(mesh);
  }
  return {std::move(arrays), std::move(even_halfedges), std::move(halfedges_of_faces)};
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_MESH_READ_HALFEDGES_H
