// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "commands/commands.h"
#include "computation/Mesh_graph.h"
#include "computation/analysis.h"
#include "generated_surfaces/build_mesh.h"
#include "generated_surfaces/standing_figure.h"
#include "output/graph_output.h"
#include "output/mesh_output.h"
#include "output/output_file.h"
#include "output/report_output.h"
#include "page/page_output.h"

#include <iostream>

namespace fs = std::filesystem;

namespace reeb_graph_program {
namespace {
constexpr std::size_t number_of_vertices = 20000;

Scalar_map add_height(Surface& surface)
{
  Scalar_map scalar_map = surface.add_property_map<Surface::Vertex_index, double>("v:scalar").first;
  for(const Surface::Vertex_index v : surface.vertices())
    scalar_map[v] = surface.point(v).z();
  return scalar_map;
}

} // namespace

void run_demo(const Demo_options& options)
{
  const fs::path& folder = options.folder;
  Output_group files;
  make_folder(folder);
  Report report;
  Mesh mesh;
  Surface& surface = mesh.surface;
  const Scalar_map scalar_map = timed(report, "generate", [&] {
    surface = generated_surfaces::make_mesh<Surface>(generated_surfaces::standing_figure(number_of_vertices));
    return add_height(surface);
  });
  Graph_options graph_options;
  graph_options.are_places_wanted = true;
  const auto mesh_graph = compute_mesh_graph(mesh, scalar_map, graph_options, {}, 0, report);
  const Graph& graph = mesh_graph->result();
  count_all(surface, graph, report);

  write_surface(folder / "surface.off", surface, report.notes);
  write_scalars(folder / "scalars.txt", surface, scalar_map);
  write_coloured_surface(folder / "surface_coloured.ply", surface, scalar_map);
  const Field_label field_label = {"height", "m"};
  for(const char* name : {"graph.svg", "graph.graphml", "graph.dot"})
    write_graph(folder / name, graph, field_label, own_numbers, mesh_graph->arc_table().attributes());

  if(is_page_available())
    write_page(folder / "page.html", {scalar_map, *mesh_graph, "Figure with a hand on its hip", field_label});
  files.put_in_place();
  if(is_page_available())
    std::cout << "Open this page in a web browser to see the surface and its Reeb graph:\n\n  "
              << fs::absolute(folder / "page.html").lexically_normal().string() << "\n\n";

  std::cout << "The Reeb graph of the height on a generated figure, with one hand on the hip:\n\n";
  write_text(std::cout, report);
  std::cout
    << "\nThe arm and the body make the loop of the graph. Its leaves are the feet, the head, the hand that waves,\n"
       "and the bird on that arm. Files in "
    << folder.string() << ":\n\n"
    << (is_page_available() ? "  page.html             the surface and the graph, to turn, to point at, and to send\n"
                            : "")
    << "  graph.svg             the graph, drawn: open it in a web browser\n"
       "  surface_coloured.ply  the surface, dark where low and yellow where high: open it in MeshLab or Blender\n"
       "  graph.dot             the graph for Graphviz\n"
       "  graph.graphml         the graph for programs: NetworkX, Gephi, yEd\n"
       "  surface.off           the surface\n"
       "  scalars.txt           the field, one number per vertex\n"
    << (is_page_available() ? "" : "\nFor a page that shows both, install libjs-three, and build the program again.\n")
    << "\nThe same by hand:\n\n  reeb_graph compute " << (folder / "surface.off").string() << " --scalars "
    << (folder / "scalars.txt").string() << " --graph graph.svg"
    << (is_page_available() ? " --html page.html\n" : "\n");
}

} // namespace reeb_graph_program
