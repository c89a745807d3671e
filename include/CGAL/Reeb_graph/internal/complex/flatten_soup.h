// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_FLATTEN_SOUP_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_FLATTEN_SOUP_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/complex/Simplicial_complex.h>
#include <CGAL/Reeb_graph/internal/complex/flatten.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>

namespace CGAL::Reeb_graph::internal {

// The number of vertices, given as such or by a range of points.
template <class PointsOrNumber>
std::size_t count_vertices(const PointsOrNumber& points)
{
  if constexpr(std::is_integral_v<PointsOrNumber>)
    return static_cast<std::size_t>(points);
  else
    return static_cast<std::size_t>(std::distance(std::begin(points), std::end(points)));
}

template <class Range>
using Value_of_range = typename std::iterator_traits<decltype(std::begin(std::declval<const Range&>()))>::value_type;

// The indices of an edge, which may be given as a pair.
template <class Simplex>
const Simplex& as_range(const Simplex& simplex)
{
  return simplex;
}

template <class First, class Second>
std::array<First, 2> as_range(const std::pair<First, Second>& edge)
{
  return {edge.first, edge.second};
}

// How a range of indices fails to be a simplex of `size` vertices.
enum class Simplex_fault
{
  NONE,
  SIZE,
  INDEX,
  REPETITION
};

// Reads a range of `size` different indices of vertices. Negative numbers are no indices.
template <std::size_t size, class Simplex>
Simplex_fault read_simplex(const Simplex& simplex,
                           std::size_t number_of_vertices,
                           std::array<Vertex_index, size>& result)
{
  std::size_t n = 0;
  bool are_vertices = true;
  const auto& indices = as_range(simplex);
  for(const auto index : indices)
  {
    if(n == size)
      return Simplex_fault::SIZE;
    const bool is_vertex = !(index < 0) && static_cast<std::size_t>(index) < number_of_vertices;
    are_vertices &= is_vertex;
    result[n++] = Vertex_index(static_cast<std::size_t>(index));
  }
  if(n != size)
    return Simplex_fault::SIZE;
  if(!are_vertices)
    return Simplex_fault::INDEX;
  for(std::size_t i = 0; i != size; ++i)
    for(std::size_t j = 0; j != i; ++j)
      if(result[i] == result[j])
        return Simplex_fault::REPETITION;
  return Simplex_fault::NONE;
}

// Calls visit(vertices) for each simplex of a range, and throw_error(position, fault) for the first that is none.
template <std::size_t size, class Simplices, class ThrowError, class Visit>
void for_each_simplex(const Simplices& simplices,
                      std::size_t number_of_vertices,
                      const ThrowError& throw_error,
                      const Visit& visit)
{
  std::size_t position = 0;
  std::array<Vertex_index, size> vertices = {};
  for(const auto& simplex : simplices)
  {
    const Simplex_fault fault = read_simplex<size>(simplex, number_of_vertices, vertices);
    if(fault != Simplex_fault::NONE)
      throw_error(position, fault);
    visit(vertices);
    ++position;
  }
}

// Throws the error of a range of indices that is no triangle, or no tetrahedron.
template <std::size_t vertices_per_cell>
[[noreturn]] void throw_cell_error(std::size_t cell, Simplex_fault fault)
{
  if(fault == Simplex_fault::INDEX)
    throw Vertex_out_of_range_error(vertices_per_cell == 3 ? "face" : "tetrahedron", cell);
  if(vertices_per_cell == 4)
    throw Non_tetrahedral_cell_error(cell);
  if(fault == Simplex_fault::SIZE)
    throw Non_triangular_face_error(cell);
  throw Degenerate_face_error(cell);
}

// The complex of triangles, or of the faces of tetrahedra, and of edges, which are pairs of indices.
template <std::size_t vertices_per_cell, class Cells, class Edges>
Simplicial_complex read_cells(std::size_t number_of_vertices, const Cells& cells, const Edges& edges)
{
  checked_index(number_of_vertices);
  const auto for_each_triangle = [&](const auto& visit) {
    for_each_simplex<vertices_per_cell>(cells, number_of_vertices, throw_cell_error<vertices_per_cell>,
                                        [&](const auto& v) {
                                          visit(v[0], v[1], v[2]);
                                          if constexpr(vertices_per_cell == 4)
                                          {
                                            visit(v[0], v[1], v[3]);
                                            visit(v[0], v[2], v[3]);
                                            visit(v[1], v[2], v[3]);
                                          }
                                        });
  };
  const auto for_each_edge = [&](const auto& visit) {
    const auto throw_error = [](std::size_t edge, Simplex_fault fault) {
      if(fault == Simplex_fault::INDEX)
        throw Vertex_out_of_range_error("edge", edge);
      throw Degenerate_edge_error(edge);
    };
    for_each_simplex<2>(edges, number_of_vertices, throw_error, [&](const auto& v) { visit(v[0], v[1]); });
  };
  return Simplicial_complex(number_of_vertices, for_each_triangle, for_each_edge);
}

} // namespace CGAL::Reeb_graph::internal

