// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_FLATTEN_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_FLATTEN_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Threads.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/internal/complex/Keyed_field.h>
#include <CGAL/Reeb_graph/internal/complex/surface_complexes.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The descriptors of a mesh, numbered in the order of a range: a property map whose copies share the numbers. Several
// threads may read it, also with descriptors of other meshes, which a dynamic property map of CGAL inserts when it is
// read.
template <class Descriptor, class Number>
class Descriptor_numbers
{
public:
  typedef Descriptor key_type;
  typedef Number value_type;
  typedef Number reference;
  typedef boost::readable_property_map_tag category;

  template <class Range>
  Descriptor_numbers(const Range& descriptors, std::size_t size)
    : numbers_(std::make_shared<std::unordered_map<Descriptor, Number>>())
  {
    numbers_->reserve(size);
    for(const Descriptor& d : descriptors)
      numbers_->emplace(d, static_cast<Number>(numbers_->size()));
  }

  // The number of a descriptor, the greatest of its type if it has none.
  friend Number get(const Descriptor_numbers& map, const Descriptor& d)
  {
    const auto found = map.numbers_->find(d);
    return found == map.numbers_->end() ? (std::numeric_limits<Number>::max)() : found->second;
  }

private:
  std::shared_ptr<std::unordered_map<Descriptor, Number>> numbers_;
};

// The position of each vertex (or face) in the list given at construction, found through an index map, which can have
// holes, such as those that removed elements leave.
template <class Position, class IndexMap>
class Descriptor_positions
{
public:
  template <class DescriptorList>
  Descriptor_positions(const IndexMap& index_map, const DescriptorList& descriptors, const char* name)
    : index_map_(index_map),
      positions_(descriptors.size(), no_index)
  {
    for(const Position position : Index_range<Position>(descriptors.size()))
    {
      const auto i = get(index_map_, descriptors[position]);
      if(i < 0 || static_cast<std::size_t>(i) >= no_index)
        throw Invalid_index_map_error(name);
      const std::size_t index = static_cast<std::size_t>(i);
      if(index >= positions_.size())
        positions_.resize(index + 1, no_index);
      if(positions_[index] != no_index)
        throw Invalid_index_map_error(name);
      positions_[index] = position;
    }
  }

  // The position of a descriptor that may be unknown; then it is no_index.
  template <class Descriptor>
  Position operator()(const Descriptor& d) const
  {
    const std::size_t index = static_cast<std::size_t>(get(index_map_, d));
    return index < positions_.size() ? positions_[index] : no_index;
  }

private:
  IndexMap index_map_;
  std::vector<Position> positions_; // by index
};

// Stores the positions for a mesh that has no index map.
template <class Position, class Descriptor, class DescriptorList>
auto store_positions(const DescriptorList& descriptors)
{
  const Descriptor_numbers<Descriptor, Index> numbers(descriptors, descriptors.size());
  return [numbers](const Descriptor& d) { return Position(get(numbers, d)); };
}

// Whether the mesh has indices that cannot be written. Writable ones, such as the ids of a Polyhedron_3, may never
// have been set, and setting them here would change the mesh.
template <class Graph, class IndexTag, bool has_index = graph_has_property<Graph, IndexTag>::value>
struct Has_constant_index : std::false_type
{
};

template <class Graph, class IndexTag>
struct Has_constant_index<Graph, IndexTag, true>
  : std::bool_constant<
      !CGAL::internal::Is_writable_property_map<typename boost::property_map<Graph, IndexTag>::const_type>::value>
{
};

// Whether reading a map can change it: one of CGAL's inserts a default value where there is none.
template <class Map>
struct Is_changed_by_reading : std::false_type
{
};
template <class Key, class Value>
struct Is_changed_by_reading<CGAL::internal::Dynamic_property_map<Key, Value>> : std::true_type
{
};

