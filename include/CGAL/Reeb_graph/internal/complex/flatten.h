// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_FLATTEN_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_FLATTEN_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/internal/complex/Regular_vertices.h>
#include <CGAL/Reeb_graph/internal/complex/Unchecked_complex.h>
#include <CGAL/Reeb_graph/internal/complex/Vertex_order.h>
#include <CGAL/Reeb_graph/internal/complex/descriptor_lists.h>
#include <CGAL/Reeb_graph/internal/complex/surface_complexes.h>

#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

namespace CGAL::Reeb_graph::internal {

template <class FaceListGraph>
struct Read_halfedges
{
  Halfedge_arrays arrays;
  Indexed_vector<Edge_index, typename boost::graph_traits<FaceListGraph>::halfedge_descriptor> even_halfedges;
  // The halfedges of each face, from the one that the mesh gives on.
  Indexed_vector<Face_index, std::array<Halfedge_index, 3>> halfedges_of_faces;
};

// What a model of EdgeListGraph has, which a FaceListGraph need not be.
template <class FaceListGraph>
using Edge_list =
  decltype(edges(std::declval<const FaceListGraph&>()), num_edges(std::declval<const FaceListGraph&>()));

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
      arrays.halfedges.push_back({vertex_positions(v), no_index});
    return Halfedge_index(checked_index(arrays.halfedges.size()) - 2);
  };
  const auto number = [&](halfedge_descriptor h) {
    const auto across = face(opposite(h, mesh), mesh);
    if(across == Graph_traits::null_face() || !halfedges_of_faces.contains(face_positions(across)))
      return add_edge_of(h);
    const std::array<Halfedge_index, 3>& numbers = halfedges_of_faces[face_positions(across)];
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
  if constexpr(Has<Edge_list, FaceListGraph>::value)
  {
    if(num_edges(mesh) != even_halfedges.size()) // It may count removed ones, too.
      check_edges(mesh);
  }
  return {std::move(arrays), std::move(even_halfedges), std::move(halfedges_of_faces)};
}

// The stages see a mesh of any type as a copy, but a Surface_mesh as it is.
template <class FaceListGraph>
struct Complex_of
{
  typedef Triangle_complex type;
};

template <class Point>
struct Complex_of<Surface_mesh<Point>>
{
  typedef Surface_mesh_complex<Point> type;
};

template <class FaceListGraph>
using Complex_of_t = typename Complex_of<FaceListGraph>::type;

// A field by the numbers of vertices, and the way from numbers to the mesh and back. The numbers of vertices can outlive
// the mesh if its index map can.
template <class FaceListGraph, class Scalar>
struct Field_by_numbers
{
  Indexed_vector<Vertex_index, Scalar> values;
  Vertex_list<FaceListGraph> vertices;
  Halfedge_list<FaceListGraph> halfedges;
  std::function<Vertex_index(typename Vertex_list<FaceListGraph>::vertex_descriptor)> numbers;
};

// A mesh with its field by numbers.
template <class Complex, class FaceListGraph, class Scalar>
struct Complex_with_field
{
  Complex complex;
  Field_by_numbers<FaceListGraph, Scalar> field;
};

// Those before the mesh has been checked, and afterwards.
template <class FaceListGraph, class Scalar>
using Unchecked_surface = Complex_with_field<Unchecked_complex<Complex_of_t<FaceListGraph>>, FaceListGraph, Scalar>;
template <class FaceListGraph, class Scalar>
using Flat_surface = Complex_with_field<Complex_of_t<FaceListGraph>, FaceListGraph, Scalar>;

