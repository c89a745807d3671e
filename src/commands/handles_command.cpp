// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/stopwatch.h"
#include "commands/commands.h"
#include "computation/handles.h"
#include "input/field_input.h"
#include "output/loops_output.h"
#include "output/output_file.h"
#include "output/report_output.h"

#include <ostream>

namespace reeb_graph_program {
namespace {
// The given field, or if none is given, a coordinate.
Scalar_map add_field_or_height(Input_options input, Surface& surface, Handles_report& report)
{
  const bool is_given = !input.field.empty() || !input.scalars_path.empty();
  if(!is_given)
    input.field = "z";
  const Scalar_map scalar_map = add_field(input, surface, report);
  report.field = field_label(input, "").name;
  if(!is_given)
    report.field = write_least_rough_height(surface, scalar_map);
  return scalar_map;
}

} // namespace

void run_handles(const Handles_options& options)
{
  if(!options.loops_path.empty())
    check_loops_format(options.loops_path);
  check_outputs({options.loops_path}, input_files(options.input));
  Handles_report report;
  Input_options input = options.input;
  if(input.field.empty() && input.scalars_path.empty())
    input.field = "z"; // until the mesh is known
  Surface surface = read_surface(input, report);
  const Stopwatch field_stopwatch;
  const Scalar_map scalar_map = add_field_or_height(options.input, surface, report);
  report.add_seconds("field", field_stopwatch.seconds());
  const Stopwatch stopwatch;
  const Loops_of_surface loops = find_loops(surface, scalar_map, options.are_loops_shortened);
  report.add_seconds("handles", stopwatch.seconds());
  report.loops = loops.rows;
  if(!options.loops_path.empty())
  {
    const Stopwatch output_stopwatch;
    write_loops(options.loops_path, loops);
    report.add_seconds("output", output_stopwatch.seconds());
  }
  std::ostream& stream = report_stream({options.loops_path});
  if(options.is_report_json)
    write_json(stream, report);
  else
    write_text(stream, report);
}

} // namespace reeb_graph_program
