// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// Times and memory from a mesh to the finished graph with its chains, for both methods, with one thread and with more,
// beside two floors that are measured in the same run: std::sort of (value, index) pairs, and one sweep over the
// faces as flat triangles. Then meshes in a bad order, how the time grows with the mesh, and complexes that are no
// surfaces. All is generated.

#include "complex_table.h"
#include "handles_table.h"
#include "shuffled_table.h"
#include "simplification_table.h"
#include "tables.h"

#ifdef CGAL_REEB_GRAPH_BENCHMARK_VTK
#include "vtk_table.h"
#endif

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

int main(int argc, char* argv[])
{
  benchmark::Options options;
  std::vector<std::string> tables = {"comparison", "shuffled", "simplification", "growth", "complexes", "handles"};
  CLI::App app("Times and memory of Reeb graphs, beside sorting the field and sweeping over the faces");
  const auto add_list = [&](const std::string& name, auto& list, const std::string& description) {
    return app.add_option(name, list, description)->delimiter(',')->capture_default_str();
  };
  add_list("--vertices", options.sizes, "Numbers of vertices of the surfaces, up to a factor of 2")
    ->check(CLI::Range(100, 1000000000));
  add_list("--surfaces", options.surfaces, "Surfaces")->check(CLI::IsMember(benchmark::surface_names()));
  add_list("--fields", options.fields, "Fields")->check(CLI::IsMember(benchmark::field_names()));
  add_list("--growth-vertices", options.growth_sizes, "Numbers of vertices for the table of growth")
    ->check(CLI::Range(100, 1000000000));
  add_list("--triangles", options.numbers_of_triangles, "Numbers of triangles for the table of complexes")
    ->check(CLI::Range(100, 1000000000));
#ifdef CGAL_REEB_GRAPH_BENCHMARK_VTK
  tables.push_back("vtk");
  std::size_t vtk_size = 20000;
  app.add_option("--vtk-vertices", vtk_size, "The number of vertices for the comparison with VTK")
    ->check(CLI::Range(100, 1000000000))
    ->capture_default_str();
#endif
  const std::vector<std::string> all_tables = tables;
  add_list("--tables", tables, "Tables: comparison, which includes that of the stages, and others")
    ->check(CLI::IsMember(all_tables));
  app.add_option("--repetitions", options.number_of_repetitions, "Of which the medians are taken")
    ->check(CLI::Range(1, 1000))
    ->capture_default_str();
  app.add_option("--threads", options.number_of_threads, "Beside one")
    ->check(CLI::Range(2, 1024))
    ->capture_default_str();
  app
    .add_option("--critical-sets-limit", options.largest_number_for_critical_sets,
                "Leave the method of critical sets out if there are more critical vertices than this")
    ->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  const auto print = [&](const std::string& table, const auto& print_table) {
    if(std::find(tables.begin(), tables.end(), table) == tables.end())
      return;
    const benchmark::Stopwatch stopwatch;
    print_table(options);
    std::printf("\n%s: %.0f seconds\n", table.c_str(), stopwatch.milliseconds() / 1000);
  };
  print("comparison", benchmark::print_comparison_and_stages);
  print("shuffled", benchmark::print_shuffled);
  print("simplification", benchmark::print_simplification);
  print("growth", benchmark::print_growth);
  print("complexes", benchmark::print_complexes);
  print("handles", benchmark::print_handles);
#ifdef CGAL_REEB_GRAPH_BENCHMARK_VTK
  print("vtk", [&](const benchmark::Options& options) { benchmark::print_vtk(options, vtk_size); });
#endif
  return EXIT_SUCCESS;
}
