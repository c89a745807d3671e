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
#include "computation/curves.h"
#include "computation/simplification.h"
#include "input/field_input.h"
#include "input/mesh_formats.h"
#include "output/graph_output.h"
#include "output/mesh_output.h"
#include "output/output_file.h"
#include "output/polylines_output.h"
#include "output/report_output.h"
#include "page/page_output.h"

#include <CGAL/Reeb_graph/curves/exceptions.h>
#include <CGAL/boost/graph/helpers.h>

#include <iostream>
#include <limits>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
constexpr const char* polylines_ending = ".polylines.txt";

void check_thresholds(const Cut_options& options)
{
  for(const auto& [name, threshold] :
      {std::make_pair("--persistence", options.persistence), std::make_pair("--area", options.area)})
  {
    if(threshold && options.type != Curves_type::BRANCH)
      throw std::runtime_error(std::string(name) + " goes with the type branch only");
    if(threshold && !(*threshold >= 0))
      throw std::runtime_error(std::string(name) + " must not be negative or NaN");
  }
}

void check_levels_and_disks(const Curves_options& options)
{
  const Level_choice& levels = options.cut.levels;
  const int number = int(!levels.values.empty()) + int(levels.number.has_value()) + int(levels.spacing.has_value());
  const bool are_levels = options.cut.type == Curves_type::LEVELS, are_disks = options.cut.type == Curves_type::DISKS;
  if(are_levels && number != 1)
    throw std::runtime_error("one of --level, --levels, and --spacing is needed for the type levels");
  if(!are_levels && number != 0)
    throw std::runtime_error("--level, --levels, and --spacing go with the type levels only");
  if((are_levels || are_disks) && options.cut.borders)
    throw std::runtime_error("--borders does not go with the types levels and disks, which never change the field");
  if(!are_disks && !options.vertex_map_path.empty())
    throw std::runtime_error("--vertex-map goes with the type disks only");
}

void check_formats(const Curves_options& options)
{
  if(options.cut.type == Curves_type::LEVELS)
    check_contour_format(options.curves_path, false);
  else
    check_polylines_format(options.curves_path);
  check_mesh_format(options.cut_mesh_path);
  check_graph_format(options.graph_path);
  check_mesh_format(options.mesh_path);
  check_page(options.page_path, options.up);
}

std::vector<std::filesystem::path> output_files(const Curves_options& options)
{
  std::vector<std::filesystem::path> paths = graph_files(options.graph_path);
  paths.insert(paths.end(), {options.curves_path, options.cut_mesh_path, options.patches_path, options.pieces_path,
                             options.vertex_map_path, options.mesh_path, options.page_path});
  return paths;
}

// Whether curves are written with the arcs that they belong to.
bool are_arcs_written(const Curves_options& options)
{
  return options.cut.type == Curves_type::LEVELS && !options.curves_path.empty()
      && ending_of(options.curves_path, "curves", {polylines_ending, ".csv", ".vtp", ".obj", ".json"})
           != polylines_ending;
}

bool is_graph_written(const Curves_options& options)
{
  return !options.graph_path.empty() || !options.mesh_path.empty() || !options.page_path.empty();
}

// Disks need no field, unless something is asked for that shows it.
bool is_field_needed(const Curves_options& options)
{
  return options.cut.type != Curves_type::DISKS || is_graph_written(options) || !options.input.field.empty()
      || !options.input.scalars_path.empty() || options.simplification.is_anything_removed();
}

// What has been asked for in other files need not be in that of the mesh.
void note_lost_maps(const Curves_options& options, const Cut_result& result, Notes& notes)
{
  if(options.cut_mesh_path.empty() || has_room_for_numbers(options.cut_mesh_path))
    return;
  std::vector<std::string> things;
  if(options.patches_path.empty())
    things.emplace_back("patches");
  if(result.band_map)
    things.emplace_back("bands");
  if(result.original_map && options.vertex_map_path.empty())
    things.emplace_back("numbers of original vertices");
  note_left_out(options.cut_mesh_path, things, notes);
}

void write_files(const Curves_options& options, const Surface& surface, const Cut_result& result, Notes& notes)
{
  if(!options.vertex_map_path.empty())
    write_numbers<std::int64_t>(options.vertex_map_path, {result.original_map->begin(), result.original_map->end()});
  if(!options.curves_path.empty() && !are_arcs_written(options))
    write_polylines(options.curves_path, result.polylines);
  if(!options.cut_mesh_path.empty())
    write_surface_with_patches(options.cut_mesh_path, surface, result.patch_map, notes);
  if(!options.patches_path.empty())
    write_numbers<std::int64_t>(options.patches_path, {result.patch_map.begin(), result.patch_map.end()});
  if(!options.pieces_path.empty())
    write_pieces(options.pieces_path, surface, {result.patch_map.begin(), result.patch_map.end()});
}

