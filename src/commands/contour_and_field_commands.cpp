// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/surface.h"
#include "commands/commands.h"
#include "computation/Mesh_graph.h"
#include "computation/simplification.h"
#include "input/field_input.h"
#include "input/input_error.h"
#include "output/mesh_output.h"
#include "output/output_file.h"
#include "output/polylines_output.h"
#include "output/report_output.h"

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace reeb_graph_program {
namespace {
void check_choice(const Contour_choice& choice)
{
  if(choice.arc && !choice.t)
    throw std::runtime_error("--arc goes with --t only");
  if(int(choice.t.has_value()) + int(!choice.levels.empty()) + int(choice.number_of_levels.has_value())
       + int(choice.point.has_value())
     != 1)
    throw std::runtime_error("one of --t, --level, --levels, and --closest is needed");
}

void note_empty_levels(const std::vector<double>& levels, const std::vector<Contour>& contours, Work_report& report)
{
  for(const double level : levels)
    if(std::none_of(contours.begin(), contours.end(), [&](const Contour& contour) { return contour.value == level; }))
    {
      std::ostringstream note;
      note << "there is no contour at the level " << level;
      report.notes.push_back(note.str());
    }
}

} // namespace

void run_contour(const Contour_options& options)
{
  check_choice(options.choice);
  const std::vector<std::filesystem::path> outputs(options.output_paths.begin(), options.output_paths.end());
  for(const std::string& path : options.output_paths)
    check_contour_format(path);
  check_outputs(outputs, input_files(options.input));
  check_simplification_options(options.choice.simplification);
  Contours_report report;
  Mesh mesh = read_mesh(options.input, report);
  if(const std::string reason = reason_against("contour", mesh); !reason.empty())
    throw Input_error(options.input.mesh_path, reason);
  const bool has_tetrahedra = mesh.complex && !mesh.complex->tetrahedra.empty();
  for(const std::string& path : options.output_paths)
    check_contour_format(path, has_tetrahedra);
  const Scalar_map scalar_map = add_field(options.input, mesh, report);
  const Contour_choice& choice = options.choice;
  Report graph_report;
  const std::vector<Contour> contours =
    compute_mesh_graph(mesh, scalar_map, choice.graph, choice.simplification,
                       threshold_in_units(choice.simplification, mesh.surface, scalar_map), graph_report)
      ->find_contours(choice);
  Output_group files;
  for(const std::string& path : options.output_paths)
    write_contours(path, contours, has_tetrahedra);
  files.put_in_place();
  note_empty_levels(choice.levels, contours, report);
  report.contours = contours.size();
  write_report(options.is_report_json, outputs, report);
}

void run_field(const Command_options& options)
{
  const std::vector<std::filesystem::path> outputs(options.output_paths.begin(), options.output_paths.end());
  check_outputs(outputs, input_files(options.input));
  for(const std::string& path : options.output_paths)
    check_numbers_format(path);
  Work_report report;
  Mesh mesh = read_mesh(options.input, report);
  const Scalar_map scalar_map = add_field(options.input, mesh, report);
  timed(report, "output", [&] {
    Output_group files;
    for(const std::string& path : options.output_paths)
      write_scalars(path, mesh.surface, scalar_map);
    files.put_in_place();
  });
  const Field_range range(scalar_map.begin(), scalar_map.end());
  write_report(options.is_report_json, outputs, range, report);
}

} // namespace reeb_graph_program
