// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_ARC_COLUMNS_H
#define CGAL_REEB_GRAPH_SRC_ARC_COLUMNS_H

#include "base/report.h"
#include "base/surface.h"

#include <CGAL/Reeb_graph/simplification/simplify.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace reeb_graph_program {
// The table with what the graph alone knows: the ends and the persistence of each arc.
Arc_table table_of_graph(const Graph& graph);

// The columns of what is measured on the mesh.
Arc_column length_column(std::vector<double> lengths);
Arc_column size_column(const std::string& name, std::vector<double> sizes); // the area or the volume
Arc_column mean_value_column(std::vector<double> means);

// How many vertices belong to each arc. `places` are those of the vertices, and of vertices of the mesh only.
template <class VertexRange>
Arc_column vertices_column(const VertexRange& vertices,
                           const std::vector<std::size_t>& places,
                           std::size_t number_of_nodes,
                           std::size_t number_of_arcs)
{
  std::vector<std::int64_t> of_nodes(number_of_nodes, 0), of_arcs(number_of_arcs, 0);
  for(const std::size_t v : vertices)
    ++(places[v] < number_of_nodes ? of_nodes[places[v]] : of_arcs[places[v] - number_of_nodes]);
  return {{"vertices", std::move(of_arcs)}, Arc_joining::WITH_NODES, Arc_unit::COUNT, true, std::move(of_nodes)};
}

// The table of a simplified graph, from that of the given one. For each of its arcs, `parts` are those of the given graph
// that its chain passes.
Arc_table join_arcs(const Arc_table& given,
                    const Graph& simplified,
                    const CGAL::Reeb_graph::Simplification<Graph>& simplification,
                    const std::vector<std::vector<std::size_t>>& parts);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_ARC_COLUMNS_H