// The values of all vertices. Only plain numbers are read in parallel: copies of others may share parts.
template <class ConcurrencyTag, class VertexList, class ScalarMap, class Traits>
Indexed_vector<Vertex_index, typename Traits::Scalar> read_values(const VertexList& vertices,
                                                                  const ScalarMap& scalar_map,
                                                                  const Traits& traits)
{
  typedef typename Traits::Scalar Scalar;
  static_assert(!std::is_same_v<Scalar, bool>, "Scalar values of type bool are not supported: use char.");
  constexpr bool is_read_in_parallel = std::is_arithmetic_v<Scalar> && !Is_changed_by_reading<ScalarMap>::value;
  typedef std::conditional_t<is_read_in_parallel, ConcurrencyTag, Sequential_tag> Tag;
  const auto is_ordered_object = traits.is_ordered_object();
  const auto is_ordered = [&](const Scalar& value) {
    if constexpr(is_order_of_numbers<Scalar, std::decay_t<decltype(traits.less_scalar_object())>>)
      return internal::is_ordered(value) && is_ordered_object(value);
    else
      return is_ordered_object(value);
  };
  Indexed_vector<Vertex_index, Scalar> values;
  values.resize(vertices.size());
  const auto read = [&](std::size_t begin, std::size_t end, std::size_t& number_of_unordered) {
    for(const Vertex_index v : Index_range(Vertex_index(begin), Vertex_index(end)))
    {
      if(!vertices.contains(v))
      {
        values[v] = Scalar();
        continue;
      }
      values[v] = get(scalar_map, vertices[v]);
      number_of_unordered += is_ordered(values[v]) ? 0 : 1;
    }
  };
  if(sum_of_parts<Tag, std::size_t>(vertices.size(), read) == 0)
    return values;
  for(const Vertex_index v : values.keys())
  {
    if(vertices.contains(v) && !is_ordered(values[v]))
      throw Unordered_scalar_error(vertices.position(v));
  }
  return values;
}

// Whether a halfedge can be one of the mesh. Only a mesh that numbers its halfedges tells those of other meshes.
template <class FaceListGraph, class HalfedgeDescriptor>
bool can_be_halfedge(const FaceListGraph&, const HalfedgeDescriptor&)
{
  return true;
}

template <class Point>
bool can_be_halfedge(const Surface_mesh<Point>& mesh, typename Surface_mesh<Point>::Halfedge_index h)
{
  return mesh.has_valid_index(h);
}

// What tells most edits of a mesh: its numbers of vertices, edges and faces, and the first number behind those of a
// Surface_mesh, whose removed elements keep theirs.
typedef std::array<std::size_t, 5> Element_counts;

template <class FaceListGraph>
Element_counts count_elements(const FaceListGraph& mesh)
{
  std::size_t number_of_edges = 0;
  if constexpr(Has<Edge_list, FaceListGraph>::value)
    number_of_edges = num_edges(mesh);
  return {num_vertices(mesh), number_of_edges, num_faces(mesh), 0, 0};
}

template <class Point>
Element_counts count_elements(const Surface_mesh<Point>& mesh)
{
  return {mesh.number_of_vertices(), mesh.number_of_edges(), mesh.number_of_faces(), mesh.num_vertices(),
          mesh.num_edges()};
}

// Index maps for a mesh that needs none are checked, too: whoever gives one that is wrong is told so.
template <class FaceListGraph, class NamedParameters>
void check_index_maps(const FaceListGraph& mesh, const NamedParameters& np)
{
  typedef boost::graph_traits<FaceListGraph> Graph_traits;
  using parameters::get_parameter;
  if constexpr(is_given<decltype(get_parameter(np, internal_np::vertex_index))>)
  {
    const auto range = vertices(mesh);
    typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
    make_vertex_positions(mesh, Indexed_vector<Vertex_index, vertex_descriptor>(range.first, range.second), np);
  }
  if constexpr(is_given<decltype(get_parameter(np, internal_np::face_index))>)
  {
    const auto range = faces(mesh);
    typedef typename Graph_traits::face_descriptor face_descriptor;
    make_face_positions(mesh, Indexed_vector<Face_index, face_descriptor>(range.first, range.second), np);
  }
}

template <class ConcurrencyTag, class FaceListGraph, class ScalarMap, class Traits, class NamedParameters>
Unchecked_surface<FaceListGraph, typename Traits::Scalar> flatten_unchecked(const FaceListGraph& mesh,
                                                                            const ScalarMap& scalar_map,
                                                                            const Traits& traits,
                                                                            const NamedParameters& np)
{
  Vertex_list<FaceListGraph> vertex_list(mesh);
  auto values = read_values<ConcurrencyTag>(vertex_list, scalar_map, traits);
  const auto face_range = faces(mesh);
  typedef typename boost::graph_traits<FaceListGraph>::face_descriptor face_descriptor;
  const Indexed_vector<Face_index, face_descriptor> face_list(face_range.first, face_range.second);
  auto positions = make_vertex_positions(mesh, vertex_list, np);
  auto read = read_halfedges(mesh, face_list, vertex_list.size(), positions, make_face_positions(mesh, face_list, np));
  return {Unchecked_complex(Triangle_complex(std::move(read.arrays), face_list.size())),
          {std::move(values), std::move(vertex_list), Halfedge_list<FaceListGraph>(std::move(read.even_halfedges)),
           std::move(positions)}};
}

