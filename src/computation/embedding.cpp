// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/embedding.h"

#include <CGAL/Reeb_graph/simplification/arc_persistences.h>

#include <cstddef>
#include <cstdint>

namespace reeb_graph_program {
std::vector<CGAL::Reeb_graph::Attribute> attributes_of_arcs(const Graph& graph, const std::vector<Arc_row>& arcs)
{
  std::vector<double> lengths, sizes;
  bool are_volumes = false;
  std::vector<std::int64_t> vertices;
  for(const Arc_row& arc : arcs)
  {
    lengths.push_back(arc.length);
    sizes.push_back(arc.volume.value_or(arc.area));
    are_volumes = arc.volume.has_value();
    vertices.push_back(static_cast<std::int64_t>(arc.vertices));
  }
  return {{"persistence", CGAL::Reeb_graph::arc_persistences(graph)},
          {"length", lengths},
          {are_volumes ? "volume" : "area", sizes},
          {"vertices", vertices}};
}

} // namespace reeb_graph_program
