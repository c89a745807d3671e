// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/report_output.h"
#include "output/report_parts.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace reeb_graph_program {
namespace {
// Of an oriented connected surface.
std::optional<long> genus_of(const Soup_counts& counts)
{
  const long twice = 2 - counts.euler_characteristic() - static_cast<long>(counts.border_loops);
  return counts.is_surface() && counts.components == 1 && twice % 2 == 0 ? std::make_optional(twice / 2) : std::nullopt;
}

void write_faults(std::ostream& out, const Soup_counts& counts)
{
  if(counts.edges_of_many_faces > 0)
    out << "         " << count(counts.edges_of_many_faces, "edge") << " with more than two faces\n";
  if(counts.vertices_of_several_fans > 0)
    out << "         " << count(counts.vertices_of_several_fans, "vertex", "vertices")
        << " whose faces form several fans\n";
  if(counts.edges_without_orientation > 0)
    out << "         " << count(counts.edges_without_orientation, "edge")
        << " along which both faces run in the same direction\n";
}

void write_mesh_counts(std::ostream& out, const std::string& title, const Soup_counts& counts)
{
  out << title << count(counts.vertices, "vertex", "vertices") << ", " << count(counts.edges, "edge") << ", "
      << count(counts.faces, "face") << "\n         " << count(counts.components, "component") << ", "
      << count(counts.border_loops, "border loop") << ", Euler characteristic " << counts.euler_characteristic();
  if(const auto genus = genus_of(counts))
    out << ", genus " << *genus;
  out << '\n';
  write_faults(out, counts);
}

nlohmann::ordered_json json_of(const Soup_counts& counts)
{
  nlohmann::ordered_json json;
  json["vertices"] = counts.vertices;
  json["edges"] = counts.edges;
  json["faces"] = counts.faces;
  json["components"] = counts.components;
  json["border_loops"] = counts.border_loops;
  json["euler_characteristic"] = counts.euler_characteristic();
  json["genus"] = nullptr;
  if(const auto genus = genus_of(counts))
    json["genus"] = *genus;
  json["edges_of_many_faces"] = counts.edges_of_many_faces;
  json["vertices_of_several_fans"] = counts.vertices_of_several_fans;
  json["edges_without_orientation"] = counts.edges_without_orientation;
  return json;
}

// The numbers of a repair: their names in JSON, and what is said where one is not 0, for one and for several.
struct Step
{
  const char* name;
  std::size_t number;
  const char *singular, *plural;
};

std::vector<Step> steps_of(const Repair_counts& counts)
{
  const auto more = [](std::size_t before, std::size_t after) { return after > before ? after - before : 0; };
  return {{"merged_points", counts.merged_points, "point merged into another one", "points merged into others"},
          {"unmerged_points", counts.unmerged_points, "point that coincides with another one left",
           "points that coincide with others left"},
          {"collapsed_faces", counts.collapsed_faces, "face left out, as a merged point is at two corners",
           "faces left out, as merged points are at two corners"},
          {"faces_repeated_by_merging", counts.faces_repeated_by_merging,
           "face left out, as merging makes it repeat another one",
           "faces left out, as merging makes them repeat others"},
          {"", more(counts.given.edges_of_many_faces, counts.merged.edges_of_many_faces),
           "edge got more than two faces by merging", "edges got more than two faces by merging"},
          {"", more(counts.given.vertices_of_several_fans, counts.merged.vertices_of_several_fans),
           "vertex got several fans of faces by merging", "vertices got several fans of faces by merging"},
          {"cancelled_faces", counts.cancelled_faces, "face cancelled by one the other way round",
           "faces cancelled by others the other way round"},
          {"sheets", counts.sheets, "sheet was there on both sides: one is kept",
           "sheets were there on both sides: one of each is kept"},
          {"paired_edges", counts.paired_edges, "edge with more than two faces, where these are paired",
           "edges with more than two faces, where these are paired"},
          {"unpaired_faces", counts.unpaired_sides, "face cut off at an edge", "faces cut off at edges"},
          {"added_points", counts.added_points, "point added by splitting", "points added by splitting"},
          {"added_midpoints", counts.added_midpoints, "of these on an edge or face", "of these on edges and faces"},
          {"reversed_faces", counts.reversed_faces, "face reversed", "faces reversed"},
          {"small_pieces", counts.small_pieces, "component with too small an area left out",
           "components with too small an area left out"},
          {"pieces_without_volume", counts.pieces_without_volume, "component without volume left out",
           "components without volume left out"},
          {"faces_of_pieces", counts.faces_of_pieces, "face of these", "faces of these"},
          {"filled_borders", counts.filled_borders, "border filled", "borders filled"},
          {"filling_faces", counts.filling_faces, "face for that", "faces for that"},
          {"faces_of_other_components", counts.other_faces, "face of other components left out",
           "faces of other components left out"}};
}

} // namespace

void write_steps(std::ostream& out, const Repair_counts& counts)
{
  for(const Step& step : steps_of(counts))
    if(step.number > 0)
      out << "         " << count(step.number, step.singular, step.plural) << '\n';
}

void add_steps(nlohmann::ordered_json& json, const Repair_counts& counts)
{
  for(const Step& step : steps_of(counts))
    if(*step.name != '\0')
      json[step.name] = step.number;
}

void write_text(std::ostream& out, const Repair_report& report)
{
  const Repair_counts& counts = report.counts;
  write_mesh_counts(out, "given    ", counts.given);
  write_input_text(out, report);
  out << "repair\n";
  if(report.lines_left_out > 0)
    out << "         " << count(report.lines_left_out, "line left out", "lines left out") << '\n';
  write_steps(out, counts);
  for(const Merged_field& field : report.fields)
    if(field.differing_points > 0)
      out << "         " << field.name << " differs at " << count(field.differing_points, "merged point")
          << ", by at most " << field.largest_difference << '\n';
  for(const std::string& name : report.lost_fields)
    out << "         " << name << " is lost, as only PLY and VTP have fields, of one number for each vertex\n";
  write_mesh_counts(out, "result   ", counts.result);
}

void write_json(std::ostream& out, const Repair_report& report)
{
  const Repair_counts& counts = report.counts;
  nlohmann::ordered_json json;
  json["given"] = json_of(counts.given);
  json["merged"] = json_of(counts.merged);
  json["result"] = json_of(counts.result);
  add_steps(json, counts);
  json["lines_left_out"] = report.lines_left_out;
  json["fields"] = nlohmann::ordered_json::array();
  for(const Merged_field& field : report.fields)
    json["fields"].push_back({{"name", field.name},
                              {"differing_points", field.differing_points},
                              {"largest_difference", field.largest_difference}});
  json["lost_fields"] = report.lost_fields;
  add_field_and_costs(json, report);
  write_line(out, json);
}

} // namespace reeb_graph_program
