// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "page/page_graph.h"

#include <CGAL/Reeb_graph/plane_layout.h>
#include <CGAL/boost/graph/iterator.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <variant>

namespace reeb_graph_program {
namespace {
nlohmann::ordered_json page_node(const Graph& graph,
                                 std::size_t node,
                                 const Point& point,
                                 double column,
                                 const Page_frame& frame)
{
  nlohmann::ordered_json json;
  json["value"] = number_or_string(graph[node].value);
  json["kind"] = to_string(graph[node].kind);
  json["vertex"] = graph[node].vertex.idx();
  json["point"] = frame.coordinates(point);
  json["column"] = column;
  return json;
}

nlohmann::ordered_json json_number(double number) { return number_or_string(number); }
nlohmann::ordered_json json_number(std::int64_t number) { return number; }

const char* name_of(Arc_unit unit)
{
  return unit == Arc_unit::COUNT ? "count" : unit == Arc_unit::PLAIN ? "" : "field";
}

} // namespace

nlohmann::ordered_json number_or_string(double number)
{
  if(std::isfinite(number))
    return number;
  return std::isnan(number) ? "NaN" : number > 0 ? "Infinity" : "-Infinity";
}

nlohmann::ordered_json page_columns(const Arc_table& table)
{
  auto json = nlohmann::ordered_json::array();
  for(const Arc_column& column : table.columns)
    json.push_back({{"name", column.attribute.name}, {"unit", name_of(column.unit)}});
  return json;
}

void add_columns(const Arc_table& table, std::size_t arc, nlohmann::ordered_json& json)
{
  for(const Arc_column& column : table.columns)
    json[column.attribute.name] =
      std::visit([&](const auto& numbers) { return json_number(numbers[arc]); }, column.attribute.numbers);
}

nlohmann::ordered_json flat_polyline(const Polyline& polyline, const Page_frame& frame)
{
  auto json = nlohmann::ordered_json::array();
  for(const Point& point : polyline)
    for(const double coordinate : frame.coordinates(point))
      json.push_back(coordinate);
  return json;
}

nlohmann::ordered_json flat_drawing(const std::vector<std::array<double, 2>>& drawing, const Value_scale& value_scale)
{
  auto json = nlohmann::ordered_json::array();
  for(const auto& [column, value] : drawing)
  {
    json.push_back(column);
    json.push_back(value_scale.finite_value(value));
  }
  return json;
}

nlohmann::ordered_json page_graph(const Embedded_graph& embedded,
                                  const Page_frame& frame,
                                  const Value_scale& value_scale)
{
  const Graph& graph = embedded.graph;
  const CGAL::Reeb_graph::Plane_layout layout = CGAL::Reeb_graph::lay_out_in_plane(graph);
  auto nodes = nlohmann::ordered_json::array();
  for(const auto node : CGAL::make_range(vertices(graph)))
    nodes.push_back(page_node(graph, node, embedded.node_points[node], layout.node_positions[node], frame));
  auto arcs = nlohmann::ordered_json::array();
  for(std::size_t i = 0; i != num_edges(graph); ++i)
  {
    const Arc_ends& ends = embedded.arc_table.ends[i];
    nlohmann::ordered_json arc;
    arc["source"] = ends.lower_node;
    arc["target"] = ends.upper_node;
    arc["polyline"] = flat_polyline(embedded.arc_polylines[i], frame);
    arc["plane"] = flat_drawing(layout.arc_polylines[i], value_scale);
    add_columns(embedded.arc_table, i, arc);
    arcs.push_back(std::move(arc));
  }
  return {{"nodes", std::move(nodes)}, {"arcs", std::move(arcs)}};
}

} // namespace reeb_graph_program