template <class Position, class Descriptor, class IndexTag, class Graph, class DescriptorList, class IndexParameter>
auto make_descriptor_positions(const Graph& mesh,
                               const DescriptorList& descriptors,
                               const IndexParameter& index_parameter,
                               const char* name)
{
  if constexpr(!std::is_same_v<IndexParameter, internal_np::Param_not_found>)
  {
    Descriptor_positions<Position, IndexParameter> positions(index_parameter, descriptors,
                                                             name); // which checks the map
    if constexpr(Is_changed_by_reading<IndexParameter>::value)
      return store_positions<Position, Descriptor>(descriptors);
    else
      return positions;
  }
  else if constexpr(Has_constant_index<Graph, IndexTag>::value)
  {
    typedef typename boost::property_map<Graph, IndexTag>::const_type Index_map;
    return Descriptor_positions<Position, Index_map>(get(IndexTag(), mesh), descriptors, name);
  }
  else
    return store_positions<Position, Descriptor>(descriptors);
}

template <class Graph, class DescriptorList, class NamedParameters>
auto make_vertex_positions(const Graph& mesh, const DescriptorList& vertices, const NamedParameters& np)
{
  typedef typename boost::graph_traits<Graph>::vertex_descriptor vertex_descriptor;
  return make_descriptor_positions<Vertex_index, vertex_descriptor, boost::vertex_index_t>(
    mesh, vertices, parameters::get_parameter(np, internal_np::vertex_index), "vertices");
}

template <class Graph, class DescriptorList, class NamedParameters>
auto make_face_positions(const Graph& mesh, const DescriptorList& faces, const NamedParameters& np)
{
  typedef typename boost::graph_traits<Graph>::face_descriptor face_descriptor;
  return make_descriptor_positions<Face_index, face_descriptor, boost::face_index_t>(
    mesh, faces, parameters::get_parameter(np, internal_np::face_index), "faces");
}

// The vertices of a mesh by number: by their positions in vertices(mesh).
template <class FaceListGraph>
class Vertex_list
{
public:
  typedef typename boost::graph_traits<FaceListGraph>::vertex_descriptor vertex_descriptor;

  explicit Vertex_list(const FaceListGraph& mesh) : vertices_(vertices(mesh).first, vertices(mesh).second)
  {
    checked_index(vertices_.size());
  }

  // The first number behind those of the vertices, of which not all need belong to a vertex.
  std::size_t size() const { return vertices_.size(); }
  bool contains(Vertex_index) const { return true; }

  vertex_descriptor operator[](Vertex_index v) const { return vertices_[v]; }
  auto begin() const { return vertices_.begin(); }
  auto end() const { return vertices_.end(); }
  std::size_t position(Vertex_index v) const { return v.number(); }

private:
  Indexed_vector<Vertex_index, vertex_descriptor> vertices_;
};

// The vertices of a Surface_mesh are numbers. Removed ones keep theirs.
template <class Point>
class Vertex_list<Surface_mesh<Point>>
{
public:
  typedef typename Surface_mesh<Point>::Vertex_index vertex_descriptor;

  explicit Vertex_list(const Surface_mesh<Point>& mesh) : mesh_(&mesh) { checked_index(size()); }

  std::size_t size() const { return mesh_->num_vertices(); }
  bool contains(Vertex_index v) const { return !mesh_->has_garbage() || !mesh_->is_removed((*this)[v]); }

  vertex_descriptor operator[](Vertex_index v) const { return vertex_descriptor(v.number()); }
  std::size_t position(Vertex_index v) const
  {
    std::size_t position = 0;
    for(const Vertex_index i : Index_range<Vertex_index>(v.number()))
      position += contains(i) ? 1 : 0;
    return position;
  }

private:
  const Surface_mesh<Point>* mesh_;
};

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

// Members of a model of EdgeListGraph, which a FaceListGraph need not be.
template <class FaceListGraph>
using Edge_list =
  decltype(edges(std::declval<const FaceListGraph&>()), num_edges(std::declval<const FaceListGraph&>()));

