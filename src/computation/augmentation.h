// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_AUGMENTATION_H
#define CGAL_REEB_GRAPH_SRC_AUGMENTATION_H

#include "base/options.h"
#include "base/report.h"
#include "base/surface.h"
#include "computation/simplification.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace reeb_graph_program {
typedef Augmentation::Vertex_locations Vertex_locations;

// Computes the Reeb graph, and adds what it took to the report.
Graph compute_and_time(const Surface& surface, Scalar_map scalar_map, const Graph_options& options, Report& report);

// Without a report.
Graph compute_graph(const Surface& surface, Scalar_map scalar_map, const Graph_options& options);

// The places are numbered as in the graph files.
Vertex_locations locate_vertices(const Augmentation& augmentation);

// The arcs of the graph, by their numbers.
std::vector<Arc_row> measure_arcs(const Surface& surface,
                                  Scalar_map scalar_map,
                                  const Graph& graph,
                                  const Vertex_locations& locations);

template <class AnyGraph, class AnyVertexLocations>
std::vector<Arc_row> rows_of_arcs(const AnyGraph& graph,
                                  const AnyVertexLocations& locations,
                                  const std::vector<double>& lengths,
                                  const std::vector<double>& areas)
{
  std::vector<Arc_row> rows;
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    const std::size_t i = get(boost::edge_index, graph, arc), lower = source(arc, graph), upper = target(arc, graph);
    rows.push_back({lower, upper, graph[lower].value, graph[upper].value, lengths[i], areas[i],
                    locations.vertices_of_arc(i).size()});
  }
  return rows;
}

// The graph with values to which `base` is added, in `copy` if need be.
template <class AnyGraph>
const AnyGraph& with_base(const AnyGraph& graph, double base, std::optional<AnyGraph>& copy)
{
  if(base == 0)
    return graph;
  copy = graph;
  for(const auto node : CGAL::make_range(vertices(*copy)))
    (*copy)[node].value += base;
  return *copy;
}

template <class VertexRange, class AnyVertexLocations>
std::vector<std::size_t> places_of(const VertexRange& vertices, const AnyVertexLocations& locations)
{
  std::vector<std::size_t> places;
  for(const auto v : vertices)
    places.push_back(locations.index(v));
  return places;
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_AUGMENTATION_H
