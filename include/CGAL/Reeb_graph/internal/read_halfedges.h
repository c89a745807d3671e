// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_READ_HALFEDGES_H
#define CGAL_REEB_GRAPH_INTERNAL_READ_HALFEDGES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/Descriptor_list.h>
#include <CGAL/Reeb_graph/internal/Descriptor_positions.h>
#include <CGAL/Reeb_graph/internal/Large_vector.h>
#include <CGAL/Reeb_graph/internal/Triangle_complex.h>
#include <CGAL/Reeb_graph/internal/parallel.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The halfedges of a mesh by the numbers that they have in a Triangle_complex.
template <class FaceListGraph>
class Numbered_halfedges
{
public:
  typedef typename boost::graph_traits<FaceListGraph>::halfedge_descriptor halfedge_descriptor;

  Numbered_halfedges() = default;
  // From the halfedge with the even number of each edge, or none if descriptors are made from the numbers.
  explicit Numbered_halfedges(Large_vector<halfedge_descriptor> even_halfedges)
    : even_halfedges_(std::move(even_halfedges))
  {}

  halfedge_descriptor operator()(const FaceListGraph& mesh, Index number) const
  {
    if constexpr(Consecutive_descriptors<FaceListGraph>::are_possible)
    {
      if(even_halfedges_.empty())
        return halfedge_descriptor(number);
    }
    const halfedge_descriptor h = even_halfedges_[number / 2];
    return number % 2 == 0 ? h : opposite(h, mesh);
  }

private:
  Large_vector<halfedge_descriptor> even_halfedges_; // by edge
};

template <class FaceListGraph>
struct Read_halfedges
{
  Halfedge_arrays arrays;
  Numbered_halfedges<FaceListGraph> numbered_halfedges;
};

template <class FaceListGraph>
void throw_error_of_first_bad_face(const FaceListGraph& mesh)
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

// A halfedge of a face that ends where h does, the null halfedge if there is none.
template <class FaceListGraph, class HalfedgeDescriptor>
HalfedgeDescriptor find_halfedge_of_face(const FaceListGraph& mesh, HalfedgeDescriptor h)
{
  const HalfedgeDescriptor null = boost::graph_traits<FaceListGraph>::null_halfedge();
  if(h == null || !is_border(h, mesh))
    return h;
  for(const HalfedgeDescriptor around : CGAL::halfedges_around_target(h, mesh))
  {
    if(!is_border(around, mesh))
      return around;
  }
  return null;
}

// Numbers the halfedges of a mesh that numbers its edges.
template <class FaceListGraph>
class Halfedge_numbers
{
  typedef boost::graph_traits<FaceListGraph> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef Descriptor_list<FaceListGraph, typename Graph_traits::edge_descriptor> Edge_list;

public:
  explicit Halfedge_numbers(const FaceListGraph& mesh)
    : mesh_(mesh),
      edge_list_(mesh, CGAL::make_range(edges(mesh))),
      edge_positions_(make_positions_by_constant_index<boost::edge_index_t>(mesh, edge_list_, "edges")),
      is_consecutive_(edge_list_.is_consecutive())
  {
    checked_index(2 * edge_list_.size());
  }

  Index operator()(halfedge_descriptor h) const
  {
    if constexpr(Consecutive_descriptors<FaceListGraph>::are_possible)
    {
      if(is_consecutive_)
        return static_cast<Index>(h);
    }
    // The edge that comes from h may not be that of the list: only the latter leads to the halfedge of even number.
    const Index e = edge_positions_[edge(h, mesh_)];
    return 2 * e + (even_halfedge(e) == h ? 0 : 1);
  }

  std::size_t number_of_edges() const { return edge_list_.size(); }
  halfedge_descriptor even_halfedge(std::size_t edge) const { return halfedge(edge_list_[edge], mesh_); }

