// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/costs.h"
#include "commands/commands.h"
#include "computation/Mesh_graph.h"
#include "computation/handles.h"
#include "input/field_input.h"
#include "input/mesh_formats.h"
#include "input/repair_soup.h"
#include "output/graph_output.h"
#include "output/mesh_output.h"
#include "output/output_file.h"
#include "output/polylines_output.h"
#include "output/report_output.h"
#include "page/page_output.h"

#include <cstddef>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

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

bool is_any_removed(const Handles_options& options) { return options.size_to_remove || options.number_to_remove; }

std::vector<std::filesystem::path> check_options(const Handles_options& options)
{
  check_loops_format(options.loops_path);
  check_page(options.page_path, options.up);
  std::vector<std::filesystem::path> outputs = {options.loops_path, options.page_path};
  if(is_any_removed(options) && options.output_paths.empty())
    throw std::runtime_error("--remove-below and --remove go with --output");
  for(const std::string& path : options.output_paths)
  {
    if(is_any_removed(options))
      check_mesh_format(path);
    else
      check_loops_format(path, "loops (a mesh goes with --remove-below or --remove)");
    outputs.emplace_back(path);
  }
  check_outputs(outputs, input_files(options.input));
  return outputs;
}

void remove(const Handles_options& options, Surface& surface, Scalar_map scalar_map, Handles_report& report)
{
  const Timed_step timed(report, "removal");
  report.removals = remove_handles(
    surface, scalar_map, properties_to_keep(options.input.mesh_path, options.output_paths, surface, report.notes),
    options.size_to_remove, options.number_to_remove.value_or((std::numeric_limits<std::size_t>::max)()),
    options.are_self_intersections_ignored);
}

// The page shows the Reeb graph of the field with the loops.
void write_page_of_loops(const Handles_options& options,
                         const Mesh& mesh,
                         Scalar_map scalar_map,
                         const Loops_of_surface& loops,
                         const std::string& field)
{
  const auto graph = compute_mesh_graph(mesh, scalar_map, Graph_options());
  Page_request request = {scalar_map, *graph, name_of_input(options.input.mesh_path), {field, options.unit}};
  request.up = options.up;
  request.curves = loops.polylines;
  request.loops = loops.rows;
  write_page(options.page_path, request);
}

} // namespace

void run_handles(const Handles_options& options)
{
  const std::vector<std::filesystem::path> outputs = check_options(options);
  Handles_report report;
  Input_options input = options.input;
  input.is_repaired = input.is_border_taken = !input.is_strict;
  if(input.field.empty() && input.scalars_path.empty())
    input.field = "z"; // until the mesh is known
  Mesh mesh;
  mesh.surface = read_surface("handles", input, report);
  Surface& surface = mesh.surface;
  report.input->inside_out_solids = count_inside_out_solids(surface);
  const Scalar_map scalar_map =
    timed(report, "field", [&] { return add_field_or_height(options.input, surface, report); });
  if(is_any_removed(options))
    remove(options, surface, scalar_map, report);
  const Loops_of_surface loops = timed(report, "handles", [&] {
    return find_loops(surface, scalar_map, options.are_loops_shortened, options.are_self_intersections_ignored);
  });
  report.loops = loops.rows;
  report.self_intersections = loops.self_intersections;
  report.are_self_intersections_ignored = options.are_self_intersections_ignored;
  const Stopwatch output_stopwatch;
  Output_group files;
  for(const std::string& path : options.output_paths)
    if(is_any_removed(options))
      write_surface(path, surface, report.notes);
    else
      write_loops(path, loops);
  if(!options.loops_path.empty())
    write_loops(options.loops_path, loops);
  if(!options.page_path.empty())
    write_page_of_loops(options, mesh, scalar_map, loops, report.field);
  files.put_in_place();
  note_lost_unit(options.unit, !options.page_path.empty(), report.notes);
  if(!options.output_paths.empty() || !options.loops_path.empty() || !options.page_path.empty())
    report.add_seconds("output", output_stopwatch.seconds());
  write_report(options.is_report_json, outputs, report);
}

} // namespace reeb_graph_program
