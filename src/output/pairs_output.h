// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_PAIRS_OUTPUT_H
#define CGAL_REEB_GRAPH_SRC_PAIRS_OUTPUT_H

#include "base/surface.h"
#include "computation/simplification.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace reeb_graph_program {
// Throws an exception unless the file name ends in .csv or .pers.
void check_pairs_format(const std::filesystem::path& path);

// Writes the pairs of a graph, one per line: .csv with kind, vertices, and values; .pers for GUDHI, with dimension,
// birth, and death as its extended persistence has them. Vertices are numbered as in the surface if no numbers are
// given. Throws std::runtime_error if the file cannot be written.
void write_pairs(const std::filesystem::path& path,
                 const Graph& graph,
                 const std::vector<Persistence_pair>& pairs,
                 const Vertex_numbers& vertex_numbers = {});

// Throws an exception unless the file name ends in .svg.
void check_diagram_format(const std::filesystem::path& path);

// Draws the persistence diagram: each pair of finite values is a point, as far above the diagonal as it is persistent,
// and what is below the threshold is in a shaded band. Throws std::runtime_error if the file cannot be written.
void write_diagram(const std::filesystem::path& path,
                   const Graph& graph,
                   const std::vector<Persistence_pair>& pairs,
                   std::optional<double> threshold);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_PAIRS_OUTPUT_H
