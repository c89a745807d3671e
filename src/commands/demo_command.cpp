// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/stopwatch.h"
#include "commands/commands.h"
#include "computation/analysis.h"
#include "generated_surfaces/build_mesh.h"
#include "generated_surfaces/generated_surfaces.h"
#include "output/graph_output.h"
#include "output/mesh_output.h"
#include "output/output_file.h"
#include "output/report_output.h"
#include "page/page_output.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <iostream>
#include <stdexcept>
#include <string>

namespace fs = std::filesystem;

namespace reeb_graph_program {
namespace {
constexpr unsigned genus = 3;
constexpr std::size_t number_of_vertices = 20000;

Scalar_map add_tilted_height(Surface& surface)
{
  Scalar_map scalar_map = surface.add_property_map<Surface::Vertex_index, double>("v:scalar").first;
  for(const Surface::Vertex_index v : surface.vertices())
  {
    const Point& point = surface.point(v);
    scalar_map[v] = 0.9 * point.x() + 0.4 * point.y() + 0.15 * point.z();
  }
  return scalar_map;
}

// Returns false if dot of Graphviz is not installed, or fails.
bool run_dot(const fs::path& dot_path, const fs::path& svg_path)
{
  std::array<std::string, 5> arguments = {"dot", "-Tsvg", "-o", svg_path.string(), dot_path.string()};
  std::array<char*, 6> argument_pointers = {};
  for(std::size_t i = 0; i < arguments.size(); ++i)
    argument_pointers[i] = arguments[i].data();
  pid_t process = 0;
  int status = 0;
  return posix_spawnp(&process, "dot", nullptr, nullptr, argument_pointers.data(), environ) == 0
      && waitpid(process, &status, 0) == process && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

// Returns false if the graph cannot be drawn here.
bool draw_graph(const fs::path& dot_path, const fs::path& svg_path)
{
  try
  {
    replace_file(svg_path, [&](const fs::path& temporary_path) {
      if(!run_dot(dot_path, temporary_path))
        throw std::runtime_error("dot failed");
    });
    return true;
  }
  catch(const std::runtime_error&)
  {
    return false;
  }
}

} // namespace

void run_demo(const Demo_options& options)
{
  const fs::path& folder = options.folder;
  fs::create_directories(folder);

  Report report;
  const Stopwatch stopwatch;
  Surface surface =
    generated_surfaces::make_mesh<Surface>(generated_surfaces::closed_surface(genus, number_of_vertices));
  const Scalar_map scalar_map = add_tilted_height(surface);
  report.seconds.emplace_back("generate", stopwatch.seconds());
  const Graph graph = compute_and_time(surface, scalar_map, Graph_options(), report);
  count_all(surface, graph, report);

  write_surface(folder / "surface.off", surface);
  write_scalars(folder / "scalars.txt", surface, scalar_map);
  write_coloured_surface(folder / "surface_coloured.ply", surface, scalar_map);
  const Field_label field_label = {"tilted height", ""};
  write_graph(folder / "graph.graphml", graph, surface, field_label);
  write_graph(folder / "graph.dot", graph, surface, field_label);
  const bool is_drawn = draw_graph(folder / "graph.dot", folder / "graph.svg");

  if(is_page_available())
  {
    write_page(folder / "page.html", {surface, scalar_map, graph, Graph_options(), "surface.off", field_label});
    std::cout << "Open this page in a web browser to see the surface and its Reeb graph:\n\n  "
              << fs::absolute(folder / "page.html").lexically_normal().string() << "\n\n";
  }

  std::cout << "The Reeb graph of a tilted height field on a generated surface of genus " << genus << ":\n\n";
  write_text(std::cout, report);
  std::cout << "\nEach handle of the surface is a loop of the graph. Files in " << folder.string() << ":\n\n"
            << (is_page_available()
                  ? "  page.html             the surface and the graph, to turn, to point at, and to send\n"
                  : "")
            << (is_drawn ? "  graph.svg             the graph, drawn: open it in a web browser\n" : "")
            << "  surface_coloured.ply  the surface, blue where low and red where high: open it in MeshLab or Blender\n"
               "  graph.dot             the graph for Graphviz, drawn by: dot -Tsvg graph.dot -o graph.svg\n"
               "  graph.graphml         the graph for programs: NetworkX, Gephi, yEd\n"
               "  surface.off           the surface\n"
               "  scalars.txt           the field, one number per vertex\n";
  if(!is_drawn)
    std::cout << "\nTo see the graph drawn as well, install Graphviz and run the demo again.\n";
  std::cout << "\nThe same by hand:\n\n  reeb_graph compute " << (folder / "surface.off").string() << " --scalars "
            << (folder / "scalars.txt").string() << " --graph graph.dot\n";
}

} // namespace reeb_graph_program
