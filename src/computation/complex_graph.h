// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_COMPLEX_GRAPH_H
#define CGAL_REEB_GRAPH_SRC_COMPLEX_GRAPH_H

#include "base/complex.h"
#include "base/options.h"
#include "base/report.h"
#include "computation/augmentation.h"
#include "computation/simplification.h"

#include <cstddef>
#include <vector>

// Graphs of complexes that are no oriented manifold surfaces: what analysis.h and augmentation.h have for surfaces.
namespace reeb_graph_program {
typedef Simplified_graph_of<Complex_graph> Simplified_complex_graph;

// Computes the Reeb graph, and adds what it took to the report.
Complex_graph compute_and_time(const Mesh& mesh, Scalar_map scalar_map, const Graph_options& options, Report& report);

// Counts what the report tells of the complex and of the graph.
void count_all(const Mesh& mesh, const Complex_graph& graph, Report& report);

// The same graph with descriptors of the surface that has the vertices, for the functions that write graphs. If chains
// are wanted, their edges are added to the surface.
Graph graph_on_vertices(const Complex_graph& graph, Surface& vertices, bool are_chains_wanted);

// The place of each vertex, as in the graph files.
std::vector<std::size_t> locate_vertices(const Mesh& mesh,
                                         Scalar_map scalar_map,
                                         const Simplified_complex_graph& graph,
                                         const Graph_options& options);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_COMPLEX_GRAPH_H
