// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_LOCATE_VERTICES_H
#define CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_LOCATE_VERTICES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/engine/Between_stages.h>
#include <CGAL/Reeb_graph/internal/engine/Locate_on_arcs.h>
#include <CGAL/Reeb_graph/internal/engine/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/find_arcs.h>
#include <CGAL/Reeb_graph/internal/engine/reduce_arcs.h>
#include <CGAL/Reeb_graph/internal/way_back/find_vertex_places.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The places in a simplified graph of the nodes, and behind them the arcs, of the exact graph, by the named parameter
// `simplification`. There are none if that is not given, as each has the same place then.
typedef std::optional<std::vector<Index>> Simplified_places;

template <class NamedParameters>
Simplified_places read_simplified_places(const NamedParameters& np)
{
  Simplified_places places;
  const auto simplification = parameters::get_parameter(np, internal::simplification);
  if constexpr(is_given<decltype(simplification)>)
  {
    places.emplace();
    for(std::size_t node = 0; node != simplification.number_of_old_nodes(); ++node)
      places->push_back(static_cast<Index>(simplification.index_of_node(node)));
    for(std::size_t arc = 0; arc != simplification.number_of_old_arcs(); ++arc)
      places->push_back(static_cast<Index>(simplification.index_of_arc(arc)));
  }
  return places;
}

// The checks below throw Graph_mismatch_error for a graph that is not of this mesh and field.

// Checks that the nodes are vertices of the mesh with their values, in ascending order.
template <class GraphOnMesh>
void check_nodes(const GraphOnMesh& on_mesh)
{
  const auto& graph = on_mesh.graph();
  if(num_vertices(graph) == 0 && on_mesh.has_vertices())
    throw Graph_mismatch_error();
  Vertex_index lower_vertex = no_index;
  for(const auto node : CGAL::make_range(vertices(graph)))
  {
    const Vertex_index v = on_mesh.node_vertex(node);
    if(!on_mesh.is_vertex(v, graph[node].vertex) || on_mesh.order().is_lower(v, graph[node].value)
       || on_mesh.order().is_higher(v, graph[node].value)
       || (lower_vertex != no_index && !on_mesh.order()(lower_vertex, v)))
      throw Graph_mismatch_error();
    lower_vertex = v;
  }
}

// Checks that each arc ascends, and that its chain begins at its lower node. With other ties than those of the graph,
// the levels next to a node could miss its arcs.
template <class GraphOnMesh>
void check_arcs(const GraphOnMesh& on_mesh, Ties ties)
{
  const auto& order = on_mesh.order();
  for(const auto arc : on_mesh.arcs())
  {
    const Vertex_index lower = on_mesh.lower_vertex(arc), upper = on_mesh.upper_vertex(arc);
    if(!order(lower, upper) || on_mesh.chain(arc).empty())
      throw Graph_mismatch_error();
    const Vertex_index first = on_mesh.checked_source(on_mesh.chain(arc).front());
    const bool fits =
      ties == Ties::CONTRACT ? order.are_tied(lower, first) && !order.are_tied(lower, upper) : lower == first;
    if(!fits)
      throw Graph_mismatch_error();
  }
}

// Whether the graph is the exact one, which `flat_graph` is.
template <class GraphOnMesh>
bool is_same_graph(const GraphOnMesh& on_mesh, const Flat_graph& flat_graph)
{
  const auto& graph = on_mesh.graph();
  bool is_same = flat_graph.nodes.size() == num_vertices(graph) && flat_graph.arcs.size() == num_edges(graph);
  for(std::size_t node = 0; is_same && node != flat_graph.nodes.size(); ++node)
    is_same = flat_graph.nodes[Node_index(node)].vertex == on_mesh.node_vertex(node);
  auto flat_arc = flat_graph.arcs.begin();
  for(auto arc = edges(graph).first; is_same && flat_arc != flat_graph.arcs.end(); ++arc, ++flat_arc)
    is_same = source(*arc, graph) == flat_arc->lower.number() && target(*arc, graph) == flat_arc->upper.number();
  return is_same;
}

// Whether the exact graph, which `flat_graph` is, has been simplified to this one: whether each node here is one of
// those that have come to its place.
template <class GraphOnMesh>
bool is_simplified_graph(const GraphOnMesh& on_mesh,
                         const Flat_graph& flat_graph,
                         const std::vector<Index>& simplified_places)
{
  if(simplified_places.size() != flat_graph.nodes.size() + flat_graph.arcs.size())
    return false;
  const std::size_t number_of_nodes = num_vertices(on_mesh.graph());
  std::size_t number_of_found = 0;
  for(Index old_place = 0; old_place != simplified_places.size(); ++old_place)
  {
    const Index place = simplified_places[old_place];
    if(place >= number_of_nodes + num_edges(on_mesh.graph()))
      return false;
    const bool is_node = old_place < flat_graph.nodes.size() && place < number_of_nodes;
    if(is_node && on_mesh.node_vertex(place) == flat_graph.nodes[Node_index(old_place)].vertex)
      ++number_of_found;
  }
  return number_of_found == number_of_nodes;
}

// Checks that the graph is the exact one, or what that has been simplified to.
template <class GraphOnMesh>
void check_same_graph(const GraphOnMesh& on_mesh,
                      const Flat_graph& flat_graph,
                      const Simplified_places& simplified_places)
{
  const bool is_right = simplified_places ? is_simplified_graph(on_mesh, flat_graph, *simplified_places)
                                          : is_same_graph(on_mesh, flat_graph);
  if(!is_right)
    throw Graph_mismatch_error();
}

