// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_LOCATE_VERTICES_H
#define CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_LOCATE_VERTICES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Vertex_locations.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/internal/engine/Flat_graph.h>
#include <CGAL/Reeb_graph/internal/engine/Slab.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/Vertex_queries.h>
#include <CGAL/Reeb_graph/internal/engine/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/find_arcs.h>
#include <CGAL/Reeb_graph/internal/engine/reduce_arcs.h>
#include <CGAL/Reeb_graph/internal/way_back/Vertex_places.h>
#include <CGAL/Reeb_graph/internal/way_back/check_graph.h>
#include <CGAL/Reeb_graph/options.h>

#include <cstddef>
#include <functional>
#include <memory>

namespace CGAL::Reeb_graph::internal {

// The places of all vertices in the exact graph, which is computed once more. Nothing but the surface and the order of
// its vertices is asked. check_graph(graph) may throw.
template <class ConcurrencyTag, class Complex, class Order>
Vertex_places find_places(const Complex& complex,
                          const Order& order,
                          Ties ties,
                          bool are_degree_two_nodes_kept,
                          const std::function<void(const Flat_graph&)>& check_graph,
                          const Progress& progress)
{
  progress.report(0);
  const Swept_vertices critical_vertices = classify_vertices<ConcurrencyTag>(complex, order);
  Arc_of_vertex arc_of_vertex;
  const Slab_arcs arcs = find_arcs_of_vertices<ConcurrencyTag>(complex, order, critical_vertices, arc_of_vertex,
                                                               Stage_progress(progress, 0.3, 0.85));
  progress.report(0.9);
  const Flat_graph graph =
    reduce_arcs<ConcurrencyTag>(complex, order, critical_vertices, arcs, ties, are_degree_two_nodes_kept, true);
  progress.report(0.95);
  check_graph(graph);
  return Vertex_place_finder(complex, order, critical_vertices, arcs, arc_of_vertex, graph, ties)
    .template find<ConcurrencyTag>();
}

// The places of all vertices in the exact graph as a map has them, which compute_reeb_graph() has been given.
template <class GraphOnMesh, class PlaceMap>
Vertex_places read_places(const GraphOnMesh& on_mesh, const PlaceMap& map, std::size_t number_of_places)
{
  using boost::get; // for a pointer, whatever has been included before
  Vertex_places places(on_mesh.complex().number_of_vertices(), no_index);
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
template <class ConcurrencyTag, class GraphOnMesh, class NamedParameters>
auto locate_vertices(const GraphOnMesh& on_mesh,
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
  auto place_of_vertex = std::make_shared<Vertex_places>();
  if constexpr(is_given<decltype(given_map)>)
    *place_of_vertex =
      read_places(on_mesh, given_map, simplified_places.is_simplified() ? simplified_places.size() : number_of_places);
  else
  {
    const auto check_graph = [&](const Flat_graph& flat_graph) {
      check_same_graph(on_mesh, flat_graph, simplified_places);
    };
    *place_of_vertex = find_places<ConcurrencyTag>(on_mesh.complex(), on_mesh.order(), ties, are_degree_two_nodes_kept,
                                                   check_graph, progress);
  }
  if(simplified_places.is_simplified())
  {
    for(Index& place : *place_of_vertex)
      place = place == no_index ? place : simplified_places(place);
  }
  const auto arcs = edges(graph);
  progress.report_end();
  return Reeb_graph::Vertex_locations<vertex_descriptor, typename GraphOnMesh::Graph>(
    on_mesh.vertex_numbers(), num_vertices(graph), {arcs.first, arcs.second}, place_of_vertex,
    std::make_shared<Vertex_lists<vertex_descriptor>>(on_mesh.list_vertices(place_of_vertex, number_of_places)));
}

#define CGAL_REEB_GRAPH_FIND_PLACES(PREFIX, TAG, COMPLEX, SCALAR)                                                      \
  PREFIX template Vertex_places find_places<TAG>(const COMPLEX&, const Natural_order<SCALAR>&, Ties, bool,             \
                                                 const std::function<void(const Flat_graph&)>&, const Progress&);
CGAL_REEB_GRAPH_FOR_COMPLEXES_OF_DOUBLES(CGAL_REEB_GRAPH_FIND_PLACES)

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_LOCATE_VERTICES_H
