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
#include <iomanip>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace reeb_graph_program {
namespace {
std::string count_saddles(const CGAL::Reeb_graph::Critical_vertex_counts& counts)
{
  std::size_t total = 0;
  std::string by_multiplicity;
  for(const auto& [multiplicity, number] : counts.saddles)
  {
    total += number;
    if(multiplicity > 1)
      by_multiplicity += (by_multiplicity.empty() ? "" : ", ") + std::to_string(number) + " of multiplicity "
                       + std::to_string(multiplicity);
  }
  return count(total, "saddle") + (by_multiplicity.empty() ? "" : " (" + by_multiplicity + ")");
}

std::string count_parts(const Graph_counts& graph)
{
  return count(graph.nodes, "node") + ", " + count(graph.arcs, "arc") + ", " + count(graph.loops, "loop")
       + (graph.arcs_of_length_zero > 0 ? ", " + count(graph.arcs_of_length_zero, "arc") + " of length zero" : "");
}

void write_counts(std::ostream& out, const Complex_counts& complex)
{
  out << "complex  " << count(complex.vertices, "vertex", "vertices") << ", " << count(complex.edges, "edge") << ", "
      << count(complex.triangles, "triangle");
  if(complex.tetrahedra > 0)
    out << ", " << count(complex.tetrahedra, "tetrahedron", "tetrahedra");
  out << "\n         " << count(complex.components, "component") << ", Euler characteristic "
      << complex.euler_characteristic();
  if(const auto& edge = complex.first_edge_without_triangles)
    out << "\n         " << count(complex.edges_without_triangles, "edge") << " on no triangle, the first one, "
        << "of the vertices " << edge->first << " and " << edge->second;
  if(complex.first_duplicate_face)
    out << "\n         "
        << count(complex.duplicate_faces, "face that repeats an earlier one", "faces that repeat earlier ones")
        << ", the first one, face " << *complex.first_duplicate_face;
  if(const auto& edge = complex.first_edge_of_many_faces)
    out << "\n         " << count(complex.edges_of_many_faces, "edge")
        << " with more than two triangles, the first one, "
        << "of the vertices " << edge->u << " and " << edge->v << ", with " << edge->faces;
  if(const auto& vertex = complex.first_vertex_of_several_fans)
    out << "\n         " << count(complex.vertices_of_several_fans, "vertex", "vertices")
        << " whose triangles form several fans, the first one, vertex " << vertex->vertex << ", with " << vertex->fans;
  if(const auto& edge = complex.first_edge_without_orientation)
    out << "\n         not orientable, which shows at the edge of the vertices " << edge->first << " and "
        << edge->second;
  out << '\n';
}

nlohmann::ordered_json json_of(const Complex_counts& complex)
{
  const auto number_of_places = [&](std::size_t number) { // which are not counted where there are tetrahedra
    return complex.tetrahedra == 0 ? std::make_optional(number) : std::nullopt;
  };
  nlohmann::ordered_json places = {{"tetrahedra", complex.tetrahedra},
                                   {"edges_without_faces", complex.edges_without_triangles},
                                   {"first_edge_without_faces", complex.first_edge_without_triangles},
                                   {"duplicate_faces", complex.duplicate_faces},
                                   {"first_duplicate_face", complex.first_duplicate_face},
                                   {"edges_of_many_faces", number_of_places(complex.edges_of_many_faces)},
                                   {"first_edge_of_many_faces", nullptr},
                                   {"vertices_of_several_fans", number_of_places(complex.vertices_of_several_fans)},
                                   {"first_vertex_of_several_fans", nullptr},
                                   {"first_edge_without_orientation", complex.first_edge_without_orientation}};
  if(const auto& edge = complex.first_edge_of_many_faces)
    places["first_edge_of_many_faces"] = {{"vertices", {edge->u, edge->v}}, {"faces", edge->faces}};
  if(const auto& vertex = complex.first_vertex_of_several_fans)
    places["first_vertex_of_several_fans"] = {{"vertex", vertex->vertex}, {"fans", vertex->fans}};
  return {{"vertices", complex.vertices},
          {"edges", complex.edges},
          {"faces", complex.triangles},
          {"components", complex.components},
          {"border_loops", nullptr},
          {"euler_characteristic", complex.euler_characteristic()},
          {"genus", nullptr},
          {"complex", places}};
}

// As the option --embedding calls it.
std::string name_of(CGAL::Reeb_graph::Embedding_manner manner)
{
  using CGAL::Reeb_graph::Embedding_manner;
  return manner == Embedding_manner::ON_SURFACE ? "on-surface"
       : manner == Embedding_manner::STRAIGHT   ? "straight"
                                                : "centroids";
}

nlohmann::ordered_json json_of(const Simplification_counts& simplification)
{
  return {{"threshold", simplification.threshold},
          {"nodes", simplification.graph.nodes},
          {"arcs", simplification.graph.arcs},
          {"loops", simplification.graph.loops},
          {"arcs_of_length_zero", simplification.graph.arcs_of_length_zero},
          {"largest_change", simplification.largest_change},
          {"ties_contracted", simplification.are_ties_contracted}};
}

nlohmann::ordered_json json_of(const CGAL::Reeb_graph::Simplification_threshold& threshold)
{
  return {{"threshold", threshold.threshold}, {"gap", threshold.gap},     {"nodes", threshold.nodes},
          {"leaves", threshold.leaves},       {"loops", threshold.loops}, {"suggested", threshold.is_suggested}};
}

nlohmann::ordered_json json_of(const Arc_table& table)
{
  auto rows = nlohmann::ordered_json::array();
  for(const Arc_ends& ends : table.ends)
    rows.push_back({{"arc", rows.size()},
                    {"from", ends.lower_node},
                    {"to", ends.upper_node},
                    {"lower_value", ends.lower_value},
                    {"upper_value", ends.upper_value}});
  for(const auto& column : table.columns)
    std::visit(
      [&](const auto& numbers) {
        for(std::size_t arc = 0; arc != rows.size(); ++arc)
          rows[arc][column.attribute.name] = numbers[arc];
      },
      column.attribute.numbers);
  return rows;
}

// What a person can choose for --simplify, or leave to `auto`.
void write_thresholds(std::ostream& out, const std::vector<CGAL::Reeb_graph::Simplification_threshold>& thresholds)
{
  out << std::defaultfloat << std::setprecision(3);
  for(const auto& threshold : thresholds)
    out << "\n         --simplify " << threshold.threshold << " gives " << count(threshold.nodes, "node") << ", "
        << count(threshold.leaves, "leaf", "leaves") << ", " << count(threshold.loops, "loop")
        << (threshold.is_suggested ? ", and so does auto" : "");
}

void write_table(std::ostream& out, const Arc_table& table)
{
  const auto for_each_column = [&](const auto& write) {
    for(const Arc_column& column : table.columns)
      if(column.is_in_text)
      {
        out << std::setw(column.unit == Arc_unit::COUNT ? 10 : 16);
        write(column.attribute);
      }
    out << '\n';
  };
  out << "\n  arc   from     to        from value          to value";
  for_each_column([&](const CGAL::Reeb_graph::Attribute& attribute) { out << attribute.name; });
  out << std::defaultfloat << std::setprecision(6);
  for(std::size_t arc = 0; arc < table.ends.size(); ++arc)
  {
    const Arc_ends& ends = table.ends[arc];
    out << std::setw(5) << arc << std::setw(7) << ends.lower_node << std::setw(7) << ends.upper_node << std::setw(18)
        << ends.lower_value << std::setw(18) << ends.upper_value;
    for_each_column([&](const CGAL::Reeb_graph::Attribute& attribute) {
      std::visit([&](const auto& numbers) { out << numbers[arc]; }, attribute.numbers);
    });
  }
}

std::size_t largest_peak_memory_bytes(const Ranks_report& report)
{
  std::size_t largest = 0;
  for(const Rank_report& rank : report.ranks)
    largest = std::max(largest, rank.peak_memory_bytes);
  return largest;
}

// The sum over all ranks, step by step.
std::vector<std::pair<std::string, double>> cpu_seconds(const Ranks_report& report)
{
  Work_report sums;
  for(const Rank_report& rank : report.ranks)
    for(const auto& [step, seconds] : rank.cpu_seconds)
      sums.add_seconds(step, seconds);
  return sums.seconds;
}

nlohmann::ordered_json json_of_steps(const std::vector<std::pair<std::string, double>>& steps)
{
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for(const auto& [step, seconds] : steps)
    json[step] = seconds;
  return json;
}

void add_ranks(nlohmann::ordered_json& json, const Ranks_report& report)
{
  json["ranks"] = report.ranks.size();
  json["slabs"] = report.slabs;
  json["slabs_per_triangle"] = report.slabs_per_triangle;
  json["cpu_seconds"] = json_of_steps(cpu_seconds(report));
  json["per_rank"] = nlohmann::ordered_json::array();
  for(const Rank_report& rank : report.ranks)
    json["per_rank"].push_back({{"vertices", rank.vertices},
                                {"triangles", rank.triangles},
                                {"copies", rank.copies},
                                {"bytes_sent", rank.bytes_sent},
                                {"cpu_seconds", json_of_steps(rank.cpu_seconds)},
                                {"peak_memory_bytes", rank.peak_memory_bytes}});
}

void write_ranks(std::ostream& out, const Ranks_report& report)
{
  out << "ranks    " << report.ranks.size() << " on " << count(report.slabs, "slab");
  if(report.slabs < report.ranks.size())
    out << ": with one for each rank, a triangle would meet " << std::fixed << std::setprecision(1)
        << report.slabs_per_triangle << " of them";
  out << "\n         " << std::fixed << std::setprecision(3)
      << (report.ranks.empty() ? 0. : cpu_seconds(report).back().second) << " seconds of CPU in all, at most "
      << std::setprecision(1) << static_cast<double>(largest_peak_memory_bytes(report)) / 1e6 << " MB on a rank\n";
}

} // namespace

