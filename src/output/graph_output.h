// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_GRAPH_OUTPUT_H
#define CGAL_REEB_GRAPH_SRC_GRAPH_OUTPUT_H

#include "base/Field_label.h"
#include "base/surface.h"
#include "computation/augmentation.h"

#include <cstddef>
#include <filesystem>

namespace reeb_graph_program {
// Throws std::runtime_error if the extension is none of .graphml, .dot, and .svg.
void check_graph_format(const std::filesystem::path& path);

// The label is that of the axis of a drawing.
void write_graph(const std::filesystem::path& path,
                 const Graph& graph,
                 const Surface& surface,
                 const Field_label& field_label);

// Writes for each vertex, on a line of its own, the node or the arc that it belongs to, by their numbers in the graph
// files. `places` are those of locate_vertices().
void write_vertex_arcs(const std::filesystem::path& path,
                       const Surface& surface,
                       const Vertex_locations& locations,
                       std::size_t number_of_nodes);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_GRAPH_OUTPUT_H
