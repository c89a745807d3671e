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

#include <CGAL/Reeb_graph/internal/base/Threads.h>
#include <CGAL/Reeb_graph/internal/complex/flatten.h>
#include <CGAL/Reeb_graph/internal/engine/find_arcs.h>
#include <CGAL/Reeb_graph/options.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>

namespace CGAL::Reeb_graph::internal {

// The place of each vertex in the exact graph, from the arcs between critical vertices and what they have been reduced
// to: the number of a node, or the number of nodes plus that of an arc.
template <class Complex>
Place_of_vertex find_vertex_places(const Threads& threads,
                                   const Complex& complex,
                                   const Vertex_order& order,
                                   const Swept_vertices& critical_vertices,
                                   const Swept_arcs& critical_arcs,
                                   const Arc_of_vertex& arc_of_vertex,
                                   const Flat_graph& graph,
                                   Ties ties)
{
  checked_index(graph.nodes.size() + graph.arcs.size());
  const auto place_of_arc = [&](Arc_index arc) { return static_cast<Index>(graph.nodes.size()) + arc.number(); };
  const auto place_of_critical = [&](Swept_index critical) {
    const Node_index node = graph.node_of_critical[critical];
    return node != no_index ? node.number() : place_of_arc(graph.arc_of_critical[critical]);
  };
  // The place of a regular vertex on an arc between critical vertices. On a plateau, it is where the end of the arc is.
  const auto place_on_arc = [&](Vertex_index vertex, Swept_arc_index critical_arc) {
    if(ties == Ties::CONTRACT)
      for(const Swept_index end :
          {critical_arcs[critical_arc].lower_vertex(), critical_arcs[critical_arc].upper_vertex()})
        if(order.are_tied(vertex, critical_vertices.vertex(end)))
          return place_of_critical(end);
    return place_of_arc(graph.arc_of_critical_arc[critical_arc]);
  };
  Place_of_vertex places(complex.number_of_vertices(), no_index);
  for(const Swept_index critical : critical_vertices.indices())
    places[critical_vertices.vertex(critical)] = place_of_critical(critical);
  threads.for_each<Vertex_index>(places.size(), [&](Vertex_index vertex) {
    if(places[vertex] == no_index && complex.has_vertex(vertex))
      places[vertex] = place_on_arc(vertex, arc_of_vertex[vertex]);
  });
  return places;
}

// Writes the places to a property map.
template <class VertexList, class PlaceMap>
void write_places(const Place_of_vertex& places, const VertexList& vertices, const PlaceMap& map)
{
  using boost::put; // for a pointer, whatever has been included before
  typedef typename boost::property_traits<PlaceMap>::value_type Place;
  for(const Vertex_index v : places.keys())
  {
    if(places[v] != no_index)
      put(map, vertices[v], static_cast<Place>(places[v]));
  }
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_VERTEX_PLACES_H
