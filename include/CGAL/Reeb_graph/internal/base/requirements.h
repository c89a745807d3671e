// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_REQUIREMENTS_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_REQUIREMENTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/scalars.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>

// Requirements of the public functions on the types of their arguments. Each one is a class whose instantiation is an
// error with a message if it is not met, and whose `value` tells whether it is. Classes combine them such that none is
// looked at behind one that is not met, and functions do nothing then: so the compiler says one message, and no more.
// No list of requirements is one template argument: compilers repeat it in each line.

namespace CGAL::Reeb_graph::internal {

// A type, for a base class, that is named after the requirement has told what does not fit.
template <class Requirement, class Type, bool = Requirement::value>
using Checked_type = Type;

// ---- Expressions that must compile. Boost's traits of what is no graph are an error, so they come last.

template <class Graph>
using Vertices_of = decltype(vertices(std::declval<const Graph&>()));
template <class Graph>
using Faces_of = decltype(faces(std::declval<const Graph&>()));
template <class Graph>
using Halfedge_of_face =
  decltype(next(halfedge(std::declval<typename boost::graph_traits<std::remove_const_t<Graph>>::face_descriptor>(),
                         std::declval<const Graph&>()),
                std::declval<const Graph&>()));
template <class Graph>
using Added_edge = decltype(add_edge(std::declval<Graph&>()));
template <class Map>
using Key_and_value_of =
  std::pair<typename boost::property_traits<Map>::key_type*, typename boost::property_traits<Map>::value_type*>;
template <class Scalar>
using Less_of = decltype(std::declval<const Scalar&>() < std::declval<const Scalar&>());

// ---- Meshes

template <class Mesh>
struct Mesh_is_not_const : std::negation<std::is_const<Mesh>>
{
  static_assert(Mesh_is_not_const::value, "The mesh is const, but this function changes it: pass one that is not.");
};

template <class Mesh>
using Is_face_list_graph = std::conjunction<Has<Vertices_of, Mesh>, Has<Faces_of, Mesh>, Has<Halfedge_of_face, Mesh>>;

template <class Mesh>
struct Mesh_is_face_list_graph : Is_face_list_graph<Mesh>
{
  static_assert(Mesh_is_face_list_graph::value,
                "The mesh is not a FaceListGraph of CGAL. If its type is one, include the header that says so, such as "
                "CGAL/Surface_mesh.h or one of CGAL/boost/graph/graph_traits_*.h.");
};

// The descriptors of a mesh, or others if it is none, so that only the message of a function says so.
template <class Mesh, bool = Is_face_list_graph<Mesh>::value>
struct Descriptors
{
  typedef typename boost::graph_traits<std::remove_const_t<Mesh>>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<std::remove_const_t<Mesh>>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<std::remove_const_t<Mesh>>::face_descriptor face_descriptor;
};

template <class Mesh>
struct Descriptors<Mesh, false>
{
  typedef std::size_t vertex_descriptor, halfedge_descriptor, face_descriptor;
};

// ---- Property maps

template <class Map>
struct Map_is_property_map : Has<Key_and_value_of, Map>
{
  static_assert(
    Map_is_property_map::value,
    "A property map is needed here, and this type is not one. Are the arguments in their order? For values in "
    "the order of the vertices, CGAL::Reeb_graph::make_scalar_map() makes one.");
};

// The value type of a property map, or another one if it is none, so that only the message of a function says so.
template <class Map, bool = Has<Key_and_value_of, Map>::value>
struct Value_of_map
{
  typedef std::remove_cv_t<std::remove_reference_t<typename boost::property_traits<Map>::value_type>> type;
};

template <class Map>
struct Value_of_map<Map, false>
{
  typedef int type;
};

// A map with keys of type void takes any key.
template <class Map, class Descriptor>
struct Has_key
  : std::bool_constant<
      std::is_void_v<typename boost::property_traits<
        Map>::key_type> || std::is_convertible_v<Descriptor, typename boost::property_traits<Map>::key_type>>
{
};

template <class Map, class Mesh>
struct Keys_are_vertices : Has_key<Map, typename boost::graph_traits<Mesh>::vertex_descriptor>
{
  static_assert(
    Keys_are_vertices::value,
    "The keys of this property map are not the vertices of the mesh: its key_type has to be their descriptor.");
};

template <class Map, class Mesh>
struct Keys_are_faces : Has_key<Map, typename boost::graph_traits<Mesh>::face_descriptor>
{
  static_assert(
    Keys_are_faces::value,
    "The keys of this property map are not the faces of the mesh: its key_type has to be their descriptor.");
};

template <class Map>
struct Map_is_writable
  : std::is_convertible<typename boost::property_traits<Map>::category, boost::writable_property_map_tag>
{
  static_assert(Map_is_writable::value, "This property map can only be read, but this function writes to it.");
};

template <class Map, class Mesh>
struct Vertex_map : std::conjunction<Map_is_property_map<Map>, Keys_are_vertices<Map, Mesh>>
{
};

template <class Map, class Mesh>
struct Writable_vertex_map : std::conjunction<Vertex_map<Map, Mesh>, Map_is_writable<Map>>
{
};

template <class Mesh, class Map>
struct Mesh_with_vertex_map : std::conjunction<Mesh_is_face_list_graph<Mesh>, Writable_vertex_map<Map, Mesh>>
{
};

template <class Map, class Mesh>
struct Writable_face_map : std::conjunction<Map_is_property_map<Map>, Keys_are_faces<Map, Mesh>, Map_is_writable<Map>>
{
};

template <class Mesh, class Map>
struct Mesh_with_face_map : std::conjunction<Mesh_is_face_list_graph<Mesh>, Writable_face_map<Map, Mesh>>
{
};

// ---- Scalar values

template <class Traits, class Less>
struct Is_order : std::is_invocable_r<bool, const Less&, const typename Traits::Scalar&, const typename Traits::Scalar&>
{
};
template <class Traits>
struct Is_order<Traits, std::less<typename Traits::Scalar>> : Has<Less_of, typename Traits::Scalar>
{
};

template <class Traits>
struct Scalars_are_ordered
  : Is_order<Traits, std::decay_t<decltype(std::declval<const Traits&>().less_scalar_object())>>
{
  static_assert(Scalars_are_ordered::value,
                "The scalar values have no order: give their type an operator<, or pass as named parameter geom_traits "
                "a traits class with a Less_scalar that compares them.");
};

template <class Traits>
struct Scalars_are_numbers : std::bool_constant<Scalar_conversion<Traits>::has_numbers>
{
  static_assert(
    Scalars_are_numbers::value,
    "The scalar values are not numbers, which this function needs. Pass as named parameter geom_traits, if it "
    "takes that, a traits class with a member scalar_to_double_object() that makes numbers of them.");
};

template <class Mesh, class ScalarMap>
struct Mesh_with_scalars : std::conjunction<Mesh_is_face_list_graph<Mesh>, Vertex_map<ScalarMap, Mesh>>
{
};

template <class Mesh, class ScalarMap, class Traits>
struct Scalar_field : std::conjunction<Mesh_with_scalars<Mesh, ScalarMap>, Scalars_are_ordered<Traits>>
{
};

template <class Mesh, class ScalarMap, class Traits>
struct Mesh_with_numbers : std::conjunction<Mesh_with_scalars<Mesh, ScalarMap>, Scalars_are_numbers<Traits>>
{
};

template <class Mesh, class ScalarMap, class Traits>
struct Field_of_numbers : std::conjunction<Scalar_field<Mesh, ScalarMap, Traits>, Scalars_are_numbers<Traits>>
{
};

template <class Mesh, class ScalarMap, class Traits, class VertexMap>
struct Field_of_numbers_and_map
  : std::conjunction<Field_of_numbers<Mesh, ScalarMap, Traits>, Writable_vertex_map<VertexMap, Mesh>>
{
};

template <class Mesh>
struct Mesh_can_be_refined : Has<Added_edge, Mesh>
{
  static_assert(Mesh_can_be_refined::value, "The mesh is not a MutableFaceGraph of CGAL: no edge can be added to it.");
};

template <class Mesh>
struct Refinable_mesh
  : std::conjunction<Mesh_is_not_const<Mesh>, Mesh_is_face_list_graph<Mesh>, Mesh_can_be_refined<Mesh>>
{
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_REQUIREMENTS_H
