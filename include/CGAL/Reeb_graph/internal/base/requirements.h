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
#include <boost/graph/properties.hpp>
#include <boost/pending/property.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>

// Requirements of the public functions on the types of their arguments. Each one is a class whose instantiation is an
// error with a message if it is not met, and whose `value` tells whether it is. Conjunctions combine them such that none
// is looked at behind one that is not met.

namespace CGAL::Reeb_graph::internal {

// Says the message of the first requirement that is not met, in a static_assert at the head of a function. It is true in
// any case, so that no other message follows: compilers look at no more functions that are called behind an error.
template <class... Requirements>
inline constexpr bool are_met = (std::conjunction<Requirements...>::value, true);

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
using Vertex_map = std::conjunction<Map_is_property_map<Map>, Keys_are_vertices<Map, Mesh>>;

template <class Map, class Mesh>
using Writable_vertex_map = std::conjunction<Vertex_map<Map, Mesh>, Map_is_writable<Map>>;

template <class Mesh, class Map>
using Mesh_with_vertex_map = std::conjunction<Mesh_is_face_list_graph<Mesh>, Writable_vertex_map<Map, Mesh>>;

template <class Map, class Mesh>
using Writable_face_map = std::conjunction<Map_is_property_map<Map>, Keys_are_faces<Map, Mesh>, Map_is_writable<Map>>;

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

template <class Mesh, class ScalarMap>
using Mesh_with_scalars = std::conjunction<Mesh_is_face_list_graph<Mesh>, Vertex_map<ScalarMap, Mesh>>;

template <class Mesh, class ScalarMap, class Traits>
using Scalar_field = std::conjunction<Mesh_with_scalars<Mesh, ScalarMap>, Scalars_are_ordered<Traits>>;

template <class Mesh>
struct Mesh_can_be_refined : Has<Added_edge, Mesh>
{
  static_assert(Mesh_can_be_refined::value, "The mesh is not a MutableFaceGraph of CGAL: no edge can be added to it.");
};

template <class Mesh>
using Refinable_mesh =
  std::conjunction<Mesh_is_not_const<Mesh>, Mesh_is_face_list_graph<Mesh>, Mesh_can_be_refined<Mesh>>;

// ---- Reeb graphs

template <class Graph>
using Edges_of = decltype(edges(std::declval<const Graph&>()));
template <class Graph>
using Node_of = std::decay_t<
  decltype(std::declval<const Graph&>()[std::declval<typename boost::graph_traits<Graph>::vertex_descriptor>()])>;
template <class Graph>
using Arc_of = std::decay_t<
  decltype(std::declval<const Graph&>()[std::declval<typename boost::graph_traits<Graph>::edge_descriptor>()])>;
template <class Graph>
using Members_of_node = decltype(std::declval<const Node_of<Graph>&>().vertex,
                                 std::declval<const Node_of<Graph>&>().value,
                                 std::declval<const Node_of<Graph>&>().kind);
template <class Graph>
using Chain_of_arc = decltype(std::declval<const Arc_of<Graph>&>().chain);
template <class Graph>
using Vertex_of_node = std::decay_t<decltype(std::declval<const Node_of<Graph>&>().vertex)>;
template <class Graph>
using Value_of_node = std::decay_t<decltype(std::declval<const Node_of<Graph>&>().value)>;

template <class Graph>
struct Graph_is_not_const : std::negation<std::is_const<Graph>>
{
  static_assert(Graph_is_not_const::value,
                "The graph is const, but the result is written to it: pass one that is not.");
};

template <class Graph>
struct Graph_is_boost_graph : std::conjunction<Has<Vertices_of, Graph>, Has<Edges_of, Graph>>
{
  static_assert(Graph_is_boost_graph::value,
                "The graph is not a graph of Boost: use CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph.");
};

template <class Graph>
struct Graph_is_bidirectional
  : std::is_convertible<typename boost::graph_traits<Graph>::directed_category, boost::bidirectional_tag>
{
  static_assert(Graph_is_bidirectional::value,
                "The arcs of a Reeb graph are directed upwards: the graph has to be boost::bidirectionalS.");
};

template <class Graph>
struct Graph_has_parallel_arcs
  : std::is_convertible<typename boost::graph_traits<Graph>::edge_parallel_category, boost::allow_parallel_edge_tag>
{
  static_assert(
    Graph_has_parallel_arcs::value,
    "A Reeb graph has parallel arcs, which this graph would lose: store edges in boost::vecS, not in setS.");
};

template <class Graph>
struct Nodes_are_numbers : std::is_integral<typename boost::graph_traits<Graph>::vertex_descriptor>
{
  static_assert(Nodes_are_numbers::value,
                "The nodes of a Reeb graph are numbered: the graph has to store its vertices in boost::vecS.");
};

template <class Graph>
struct Graph_has_nodes_and_arcs : std::conjunction<Has<Members_of_node, Graph>, Has<Chain_of_arc, Graph>>
{
  static_assert(
    Graph_has_nodes_and_arcs::value,
    "The graph has no places for what a Reeb graph stores: its properties have to be the types Node and Arc "
    "of CGAL::Reeb_graph_traits<Mesh, Scalar_map>.");
};

template <class Graph>
using Plain_reeb_graph = std::conjunction<Graph_is_boost_graph<Graph>,
                                          Graph_is_bidirectional<Graph>,
                                          Graph_has_parallel_arcs<Graph>,
                                          Nodes_are_numbers<Graph>>;

template <class Graph>
using Augmented_reeb_graph = std::conjunction<Plain_reeb_graph<Graph>, Graph_has_nodes_and_arcs<Graph>>;

template <class Graph, class Mesh>
struct Graph_is_of_this_mesh
  : std::is_assignable<Vertex_of_node<Graph>&, typename boost::graph_traits<Mesh>::vertex_descriptor>
{
  static_assert(Graph_is_of_this_mesh::value,
                "The graph is one for meshes of another type: use CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph.");
};

template <class Graph, class Scalar>
struct Graph_is_of_these_scalars : std::is_assignable<Value_of_node<Graph>&, const Scalar&>
{
  static_assert(
    Graph_is_of_these_scalars::value,
    "The graph is one for scalar values of another type: use CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph.");
};

template <class Graph, class Mesh, class Scalar>
using Graph_of_field = std::conjunction<Augmented_reeb_graph<Graph>,
                                        Graph_is_of_this_mesh<Graph, Mesh>,
                                        Graph_is_of_these_scalars<Graph, Scalar>>;

// ---- The numbers of arcs

// Whether the arcs of a graph have the property boost::edge_index.
template <class Graph, class = void>
struct Has_arc_index : std::false_type
{
};
template <class Graph>
struct Has_arc_index<Graph, std::void_t<typename Graph::edge_property_type>>
  : std::bool_constant<boost::lookup_one_property<typename Graph::edge_property_type, boost::edge_index_t>::found>
{
};

// Numbers an arc if its graph has a place for the number.
template <class Graph>
void set_arc_index(Graph& graph, const typename Graph::edge_descriptor& arc, std::size_t number)
{
  if constexpr(Has_arc_index<Graph>::value)
    put(boost::edge_index, graph, arc, number);
}

// ---- Requirements together

// A field, and the graph that it has.
template <class Mesh, class ScalarMap, class Graph, class Traits>
using Field_and_graph =
  std::conjunction<Scalar_field<Mesh, ScalarMap, Traits>, Graph_of_field<Graph, Mesh, typename Traits::Scalar>>;

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_REQUIREMENTS_H
