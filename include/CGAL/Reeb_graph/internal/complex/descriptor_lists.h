// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_DESCRIPTOR_LISTS_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_DESCRIPTOR_LISTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The descriptors of a mesh, numbered in the order in which they are added: a property map whose copies share the
// numbers. Several threads may read it, also with descriptors of other meshes, which a dynamic property map of CGAL
// inserts when it is read.
template <class Descriptor, class Number>
class Descriptor_numbers
{
public:
  typedef Descriptor key_type;
  typedef Number value_type;
  typedef Number reference;
  typedef boost::readable_property_map_tag category;

  explicit Descriptor_numbers(std::size_t size) : numbers_(std::make_shared<std::unordered_map<Descriptor, Number>>())
  {
    numbers_->reserve(size);
  }

  void add(const Descriptor& d) { numbers_->emplace(d, static_cast<Number>(numbers_->size())); }

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
  Descriptor_numbers<Descriptor, Number> numbers(descriptors.size());
  for(const Position position : Index_range<Position>(descriptors.size()))
    numbers.add(descriptors[position]);
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

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_DESCRIPTOR_LISTS_H