  Numbered_halfedges<FaceListGraph> numbered_halfedges() const
  {
    Large_vector<halfedge_descriptor> even_halfedges;
    for(std::size_t e = 0; !is_consecutive_ && e != number_of_edges(); ++e)
      even_halfedges.push_back(even_halfedge(e));
    return Numbered_halfedges<FaceListGraph>(std::move(even_halfedges));
  }

private:
  const FaceListGraph& mesh_;
  const Edge_list edge_list_;
  const decltype(make_positions_by_constant_index<boost::edge_index_t>(std::declval<const FaceListGraph&>(),
                                                                       std::declval<const Edge_list&>(),
                                                                       "")) edge_positions_;
  const bool is_consecutive_;
};

// Fills the array of halfedges, and checks that they are those of triangles.
template <class ConcurrencyTag, class FaceListGraph, class Numbers, class VertexPositions>
void read_triangles(const FaceListGraph& mesh,
                    const Numbers& number,
                    const VertexPositions& vertex_positions,
                    Halfedge_arrays& arrays)
{
  typedef typename boost::graph_traits<FaceListGraph>::halfedge_descriptor halfedge_descriptor;
  arrays.halfedges.resize(2 * number.number_of_edges());
  Shared_counter<ConcurrencyTag> number_of_bad_halfedges, number_of_halfedges_of_triangles;
  for_each_block<ConcurrencyTag>(number.number_of_edges(), [&](std::size_t begin, std::size_t end) {
    std::size_t number_of_bad = 0, number_of_good = 0;
    const auto read = [&](std::size_t i, halfedge_descriptor h) {
      arrays.halfedges[i] = {vertex_positions[target(h, mesh)], no_index};
      if(is_border(h, mesh))
        return;
      const halfedge_descriptor second = next(h, mesh), third = next(second, mesh);
      const bool is_bad = second == h || third == h || next(third, mesh) != h || target(h, mesh) == target(third, mesh);
      arrays.halfedges[i].next = number(second);
      ++(is_bad ? number_of_bad : number_of_good);
    };
    for(std::size_t e = begin; e != end; ++e)
    {
      const halfedge_descriptor h = number.even_halfedge(e);
      read(2 * e, h);
      read(2 * e + 1, opposite(h, mesh));
    }
    number_of_bad_halfedges.add(number_of_bad);
    number_of_halfedges_of_triangles.add(number_of_good);
  });
  if(number_of_bad_halfedges.get() != 0)
    throw_error_of_first_bad_face(mesh);
  arrays.number_of_halfedges_of_triangles = number_of_halfedges_of_triangles.get();
}

// For meshes that number their edges: copies the arrays that they have.
template <class ConcurrencyTag, class FaceListGraph, class VertexList, class VertexPositions>
Read_halfedges<FaceListGraph> read_halfedges_by_edges(const FaceListGraph& mesh,
                                                      const VertexList& vertex_list,
                                                      const VertexPositions& vertex_positions)
{
  typedef boost::graph_traits<FaceListGraph> Graph_traits;
  const Halfedge_numbers<FaceListGraph> number(mesh);
  Read_halfedges<FaceListGraph> result;
  read_triangles<ConcurrencyTag>(mesh, number, vertex_positions, result.arrays);
  Large_vector<Index>& halfedges_of_vertices = result.arrays.halfedges_of_vertices;
  halfedges_of_vertices.resize(vertex_list.size());
  for_each_block<ConcurrencyTag>(vertex_list.size(), [&](std::size_t begin, std::size_t end) {
    for(std::size_t v = begin; v != end; ++v)
    {
      const auto h = find_halfedge_of_face(mesh, halfedge(vertex_list[v], mesh));
      halfedges_of_vertices[v] = h == Graph_traits::null_halfedge() ? no_index : number(h);
    }
  });
  result.numbered_halfedges = number.numbered_halfedges();
  return result;
}

