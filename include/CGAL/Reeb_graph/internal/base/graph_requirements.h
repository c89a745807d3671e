// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_GRAPH_REQUIREMENTS_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_GRAPH_REQUIREMENTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/pending/property.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

// Requirements of the public functions on the type of a Reeb graph; see requirements.h.

namespace CGAL::Reeb_graph::internal {

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
struct Plain_reeb_graph : std::conjunction<Graph_is_boost_graph<Graph>,
                                           Graph_is_bidirectional<Graph>,
                                           Graph_has_parallel_arcs<Graph>,
                                           Nodes_are_numbers<Graph>>
{
};

template <class Graph>
struct Augmented_reeb_graph : std::conjunction<Plain_reeb_graph<Graph>, Graph_has_nodes_and_arcs<Graph>>
{
};

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

// The traits class for functions that see no more of a field than the values of the nodes: the named parameter
// geom_traits, or else one that knows their type; another type if there are none, so that only the message says so.
template <class Graph, class = void>
struct Default_traits_of_nodes
{
  typedef int Scalar;
};
template <class Graph>
struct Default_traits_of_nodes<Graph,
                               std::enable_if_t<std::conjunction_v<Has<Vertices_of, Graph>, Has<Value_of_node, Graph>>>>
{
  typedef Value_of_node<Graph> Scalar;
};

template <class Graph, class NamedParameters>
using Traits_of_nodes = Chosen_traits<Default_traits_of_nodes<Graph>, NamedParameters>;

template <class Graph, class NamedParameters>
auto choose_conversion_of_nodes(const NamedParameters& np)
{
  return Scalar_conversion<Traits_of_nodes<Graph, NamedParameters>>(choose_traits<Default_traits_of_nodes<Graph>>(np));
}

template <class Graph>
struct Nodes_have_values : Has<Value_of_node, Graph>
{
  static_assert(Nodes_have_values::value,
                "The nodes of the graph have no scalar values: their property needs a member `value`.");
};

template <class Graph, class NamedParameters>
struct Nodes_have_numbers
  : std::conjunction<Nodes_have_values<Graph>, Scalars_are_numbers<Traits_of_nodes<Graph, NamedParameters>>>
{
};

// Graphs whose values are numbers, if need be by the named parameter geom_traits.
template <class Graph, class NamedParameters>
struct Plain_graph_of_numbers : std::conjunction<Plain_reeb_graph<Graph>, Nodes_have_numbers<Graph, NamedParameters>>
{
};

template <class Graph, class NamedParameters>
struct Graph_of_numbers : std::conjunction<Augmented_reeb_graph<Graph>, Nodes_have_numbers<Graph, NamedParameters>>
{
};

template <class Graph, class Mesh, class Scalar>
struct Graph_of_field : std::conjunction<Augmented_reeb_graph<Graph>,
                                         Graph_is_of_this_mesh<Graph, Mesh>,
                                         Graph_is_of_these_scalars<Graph, Scalar>>
{
};

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
struct Field_and_graph
  : std::conjunction<Scalar_field<Mesh, ScalarMap, Traits>, Graph_of_field<Graph, Mesh, typename Traits::Scalar>>
{
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_GRAPH_REQUIREMENTS_H
