// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_LOCATE_VERTICES_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_LOCATE_VERTICES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Vertex_locations.h>
#include <CGAL/Reeb_graph/internal/augmentation/New_places.h>
#include <CGAL/Reeb_graph/internal/augmentation/Vertex_lists.h>
#include <CGAL/Reeb_graph/internal/augmentation/Vertex_places.h>
#include <CGAL/Reeb_graph/internal/augmentation/check_graph.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/options.h>

#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The places of all vertices in the graph, which has to be the exact one, or one that this has been simplified to.
template <class ConcurrencyTag, class GraphOnMesh>
auto locate_vertices(const GraphOnMesh& on_mesh,
                     Ties ties,
                     bool are_degree_two_nodes_kept,
                     const New_places& new_places,
                     const Progress& progress)
{
  typedef typename GraphOnMesh::vertex_descriptor vertex_descriptor;
  typedef Vertex_places<typename GraphOnMesh::Complex, typename GraphOnMesh::Order> Places;
  auto places = Places::template make<ConcurrencyTag>(on_mesh.complex(), on_mesh.order(), ties,
                                                      are_degree_two_nodes_kept, progress);
  check_same_graph(on_mesh, places.graph(), new_places);
  const auto place_of_vertex = std::make_shared<Place_of_vertex>(std::move(places).release());
  if(new_places.is_simplified())
  {
    for(Index& place : *place_of_vertex)
      place = place == no_index ? place : new_places(place);
  }
  const auto& graph = on_mesh.graph();
  const auto arcs = edges(graph);
  const std::size_t number_of_places = num_vertices(graph) + num_edges(graph);
  progress.report_end();
  return Reeb_graph::Vertex_locations<vertex_descriptor, typename GraphOnMesh::Graph>(
    on_mesh.vertex_numbers(), num_vertices(graph), {arcs.first, arcs.second}, place_of_vertex,
    std::make_shared<Vertex_lists<vertex_descriptor>>(on_mesh.list_vertices(place_of_vertex, number_of_places)));
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_LOCATE_VERTICES_H