namespace boost {

// A soup of triangles has no other mesh than the complex, which stands where a mesh is asked for.
template <>
struct graph_traits<CGAL::Reeb_graph::internal::Simplicial_complex>
{
  typedef std::size_t vertex_descriptor;
  typedef std::pair<std::size_t, std::size_t> halfedge_descriptor; // source and target
};

} // namespace boost

namespace CGAL::Reeb_graph::internal {

template <>
struct Descriptors<Simplicial_complex, false>
{
  typedef boost::graph_traits<Simplicial_complex>::vertex_descriptor vertex_descriptor, face_descriptor;
  typedef boost::graph_traits<Simplicial_complex>::halfedge_descriptor halfedge_descriptor;
};

inline std::size_t source(const boost::graph_traits<Simplicial_complex>::halfedge_descriptor& h,
                          const Simplicial_complex&)
{
  return h.first;
}
inline std::size_t target(const boost::graph_traits<Simplicial_complex>::halfedge_descriptor& h,
                          const Simplicial_complex&)
{
  return h.second;
}
inline std::size_t num_vertices(const Simplicial_complex& complex) { return complex.number_of_vertices(); }

// The type of a scalar map in the traits class of a soup.
template <class Scalar>
using Soup_scalars = boost::iterator_property_map<const Scalar*, boost::typed_identity_property_map<std::size_t>>;

template <>
class Vertex_list<Simplicial_complex>
{
public:
  typedef std::size_t vertex_descriptor;

  explicit Vertex_list(std::size_t size) : size_(size) {}

  std::size_t size() const { return size_; }
  bool contains(Vertex_index) const { return true; }
  vertex_descriptor operator[](Vertex_index v) const { return v.number(); }
  std::size_t position(Vertex_index v) const { return v.number(); }

private:
  std::size_t size_;
};

template <>
class Halfedge_list<Simplicial_complex>
{
public:
  typedef boost::graph_traits<Simplicial_complex>::halfedge_descriptor halfedge_descriptor;

  halfedge_descriptor operator()(const Simplicial_complex& complex, Halfedge_index halfedge) const
  {
    return {complex.source(halfedge).number(), complex.target(halfedge).number()};
  }
};

template <>
struct Complex_of<Simplicial_complex>
{
  typedef Simplicial_complex type;
};

// A soup, or the faces of tetrahedra, with its field by numbers.
template <class Scalar>
using Flat_soup = Complex_with_field<Simplicial_complex, Simplicial_complex, Scalar>;

// The values of the vertices, one for each in a random access range.
template <class ConcurrencyTag, class Scalars, class Traits>
Indexed_vector<Vertex_index, typename Traits::Scalar> read_scalars(std::size_t number_of_vertices,
                                                                   const Scalars& scalars,
                                                                   const Traits& traits)
{
  const std::size_t number_of_scalars = static_cast<std::size_t>(std::end(scalars) - std::begin(scalars));
  if(number_of_scalars != number_of_vertices)
    throw Scalar_count_error(number_of_scalars, number_of_vertices);
  const auto map =
    boost::make_iterator_property_map(std::begin(scalars), boost::typed_identity_property_map<std::size_t>());
  return read_values<ConcurrencyTag>(Vertex_list<Simplicial_complex>(number_of_vertices), map, traits);
}

// The complex of triangles or of tetrahedra, by their number of vertices, and of the edges of a named parameter, with
// its field by numbers. The field is checked before the complex.
template <class ConcurrencyTag,
          std::size_t vertices_per_cell,
          class PointsOrNumber,
          class Cells,
          class EdgesParameter,
          class Scalars,
          class Traits>
Flat_soup<typename Traits::Scalar> flatten_cells(const PointsOrNumber& points,
                                                 const Cells& cells,
                                                 const EdgesParameter& edges_parameter,
                                                 const Scalars& scalars,
                                                 const Traits& traits)
{
  auto edges = parameters::choose_parameter<std::array<std::array<std::size_t, 2>, 0>>(edges_parameter);
  const std::size_t size = count_vertices(points);
  auto values = read_scalars<ConcurrencyTag>(size, scalars, traits);
  const auto number_of = [=](std::size_t v) { return v < size ? Vertex_index(v) : Vertex_index(no_index); };
  return {read_cells<vertices_per_cell>(size, cells, unwrap_reference(edges)),
          {Vertex_list<Simplicial_complex>(size), {}, number_of},
          std::move(values)};
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_FLATTEN_SOUP_H