void write_text(std::ostream& out, const Report& report)
{
  const auto& critical_vertices = report.critical_vertices;
  if(report.complex)
    write_counts(out, *report.complex);
  else
    write_counts(out, "surface  ", report.surface);
  write_input_text(out, report);
  out << "field    " << count(critical_vertices.minima, "minimum", "minima") << ", " << count_saddles(critical_vertices)
      << ", " << count(critical_vertices.maxima, "maximum", "maxima");
  if(critical_vertices.border_saddles > 0)
    out << ", " << count(critical_vertices.border_saddles, "saddle") << " on the border";
  if(critical_vertices.isolated > 0 && !report.input) // else it is said above
    out << ", " << count(critical_vertices.isolated, "isolated vertex", "isolated vertices");
  out << '\n';
  write_field_text(out, report);
  out << "graph    " << count_parts(report.graph);
  if(report.graph.hidden_handles.value_or(0) > 0)
    out << ", " << count(static_cast<std::size_t>(*report.graph.hidden_handles), "hidden handle");
  if(report.graph.arcs_of_length_zero > 0)
    out << "\n         --ties contract would remove the arcs of length zero";
  if(report.simplification)
    out << "\n         simplified: " << count_parts(report.simplification->graph);
  if(report.simplification && report.simplification->largest_change)
    out << ", largest change of the field " << *report.simplification->largest_change
        << (report.simplification->are_ties_contracted ? ", which needs --ties contract" : "");
  write_thresholds(out, report.thresholds);
  if(report.longest_loop)
    out << "\n         most persistent loop: persistence " << *report.longest_loop->persistence << ", length "
        << report.longest_loop->length;
  if(report.embedding_manner)
    out << "\n         in space: " << name_of(*report.embedding_manner);
  out << "\nseconds  " << std::fixed << std::setprecision(3);
  for(std::size_t i = 0; i < report.seconds.size(); ++i)
    out << (i == 0 ? "" : ", ") << report.seconds[i].first << " " << report.seconds[i].second;
  out << "\nmemory   " << std::setprecision(1) << static_cast<double>(peak_memory_bytes()) / 1e6 << " MB at the peak\n";
  if(report.ranks)
    write_ranks(out, *report.ranks);
  if(report.arc_table != nullptr && !report.arc_table->ends.empty())
    write_table(out, *report.arc_table);
}

