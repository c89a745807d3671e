// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/costs.h"
#include "commands/commands.h"
#include "input/field_input.h"
#include "output/mesh_output.h"
#include "output/output_file.h"
#include "output/report_output.h"

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace reeb_graph_program {
void run_field(const Field_options& options)
{
  const std::vector<std::filesystem::path> outputs(options.output_paths.begin(), options.output_paths.end());
  check_outputs(outputs, input_files(options.input));
  for(const std::string& path : options.output_paths)
    check_numbers_format(path);
  Work_report report;
  Mesh mesh = read_mesh(options.input, report);
  const Scalar_map scalar_map = add_field(options.input, mesh, report);
  const Stopwatch stopwatch;
  Output_group files;
  for(const std::string& path : options.output_paths)
    write_scalars(path, mesh.surface, scalar_map);
  files.put_in_place();
  report.add_seconds("output", stopwatch.seconds());
  const Field_range range(scalar_map.begin(), scalar_map.end());
  write_report(options.is_report_json, outputs, range, report);
}

} // namespace reeb_graph_program
