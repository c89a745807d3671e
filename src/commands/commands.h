// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_COMMANDS_H
#define CGAL_REEB_GRAPH_SRC_COMMANDS_H

#include "base/options.h"
#include "base/report.h"
#include "base/surface.h"
#include "computation/Mesh_graph.h"
#include "computation/skeleton.h"
#include "input/repair_soup.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace reeb_graph_program {
// What commands have in common, as far as they have it. Paths are empty if that file is not written.
struct Command_options
{
  Input_options input;
  std::vector<std::string> output_paths; // of handles meshes without them, or loops if none are to be removed
  std::string page_path;
  std::string up;   // of the page: x, y, z, -x, -y, -z, or as it finds it
  std::string unit; // of the field, for what is drawn
  bool is_report_json = false;
  std::size_t number_of_threads = 0; // 0: one per core
};

struct Compute_options : Command_options
{
  Graph_options graph;
  Simplification_options simplification;
  std::string graph_path;
  std::optional<CGAL::Reeb_graph::Embedding_manner> embedding_manner; // by default by cost
  std::string mesh_path;
  std::string vertex_arcs_path;
  std::string pairs_path;
  std::string diagram_path;
  std::string loop_path;
  std::string simplified_scalars_path;
  std::optional<bool> is_table_wanted; // by default that of a graph of few arcs
  std::string title;                   // of the page, by default the name of the mesh file
  double base = 0;                     // is added to the values of the field in files of graphs and pairs
};

struct Compare_options : Command_options
{
  Graph_options graph;
  Simplification_options simplification;
  std::vector<std::string> mesh_paths, scalars_paths; // one field for all meshes, or one for each; so are sources
  std::vector<std::vector<std::size_t>> sources;
  std::string matrix_path;
  double price_alone = 1; // of an arc without partner
};

struct Contour_options : Command_options
{
  Contour_choice choice;
  std::string parametrization; // unit-gradient, or a file of numbers; empty for the field itself
};

struct Curves_options : Command_options
{
  Graph_options graph = {false, CGAL::Reeb_graph::Ties::CONTRACT}; // of what is written and shown of it
  Simplification_options simplification;
  Cut_options cut;
  std::string curves_path;
  std::string cut_mesh_path;
  std::string patches_path;
  std::string pieces_path;     // a folder
  std::string vertex_map_path; // of disks
  std::string graph_path;
  std::string mesh_path;
  bool is_large_accepted = false; // a cut mesh of more than 50 times the triangles
};

struct Handles_options : Command_options
{
  std::string loops_path;
  std::optional<Threshold> size_to_remove;     // handles that are smaller are removed
  std::optional<std::size_t> number_to_remove; // so many at most, the smallest ones
  bool are_loops_shortened = true;
  bool are_self_intersections_ignored = false;
};

struct Repair_command_options : Command_options
{
  Repair_options repair;
  std::string map_path;
};

struct Skeleton_command_options : Command_options
{
  Skeleton_settings settings;
  std::vector<Skeleton_place> from, to; // of paths, which are found if one of both is not empty
  Swc_options swc;
  std::string mesh_path, pieces_path;
};

struct Demo_options
{
  std::filesystem::path folder = "reeb_graph_demo";
};

// Parts of run_compute(): throw std::runtime_error if what is asked for does not go together, or not with the mesh.
void check(const Compute_options& options);
void check_for_complex(const Compute_options& options, const Mesh& mesh);

// A part of run_compute(): writes the files that are asked for, and completes the report.
void write_results(const Compute_options& options,
                   Mesh& mesh,
                   Scalar_map scalar_map,
                   Mesh_graph& graph,
                   Report& report);

// A part of that: finds the pairs of the given graph if they are asked for, and writes them.
void write_pairs_and_diagram(const Compute_options& options,
                             const Graph& graph,
                             double threshold,
                             Report& report,
                             const Vertex_numbers& vertex_numbers = own_numbers);

// They print to standard output, or to standard error if a file is written there, and throw an exception derived from std::exception for any error.
void run_compute(const Compute_options& options);
void run_compare(const Compare_options& options);
void run_contour(const Contour_options& options);
void run_curves(Curves_options options);
void run_field(const Command_options& options);
void run_handles(const Handles_options& options);
void run_repair(const Repair_command_options& options);
void run_skeleton(const Skeleton_command_options& options);
void run_demo(const Demo_options& options);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_COMMANDS_H