// For meshes that number at most their faces: numbers the edges as they are met.
template <class FaceListGraph, class FaceList, class VertexList, class VertexPositions, class FacePositions>
Read_halfedges<FaceListGraph> read_halfedges_by_faces(const FaceListGraph& mesh,
                                                      const FaceList& face_list,
                                                      const VertexList& vertex_list,
                                                      const VertexPositions& vertex_positions,
                                                      const FacePositions& face_positions)
{
  typedef boost::graph_traits<FaceListGraph> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  throw_error_of_first_bad_face(mesh);
  Read_halfedges<FaceListGraph> result;
  Halfedge_arrays& arrays = result.arrays;
  arrays.halfedges_of_vertices.assign(vertex_list.size(), no_index);
  Large_vector<halfedge_descriptor> even_halfedges;
  Large_vector<std::array<Index, 3>> numbers_in_faces;
  numbers_in_faces.reserve(face_list.size());

  const auto add_edge_of = [&](halfedge_descriptor h) {
    even_halfedges.push_back(h);
    for(const auto v : {target(h, mesh), source(h, mesh)})
      arrays.halfedges.push_back({vertex_positions[v], no_index});
    return checked_index(arrays.halfedges.size()) - 2;
  };
  const auto number = [&](halfedge_descriptor h) {
    const auto across = face(opposite(h, mesh), mesh);
    if(across == Graph_traits::null_face() || face_positions[across] >= numbers_in_faces.size())
      return add_edge_of(h);
    const std::array<Index, 3>& numbers = numbers_in_faces[face_positions[across]];
    const auto is_of_edge = [&](Index i) { return even_halfedges[i / 2] == opposite(h, mesh); };
    return Triangle_complex::opposite(is_of_edge(numbers[0]) ? numbers[0]
                                                             : (is_of_edge(numbers[1]) ? numbers[1] : numbers[2]));
  };
  arrays.number_of_halfedges_of_triangles = 3 * face_list.size();
  for(std::size_t f = 0; f != face_list.size(); ++f)
  {
    const halfedge_descriptor h = halfedge(face_list[f], mesh);
    const std::array<Index, 3> numbers = {number(h), number(next(h, mesh)), number(prev(h, mesh))};
    for(std::size_t i = 0; i != 3; ++i)
    {
      arrays.halfedges[numbers[i]].next = numbers[(i + 1) % 3];
      arrays.halfedges_of_vertices[arrays.halfedges[numbers[i]].target] = numbers[i];
    }
    numbers_in_faces.push_back(numbers);
  }
  result.numbered_halfedges = Numbered_halfedges<FaceListGraph>(std::move(even_halfedges));
  return result;
}

template <class ConcurrencyTag, class FaceListGraph, class VertexList, class VertexPositions, class NamedParameters>
Read_halfedges<FaceListGraph> read_halfedges(const FaceListGraph& mesh,
                                             const VertexList& vertex_list,
                                             const VertexPositions& vertex_positions,
                                             const NamedParameters& np)
{
  typedef std::decay_t<decltype(parameters::get_parameter(np, internal_np::face_index))> Face_index_parameter;
  constexpr bool has_face_indices = !std::is_same_v<Face_index_parameter, internal_np::Param_not_found>;
  // The edge indices of a Polyhedron_3 cannot be written, but come from ids of halfedges that can.
  constexpr bool has_edge_indices = Has_constant_index<FaceListGraph, boost::halfedge_index_t>::value
                                 && Has_constant_index<FaceListGraph, boost::edge_index_t>::value;
  if constexpr(has_edge_indices && !has_face_indices)
    return read_halfedges_by_edges<ConcurrencyTag>(mesh, vertex_list, vertex_positions);
  else
  {
    const Descriptor_list<FaceListGraph, typename boost::graph_traits<FaceListGraph>::face_descriptor> face_list(
      mesh, CGAL::make_range(faces(mesh)));
    return read_halfedges_by_faces(mesh, face_list, vertex_list, vertex_positions,
                                   make_face_positions(mesh, face_list, np));
  }
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_READ_HALFEDGES_H
