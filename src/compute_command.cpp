// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "analysis.h"
#include "commands.h"
#include "graph_output.h"
#include "mesh_input.h"
#include "report.h"
#include "scalar_input.h"
#include "stopwatch.h"

#include <iostream>
#include <vector>

namespace reeb_graph_program {
namespace {
Scalar_map add_field(const Compute_options& options, Surface& surface)
{
  const Scalar_map scalar_map = surface.add_property_map<Surface::Vertex_index, double>("v:scalar").first;
  if(!options.scalars_path.empty())
  {
    const std::vector<double> scalars = read_scalars(options.scalars_path, surface.number_of_vertices());
    for(const Surface::Vertex_index v : surface.vertices())
      scalar_map[v] = scalars[v];
    return scalar_map;
  }
  const int coordinate = options.field == "x" ? 0 : options.field == "y" ? 1 : 2; // height is z
  for(const Surface::Vertex_index v : surface.vertices())
    scalar_map[v] = surface.point(v)[coordinate];
  return scalar_map;
}

} // namespace

void run_compute(const Compute_options& options)
{
  if(!options.graph_path.empty())
    check_graph_format(options.graph_path);

  Report report;
  const Stopwatch read_stopwatch;
  Surface surface = read_surface(options.mesh_path, options.are_faces_triangulated);
  const Scalar_map scalar_map = add_field(options, surface);
  report.seconds.emplace_back("read", read_stopwatch.seconds());

  const Graph graph = compute_and_time(surface, scalar_map, options.are_degree_two_nodes_kept, report);
  count_all(surface, graph, report);
  if(!options.graph_path.empty())
  {
    const Stopwatch output_stopwatch;
    write_graph(options.graph_path, graph, surface);
    report.seconds.emplace_back("output", output_stopwatch.seconds());
  }
  if(options.is_report_json)
    write_json(std::cout, report);
  else
    write_text(std::cout, report);
}

} // namespace reeb_graph_program
