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

#include <cstdint>
#include <functional>

namespace reeb_graph_program {
namespace {
std::vector<CGAL::Reeb_graph::Attribute> measures(const Graph& graph, const std::vector<Arc_row>& arcs)
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

} // namespace

Graph_in_space embed_graph(const Augmentation& augmentation,
                           CGAL::Reeb_graph::Embedding_manner manner,
                           const std::vector<Arc_row>* arcs)
{
  Progress_bar progress_bar("embedding");
  const auto np = CGAL::parameters::embedding_manner(manner).callback(std::ref(progress_bar));
  Graph_in_space result = {CGAL::Reeb_graph::embed<CGAL::Parallel_if_available_tag>(augmentation, np), {}};
  if(arcs)
    result.arc_attributes = measures(augmentation.graph(), *arcs);
  return result;
}

} // namespace reeb_graph_program
