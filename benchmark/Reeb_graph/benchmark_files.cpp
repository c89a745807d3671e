// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// How fast the program reads and writes files, beside its own times for the graph, with one thread and with two.
//
// Usage: benchmark_files PROGRAM [NUMBER OF VERTICES] [REPETITIONS]

#include "Table.h"
#include "inputs.h"
#include "measurements.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <nlohmann/json.hpp>

#include <stdio.h>
#include <stdlib.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {
using benchmark::cell;
namespace fs = std::filesystem;

struct Temporary_folder
{
  fs::path path = fs::temp_directory_path() / "benchmark_files_XXXXXX";

  Temporary_folder()
  {
    std::string name = path.string();
    if(mkdtemp(name.data()) == nullptr)
      throw std::runtime_error("no folder can be made for the files");
    path = name;
  }

  ~Temporary_folder() { fs::remove_all(path); }

  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;
};

// The milliseconds that the program says that its steps take, and those of the whole command.
struct Run
{
  nlohmann::json seconds;
  double whole = 0;

  double milliseconds(const std::string& step) const { return 1000 * seconds.value(step, 0.); }
  double graph() const { return milliseconds("compute"); }
};

Run run(const std::string& command)
{
  const benchmark::Stopwatch stopwatch;
  FILE* const pipe = popen(command.c_str(), "r");
  std::string text;
  std::array<char, 4096> block;
  for(std::size_t size = 1; pipe != nullptr && size > 0; text.append(block.data(), size))
    size = std::fread(block.data(), 1, block.size(), pipe);
  if(pipe == nullptr || pclose(pipe) != 0)
    throw std::runtime_error("this failed: " + command);
  return {nlohmann::json::parse(text).at("seconds"), stopwatch.milliseconds()};
}

void write_scalars(const fs::path& path, const benchmark::Input& input)
{
  std::ofstream out(path);
  out.precision(17);
  for(const auto v : input.mesh().vertices())
    out << input.scalar_map()[v] << '\n';
}

void write_files(const fs::path& folder, std::size_t number_of_vertices)
{
  benchmark::Input input("genus-3", number_of_vertices);
  const auto text = CGAL::parameters::stream_precision(17).use_binary_mode(false);
  const auto binary = CGAL::parameters::use_binary_mode(true);
  const auto write = [&](const char* name, const auto& np) {
    if(!CGAL::IO::write_polygon_mesh((folder / name).string(), input.mesh(), np))
      throw std::runtime_error("the files cannot be written");
  };
  write("surface.off", text);
  write("surface.obj", text);
  write("ascii.ply", text);
  write("binary.ply", binary);
  write("ascii.stl", text);
  write("binary.stl", binary);
  for(const char* const field : {"smooth", "noise"})
  {
    input.set_field(field);
    write_scalars(folder / field, input);
  }
}

// What is measured: a command, the files that it reads or writes, and the step of the program that does so. The step
// "read" ends with a surface that is checked; "output" begins when all that is written has been found, with the
// measures of arcs ("measure") and the places of nodes and the persistences of arcs ("embed").
struct Row
{
  std::string name, arguments;
  std::vector<std::string> files;
  std::string step;
};

const std::vector<Row>& rows()
{
  static const std::vector<Row> result = {
    {"OFF, scalars", "surface.off --scalars smooth", {"surface.off", "smooth"}, "read"},
    {"OFF", "surface.off --field y", {"surface.off"}, "read"},
    {"OBJ", "surface.obj --field y", {"surface.obj"}, "read"},
    {"PLY, ascii", "ascii.ply --field y", {"ascii.ply"}, "read"},
    {"PLY, binary", "binary.ply --field y", {"binary.ply"}, "read"},
    {"STL, ascii", "ascii.stl --field y", {"ascii.stl"}, "read"},
    {"STL, binary", "binary.stl --field y", {"binary.stl"}, "read"},
    {"to GraphML", "surface.off --scalars noise --graph g.graphml", {"g.graphml"}, "output"},
    {"to CSV", "surface.off --scalars noise --graph g.csv", {"g.nodes.csv", "g.arcs.csv"}, "output"},
    {"vertex arcs", "surface.off --scalars noise --vertex-arcs a.txt", {"a.txt"}, "output"}};
  return result;
}

void print_row(const benchmark::Table& table,
               const Row& row,
               const std::string& program,
               const fs::path& folder,
               std::size_t repetitions)
{
  std::array<benchmark::Sample, 2> steps, graphs, wholes;
  for(std::size_t repetition = 0; repetition < repetitions; ++repetition)
    for(const std::size_t threads : {1, 2})
    {
      if(row.step == "output") // To replace a file takes longer: the system puts the new one on the disk first.
        for(const std::string& file : row.files)
          fs::remove(folder / file);
      const Run result = run("cd '" + folder.string() + "' && '" + program + "' compute " + row.arguments
                             + " --no-table --json --threads " + std::to_string(threads));
      steps[threads - 1].add(result.milliseconds(row.step));
      graphs[threads - 1].add(result.graph());
      wholes[threads - 1].add(result.whole);
    }
  double megabytes = 0;
  for(const std::string& file : row.files)
    megabytes += static_cast<double>(fs::file_size(folder / file)) / 1e6;
  const double time = *steps[0].median(), graph = *graphs[0].median(), time_of_two = *steps[1].median();
  table.print_row({row.name, row.step, cell(megabytes, 0), cell(time, 0), cell(1000 * megabytes / time, 0),
                   cell(graph, 0), cell(time / graph, 1), cell(*wholes[0].median() / graph, 1), cell(time_of_two, 0),
                   cell(50 * time / time_of_two, 0), cell(*wholes[1].median() / *graphs[1].median(), 1)});
}
} // namespace

int main(int argc, char* argv[])
try
{
  const std::size_t number_of_vertices = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1000000;
  const std::size_t repetitions = argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 5;
  if(argc < 2 || number_of_vertices < 100 || repetitions == 0)
    throw std::runtime_error("usage: benchmark_files PROGRAM [NUMBER OF VERTICES] [REPETITIONS]");
  const benchmark::Stopwatch stopwatch;
  const std::string program = fs::absolute(argv[1]).string();
  const Temporary_folder folder;
  write_files(folder.path, number_of_vertices);
  const benchmark::Table table("Files that the program reads and writes, genus 3, " + cell(number_of_vertices)
                                 + " vertices; ms and MB/s are those of the step, whole: the whole command; medians of "
                                 + cell(repetitions) + " runs",
                               {{"file", "", 12},
                                {"step", "", 6},
                                {"size", "MB", 5},
                                {"1 thread", "ms"},
                                {"1 thread", "MB/s"},
                                {"graph", "ms", 5},
                                {"file", "/ graph"},
                                {"whole", "/ graph"},
                                {"2 thr.", "ms"},
                                {"2 thr.", "effic. %"},
                                {"whole", "/ graph"}});
  for(const Row& row : rows())
    print_row(table, row, program, folder.path, repetitions);
  std::printf("\nfiles: %.0f seconds\n", stopwatch.milliseconds() / 1000);
  return EXIT_SUCCESS;
}
catch(const std::exception& error)
{
  std::fprintf(stderr, "%s\n", error.what());
  return EXIT_FAILURE;
}