void write_graph_file(const Curves_options& options, Mesh_graph& graph)
{
  std::vector<CGAL::Reeb_graph::Attribute> attributes;
  if(has_arc_attributes(options.graph_path))
    attributes = graph.arc_table().attributes();
  if(is_format_in_space(options.graph_path))
  {
    const Embedding embedding = graph.embed(CGAL::Reeb_graph::Embedding_manner::BY_COST);
    return write_graph_in_space(options.graph_path, graph.result(), embedding, attributes,
                                [&](std::ostream& stream) { graph.write_json(stream, embedding, attributes, 0); });
  }
  write_graph(options.graph_path, graph.result(), field_label(options.input, options.unit), own_numbers, attributes);
}

void write_page_of_curves(const Curves_options& options,
                          Scalar_map scalar_map,
                          Mesh_graph& graph,
                          const std::vector<Polyline>& curves,
                          const std::optional<Patch_map>& patch_map,
                          Curves_report& report)
{
  const Timed_step timed(report, "page");
  Page_request request = {scalar_map, graph, name_of_input(options.input.mesh_path),
                          field_label(options.input, options.unit)};
  request.up = options.up;
  request.patch_map = patch_map;
  request.curves = curves;
  write_page(options.page_path, request);
}

// The page of disks shows the mesh as it was before, as a cut leaves little of its graph.
void write_page_of_disks(const Curves_options& options, Mesh& whole, const Cut_result& result, Curves_report& report)
{
  const Scalar_map scalar_map = whole.surface.add_property_map<Surface::Vertex_index, double>("v:scalar").first;
  const auto graph = compute_mesh_graph(whole, scalar_map, options.graph);
  write_page_of_curves(options, scalar_map, *graph, result.polylines, std::nullopt, report);
}

// What shows the graph of the field on the cut mesh: the graph file, the mesh with results, and the page have the same
// nodes and arcs.
void write_files_of_graph(const Curves_options& options,
                          const Mesh& mesh,
                          Scalar_map scalar_map,
                          const Cut_result& result,
                          Curves_report& report)
{
  if(!is_graph_written(options) && !are_arcs_written(options))
    return;
  Report unused;
  Graph_options graph_options = options.graph;
  graph_options.are_places_wanted = !options.mesh_path.empty() || !options.page_path.empty()
                                 || (!options.graph_path.empty() && has_arc_attributes(options.graph_path));
  const auto graph = timed(report, "graph", [&] {
    auto graph = compute_mesh_graph(mesh, scalar_map, graph_options, {}, 0, unused);
    if(!options.graph_path.empty())
    {
      write_graph_file(options, *graph);
      note_lost_nodes(options.graph_path, graph->result(), report.notes);
    }
    if(are_arcs_written(options))
      write_contours(options.curves_path, contours_of_levels(result, scalar_map, *graph), false);
    return graph;
  });
  if(!options.mesh_path.empty())
  {
    const Timed_step timed(report, "mesh");
    write_mesh(options.mesh_path, mesh.surface,
               {scalar_map, graph->places(), num_vertices(graph->result()), result.patch_map, result.band_map,
                result.original_map},
               report.notes);
  }
  if(!options.page_path.empty())
    write_page_of_curves(options, scalar_map, *graph, result.polylines, result.patch_map, report);
}

// The mesh, and the field, which is harmonic if none is asked for: between the borders if there are any. Disks need
// none.
Surface read(Input_options& input, bool is_field_needed, Curves_report& report)
{
  if(!is_field_needed)
  {
    Input_options without_field = input;
    without_field.field = "z"; // which needs nothing of the file
    return read_surface("curves", without_field, report);
  }
  const bool is_default = input.field.empty() && input.scalars_path.empty();
  if(is_default)
    input.field = "harmonic";
  Surface surface = read_surface("curves", input, report);
  const bool has_borders = !CGAL::is_closed(surface);
  if(is_default && has_borders && !input.lowest_vertex)
    input.field = "harmonic-between-borders";
  if(is_default)
    report.notes.push_back("the field is " + input.field + ", as the mesh has "
                           + (has_borders ? "borders" : "no borders") + "; --field takes another one");
  else if(input.field == "harmonic" && has_borders && !input.lowest_vertex)
    report.notes.push_back("harmonic is between two vertices, for curves too; harmonic-between-borders is the field "
                           "that curves called harmonic before");
  report.field_name = field_label(input, "").name;
  return surface;
}

