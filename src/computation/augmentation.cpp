// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/augmentation.h"

#include "base/progress_bar.h"

#include <CGAL/Reeb_graph/IO/polylines.h>
#include <CGAL/Reeb_graph/arc_measures.h>
#include <CGAL/compute_reeb_graph.h>

#include <functional>

namespace reeb_graph_program {
Graph compute_graph(const Surface& surface, Scalar_map scalar_map, const Graph_options& options)
{
  Graph graph;
  Progress_bar progress_bar("graph");
  CGAL::compute_reeb_graph<CGAL::Parallel_if_available_tag>(surface, scalar_map, graph,
                                                            named_parameters(options).callback(std::ref(progress_bar)));
  return graph;
}

Vertex_locations locate_vertices(const Augmentation& augmentation)
{
  Progress_bar progress_bar("places");
  return augmentation.locate_vertices<CGAL::Parallel_if_available_tag>(
    CGAL::parameters::callback(std::ref(progress_bar)));
}

std::vector<Arc_row> measure_arcs(const Surface& surface,
                                  Scalar_map scalar_map,
                                  const Graph& graph,
                                  const Vertex_locations& locations)
{
  const std::vector<double> lengths = CGAL::Reeb_graph::arc_lengths(surface, scalar_map, graph);
  const std::vector<double> areas = CGAL::Reeb_graph::arc_areas(surface, graph, locations);
  std::vector<Arc_row> rows;
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    const std::size_t i = get(boost::edge_index, graph, arc), lower = source(arc, graph), upper = target(arc, graph);
    rows.push_back({lower, upper, graph[lower].value, graph[upper].value, lengths[i], areas[i],
                    locations.vertices_of_arc(i).size()});
  }
  return rows;
}

} // namespace reeb_graph_program
