// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/costs.h"
#include "commands/commands.h"
#include "computation/skeleton.h"
#include "input/field_input.h"
#include "input/repair_soup.h"
#include "output/graph_output.h"
#include "output/mesh_output.h"
#include "output/output_file.h"
#include "output/report_output.h"
#include "output/skeleton_output.h"
#include "page/page_output.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace reeb_graph_program {
namespace {
bool has_field(const Input_options& input) { return !input.field.empty() || !input.scalars_path.empty(); }

bool are_paths_wanted(const Skeleton_command_options& options) { return !options.from.empty() || !options.to.empty(); }

std::vector<std::filesystem::path> check_options(const Skeleton_command_options& options)
{
  std::vector<std::filesystem::path> outputs;
  for(const std::string& path : options.output_paths)
  {
    (are_paths_wanted(options) ? check_path_format : check_skeleton_format)(path);
    outputs.emplace_back(path);
  }
  const auto is_swc = [](const std::filesystem::path& path) { return path.extension() == ".swc"; };
  if((options.swc.are_radii_inscribed || options.swc.type != Swc_options().type)
     && std::none_of(outputs.begin(), outputs.end(), is_swc))
    throw std::runtime_error("--radius and --swc-type go with a file .swc only");
  check_page(options.page_path, options.up);
  if(!options.mesh_path.empty())
    check_format_with_numbers(options.mesh_path);
  outputs.insert(outputs.end(), {options.mesh_path, options.pieces_path, options.page_path});
  if(!(options.settings.pruning_ratio >= 0))
    throw std::runtime_error("--pruning-ratio must not be negative or NaN");
  if(!(options.settings.sampling_ratio >= 0.01 && options.settings.sampling_ratio <= 100))
    throw std::runtime_error("--sampling-ratio has to be from 0.01 to 100");
  if(!(options.settings.spacing >= 0))
    throw std::runtime_error("--spacing must not be negative or NaN");
  if(!(options.input.least_share >= 0 && options.input.least_share <= 1))
    throw std::runtime_error("--least-piece has to be from 0 to 1");
  if(!(options.settings.smooth >= 0 && options.settings.smooth <= 100))
    throw std::runtime_error("--smooth has to be from 0 to 100");
  check_outputs(outputs, input_files(options.input));
  return outputs;
}

} // namespace

void run_skeleton(const Skeleton_command_options& options)
{
  const std::vector<std::filesystem::path> outputs = check_options(options);
  Skeleton_report report;
  Input_options input = options.input;
  input.is_repaired = input.is_border_taken = !input.is_strict;
  if(!has_field(input))
    input.field = "geodesic";
  Surface surface = read_surface("skeleton", input, report);
  if(surface.number_of_faces() == 0)
    throw std::runtime_error(report.input->kept_faces() == 0 ? "the mesh has no faces, and so no skeleton"
                                                             : "repairing leaves no faces, and so no skeleton");
  report.input->inside_out_solids = count_inside_out_solids(surface);
  std::optional<Scalar_map> scalar_map;
  if(has_field(options.input))
    scalar_map = timed(report, "field", [&] { return add_field(input, surface, report); });
  report.field = has_field(options.input) ? field_label(input, "").name : "distance from a tip";
  const Stopwatch stopwatch;
  report.skeleton = extract_skeleton(surface, scalar_map, options.settings);
  if(are_paths_wanted(options))
  {
    const std::vector<Skeleton_place> thickest = {{Skeleton_place::THICKEST}}, tips = {{Skeleton_place::TIPS}};
    find_paths(report.skeleton, options.from.empty() ? thickest : options.from, options.to.empty() ? tips : options.to);
    if(report.skeleton.paths.empty())
      throw std::runtime_error("no path leads along the skeleton from one of these places to another point of it");
  }
  report.add_seconds("skeleton", stopwatch.seconds());
  const Stopwatch output_stopwatch;
  Output_group files;
  for(const std::string& path : options.output_paths)
  {
    write_skeleton(path, report.skeleton, options.swc);
    note_lost_parts(path, report.skeleton, report.notes);
  }
  if(!options.mesh_path.empty())
    write_skeleton_mesh(options.mesh_path, surface, report.skeleton);
  if(!options.pieces_path.empty())
  {
    write_pieces(options.pieces_path, surface, report.skeleton.face_arcs);
    note_branches_without_face(report.skeleton, report.notes);
  }
  if(!options.page_path.empty())
  {
    const auto& known = report.skeleton.certificate;
    write_page(options.page_path, {surface, report.skeleton,
                                   name_of_input(options.input.mesh_path) + ": skeleton with "
                                     + count(known.number_of_ends, "end") + ", " + count(known.number_of_loops, "loop"),
                                   options.unit, options.up});
  }
  files.put_in_place();
  note_inside_out(report.skeleton, report.notes);
  note_lost_numbers(report.skeleton, report.notes);
  note_lost_unit(options.unit, !options.page_path.empty(), report.notes);
  if(std::any_of(outputs.begin(), outputs.end(), [](const auto& path) { return !path.empty(); }))
    report.add_seconds("output", output_stopwatch.seconds());
  write_report(options.is_report_json, outputs, report);
}

} // namespace reeb_graph_program