// Writes the simplified field over the given one.
void simplify(const Mesh& mesh, Scalar_map scalar_map, const Simplification_options& options, Curves_report& report)
{
  const Timed_step timed(report, "simplified field");
  Graph_options graph_options;
  graph_options.are_places_wanted = true;
  Report unused;
  const auto graph = compute_mesh_graph(mesh, scalar_map, graph_options, options,
                                        threshold_in_units(options, mesh.surface, scalar_map), unused);
  report.are_ties_contracted =
    compute_simplified_field(mesh, scalar_map, *graph, graph_options, options, scalar_map).are_ties_contracted;
  if(report.are_ties_contracted)
    std::cerr << "contracted ties of the simplified field: what is removed has the value of its saddle\n";
}

Cut_result cut(Surface& surface, Scalar_map scalar_map, const Curves_options& options, Curves_report& report)
{
  std::vector<Any_vertex_property> properties;
  if(!options.cut_mesh_path.empty())
    properties = properties_to_keep(options.input.mesh_path, {options.cut_mesh_path}, surface, report.notes);
  if(options.cut.type == Curves_type::DISKS)
  {
    if(is_field_needed(options))
      properties.emplace_back(scalar_map);
    return cut_to_disks(surface, properties);
  }
  const std::size_t given = surface.number_of_faces();
  const auto is_size_accepted = [&](std::size_t number_of_triangles) {
    if(options.is_large_accepted)
      std::cerr << "the cut mesh is going to have " << number_of_triangles << " triangles, the mesh has " << given
                << '\n';
    return options.is_large_accepted || number_of_triangles <= 50 * given;
  };
  Cut_options cut = options.cut;
  if(report.are_ties_contracted && !cut.persistence) // a branch of no height is none
    cut.persistence = std::numeric_limits<double>::denorm_min();
  try
  {
    if(options.cut.type != Curves_type::LEVELS)
      return cut_along_curves(surface, scalar_map, properties, cut, is_size_accepted);
    const std::vector<double> levels = values_of_levels(cut.levels, scalar_map);
    const Cut_result result =
      cut_along_levels(surface, scalar_map, properties, levels, cut.is_cut_open, is_size_accepted);
    for(const std::string& note : notes_on_levels(levels, result, scalar_map))
      report.notes.push_back(note);
    return result;
  }
  catch(const CGAL::Reeb_graph::Face_count_error& error)
  {
    throw std::runtime_error("the cut mesh would have " + std::to_string(error.number_of_faces())
                             + " triangles, more than 50 times the " + std::to_string(given)
                             + " of the mesh: --large cuts it all the same");
  }
  catch(const CGAL::Reeb_graph::Border_level_error& error)
  {
    const std::string message = error.what(); // which ends in a way out that is one of the library
    throw std::runtime_error(message.substr(0, message.find(';'))
                             + "; --borders make-level changes the field so that it does");
  }
}

} // namespace

void run_curves(Curves_options options)
{
  check_thresholds(options.cut);
  check_levels_and_disks(options);
  check_formats(options);
  check_simplification_options(options.simplification);
  check_simplification_of_field(options.simplification);
  const std::vector<std::filesystem::path> outputs = output_files(options);
  check_outputs(outputs, input_files(options.input));
  check_numbers_format(options.patches_path);
  check_numbers_format(options.vertex_map_path);
  Curves_report report;
  const bool has_field = is_field_needed(options);
  Mesh mesh;
  mesh.surface = read(options.input, has_field, report);
  Surface& surface = mesh.surface;
  const Scalar_map scalar_map = has_field ? add_field(options.input, surface, report) : Scalar_map();
  if(options.simplification.is_anything_removed())
    simplify(mesh, scalar_map, options.simplification, report);
  Mesh whole;
  const bool is_whole_shown = options.cut.type == Curves_type::DISKS && !options.page_path.empty();
  if(is_whole_shown)
    whole.surface = surface;
  const Cut_result result = timed(report, "cut", [&] { return cut(surface, scalar_map, options, report); });
  Output_group files;
  timed(report, "output", [&] { write_files(options, surface, result, report.notes); });
  note_lost_maps(options, result, report.notes);
  if(is_whole_shown)
  {
    write_page_of_disks(options, whole, result, report);
    options.page_path.clear();
  }
  write_files_of_graph(options, mesh, scalar_map, result, report);
  files.put_in_place();
  note_lost_unit(options.unit,
                 is_whole_shown || !options.page_path.empty()
                   || std::filesystem::path(options.graph_path).extension() == ".svg",
                 report.notes);
  report.curves = result.polylines.size();
  report.patches = result.number_of_patches;
  report.border_changes = result.border_changes;
  report.levels = result.level_report;
  write_border_changes(std::cerr, report.border_changes);
  write_report(options.is_report_json, outputs, report);
}

} // namespace reeb_graph_program
