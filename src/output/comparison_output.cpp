// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/comparison_output.h"

#include "output/output_file.h"
#include "output/report_output.h"

#include <CGAL/Reeb_graph/IO/csv.h>
#include <CGAL/Reeb_graph/internal/io/text.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <ostream>
#include <utility>

namespace reeb_graph_program {
namespace {
const Graph_counts& compared_graph(const Report& shape)
{
  return shape.simplification ? shape.simplification->graph : shape.graph;
}

// The arcs of each of two graphs that no arc of the other one is the partner of.
std::array<std::vector<std::size_t>, 2> arcs_alone(const Comparison_report& report)
{
  std::array<std::vector<std::size_t>, 2> alone;
  for(const std::size_t shape : {0, 1})
    for(std::size_t arc = 0; arc != compared_graph(report.shapes[shape]).arcs; ++arc)
      if(std::none_of(report.partners->begin(), report.partners->end(),
                      [&](const auto& pair) { return (shape == 0 ? pair.first : pair.second) == arc; }))
        alone[shape].push_back(arc);
  return alone;
}

void write_partners(std::ostream& out, const Comparison_report& report)
{
  out << "partners " << count(report.partners->size(), "pair") << " of arcs of " << report.names[0] << " and "
      << report.names[1] << '\n';
  for(const auto& [a, b] : *report.partners)
    out << "         " << a << " and " << b << '\n';
  const auto alone = arcs_alone(report);
  for(const std::size_t shape : {0, 1})
    for(const std::size_t arc : alone[shape])
      out << "         " << arc << " of " << report.names[shape] << " has none\n";
  if(report.are_sources_on_partners)
    out << "sources  " << (*report.are_sources_on_partners ? "are" : "are not") << " on partners\n";
}

} // namespace

void write_text(std::ostream& out, const Comparison_report& report)
{
  for(std::size_t i = 0; i != report.names.size(); ++i)
  {
    const Report& shape = report.shapes[i];
    const Graph_counts& graph = compared_graph(shape);
    out << "shape    " << report.names[i] << ": " << count(shape.surface.faces, "face") << ", "
        << count(shape.surface.components, "component") << ", " << count(graph.nodes, "node") << ", "
        << count(graph.arcs, "arc") << ", " << count(graph.loops, "loop") << '\n';
    write_input_text(out, shape);
    write_field_text(out, shape);
  }
  for(const std::string& note : report.notes)
    out << "         " << note << '\n';
  if(report.partners)
  {
    out << "distance " << report.distances[0][1] << '\n';
    for(const auto& [kind, distance] : report.by_kind)
      out << "         " << distance << " of pairs " << kind << '\n';
    write_partners(out, report);
    return;
  }
  out << "distances\n";
  for(std::size_t i = 0; i != report.names.size(); ++i)
  {
    out << "         " << report.names[i] << ':';
    for(const double distance : report.distances[i])
      out << ' ' << distance;
    out << '\n';
  }
}

void write_json(std::ostream& out, const Comparison_report& report)
{
  nlohmann::ordered_json json = {{"field", report.field},       {"distance", nullptr},
                                 {"distance_by_kind", nullptr}, {"pairs", nullptr},
                                 {"without_partner", nullptr},  {"sources_on_partners", report.are_sources_on_partners},
                                 {"matrix", report.distances},  {"shapes", nlohmann::ordered_json::array()}};
  if(report.partners)
  {
    json["distance"] = report.distances[0][1];
    json["distance_by_kind"] = nlohmann::ordered_json(nlohmann::ordered_json::object());
    for(const auto& [kind, distance] : report.by_kind)
      json["distance_by_kind"][kind] = distance;
    json["pairs"] = *report.partners;
    json["without_partner"] = arcs_alone(report);
  }
  for(std::size_t i = 0; i != report.names.size(); ++i)
  {
    const Report& shape = report.shapes[i];
    const Graph_counts& graph = compared_graph(shape);
    nlohmann::ordered_json one = {{"name", report.names[i]},
                                  {"vertices", shape.surface.vertices},
                                  {"faces", shape.surface.faces},
                                  {"components", shape.surface.components},
                                  {"genus", shape.surface.genus()},
                                  {"nodes", graph.nodes},
                                  {"arcs", graph.arcs},
                                  {"loops", graph.loops}};
    add_field_and_costs(one, shape);
    json["shapes"].push_back(std::move(one));
  }
  write_with_costs(out, std::move(json), report);
}

void check_matrix_format(const std::filesystem::path& path) { ending_of(path, "distances", {".csv"}); }

void write_matrix(const std::filesystem::path& path, const Comparison_report& report)
{
  write_file(path, [&](std::ostream& stream) {
    using CGAL::Reeb_graph::internal::csv_of;
    CGAL::Reeb_graph::internal::Text_output text(stream);
    text << "shape";
    for(const std::string& name : report.names)
      text << ',' << csv_of(name);
    text << '\n';
    for(std::size_t i = 0; i != report.names.size(); ++i)
    {
      text << csv_of(report.names[i]);
      for(const double distance : report.distances[i])
        text << ',' << distance;
      text << '\n';
    }
    text.flush();
  });
}

} // namespace reeb_graph_program
