// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/report_output.h"
#include "output/skeleton_output.h"

#include <CGAL/Reeb_graph/internal/base/lengths.h>

#include <cstddef>
#include <iomanip>
#include <optional>
#include <ostream>

namespace reeb_graph_program {
void write_text(std::ostream& out, const Skeleton_report& report)
{
  const auto& known = report.skeleton.certificate;
  out << "surface   " << count(known.number_of_components, "component") << ", " << count(known.genus, "handle")
      << " with borders filled\n";
  write_input_text(out, report);
  out << "field     " << report.field << '\n';
  out << "skeleton  " << count(num_vertices(report.skeleton.graph), "point") << ", "
      << count(known.number_of_arcs, "arc") << ", " << count(known.number_of_ends, "end") << " ("
      << known.number_of_border_ends << " at borders), " << count(known.number_of_junctions, "junction") << ", "
      << count(known.number_of_loops, "loop") << ", " << count(known.number_of_hidden_handles, "hidden handle") << '\n';
  out << "inside    " << count(known.number_of_vertices_outside, "vertex", "vertices") << " outside, "
      << count(known.number_of_crossing_edges, "crossing edge") << ", "
      << count(known.number_of_contractible_loops, "contractible loop") << ", "
      << count(known.number_of_crossing_components, "self-intersecting component") << '\n';
  const Skeleton_numbers numbers = numbers_of(report.skeleton);
  out << "cable     length " << numbers.cable_length << ", " << count(known.number_of_arcs, "branch", "branches");
  if(numbers.mean_tortuosity)
    out << ", mean tortuosity " << *numbers.mean_tortuosity;
  out << ", Strahler order " << numbers.order << '\n';
  if(!report.skeleton.paths.empty())
    out << "paths     " << report.skeleton.paths.size() << '\n';
  for(const auto& [step, seconds] : report.seconds)
    out << std::left << std::setw(10) << step << std::right << std::fixed << std::setprecision(3) << seconds << " s\n";
  out << std::defaultfloat << std::setprecision(6)
      << "\n  arc   from     to          length     mean radius    least radius greatest radius  mean inscribed  "
         "component\n";
  std::size_t number = 0;
  for(const auto& row : report.skeleton.branches)
  {
    out << std::setw(5) << number++ << std::setw(7) << row.first << std::setw(7) << row.last;
    for(const double x : {row.length, row.radius, row.least_radius, row.greatest_radius, row.inscribed_radius})
      out << std::setw(16) << x;
    out << std::setw(11) << row.component << '\n';
  }
}

void write_json(std::ostream& out, const Skeleton_report& report)
{
  const auto& known = report.skeleton.certificate;
  nlohmann::ordered_json json;
  json["components"] = known.number_of_components;
  json["genus"] = known.genus;
  json["field"] = report.field;
  json["points"] = num_vertices(report.skeleton.graph);
  json["ends"] = known.number_of_ends;
  json["border_ends"] = known.number_of_border_ends;
  json["junctions"] = known.number_of_junctions;
  json["loops"] = known.number_of_loops;
  json["hidden_handles"] = known.number_of_hidden_handles;
  json["contractible_loops"] = known.number_of_contractible_loops;
  json["vertices_outside"] = known.number_of_vertices_outside;
  json["crossing_edges"] = known.number_of_crossing_edges;
  json["self_intersecting"] = known.number_of_crossing_components != 0;
  json["self_intersecting_components"] = known.number_of_crossing_components;
  const Skeleton_numbers numbers = numbers_of(report.skeleton);
  json["cable_length"] = numbers.cable_length;
  json["branches"] = known.number_of_arcs;
  json["mean_tortuosity"] = numbers.mean_tortuosity;
  json["strahler_order"] = numbers.order;
  json["arcs"] = nlohmann::ordered_json::array();
  for(const auto& row : report.skeleton.branches)
    json["arcs"].push_back({{"from", row.first},
                            {"to", row.last},
                            {"component", row.component},
                            {"parent", row.parent == Skeleton::none ? std::nullopt : std::make_optional(row.parent)},
                            {"strahler", row.order},
                            {"tortuosity", row.tortuosity},
                            {"volume", row.volume},
                            {"area", row.area},
                            {"length", row.length},
                            {"radius", row.radius},
                            {"least_radius", row.least_radius},
                            {"greatest_radius", row.greatest_radius},
                            {"inscribed_radius", row.inscribed_radius}});
  for(const auto& path : report.skeleton.paths)
  {
    double length = 0;
    for(std::size_t i = 1; i != path.size(); ++i)
      length += CGAL::Reeb_graph::internal::distance_between(report.skeleton.graph[path[i - 1]].point,
                                                             report.skeleton.graph[path[i]].point);
    json["paths"].push_back({{"from", path.front()}, {"to", path.back()}, {"length", length}});
  }
  add_field_and_costs(json, report);
  write_line(out, json);
}

} // namespace reeb_graph_program