// The number of a vertex that may be one of another mesh.
template <class GraphOnComplex>
Vertex_index checked_number(const GraphOnComplex& on_complex, typename GraphOnComplex::vertex_descriptor v)
{
  const Vertex_index number = on_complex.number(v);
  if(!on_complex.is_vertex(number, v))
    throw Unknown_vertex_error();
  return number;
}

template <class ReebGraph>
void check_is_node(const ReebGraph& graph, typename boost::graph_traits<ReebGraph>::vertex_descriptor node)
{
  if(node >= num_vertices(graph))
    throw Graph_mismatch_error("the node is not one of the graph");
}

template <class ReebGraph>
void check_is_arc(const ReebGraph& graph, typename boost::graph_traits<ReebGraph>::edge_descriptor arc)
{
  const auto lower = source(arc, graph), upper = target(arc, graph);
  if(lower >= num_vertices(graph) || upper >= num_vertices(graph))
    throw Graph_mismatch_error("the arc is not one of the graph");
  const auto is_in = [&](const auto& range) { return std::find(range.first, range.second, arc) != range.second; };
  // Nodes of high degree mostly have neighbors of low degree.
  const bool is_known =
    out_degree(lower, graph) < in_degree(upper, graph) ? is_in(out_edges(lower, graph)) : is_in(in_edges(upper, graph));
  if(!is_known)
    throw Graph_mismatch_error("the arc is not one of the graph");
}

// The places of all vertices in the exact graph, which is computed once more. Nothing but the surface and the order of
// its vertices is asked. check_graph(graph) may throw.
template <class ConcurrencyTag, class Complex, class Order>
Place_of_vertex find_places(const Complex& complex,
                            const Order& order,
                            Ties ties,
                            bool are_degree_two_nodes_kept,
                            const std::function<void(const Flat_graph&)>& check_graph,
                            const Progress& progress)
{
  progress.report(0);
  const Swept_vertices critical_vertices = classify_vertices<ConcurrencyTag>(complex, order);
  Arc_of_vertex arc_of_vertex;
  const Swept_arcs arcs = find_arcs_and_locate_vertices<ConcurrencyTag>(
    complex, order, critical_vertices, arc_of_vertex, Stage_progress(progress, 0.3, 0.85));
  progress.report(0.9);
  const Flat_graph graph =
    reduce_arcs<ConcurrencyTag>(complex, order, critical_vertices, arcs, ties, are_degree_two_nodes_kept, true);
  progress.report(0.95);
  check_graph(graph);
  return find_vertex_places<ConcurrencyTag>(complex, order, critical_vertices, arcs, arc_of_vertex, graph, ties);
}

// The places of all vertices in the exact graph as a map has them, which compute_reeb_graph() has been given.
template <class GraphOnMesh, class PlaceMap>
Place_of_vertex read_places(const GraphOnMesh& on_mesh, const PlaceMap& map, std::size_t number_of_places)
{
  using boost::get; // for a pointer, whatever has been included before
  Place_of_vertex places(on_mesh.complex().number_of_vertices(), no_index);
  for(const Vertex_index v : places.keys())
  {
    if(!on_mesh.complex().has_vertex(v))
      continue;
    const auto place = static_cast<std::size_t>(get(map, on_mesh.vertex(v))); // A negative one is too large then.
    if(place >= number_of_places)
      throw Graph_mismatch_error();
    places[v] = static_cast<Index>(place);
  }
  return places;
}

// The places of all vertices in the graph, which has to be the exact one, or one that this has been simplified to.
template <class ConcurrencyTag, class VertexPlaces, class GraphOnMesh, class NamedParameters>
VertexPlaces locate_vertices(const GraphOnMesh& on_mesh,
                             Ties ties,
                             bool are_degree_two_nodes_kept,
                             const Simplified_places& simplified_places,
                             const NamedParameters& np)
{
  typedef typename GraphOnMesh::vertex_descriptor vertex_descriptor;
  const Progress progress(np);
  const auto& graph = on_mesh.graph();
  const std::size_t number_of_places = num_vertices(graph) + num_edges(graph);
  const auto given_map = parameters::get_parameter(np, vertex_place_map);
  auto place_of_vertex = std::make_shared<Place_of_vertex>();
  if constexpr(is_given<decltype(given_map)>)
    *place_of_vertex =
      read_places(on_mesh, given_map, simplified_places ? simplified_places->size() : number_of_places);
  else
  {
    const auto check_graph = [&](const Flat_graph& flat_graph) {
      check_same_graph(on_mesh, flat_graph, simplified_places);
    };
    *place_of_vertex = find_places<ConcurrencyTag>(on_mesh.complex(), on_mesh.order(), ties, are_degree_two_nodes_kept,
                                                   check_graph, progress);
  }
  if(simplified_places)
  {
    for(Index& place : *place_of_vertex)
      place = place == no_index ? place : (*simplified_places)[place];
  }
  const auto arcs = edges(graph);
  progress.report_end();
  return VertexPlaces(
    on_mesh.vertex_numbers(), num_vertices(graph), {arcs.first, arcs.second}, place_of_vertex,
    std::make_shared<Vertex_lists<vertex_descriptor>>(on_mesh.list_vertices(place_of_vertex, number_of_places)));
}

#define CGAL_REEB_GRAPH_FIND_PLACES(PREFIX, TAG, COMPLEX, SCALAR)                                                      \
  PREFIX template Place_of_vertex find_places<TAG>(const COMPLEX&, const Natural_order<SCALAR>&, Ties, bool,           \
                                                   const std::function<void(const Flat_graph&)>&, const Progress&);
CGAL_REEB_GRAPH_FOR_COMPLEXES_OF_DOUBLES(CGAL_REEB_GRAPH_FIND_PLACES)

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_LOCATE_VERTICES_H
