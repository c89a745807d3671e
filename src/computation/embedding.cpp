// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/embedding.h"

#include "base/progress_bar.h"

#include <CGAL/Reeb_graph/embed.h>
#include <CGAL/Reeb_graph/simplification/arc_persistences.h>

#include <cstddef>
#include <cstdint>
#include <functional>

namespace reeb_graph_program {
std::vector<CGAL::Reeb_graph::Attribute> arc_attributes(const Graph& graph, const std::vector<Arc_row>& arcs)
{
  std::vector<double> lengths, areas;
  std::vector<std::int64_t> vertices;
  for(const Arc_row& arc : arcs)
  {
    lengths.push_back(arc.length);
    areas.push_back(arc.area);
    vertices.push_back(static_cast<std::int64_t>(arc.vertices));
  }
  return {{"persistence", CGAL::Reeb_graph::arc_persistences(graph)},
          {"length", lengths},
          {"area", areas},
          {"vertices", vertices}};
}

Graph_in_space embed_graph(const Augmentation& augmentation,
                           CGAL::Reeb_graph::Embedding_manner manner,
                           const std::vector<Arc_row>* arcs)
{
  Progress_bar progress_bar("embedding");
  const auto np = CGAL::parameters::embedding_manner(manner).callback(std::ref(progress_bar));
  Graph_in_space result = {CGAL::Reeb_graph::embed<CGAL::Parallel_if_available_tag>(augmentation, np), {}};
  if(arcs)
    result.arc_attributes = reeb_graph_program::arc_attributes(augmentation.graph(), *arcs);
  return result;
}

Graph_in_space embed_straight(const Graph& graph, const Surface& surface)
{
  Graph_in_space result;
  for(const auto node : CGAL::make_range(vertices(graph)))
  {
    result.embedding.node_points.push_back(surface.point(graph[node].vertex));
    result.embedding.node_values.push_back(graph[node].value);
  }
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    const std::size_t lower = source(arc, graph), upper = target(arc, graph);
    result.embedding.arc_polylines.push_back(
      {result.embedding.node_points[lower], result.embedding.node_points[upper]});
    result.embedding.arc_values.push_back({graph[lower].value, graph[upper].value});
  }
  return result;
}

} // namespace reeb_graph_program
