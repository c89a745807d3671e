// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/report_output.h"

#include "base/costs.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
nlohmann::ordered_json json_of(const std::vector<Fixed_values::Place>& places)
{
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for(const Fixed_values::Place& place : places)
    json.push_back({{"vertex", place.vertex}, {"value", place.value}});
  return json;
}

nlohmann::ordered_json json_of(const Input_findings& input)
{
  const Close_points& points = input.close_points;
  return {{"faces", input.faces},
          {"kept_faces", input.kept_faces()},
          {"faces_with_repeated_corner", input.degenerate_faces.size()},
          {"first_face_with_repeated_corner", first_of(input.degenerate_faces)},
          {"faces_with_few_corners", input.faces_of_few_corners},
          {"repeated_faces", input.repeated_faces.size()},
          {"first_repeated_face", first_of(input.repeated_faces)},
          {"isolated_points", input.isolated_points},
          {"inside_out_solids", input.inside_out_solids},
          {"coinciding_border_points", points.coinciding},
          {"close_border_points", points.close},
          {"close_distance", points.largest_distance},
          {"t_junctions", points.on_edges},
          {"suggested_repair", points.is_any() ? std::make_optional(suggested_repair(points)) : std::nullopt}};
}

// The vertices with this value, of which the first few are named.
std::string names_of(const std::vector<Fixed_values::Place>& places,
                     double value,
                     const std::string& singular,
                     const std::string& plural)
{
  constexpr std::size_t most = 8;
  std::string names;
  std::size_t number = 0;
  for(const Fixed_values::Place& place : places)
    if(place.value == value && ++number <= most)
      names += (names.empty() ? " " : ", ") + std::to_string(place.vertex);
  if(number > most)
    names += " and " + std::to_string(number - most) + " more";
  return number == 0 ? names : (number == 1 ? singular : plural) + names;
}

void write_left_out_faces(std::ostream& out, const Input_findings& input)
{
  const std::size_t degenerate = input.degenerate_faces.size(), few = input.faces_of_few_corners;
  out << "file     " << count(input.faces, "face") << ", of which " << input.kept_faces() << " are kept:";
  if(degenerate > 0)
    out << ' ' << degenerate << " with " << (degenerate > few ? "a repeated corner" : "")
        << (degenerate > few && few > 0 ? ", or " : "") << (few > 0 ? "fewer than three corners" : "")
        << ", the first one, face " << input.degenerate_faces.front();
  if(!input.repeated_faces.empty())
    out << (degenerate == 0 ? " " : ", and ") << input.repeated_faces.size()
        << " that repeat earlier ones, the first one, face " << input.repeated_faces.front();
  out << '\n';
}

// What was found when the mesh was read, a line of each kind.
void write_findings(std::ostream& out, const Input_findings& input)
{
  if(input.kept_faces() != input.faces)
    write_left_out_faces(out, input);
  if(input.is_point_cloud())
    out << "points   " << input.isolated_points << " alone: a point cloud has no faces, and is not meshed here\n";
  else if(input.isolated_points > 0)
    out << "points   " << count(input.isolated_points, "isolated vertex", "isolated vertices")
        << ", of no face or edge\n";
  if(input.inside_out_solids.value_or(0) > 0)
    out << "volume   " << count(*input.inside_out_solids, "solid is", "solids are")
        << " inside out, so that the volume is negative: 'reeb_graph repair --orient' turns "
        << (input.inside_out_solids == 1 ? "it\n" : "them\n");
  const Close_points& points = input.close_points;
  if(!points.is_any())
    return;
  out << "points   ";
  std::string separator;
  const auto next = [&separator] { return std::exchange(separator, ", "); };
  if(points.coinciding > 0)
    out << next() << points.coinciding << " along borders coincide with others";
  if(points.close > 0)
    out << next() << points.close << " along borders are less than " << points.largest_distance << " from others";
  if(points.on_edges > 0)
    out << next() << points.on_edges << " along borders " << (points.on_edges == 1 ? "lies" : "lie")
        << " on edges of borders (T-junctions)";
  out << ": '" << suggested_repair(points) << (points.on_edges > 0 ? "' joins them\n" : "' merges them\n");
}

