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
#include "computation/augmentation.h"
#include "input/field_input.h"
#include "output/graph_output.h"
#include "output/output_file.h"
#include "output/report_output.h"

#include <iostream>

namespace reeb_graph_program {
void run_compute(const Compute_options& options)
{
  if(!options.graph_path.empty())
    check_graph_format(options.graph_path);
  check_distinct_paths({options.graph_path, options.vertex_arcs_path});

  Report report;
  const Stopwatch read_stopwatch;
  Surface surface = read_surface(options.input);
  const Scalar_map scalar_map = add_field(options.input, surface);
  report.seconds.emplace_back("read", read_stopwatch.seconds());

  const Graph graph = compute_and_time(surface, scalar_map, options.graph, report);
  count_all(surface, graph, report);
  const Stopwatch output_stopwatch;
  if(!options.vertex_arcs_path.empty())
    write_vertex_arcs(options.vertex_arcs_path, locate_vertices(surface, scalar_map, graph, options.graph),
                      num_vertices(graph));
  if(!options.graph_path.empty())
    write_graph(options.graph_path, graph, surface);
  if(!options.graph_path.empty() || !options.vertex_arcs_path.empty())
    report.seconds.emplace_back("output", output_stopwatch.seconds());
  if(options.is_report_json)
    write_json(std::cout, report);
  else
    write_text(std::cout, report);
}

} // namespace reeb_graph_program
