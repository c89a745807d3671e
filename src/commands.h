// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_COMMANDS_H
#define CGAL_REEB_GRAPH_SRC_COMMANDS_H

#include <filesystem>
#include <string>

namespace reeb_graph_program {
struct Compute_options
{
  std::string mesh_path;
  std::string scalars_path; // empty if the field is a coordinate
  std::string field;        // height, x, y, or z
  std::string graph_path;   // empty if no graph is written
  bool are_degree_two_nodes_kept = false;
  bool is_report_json = false;
  bool are_faces_triangulated = false;
};

struct Demo_options
{
  std::filesystem::path folder = "reeb_graph_demo";
};

// Both print to std::cout and throw an exception derived from std::exception for any error.
void run_compute(const Compute_options& options);
void run_demo(const Demo_options& options);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_COMMANDS_H