void write_fixed_values(std::ostream& out, const Fixed_values& fixed)
{
  for(const double value : {0., 1.})
  {
    const std::string borders = names_of(fixed.borders, value, "on the border of vertex", "on the borders of vertices");
    const std::string vertices = names_of(fixed.vertices, value, "at vertex", "at vertices");
    if(!borders.empty() || !vertices.empty())
      out << "         " << fixed.field << ": " << value << ' ' << borders
          << (borders.empty() || vertices.empty() ? "" : ", ") << vertices << '\n';
  }
}

} // namespace

// What doc/Reeb_graph/report.schema.json describes: a key that goes, or means something else, makes another number.
constexpr int schema_of_reports = 1;

void write_line(std::ostream& out, const nlohmann::ordered_json& json)
{
  nlohmann::ordered_json report = {{"schema", schema_of_reports}};
  report.update(json);
  out << report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

void add_field_and_costs(nlohmann::ordered_json& json, const Work_report& report)
{
  json["input"] = report.input ? json_of(*report.input) : nlohmann::ordered_json();
  if(report.repair)
  {
    json["repair"]["command"] = report.repair_command;
    add_steps(json["repair"], *report.repair);
  }
  json["added_length"] = report.field ? std::make_optional(report.field->added_length) : std::nullopt;
  json["bad_faces"] = report.field ? std::make_optional(report.field->number_of_bad_faces) : std::nullopt;
  json["fixed_values"] = nullptr;
  if(report.fixed_values)
    json["fixed_values"] = {{"vertices", json_of(report.fixed_values->vertices)},
                            {"borders", json_of(report.fixed_values->borders)}};
  json["notes"] = report.notes;
  for(const auto& [step, seconds] : report.seconds)
    json["seconds"][step] = seconds;
  json["peak_memory_bytes"] = peak_memory_bytes();
}

void write_with_costs(std::ostream& out, nlohmann::ordered_json json, const Work_report& report)
{
  add_field_and_costs(json, report);
  write_line(out, json);
}

void write_input_text(std::ostream& out, const Work_report& report)
{
  if(report.input)
    write_findings(out, *report.input);
  for(const std::string& note : report.notes)
    out << "         " << note << '\n';
  if(!report.repair)
    return;
  out << "repair   of a copy, which '" << report.repair_command << "' writes:\n";
  write_steps(out, *report.repair);
}

void write_counts(std::ostream& out, const std::string& title, const Mesh_counts& counts)
{
  out << title << count(counts.vertices, "vertex", "vertices") << ", " << count(counts.edges, "edge") << ", "
      << count(counts.faces, "face") << "\n         " << count(counts.components, "component") << ", "
      << count(counts.border_loops, "border loop") << ", Euler characteristic " << counts.euler_characteristic();
  if(const auto genus = counts.genus())
    out << ", genus " << *genus;
  out << '\n';
}

nlohmann::ordered_json json_of(const Mesh_counts& counts)
{
  return {{"vertices", counts.vertices},
          {"edges", counts.edges},
          {"faces", counts.faces},
          {"components", counts.components},
          {"border_loops", counts.border_loops},
          {"euler_characteristic", counts.euler_characteristic()},
          {"genus", counts.genus()}};
}

void write_field_text(std::ostream& out, const Work_report& report)
{
  // A field that does not depend on the geometry has none.
  const CGAL::Reeb_graph::Field_report field = report.field.value_or(CGAL::Reeb_graph::Field_report());
  if(field.number_of_bad_faces > 0)
    out << "         " << count(field.number_of_bad_faces, "face") << " without area: ";
  else if(field.added_length > 0)
    out << "         the equations are too badly conditioned: ";
  if(field.added_length > 0)
    out << "edges are taken to be longer by " << field.added_length << '\n';
  if(report.fixed_values)
    write_fixed_values(out, *report.fixed_values);
}

void write_text(std::ostream& out, const Field_range& range, const Work_report& report)
{
  out << count(range.number_of_values, "value");
  if(range.number_of_values > 0)
    out << " from " << range.lowest << " to " << range.highest;
  out << '\n';
  write_input_text(out, report);
  write_field_text(out, report);
}

void write_json(std::ostream& out, const Field_range& range, const Work_report& report)
{
  write_with_costs(out, {{"values", range.number_of_values}, {"lowest", range.lowest}, {"highest", range.highest}},
                   report);
}

void write_text(std::ostream& out, const Contours_report& report)
{
  out << count(report.contours, "contour") << '\n';
  write_input_text(out, report);
  write_field_text(out, report);
}

void write_json(std::ostream& out, const Contours_report& report)
{
  write_with_costs(out, {{"contours", report.contours}}, report);
}

void write_text(std::ostream& out, const Curves_report& report)
{
  out << count(report.curves, "curve") << ", " << count(report.patches, "patch", "patches") << '\n';
  if(report.levels)
    out << "         " << count(report.levels->number_of_levels, "level") << ", "
        << count(report.levels->number_of_added_faces, "triangle") << " added, "
        << count(report.levels->number_of_slivers, "sliver") << '\n';
  write_input_text(out, report);
  write_field_text(out, report);
}

void write_json(std::ostream& out, const Curves_report& report)
{
  const CGAL::Reeb_graph::Border_level_changes& changes = report.border_changes;
  nlohmann::ordered_json json = {
    {"curves", report.curves},
    {"patches", report.patches},
    {"borders", changes.number_of_borders},
    {"borders_made_level", changes.number_of_changed_borders},
    {"vertices_changed", changes.number_of_changed_vertices},
    {"largest_change", changes.largest_change},
    {"ties_contracted", report.are_ties_contracted},
    {"field", report.field_name.empty() ? std::nullopt : std::make_optional(report.field_name)},
    {"slivers", nullptr},
    {"levels", nullptr}};
  if(report.levels)
  {
    json["levels"] = report.levels->number_of_levels;
    json["slivers"] = report.levels->number_of_slivers;
  }
  write_with_costs(out, std::move(json), report);
}

void write_border_changes(std::ostream& out, const CGAL::Reeb_graph::Border_level_changes& changes)
{
  if(changes.number_of_changed_borders == 0)
    return;
  out << "made " << changes.number_of_changed_borders << " of " << count(changes.number_of_borders, "border")
      << " levels of the field: values of " << changes.number_of_changed_vertices << " vertices changed, by at most "
      << changes.largest_change << '\n';
}

namespace {
void write_place_text(std::ostream& out, const Loop_place& place)
{
  out << "center " << place.center[0] << ' ' << place.center[1] << ' ' << place.center[2] << ", box " << place.box[0][0]
      << ' ' << place.box[0][1] << ' ' << place.box[0][2] << " to " << place.box[1][0] << ' ' << place.box[1][1] << ' '
      << place.box[1][2] << '\n';
}

void add_place(nlohmann::ordered_json& json, const Loop_place& place)
{
  const auto point = [](const std::array<double, 3>& p) { return nlohmann::ordered_json::array({p[0], p[1], p[2]}); };
  json["center"] = point(place.center);
  json["box"] = nlohmann::ordered_json::array({point(place.box[0]), point(place.box[1])});
  json["vertices"] = place.vertices;
}

void write_removals(std::ostream& out, const std::vector<Removal_row>& removals)
{
  const auto removed =
    std::count_if(removals.begin(), removals.end(), [](const Removal_row& r) { return r.is_removed; });
  out << "removed  " << count(static_cast<std::size_t>(removed), "handle or tunnel", "handles and tunnels") << '\n'
      << std::defaultfloat << std::setprecision(6);
  for(const Removal_row& row : removals)
  {
    if(!row.is_removed)
      out << "refused  a " << row.kind << " of length " << row.length << " of component " << row.component << ": "
          << row.reason << '\n';
    else
      out << "removed  a " << row.kind << " of length " << row.length << " of component " << row.component << '\n';
    out << "         ";
    write_place_text(out, row.place);
  }
}

} // namespace

void write_text(std::ostream& out, const Handles_report& report)
{
  const auto number_of = [&](const std::string& kind) {
    return static_cast<std::size_t>(
      std::count_if(report.loops.begin(), report.loops.end(), [&](const Loop_row& row) { return row.kind == kind; }));
  };
  out << "surface  " << count(number_of("handle"), "handle") << ", " << count(number_of("tunnel"), "tunnel") << ", "
      << count(number_of("hole"), "hole") << ", " << count(number_of("loop"), "loop")
      << (report.self_intersections == 0 ? " without inside" : "") << '\n';
  write_input_text(out, report);
  out << "field    " << report.field << '\n';
  if(report.self_intersections != 0)
    out << "crossed  " << count(report.self_intersections, "pair") << " of faces: "
        << (report.are_self_intersections_ignored
              ? "kinds of loops are not certain\n"
              : "loops there are neither handles nor tunnels; --ignore-self-intersections tells which, without being "
                "certain\n");
  if(report.removals)
    write_removals(out, *report.removals);
  if(report.loops.empty())
    return;
  out << "\n loop    kind  partner          length     persistence            area  component\n"
      << std::defaultfloat << std::setprecision(6);
  const auto write = [&](const auto& number, int width) {
    out << std::setw(width);
    if(number)
      out << *number;
    else
      out << '-';
  };
  for(std::size_t i = 0; i != report.loops.size(); ++i)
  {
    const Loop_row& row = report.loops[i];
    out << std::setw(5) << i << std::setw(8) << row.kind;
    write(row.partner, 9);
    out << std::setw(16) << row.length;
    write(row.persistence, 16);
    write(row.area, 16);
    out << std::setw(11) << row.component << (row.is_simple ? "" : "  crosses itself")
        << (row.is_certain ? "" : "  not certain") << '\n';
  }
  out << "\n loop    place\n";
  for(std::size_t i = 0; i != report.loops.size(); ++i)
  {
    out << std::setw(5) << i << "    ";
    write_place_text(out, report.loops[i].place);
  }
}

void write_json(std::ostream& out, const Handles_report& report)
{
  nlohmann::ordered_json json;
  json["field"] = report.field;
  json["intersecting_pairs"] = report.self_intersections;
  json["loops"] = nlohmann::ordered_json::array();
  for(const Loop_row& row : report.loops)
  {
    nlohmann::ordered_json loop = {
      {"kind", row.kind}, {"partner", row.partner},     {"length", row.length},    {"persistence", row.persistence},
      {"area", row.area}, {"component", row.component}, {"simple", row.is_simple}, {"certain", row.is_certain}};
    add_place(loop, row.place);
    json["loops"].push_back(loop);
  }
  if(report.removals)
  {
    json["removals"] = nlohmann::ordered_json::array();
    for(const Removal_row& row : *report.removals)
    {
      nlohmann::ordered_json removal = {{"kind", row.kind},
                                        {"length", row.length},
                                        {"component", row.component},
                                        {"result", row.is_removed ? "removed" : "refused"},
                                        {"reason", row.is_removed ? std::nullopt : std::make_optional(row.reason)}};
      add_place(removal, row.place);
      json["removals"].push_back(removal);
    }
  }
  write_with_costs(out, std::move(json), report);
}

namespace {
void write_faults(std::ostream& out, const Mesh_counts& counts)
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

nlohmann::ordered_json json_with_faults(const Mesh_counts& counts)
{
  nlohmann::ordered_json json = json_of(counts);
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
          {"stitched_points", counts.stitched_points, "point of a border cuts an edge of one",
           "points of borders cut edges of these"},
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
          {"turned_solids", counts.turned_solids, "solid that was inside out turned, with what lies in it",
           "solids that were inside out turned, with what lies in them"},
          {"small_pieces", counts.small_pieces, "component with too small an area left out",
           "components with too small an area left out"},
          {"pieces_without_volume", counts.pieces_without_volume, "component without volume left out",
           "components without volume left out"},
          {"faces_of_pieces", counts.faces_of_pieces, "face of these", "faces of these"},
          {"filled_borders", counts.filled_borders, "border filled", "borders filled"},
          {"filling_faces", counts.filling_faces, "face for that", "faces for that"},
          {"faces_of_other_components", counts.other_faces, "face of other components left out",
           "faces of other components left out"},
          {"unused_points", counts.unused_points, "point of no face left out", "points of no face left out"}};
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
  write_counts(out, "given    ", counts.given);
  write_faults(out, counts.given);
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
  write_counts(out, "result   ", counts.result);
  write_faults(out, counts.result);
}

void write_json(std::ostream& out, const Repair_report& report)
{
  const Repair_counts& counts = report.counts;
  nlohmann::ordered_json json = {{"given", json_with_faults(counts.given)},
                                 {"merged", json_with_faults(counts.merged)},
                                 {"result", json_with_faults(counts.result)}};
  add_steps(json, counts);
  json["lines_left_out"] = report.lines_left_out;
  json["fields"] = nlohmann::ordered_json::array();
  for(const Merged_field& field : report.fields)
    json["fields"].push_back({{"name", field.name},
                              {"differing_points", field.differing_points},
                              {"largest_difference", field.largest_difference}});
  json["lost_fields"] = report.lost_fields;
  write_with_costs(out, std::move(json), report);
}

} // namespace reeb_graph_program
