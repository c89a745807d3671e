// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "commands.h"

#include <CLI/CLI.hpp>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>

namespace {
using reeb_graph_program::Compute_options;
using reeb_graph_program::Demo_options;

void add_compute_command(CLI::App& app, Compute_options& options)
{
  CLI::App* command = app.add_subcommand("compute", "Compute the Reeb graph of a scalar field on a triangle mesh");
  command->add_option("MESH", options.mesh_path, "Mesh: OFF, OBJ, PLY, STL, or TS file")->required();
  CLI::Option_group* field = command->add_option_group("Field", "The scalar field, one of");
  field->add_option("--scalars", options.scalars_path,
                    "File of one number per line, in the vertex order of the mesh file");
  field->add_option("--field", options.field, "A coordinate of the vertices: height, x, y, or z; height is z")
    ->check(CLI::IsMember({"height", "x", "y", "z"}));
  field->require_option(1);
  command->add_option("--graph", options.graph_path, "Write the graph to this file, .graphml or .dot");
  command->add_flag("--keep-degree-2", options.are_degree_two_nodes_kept,
                    "Keep critical vertices with one arc below and one above as nodes");
  command->add_flag("--json", options.is_report_json, "Print the report as one JSON object");
  command->add_flag("--triangulate", options.are_faces_triangulated, "Cut faces that are not triangles into triangles");
  command->callback([&options] { run_compute(options); });
}

void add_demo_command(CLI::App& app, Demo_options& options)
{
  CLI::App* command = app.add_subcommand("demo", "Show a Reeb graph of a generated surface; needs no input");
  command->add_option("--out", options.folder, "Folder of the files that are written")->capture_default_str();
  command->callback([&options] { run_demo(options); });
}

int report_error(const std::string& message)
{
  std::cerr << "reeb_graph: error: " << message << '\n';
  return EXIT_FAILURE;
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Exact Reeb graphs of scalar fields on triangle meshes", "reeb_graph");
  app.require_subcommand(1);
  Compute_options compute_options;
  Demo_options demo_options;
  add_compute_command(app, compute_options);
  add_demo_command(app, demo_options);
  try
  {
    app.parse(argc, argv);
    if(!std::cout.flush())
      throw std::runtime_error("standard output cannot be written");
    return EXIT_SUCCESS;
  }
  catch(const CLI::Success& request_for_help)
  {
    return app.exit(request_for_help);
  }
  catch(const CLI::ParseError& error)
  {
    return report_error(std::string(error.what()) + "\nRun with --help for more information.");
  }
  catch(const std::bad_alloc&)
  {
    return report_error("out of memory");
  }
  catch(const std::exception& error)
  {
    return report_error(error.what());
  }
}
