// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_MESH_FLATTEN_SOUP_H
#define CGAL_REEB_GRAPH_INTERNAL_MESH_FLATTEN_SOUP_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/mesh/Halfedge_list.h>
#include <CGAL/Reeb_graph/internal/mesh/Simplicial_complex.h>
#include <CGAL/Reeb_graph/internal/mesh/Vertex_list.h>
#include <CGAL/Reeb_graph/internal/mesh/flatten.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>

namespace boost {

// What a soup of triangles is called by where a mesh is: there is no other mesh than the complex.
template <>
struct graph_traits<CGAL::Reeb_graph::internal::Simplicial_complex>
{
  typedef std::size_t vertex_descriptor;
  typedef std::pair<std::size_t, std::size_t> halfedge_descriptor; // source and target
};

} // namespace boost

namespace CGAL {
namespace Reeb_graph {
namespace internal {

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

// A soup, or the faces of tetrahedra, with its field by numbers.
template <class Scalar>
using Flat_soup = Complex_with_field<Simplicial_complex, Simplicial_complex, Scalar>;

// The values of the vertices, one for each in a random access range.
template <class ConcurrencyTag, class Scalars, class Traits>
Field_by_numbers<Simplicial_complex, typename Traits::Scalar> flatten_scalars(std::size_t number_of_vertices,
                                                                              const Scalars& scalars,
                                                                              const Traits& traits)
{
  const std::size_t number_of_scalars = static_cast<std::size_t>(std::end(scalars) - std::begin(scalars));
  if(number_of_scalars != number_of_vertices)
    throw Scalar_count_error(number_of_scalars, number_of_vertices);
  const Vertex_list<Simplicial_complex> vertices(number_of_vertices);
  const auto map =
    boost::make_iterator_property_map(std::begin(scalars), boost::typed_identity_property_map<std::size_t>());
  const auto number = [=](std::size_t v) { return v < number_of_vertices ? Vertex_index(v) : Vertex_index(no_index); };
  return {read_values<ConcurrencyTag>(vertices, map, traits), vertices, {}, number};
}

// The field is checked before the complex that read_complex() returns.
template <class ConcurrencyTag, class Scalars, class Traits, class ReadComplex>
Flat_soup<typename Traits::Scalar> flatten_soup(std::size_t number_of_vertices,
                                                const Scalars& scalars,
                                                const Traits& traits,
                                                const ReadComplex& read_complex)
{
  auto field = flatten_scalars<ConcurrencyTag>(number_of_vertices, scalars, traits);
  return {read_complex(), std::move(field)};
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_MESH_FLATTEN_SOUP_H
