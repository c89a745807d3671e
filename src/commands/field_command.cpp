// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/stopwatch.h"
#include "commands/commands.h"
#include "input/field_input.h"
#include "output/mesh_output.h"
#include "output/output_file.h"
#include "output/report_output.h"

#include <ostream>

namespace reeb_graph_program {
void run_field(const Field_options& options)
{
  check_outputs({options.output_path}, input_files(options.input));
  check_numbers_format(options.output_path);
  Work_report report;
  Mesh mesh = read_mesh(options.input, report);
  const Scalar_map scalar_map = add_field(options.input, mesh, report);
  const Stopwatch stopwatch;
  write_scalars(options.output_path, mesh.surface, scalar_map);
  report.add_seconds("output", stopwatch.seconds());
  const Field_range range(scalar_map.begin(), scalar_map.end());
  std::ostream& stream = report_stream({options.output_path});
  if(options.is_report_json)
    write_json(stream, range, report);
  else
    write_text(stream, range, report);
}

} // namespace reeb_graph_program
