// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/costs.h"
#include "base/progress_bar.h"
#include "base/surface.h"
#include "commands/commands.h"
#include "input/assemble_surface.h"
#include "input/input_error.h"
#include "input/merge_points.h"
#include "input/mesh_formats.h"
#include "input/repair_soup.h"
#include "output/mesh_output.h"
#include "output/output_file.h"
#include "output/report_output.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
// How much a field of the given vertices differs where they have become one.
template <class Map>
Merged_field compare(const std::string& name, const Map& field, const Repair_result& result)
{
  Merged_field merged;
  merged.name = name;
  for(std::size_t v = 0; v < result.new_vertices.size(); ++v)
  {
    if(result.new_vertices[v] == no_vertex)
      continue;
    const auto value = static_cast<double>(field[Surface::Vertex_index(static_cast<Surface::size_type>(v))]);
    const std::size_t kept = result.old_vertices[result.new_vertices[v]];
    const auto kept_value = static_cast<double>(field[Surface::Vertex_index(static_cast<Surface::size_type>(kept))]);
    if(value == kept_value || (std::isnan(value) && std::isnan(kept_value)))
      continue;
    ++merged.differing_points;
    merged.largest_difference = std::max(merged.largest_difference, std::abs(value - kept_value));
  }
  return merged;
}

// Gives the repaired surface the numbers that the file has for its vertices, if there is room for them.
void add_fields(const Repair_command_options& options,
                const Repair_result& result,
                Surface& surface,
                Repair_report& report)
{
  const std::vector<std::string>& outputs = options.output_paths;
  report.lost_fields =
    fields_not_kept(options.input.mesh_path, std::all_of(outputs.begin(), outputs.end(), has_room_for_numbers));
  for(const std::string& output : outputs)
    note_lost_parts(output, options.input.mesh_path, report.notes);
  if(std::none_of(outputs.begin(), outputs.end(), has_room_for_numbers))
    return;
  Surface given;
  for(std::size_t i = 0; i < result.new_vertices.size(); ++i)
    given.add_vertex(Point(0, 0, 0));
  read_vertex_properties(options.input.mesh_path, given);
  visit_vertex_properties(given, [&](const std::string& name, const auto& field) {
    typedef typename std::decay_t<decltype(field)>::value_type Number;
    const auto map = surface.add_property_map<Surface::Vertex_index, Number>("v:" + name).first;
    for(const Surface::Vertex_index v : surface.vertices())
    {
      const auto at = [&](std::size_t old) {
        return field[Surface::Vertex_index(static_cast<Surface::size_type>(old))];
      };
      map[v] = at(result.old_vertices[v]);
      if(std::is_floating_point_v<Number> && result.other_ends[v] != result.old_vertices[v])
        map[v] = static_cast<Number>(map[v] / 2 + at(result.other_ends[v]) / 2);
    }
    report.fields.push_back(compare(name, field, result));
  });
}

std::vector<std::int64_t> map_of(const std::vector<std::size_t>& new_vertices)
{
  std::vector<std::int64_t> map;
  for(const std::size_t v : new_vertices)
    map.push_back(v == no_vertex ? -1 : static_cast<std::int64_t>(v));
  return map;
}

} // namespace

void run_repair(const Repair_command_options& options)
{
  std::vector<std::filesystem::path> outputs = {options.map_path};
  for(const std::string& path : options.output_paths)
  {
    check_mesh_format(path);
    outputs.emplace_back(path);
  }
  check_outputs(outputs, input_files(options.input));
  check_numbers_format(options.map_path);
  Repair_report report;
  const Stopwatch stopwatch;
  std::optional<Progress_bar> progress_bar(std::in_place, "reading");
  Input_findings findings;
  Polygon_soup soup = read_checked_soup(options.input.mesh_path, true, "", findings);
  if(!soup.tetrahedra.empty())
    take_border_of_tetrahedra(soup);
  if(soup.polygons.size() == 0 && !soup.edges.empty())
    throw Input_error(options.input.mesh_path, "repair needs faces, and the mesh has lines alone");
  leave_out_repeated_faces(soup, findings);
  if(options.input.are_faces_triangulated)
  {
    Polygon_soup triangles = soup;
    triangulate_faces(triangles, options.input.mesh_path, findings); // which names the face that it cannot cut
    if(!options.repair.are_opposite_faces_cancelled)
      soup = std::move(triangles);
  }
  look_over_points(soup, border_points(soup.polygons), findings);
  findings.inside_out_solids = find_inside_out(soup).solids;
  report.input = findings;
  report.notes = soup.notes;
  report.lines_left_out = soup.edges.size();
  report.add_seconds("read", stopwatch.seconds());
  const Stopwatch repair_stopwatch;
  progress_bar.emplace("repair");
  Repair_options repair = options.repair;
  repair.are_faces_triangulated = options.input.are_faces_triangulated;
  const Repair_result result = repair_soup(soup, repair);
  report.counts = result.counts;
  Surface surface = unconnected_surface(soup.points, soup.polygons);
  add_fields(options, result, surface, report);
  report.add_seconds("repair", repair_stopwatch.seconds());
  timed(report, "output", [&] {
    Output_group files;
    for(const std::string& path : options.output_paths)
      write_surface(path, surface, report.notes);
    if(!options.map_path.empty())
      write_numbers(options.map_path, map_of(result.new_vertices));
    files.put_in_place();
  });
  write_report(options.is_report_json, outputs, report);
}

} // namespace reeb_graph_program