// Copies the faces of a mesh. Numbers the edges as they are met, face by face.
template <class FaceListGraph, class FaceList, class VertexPositions, class FacePositions>
std::pair<Triangle_complex, Halfedge_list<FaceListGraph>> read_halfedges(const FaceListGraph& mesh,
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
  Indexed_vector<Face_index, std::array<Halfedge_index, 3>> halfedges_of_faces; // from the one that the mesh gives on
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
  return {Triangle_complex(std::move(arrays), face_list.size()),
          Halfedge_list<FaceListGraph>(std::move(even_halfedges))};
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

// The way from numbers of vertices and halfedges to the mesh, and from its vertices to their numbers. Those of the
// vertices can outlive the mesh if its index map can.
template <class FaceListGraph>
struct Mesh_numbers
{
  Vertex_list<FaceListGraph> vertices;
  Halfedge_list<FaceListGraph> halfedges;
  std::function<Vertex_index(typename Vertex_list<FaceListGraph>::vertex_descriptor)> number_of;
};

// By vertex, places in a graph as a map has them, which compute_reeb_graph() has been given; no_index where there is none.
typedef Indexed_vector<Vertex_index, Index> Place_of_vertex;

// A mesh with its field by numbers, as the pipeline takes it.
template <class Complex, class FaceListGraph, class Scalar>
struct Complex_with_field
{
  Complex complex;
  Mesh_numbers<FaceListGraph> numbers;
  Keyed_field<Scalar> field;
};

// The complex and its field before the mesh has been checked.
template <class FaceListGraph, class Scalar>
using Unchecked_surface = Complex_with_field<Unchecked_complex<Complex_of_t<FaceListGraph>>, FaceListGraph, Scalar>;

// The first one of vertices.
struct First_vertex
{
  Vertex_index vertex = no_index;
  void operator+=(const First_vertex& other) { vertex = (std::min)(vertex, other.vertex); }
};

// The values of all vertices, which are checked, as convert(value) makes them. Only plain numbers are read in parallel:
// copies of others may share parts.
template <class VertexList, class ScalarMap, class Traits, class Convert>
auto read_values(const Threads& threads,
                 const VertexList& vertices,
                 const ScalarMap& scalar_map,
                 const Traits& traits,
                 const Convert& convert)
{
  typedef typename Traits::Scalar Scalar;
  typedef decltype(convert(std::declval<Scalar>())) Value;
  static_assert(!std::is_same_v<Scalar, bool>, "Scalar values of type bool are not supported: use char.");
  constexpr bool is_read_in_parallel = std::is_arithmetic_v<Scalar> && !Is_changed_by_reading<ScalarMap>::value;
  const auto is_ordered_object = traits.is_ordered_object();
  const auto is_ordered = [&](const Scalar& value) {
    if constexpr(is_order_of_numbers<Scalar, std::decay_t<decltype(traits.less_scalar_object())>>)
      return internal::is_ordered(value) && is_ordered_object(value);
    else
      return is_ordered_object(value);
  };
  Indexed_vector<Vertex_index, Value> values;
  values.resize(vertices.size());
  const auto read = [&](std::size_t begin, std::size_t end, First_vertex& unordered) {
    for(const Vertex_index v : Index_range(Vertex_index(begin), Vertex_index(end)))
    {
      if(!vertices.contains(v))
      {
        values[v] = Value();
        continue;
      }
      Scalar value = get(scalar_map, vertices[v]);
      if(!is_ordered(value))
        unordered += First_vertex{v};
      values[v] = convert(std::move(value));
    }
  };
  const Vertex_index unordered =
    (is_read_in_parallel ? threads : Threads()).sum_of_parts<First_vertex>(vertices.size(), read).vertex;
  if(unordered != no_index)
    throw Unordered_scalar_error(vertices.position(unordered));
  return values;
}

// Reads the field of all vertices.
template <class VertexList, class ScalarMap, class Traits>
Keyed_field<typename Traits::Scalar> read_field(const Threads& threads,
                                                const VertexList& vertices,
                                                const ScalarMap& scalar_map,
                                                const Traits& traits)
{
  typedef typename Traits::Scalar Scalar;
  const auto less = traits.less_scalar_object();
  typedef std::decay_t<decltype(less)> Less;
  if constexpr(has_exact_keys<Scalar, Less>)
  {
    const auto key_of = [](Scalar value) { return exact_key<Less>(value); };
    return {read_values(threads, vertices, scalar_map, traits, key_of), is_falling<Scalar, Less>};
  }
  else
  {
    auto values = read_values(threads, vertices, scalar_map, traits, [](Scalar value) { return value; });
    return {vertices, std::move(values), less};
  }
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

// The vertices have been listed before, so that values can be read first.
template <class FaceListGraph, class NamedParameters>
std::pair<Unchecked_complex<Complex_of_t<FaceListGraph>>, Mesh_numbers<FaceListGraph>> number_mesh(
  const FaceListGraph& mesh,
  Vertex_list<FaceListGraph> vertex_list,
  const NamedParameters& np)
{
  const auto face_range = faces(mesh);
  typedef typename boost::graph_traits<FaceListGraph>::face_descriptor face_descriptor;
  const Indexed_vector<Face_index, face_descriptor> face_list(face_range.first, face_range.second);
  auto positions = make_vertex_positions(mesh, vertex_list, np);
  auto [complex, halfedges] =
    read_halfedges(mesh, face_list, vertex_list.size(), positions, make_face_positions(mesh, face_list, np));
  return {Unchecked_complex(std::move(complex)), {std::move(vertex_list), std::move(halfedges), std::move(positions)}};
}

template <class Point, class NamedParameters>
std::pair<Unchecked_complex<Surface_mesh_complex<Point>>, Mesh_numbers<Surface_mesh<Point>>> number_mesh(
  const Surface_mesh<Point>& mesh,
  Vertex_list<Surface_mesh<Point>> vertex_list,
  const NamedParameters& np)
{
  check_index_maps(mesh, np);
  return {Unchecked_complex(Surface_mesh_complex<Point>(mesh)),
          {std::move(vertex_list), {}, [](auto v) { return Vertex_index(v); }}};
}

template <class FaceListGraph, class ScalarMap, class Traits, class NamedParameters>
Unchecked_surface<FaceListGraph, typename Traits::Scalar> flatten_unchecked(const Threads& threads,
                                                                            const FaceListGraph& mesh,
                                                                            const ScalarMap& scalar_map,
                                                                            const Traits& traits,
                                                                            const NamedParameters& np)
{
  Vertex_list<FaceListGraph> vertex_list(mesh);
  auto field = read_field(threads, vertex_list, scalar_map, traits);
  auto [complex, numbers] = number_mesh(mesh, std::move(vertex_list), np);
  return {std::move(complex), std::move(numbers), std::move(field)};
}

// Whether a scalar map is a public Flat_field with values of the wanted type. It is told by what it has, as it stands
// above the stages.
template <class ScalarMap, class Scalar, class = void>
struct Is_flat_field : std::false_type
{
};
template <class ScalarMap, class Scalar>
struct Is_flat_field<ScalarMap, Scalar, std::void_t<typename ScalarMap::Flat_values>>
  : std::is_same<typename ScalarMap::value_type, Scalar>
{
};

// The values of a Flat_field. Throws if they have been read in another order.
template <class FlatField, class FaceListGraph, class Traits>
auto flat_values_of(const FlatField& flat_field, const FaceListGraph& mesh, const Traits& traits)
{
  auto flat_values = flat_field.flat_values(mesh);
  if(!flat_values->field.fits_order(traits.less_scalar_object()))
    throw Graph_mismatch_error("the flat field has been made with another order of its values");
  return flat_values;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_FLATTEN_H
