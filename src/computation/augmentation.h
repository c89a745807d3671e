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
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace reeb_graph_program {
typedef Augmentation::Vertex_locations Vertex_locations;

// Without a report of the stages.
Graph compute_graph(const Surface& surface, Scalar_map scalar_map, const Graph_options& options);

// The places are numbered as in the graph files.
Vertex_locations locate_vertices(const Augmentation& augmentation);

// The arcs of the graph, by their numbers.
std::vector<Arc_row> measure_arcs(const Surface& surface,
                                  Scalar_map scalar_map,
                                  const Graph& graph,
                                  const Vertex_locations& locations);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_AUGMENTATION_H
