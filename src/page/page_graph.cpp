// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "page/page_data.h"

#include "computation/arc_columns.h"
#include "computation/simplification.h"

#include <CGAL/Reeb_graph/plane_layout.h>
#include <CGAL/Reeb_graph/simplification/simplification_thresholds.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>
#include <CGAL/boost/graph/iterator.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <variant>
#include <vector>

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

namespace {
typedef CGAL::Reeb_graph::Simplification<Graph> Simplification;

constexpr std::size_t largest_number_of_levels = 32;
constexpr std::size_t number_of_all_last_levels = 20; // of so many of the largest thresholds, none is left out

// The thresholds from which on arcs are removed, ascending.
std::vector<double> thresholds(const Graph& graph)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::set<double> result;
  for(const double persistence : CGAL::Reeb_graph::arc_persistences(graph))
    if(persistence < (std::numeric_limits<double>::max)())
      result.insert(std::nextafter(persistence, infinity));
  return std::vector<double>(result.begin(), result.end());
}

// All of the last ones, of those before, whose graphs have more arcs, ever fewer, and those of ticks.
std::vector<double> choose(const std::vector<double>& candidates, const std::vector<Simplification_threshold>& ticks)
{
  if(candidates.size() < largest_number_of_levels)
    return candidates;
  const std::size_t number_before = candidates.size() - number_of_all_last_levels;
  const std::size_t number_of_chosen = largest_number_of_levels - 1 - number_of_all_last_levels;
  std::vector<double> chosen(candidates.begin() + static_cast<std::ptrdiff_t>(number_before), candidates.end());
  for(std::size_t i = 1; i <= number_of_chosen; ++i)
  {
    const double share = std::pow(double(number_before), double(i) / double(number_of_chosen));
    chosen.push_back(candidates[number_before - (std::min)(static_cast<std::size_t>(share), number_before)]);
  }
  for(const Simplification_threshold& tick : ticks)
    if(const auto after = std::upper_bound(candidates.begin(), candidates.end(), tick.threshold);
       after != candidates.begin())
      chosen.push_back(*std::prev(after));
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

// For each arc of a simplified graph, the given arcs that it consists of, by the chains.
std::vector<std::vector<std::size_t>> parts_of_arcs(const Graph& given, const Graph& simplified)
{
  std::map<Surface::Halfedge_index, std::pair<std::size_t, std::size_t>> arc_and_length_by_start;
  std::size_t number = 0;
  for(const auto arc : CGAL::make_range(edges(given)))
    arc_and_length_by_start[given[arc].chain.front()] = {number++, given[arc].chain.size()};
  std::vector<std::vector<std::size_t>> parts;
  for(const auto arc : CGAL::make_range(edges(simplified)))
  {
    parts.emplace_back();
    const auto& chain = simplified[arc].chain;
    for(std::size_t i = 0; i < chain.size();)
    {
      const auto [part, length] = arc_and_length_by_start.at(chain[i]);
      parts.back().push_back(part);
      i += length;
    }
  }
  return parts;
}

// The simplified graph where the given one is, by the parts of its arcs.
Embedded_graph simplified_embedding(const Embedded_graph& given,
                                    const Graph& simplified,
                                    const Simplification& simplification,
                                    const std::vector<std::vector<std::size_t>>& parts)
{
  Embedded_graph result = {simplified, {}, {}, join_arcs(given.arc_table, simplified, simplification, parts)};
  result.node_points.resize(num_vertices(simplified));
  for(const auto node : CGAL::make_range(vertices(given.graph)))
  {
    const std::size_t place = simplification.index_of_node(node);
    if(place < num_vertices(simplified) && simplified[place].vertex == given.graph[node].vertex)
      result.node_points[place] = given.node_points[node];
  }
  for(const std::vector<std::size_t>& parts_of_arc : parts)
  {
    Polyline& polyline = result.arc_polylines.emplace_back();
    for(const std::size_t part : parts_of_arc)
    {
      const Polyline& more = given.arc_polylines[part];
      polyline.insert(polyline.end(), more.begin() + (polyline.empty() ? 0 : 1), more.end());
    }
  }
  return result;
}

nlohmann::ordered_json page_level(const Embedded_graph& given,
                                  double threshold,
                                  const Graph& simplified,
                                  const Simplification& simplification,
                                  const Page_frame& frame,
                                  const Value_scale& value_scale)
{
  const std::size_t number_of_nodes = num_vertices(simplified);
  nlohmann::ordered_json level;
  level["threshold"] = threshold;
  auto& new_arcs = level["arcs"] = nlohmann::ordered_json::array();
  for(std::size_t i = 0; i != given.arc_table.ends.size(); ++i)
  {
    const std::size_t place = simplification.index_of_arc(i);
    new_arcs.push_back(place < number_of_nodes ? -1 - static_cast<std::ptrdiff_t>(place)
                                               : static_cast<std::ptrdiff_t>(place - number_of_nodes));
  }
  const auto parts = parts_of_arcs(given.graph, simplified);
  level["graph"] = page_graph(simplified_embedding(given, simplified, simplification, parts), frame, value_scale);
  for(std::size_t i = 0; i != parts.size(); ++i)
    level["graph"]["arcs"][i]["parts"] = parts[i];
  return level;
}

} // namespace

nlohmann::ordered_json page_levels(const Embedded_graph& given, const Page_frame& frame, const Value_scale& value_scale)
{
  nlohmann::ordered_json first;
  first["threshold"] = 0;
  auto& arcs = first["arcs"] = nlohmann::ordered_json::array();
  for(std::size_t i = 0; i != given.arc_table.ends.size(); ++i)
    arcs.push_back(i);
  auto levels = nlohmann::ordered_json::array({first});
  std::size_t last_number_of_arcs = num_edges(given.graph);
  for(const double threshold : choose(thresholds(given.graph), find_thresholds(given.graph, true)))
  {
    Graph simplified;
    const Simplification simplification =
      CGAL::Reeb_graph::simplify(given.graph, threshold, simplified, CGAL::parameters::cancel_loops(true));
    if(num_edges(simplified) == last_number_of_arcs)
      continue;
    last_number_of_arcs = num_edges(simplified);
    levels.push_back(page_level(given, threshold, simplified, simplification, frame, value_scale));
  }
  return levels;
}

nlohmann::ordered_json page_ticks(const Graph& graph, const nlohmann::ordered_json& levels)
{
  auto ticks = nlohmann::ordered_json::array();
  for(const Simplification_threshold& threshold : find_thresholds(graph, true))
  {
    std::size_t level = 0;
    while(level + 1 != levels.size() && levels[level + 1]["threshold"].get<double>() <= threshold.threshold)
      ++level;
    if(!ticks.empty() && ticks.back()["level"] == level)
      ticks.erase(ticks.size() - 1);
    ticks.push_back({{"level", level}, {"threshold", threshold.threshold}, {"is_suggested", threshold.is_suggested}});
  }
  return ticks;
}

} // namespace reeb_graph_program
