// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_VERTEX_PLACES_H
#define CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_VERTEX_PLACES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/engine/Between_stages.h>
#include <CGAL/Reeb_graph/internal/engine/Locate_on_arcs.h>
#include <CGAL/Reeb_graph/internal/engine/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/find_arcs.h>
#include <CGAL/Reeb_graph/internal/engine/write_graph.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

struct Place_tag;
typedef Index_of<Place_tag> Place_index;

// The vertices of each place in ascending order. They are sorted when they are asked for, which takes longer than to
// find the places.
template <class VertexDescriptor>
class Vertex_lists
{
public:
  typedef Buckets<Place_index, VertexDescriptor> Lists;

  explicit Vertex_lists(std::function<Lists()> make) : make_(std::move(make)) {}

  Iterator_range<const VertexDescriptor*> operator()(std::size_t place) const
  {
    const Lists& lists = lists_([this] {
      Lists result = make_();
      make_ = nullptr; // It holds what the lists are made of.
      return result;
    });
    const auto vertices = lists[Place_index(place)];
    return {vertices.begin(), vertices.end()};
  }

private:
  mutable std::function<Lists()> make_;
  Made_on_demand<Lists> lists_;
};

// Makes what Vertex_lists needs.
template <class VertexList, class Order>
auto sort_vertices_by_place(const VertexList& vertex_list,
                            const Order& order,
                            const Place_of_vertex& places,
                            std::size_t number_of_places)
{
  typedef typename Order::template Key<Vertex_index> Key;
  Buckets<Place_index, Key> keys(number_of_places, [&](const auto& visit) {
    for(const Vertex_index v : places.keys())
      if(places[v] != no_index)
        visit(Place_index(places[v]), order.key(v, v));
  });
  const Index_range<Place_index> all_places(number_of_places);
  for(const Place_index place : all_places)
    internal::sort<Sequential_tag>(keys[place].begin(), keys[place].end(), order);
  typedef typename VertexList::vertex_descriptor vertex_descriptor;
  return Buckets<Place_index, vertex_descriptor>(number_of_places, [&](const auto& visit) {
    for(const Place_index place : all_places)
      for(const Key& key : keys[place])
        visit(place, vertex_list[key.name]);
  });
}

// The place of each vertex in the exact graph, from the arcs between critical vertices and what they have been reduced
// to: the number of a node, or the number of nodes plus that of an arc.
template <class ConcurrencyTag, class Complex, class Order>
Place_of_vertex find_vertex_places(const Complex& complex,
                                   const Order& order,
                                   const Swept_vertices& critical_vertices,
                                   const Swept_arcs& critical_arcs,
                                   const Arc_of_vertex& arc_of_vertex,
                                   const Flat_graph& graph,
                                   Ties ties)
{
  checked_index(graph.nodes.size() + graph.arcs.size());
  const auto place_of_arc = [&](Arc_index arc, Vertex_index vertex) {
    if(arc == no_index)
      complex.throw_contradiction_near(vertex);
    return static_cast<Index>(graph.nodes.size()) + arc.number();
  };
  const auto place_of_critical = [&](Swept_index critical) {
    const Node_index node = graph.node_of_critical[critical];
    return node != no_index ? node.number()
                            : place_of_arc(graph.arc_of_critical[critical], critical_vertices.vertex(critical));
  };
  // The place of a regular vertex on an arc between critical vertices. On a plateau, it is where the end of the arc is.
  const auto place_on_arc = [&](Vertex_index vertex, Swept_arc_index critical_arc) {
    if(critical_arc == no_index)
      complex.throw_contradiction_near(vertex);
    if(ties == Ties::CONTRACT)
      for(const Swept_index end :
          {critical_arcs[critical_arc].lower_vertex(), critical_arcs[critical_arc].upper_vertex()})
        if(order.are_tied(vertex, critical_vertices.vertex(end)))
          return place_of_critical(end);
    return place_of_arc(graph.arc_of_critical_arc[critical_arc], vertex);
  };
  Place_of_vertex places(complex.number_of_vertices(), no_index);
  for(const Swept_index critical : critical_vertices.indices())
    places[critical_vertices.vertex(critical)] = place_of_critical(critical);
  for_each_block<ConcurrencyTag>(places.size(), [&](std::size_t begin, std::size_t end) {
    for(const Vertex_index vertex : Index_range(Vertex_index(begin), Vertex_index(end)))
    {
      if(places[vertex] == no_index && complex.has_vertex(vertex))
        places[vertex] = place_on_arc(vertex, arc_of_vertex[vertex]);
    }
  });
  return places;
}

// Finds nothing besides the graph, where no places of vertices are wanted.
struct No_vertex_places
{
  static constexpr bool are_wanted = false;

  template <class ConcurrencyTag, class... Arguments>
  void find(const Arguments&...) const
  {}

  template <class VertexList>
  void write(const VertexList&) const
  {}
};

// The places of all vertices, for a property map: their arcs are found with those of the graph.
template <class PlaceMap>
class Vertex_places_for_map
{
public:
  static constexpr bool are_wanted = true;

  explicit Vertex_places_for_map(const PlaceMap& map) : map_(map) {}

  template <class ConcurrencyTag, class Complex, class Order>
  Swept_arcs find_arcs(const Complex& complex,
                       const Order& order,
                       const Swept_vertices& critical_vertices,
                       const Stage_progress& progress)
  {
    return find_arcs_and_locate_vertices<ConcurrencyTag>(complex, order, critical_vertices, arc_of_vertex_, progress);
  }

  template <class ConcurrencyTag, class Complex, class Order>
  void find(const Complex& complex,
            const Order& order,
            const Swept_vertices& critical_vertices,
            const Swept_arcs& critical_arcs,
            const Flat_graph& graph,
            Ties ties)
  {
    places_ =
      find_vertex_places<ConcurrencyTag>(complex, order, critical_vertices, critical_arcs, arc_of_vertex_, graph, ties);
    arc_of_vertex_ = Arc_of_vertex();
  }

  template <class VertexList>
  void write(const VertexList& vertices) const
  {
    using boost::put; // for a pointer, whatever has been included before
    typedef typename boost::property_traits<PlaceMap>::value_type Place;
    for(const Vertex_index v : places_.keys())
    {
      if(places_[v] != no_index)
        put(map_, vertices[v], static_cast<Place>(places_[v]));
    }
  }

private:
  const PlaceMap map_;
  Arc_of_vertex arc_of_vertex_;
  Place_of_vertex places_;
};

template <class NamedParameters>
auto choose_places(const NamedParameters& np)
{
  const auto map = parameters::get_parameter(np, vertex_place_map);
  if constexpr(is_given<decltype(map)>)
    return Vertex_places_for_map(map);
  else
    return No_vertex_places();
}

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
      read_places(on_mesh.flat_mesh(), given_map, simplified_places ? simplified_places->size() : number_of_places);
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

#endif // CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_VERTEX_PLACES_H
