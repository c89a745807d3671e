// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/standard_input.h"
#include "base/surface.h"
#include "commands/commands.h"
#include "computation/Mesh_graph.h"
#include "computation/scalar_fields.h"
#include "computation/simplification.h"
#include "input/field_input.h"
#include "input/input_error.h"
#include "output/graph_output.h"
#include "output/mesh_output.h"
#include "output/output_file.h"
#include "output/polylines_output.h"
#include "output/report_output.h"
#include "page/page_output.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace reeb_graph_program {
namespace {
constexpr const char* unit_gradient = "unit-gradient"; // a parametrization; any other one is a file

void check_options(const Contour_options& options)
{
  const Contour_choice& choice = options.choice;
  if(choice.arc && !choice.t)
    throw std::runtime_error("--arc goes with --t only");
  if(!options.parametrization.empty() && !choice.t)
    throw std::runtime_error("--parametrize goes with --t only");
  if(is_standard_input(options.parametrization))
    throw std::runtime_error("--parametrize takes a file, and not standard input");
  if(int(choice.t.has_value()) + int(!choice.levels.empty()) + int(choice.number_of_levels.has_value())
       + int(choice.point.has_value())
     != 1)
    throw std::runtime_error("just one of --t, --level, --levels, and --closest is needed");
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

// Returns the files that are written.
std::vector<std::filesystem::path> check_files(const Contour_options& options)
{
  if(options.output_paths.empty() && options.page_path.empty())
    throw std::runtime_error("one of --output and --html is needed");
  for(const std::string& path : options.output_paths)
    check_contour_format(path);
  check_page(options.page_path, options.up, options.input.is_strict);
  std::vector<std::filesystem::path> inputs = input_files(options.input);
  if(!options.parametrization.empty() && options.parametrization != unit_gradient)
    inputs.emplace_back(options.parametrization);
  std::vector<std::filesystem::path> outputs(options.output_paths.begin(), options.output_paths.end());
  outputs.emplace_back(options.page_path);
  check_outputs(outputs, inputs);
  return outputs;
}

// The numbers by which t is measured.
std::vector<double> parametrize(const std::string& parametrization,
                                Mesh& mesh,
                                Scalar_map scalar_map,
                                Contours_report& report)
{
  if(parametrization.empty())
    return {};
  const Timed_step timed(report, "parametrization");
  if(parametrization == unit_gradient)
    return compute_unit_gradient(mesh.surface, scalar_map, report);
  const Scalar_map map = mesh.surface.add_property_map<Surface::Vertex_index, double>("v:parametrization").first;
  read_scalars(parametrization, "", mesh.surface, map);
  return {map.begin(), map.end()};
}

// Throws Input_error if that cannot be done on the mesh.
void check_for_complex(const Contour_options& options, const Mesh& mesh)
{
  const bool is_of_unit_gradient = options.parametrization == unit_gradient;
  for(const char* what :
      {"contour", is_of_unit_gradient ? "the field unit-gradient" : "", options.page_path.empty() ? "" : "--html"})
    if(const std::string reason = reason_against(what, mesh); !reason.empty())
      throw Input_error(options.input.mesh_path, reason);
}

// The page shows the Reeb graph with the contours.
void write_page_of_contours(const Contour_options& options,
                            Scalar_map scalar_map,
                            Mesh_graph& graph,
                            const std::vector<Contour>& contours)
{
  Page_request request = {scalar_map,
                          graph,
                          name_of_input(options.input.mesh_path),
                          field_label(options.input, options.unit),
                          options.choice.simplification,
                          options.up};
  for(const Contour& contour : contours)
    for(const std::vector<std::size_t>& line : contour.polylines)
    {
      Polyline& curve = request.curves.emplace_back();
      for(const std::size_t i : line)
        curve.push_back(contour.points[i]);
    }
  write_page(options.page_path, request);
}

} // namespace

void run_contour(const Contour_options& options)
{
  check_options(options);
  const std::vector<std::filesystem::path> outputs = check_files(options);
  check_simplification_options(options.choice.simplification);
  Contours_report report;
  Input_options input = options.input;
  input.is_repaired = !input.is_strict && !options.page_path.empty();
  Mesh mesh = read_mesh(input, report);
  check_for_complex(options, mesh);
  const bool has_tetrahedra = mesh.complex && !mesh.complex->tetrahedra.empty();
  for(const std::string& path : options.output_paths)
    check_contour_format(path, has_tetrahedra);
  const Scalar_map scalar_map = add_field(input, mesh, report);
  Contour_choice choice = options.choice;
  choice.parametrization = parametrize(options.parametrization, mesh, scalar_map, report);
  choice.graph.are_places_wanted = !options.page_path.empty();
  Report graph_report;
  const std::unique_ptr<Mesh_graph> graph =
    compute_mesh_graph(mesh, scalar_map, choice.graph, choice.simplification,
                       threshold_in_units(choice.simplification, mesh.surface, scalar_map), graph_report);
  const std::vector<Contour> contours = graph->find_contours(choice);
  Output_group files;
  for(const std::string& path : options.output_paths)
    write_contours(path, contours, has_tetrahedra);
  if(!options.page_path.empty())
    write_page_of_contours(options, scalar_map, *graph, contours);
  files.put_in_place();
  note_empty_levels(choice.levels, contours, report);
  note_lost_unit(options.unit, !options.page_path.empty(), report.notes);
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
