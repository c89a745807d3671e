// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_GRAPH_OUTPUT_H
#define CGAL_REEB_GRAPH_SRC_GRAPH_OUTPUT_H

#include "base/options.h"
#include "base/surface.h"
#include "computation/Mesh_graph.h"
#include "computation/simplification.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace reeb_graph_program {
// These throw std::runtime_error, which names the formats that there are, for a file name of none of them.
void check_graph_format(const std::filesystem::path& path);

// Whether it is the format of a graph in space.
bool is_format_in_space(const std::filesystem::path& path);

// Whether the format has numbers of arcs besides their lines.
bool has_arc_attributes(const std::filesystem::path& path);

// The files that are written for a graph file of this name.
std::vector<std::filesystem::path> graph_files(const std::filesystem::path& path);

// Writes a graph in a format that needs no points. The label is that of the axis of a drawing. Without attributes, arcs
// are written without measures.
void write_graph(const std::filesystem::path& path,
                 const Graph& graph,
                 const Field_label& field_label,
                 const Vertex_numbers& vertex_numbers = own_numbers,
                 const std::vector<CGAL::Reeb_graph::Attribute>& arc_attributes = {});

// Writes a graph in a format in space. `write_json` writes it with its chains, and is called for that format only.
void write_graph_in_space(const std::filesystem::path& path,
                          const Graph& graph,
                          const Embedding& embedding,
                          const std::vector<CGAL::Reeb_graph::Attribute>& arc_attributes,
                          const std::function<void(std::ostream&)>& write_json);

// Notes nodes without arcs, which polylines have no room for.
void note_lost_nodes(const std::filesystem::path& path, const Graph& graph, std::vector<std::string>& notes);

// Notes that a unit that has been asked for is shown nowhere.
void note_lost_unit(const std::string& unit, bool is_shown, std::vector<std::string>& notes);

// Writes for each vertex, on a line of its own, the node or the arc that it belongs to, by their numbers in the graph
// files. `places` are those of a Mesh_graph.
void write_vertex_arcs(const std::filesystem::path& path,
                       const std::vector<std::size_t>& places,
                       std::size_t number_of_nodes);

// Throws an exception unless the file name ends in .csv or .pers.
void check_pairs_format(const std::filesystem::path& path);

// Writes the pairs of a graph, one per line: .csv with kind, vertices, and values; .pers for GUDHI, with dimension,
// birth, and death as its extended persistence has them. Vertices are numbered as in the surface if no numbers are
// given. Throws std::runtime_error if the file cannot be written.
void write_pairs(const std::filesystem::path& path,
                 const Graph& graph,
                 const std::vector<Persistence_pair>& pairs,
                 const Vertex_numbers& vertex_numbers = own_numbers);

// Throws an exception unless the file name ends in .svg.
void check_diagram_format(const std::filesystem::path& path);

// Draws the persistence diagram: each pair of finite values is a point, as far above the diagonal as it is persistent,
// and what is below the threshold is in a shaded band. Throws std::runtime_error if the file cannot be written.
void write_diagram(const std::filesystem::path& path,
                   const Graph& graph,
                   const std::vector<Persistence_pair>& pairs,
                   std::optional<double> threshold);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_GRAPH_OUTPUT_H