template <class ConcurrencyTag, class Point, class ScalarMap, class Traits, class NamedParameters>
Unchecked_surface<Surface_mesh<Point>, typename Traits::Scalar> flatten_unchecked(const Surface_mesh<Point>& mesh,
                                                                                  const ScalarMap& scalar_map,
                                                                                  const Traits& traits,
                                                                                  const NamedParameters& np)
{
  Vertex_list<Surface_mesh<Point>> vertex_list(mesh);
  auto values = read_values<ConcurrencyTag>(vertex_list, scalar_map, traits);
  check_index_maps(mesh, np);
  return {Unchecked_complex(Surface_mesh_complex<Point>(mesh)),
          {std::move(values), std::move(vertex_list), {}, [](auto v) { return Vertex_index(v); }}};
}

// Sets the fans of all vertices, and checks the complex. Any order of the vertices will do.
template <class ConcurrencyTag, class Complex, class Order>
Complex check_complex(Unchecked_complex<Complex> unchecked, const Order& order)
{
  const auto regular_vertices = find_regular_vertices<ConcurrencyTag>(unchecked.at_set_fans(), order);
  const auto set_fans = [&](std::size_t begin, std::size_t end, Fan_counts& counts) {
    No_visitor_of_fan visitor;
    for(const Vertex_index v : Index_range(Vertex_index(begin), Vertex_index(end)))
    {
      const Number number_of_corners = regular_vertices.number_of_corners(v);
      if(number_of_corners == 0)
      {
        unchecked.set_fan(v, counts, visitor);
        continue;
      }
      unchecked.set_closed_fan(v);
      counts.corners += number_of_corners;
    }
  };
  return std::move(unchecked).check(sum_of_parts<ConcurrencyTag, Fan_counts>(unchecked.number_of_vertices(), set_fans));
}

// Whether a scalar map is a public Flat_field with values of the wanted type. It is told by what it has, as it stands
// above the stages.
template <class ScalarMap, class Scalar, class = void>
struct Is_flat_field : std::false_type
{
};
template <class ScalarMap, class Scalar>
struct Is_flat_field<ScalarMap, Scalar, std::void_t<typename ScalarMap::Flat_surface>>
  : std::is_same<typename ScalarMap::value_type, Scalar>
{
};

// The mesh with its field by numbers, after it has been checked.
template <class ConcurrencyTag, class FaceListGraph, class ScalarMap, class Traits, class NamedParameters>
Flat_surface<FaceListGraph, typename Traits::Scalar> flatten(const FaceListGraph& mesh,
                                                             const ScalarMap& scalar_map,
                                                             const Traits& traits,
                                                             const NamedParameters& np)
{
  auto [unchecked, field] = flatten_unchecked<ConcurrencyTag>(mesh, scalar_map, traits, np);
  auto complex =
    check_complex<ConcurrencyTag>(std::move(unchecked), Vertex_order(field.values, traits.less_scalar_object()));
  return {std::move(complex), std::move(field)};
}

// The same, to be shared; that of a Flat_field is there already.
template <class ConcurrencyTag, class FaceListGraph, class ScalarMap, class Traits, class NamedParameters>
std::shared_ptr<const Flat_surface<FaceListGraph, typename Traits::Scalar>> share_flat(const FaceListGraph& mesh,
                                                                                       const ScalarMap& scalar_map,
                                                                                       const Traits& traits,
                                                                                       const NamedParameters& np)
{
  if constexpr(Is_flat_field<ScalarMap, typename Traits::Scalar>::value)
    return scalar_map.flat_surface(mesh);
  else
    return std::make_shared<const Flat_surface<FaceListGraph, typename Traits::Scalar>>(
      flatten<ConcurrencyTag>(mesh, scalar_map, traits, np));
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_FLATTEN_H
