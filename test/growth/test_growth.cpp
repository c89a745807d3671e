// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "Table.h"
#include "surfaces.h"

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>

// Usage: test_growth [PART_OF_A_NAME], or test_growth --write FOLDER VERTICES, which writes the surfaces and fields for
// the test of the program.
namespace {
void write_files(const std::filesystem::path& folder, std::size_t number_of_vertices)
{
  std::size_t number = 0;
  for(const growth::Input& input : growth::all_inputs(number_of_vertices))
  {
    const std::string stem = (folder / std::to_string(number++)).string();
    std::ofstream mesh(stem + ".off"), values(stem + ".txt"), name(stem + ".name");
    mesh.precision(std::numeric_limits<double>::max_digits10);
    values.precision(std::numeric_limits<double>::max_digits10);
    mesh << "OFF\n" << input.soup.points.size() << ' ' << input.soup.triangles.size() << " 0\n";
    for(const auto& p : input.soup.points)
      mesh << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    for(const auto& t : input.soup.triangles)
      mesh << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
    for(const double value : input.values)
      values << value << '\n';
    name << input.name;
  }
}
} // namespace

int main(int argc, char* argv[])
{
  try
  {
    if(argc == 4 && std::string(argv[1]) == "--write")
    {
      write_files(argv[2], std::stoul(argv[3]));
      return EXIT_SUCCESS;
    }
    growth::Table table(argc > 1 ? argv[1] : "");
    growth::measure_graphs(table);
    growth::measure_complexes(table);
    growth::measure_curves(table);
    growth::measure_handles(table);
    growth::measure_skeletons(table);
    growth::measure_comparisons(table);
#ifdef CGAL_EIGEN3_ENABLED
    growth::measure_fields(table);
#endif
    if(table.number_of_failures() == 0)
      return EXIT_SUCCESS;
    std::cerr << table.number_of_failures() << " rows grow faster than their bounds\n";
  }
  catch(const std::exception& error)
  {
    std::cerr << "Error: " << error.what() << '\n';
  }
  return EXIT_FAILURE;
}