void write_json(std::ostream& out, const Report& report)
{
  nlohmann::ordered_json json = report.complex ? json_of(*report.complex) : json_of(report.surface);
  if(!report.complex)
    json["complex"] = nullptr;
  json["minima"] = report.critical_vertices.minima;
  json["saddles"] = nlohmann::ordered_json::object();
  for(const auto& [multiplicity, number] : report.critical_vertices.saddles)
    json["saddles"][std::to_string(multiplicity)] = number;
  json["border_saddles"] = report.critical_vertices.border_saddles;
  json["maxima"] = report.critical_vertices.maxima;
  json["isolated"] = report.critical_vertices.isolated;
  json["nodes"] = report.graph.nodes;
  json["arcs"] = report.graph.arcs;
  json["loops"] = report.graph.loops;
  json["arcs_of_length_zero"] = report.graph.arcs_of_length_zero;
  json["hidden_handles"] = report.graph.hidden_handles;
  json["thresholds"] = nlohmann::ordered_json::array();
  json["suggested_threshold"] = nullptr;
  for(const auto& threshold : report.thresholds)
  {
    json["thresholds"].push_back(json_of(threshold));
    if(threshold.is_suggested)
      json["suggested_threshold"] = threshold.threshold;
  }
  json["simplified"] = nullptr;
  if(report.simplification)
    json["simplified"] = json_of(*report.simplification);
  json["embedding"] = report.embedding_manner ? std::make_optional(name_of(*report.embedding_manner)) : std::nullopt;
  if(report.longest_loop)
    json["longest_loop"] = {{"persistence", report.longest_loop->persistence}, {"length", report.longest_loop->length}};
  json["arc_table"] = report.arc_table != nullptr ? json_of(*report.arc_table) : nlohmann::ordered_json();
  add_field_and_costs(json, report);
  if(report.ranks)
  {
    json["peak_memory_bytes"] = largest_peak_memory_bytes(*report.ranks);
    add_ranks(json, *report.ranks);
  }
  write_line(out, json);
}

} // namespace reeb_graph_program
