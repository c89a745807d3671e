// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "page/page_data.h"

#include "base/report.h"

#include <CGAL/Reeb_graph/plane_layout.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
typedef std::vector<std::size_t> Numbers;
typedef std::vector<std::array<double, 2>> Plane_line;

// The places of points and vertices, numbered as nodes, and then arcs.
struct Skeleton_places
{
  explicit Skeleton_places(const Page_of_skeleton& page)
    : of_points(num_vertices(page.skeleton.graph), Skeleton::none),
      of_vertices(page.skeleton.vertex_map.size(), 0), // vertices without faces are not seen
      numbers_of_vertices(page.skeleton.arcs.size(), 0)
  {
    const Skeleton& skeleton = page.skeleton;
    for(const auto& arc : skeleton.arcs)
      for(const std::size_t point : {arc.front(), arc.back()})
        if(of_points[point] == Skeleton::none)
        {
          of_points[point] = nodes.size();
          nodes.push_back(point);
        }
    for(std::size_t arc = 0; arc != skeleton.arcs.size(); ++arc)
      for(const std::size_t point : skeleton.arcs[arc])
        if(of_points[point] == Skeleton::none)
          of_points[point] = nodes.size() + arc;
    for(const Surface::Vertex_index v : page.surface.vertices())
      if(skeleton.vertex_map[v] != Skeleton::none)
      {
        of_vertices[v] = of_points[skeleton.vertex_map[v]];
        if(of_vertices[v] < nodes.size())
          vertices_at_nodes.push_back(v);
        else
          ++numbers_of_vertices[of_vertices[v] - nodes.size()];
      }
  }

  Numbers of_points, of_vertices;
  Numbers nodes; // their points
  std::vector<Surface::Vertex_index> vertices_at_nodes;
  std::vector<std::int64_t> numbers_of_vertices; // on each arc
};

// The skeleton in the plane, as high as its points are far from the root.
struct Skeleton_layout
{
  std::vector<double> columns;   // of the points that are nodes
  std::vector<Plane_line> lines; // of the arcs, from their first points to the last
};

// Arcs that close a loop are laid out in two pieces, from their ends up to their farthest point.
Skeleton_layout lay_out(const Skeleton& skeleton, const std::vector<double>& distances)
{
  std::vector<std::array<std::size_t, 2>> pieces; // lower and upper points
  Numbers tops;
  for(const auto& arc : skeleton.arcs)
  {
    const auto is_lower = [&](std::size_t a, std::size_t b) {
      return std::make_pair(distances[a], a) < std::make_pair(distances[b], b);
    };
    tops.push_back(*std::max_element(arc.begin(), arc.end(), is_lower));
    for(const std::size_t end : {arc.front(), arc.back()})
      if(end != tops.back())
        pieces.push_back({end, tops.back()});
  }
  Numbers order(num_vertices(skeleton.graph));
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return distances[a] < distances[b]; });
  std::vector<bool> is_node(order.size(), false);
  for(const auto& piece : pieces)
    is_node[piece[0]] = is_node[piece[1]] = true;
  Numbers nodes(order.size());
  Graph graph;
  for(const std::size_t point : order)
    if(is_node[point])
    {
      nodes[point] = add_vertex(graph);
      graph[nodes[point]].value = distances[point];
    }
  for(const auto& [lower, upper] : pieces)
    add_edge(nodes[lower], nodes[upper], graph);
  CGAL::Reeb_graph::Plane_layout layout = CGAL::Reeb_graph::lay_out_in_plane(graph);

  Skeleton_layout result = {std::vector<double>(order.size(), 0), {}};
  for(std::size_t point = 0; point != order.size(); ++point)
    if(is_node[point])
      result.columns[point] = layout.node_positions[nodes[point]];
  auto piece = layout.arc_polylines.begin();
  for(std::size_t arc = 0; arc != skeleton.arcs.size(); ++arc)
  {
    Plane_line& line = result.lines.emplace_back();
    if(skeleton.arcs[arc].front() != tops[arc])
      line = *piece++;
    if(skeleton.arcs[arc].back() != tops[arc])
    {
      line.insert(line.end(), piece->rbegin() + (line.empty() ? 0 : 1), piece->rend());
      ++piece;
    }
  }
  return result;
}

Arc_table table_of_skeleton(const Skeleton& skeleton, std::vector<std::int64_t> numbers_of_vertices)
{
  typedef CGAL::Reeb_graph::Skeleton_branch Branch;
  Arc_table table;
  const auto add = [&](const char* name, double Branch::*member) {
    std::vector<double> numbers;
    for(const Branch& branch : skeleton.branches)
      numbers.push_back(branch.*member);
    table.columns.push_back({{name, std::move(numbers)}, Arc_joining::ALONG_CHAIN, Arc_unit::DIFFERENCE});
  };
  add("length", &Branch::length);
  add("radius", &Branch::radius);
  add("least_radius", &Branch::least_radius);
  add("greatest_radius", &Branch::greatest_radius);
  add("inscribed_radius", &Branch::inscribed_radius);
  table.columns.push_back({{"vertices", std::move(numbers_of_vertices)}, Arc_joining::WITH_NODES, Arc_unit::COUNT});
  return table;
}

nlohmann::ordered_json page_graph(const Skeleton& skeleton,
                                  const std::vector<double>& distances,
                                  const Skeleton_places& places,
                                  const Arc_table& table,
                                  const Page_frame& frame)
{
  const Skeleton_layout layout = lay_out(skeleton, distances);
  const Value_scale value_scale(distances);
  std::vector<std::size_t> degrees(places.nodes.size(), 0);
  auto arcs = nlohmann::ordered_json::array();
  auto e = edges(skeleton.graph).first; // along the arcs, in their order
  for(std::size_t i = 0; i != skeleton.arcs.size(); ++i)
  {
    Numbers points = skeleton.arcs[i];
    Plane_line plane = layout.lines[i];
    std::vector<int> are_in_junction;
    while(are_in_junction.size() + 1 != points.size())
      are_in_junction.push_back(skeleton.graph[*e++].is_in_junction ? 1 : 0);
    for(const std::size_t end : {points.front(), points.back()})
      ++degrees[places.of_points[end]];
    if(distances[points.back()] < distances[points.front()])
    {
      std::reverse(points.begin(), points.end());
      std::reverse(plane.begin(), plane.end());
      std::reverse(are_in_junction.begin(), are_in_junction.end());
    }
    Polyline line;
    std::vector<double> radii, inscribed_radii;
    for(const std::size_t point : points)
    {
      line.push_back(skeleton.graph[point].point);
      radii.push_back(frame.rounded(skeleton.graph[point].radius));
      inscribed_radii.push_back(frame.rounded(skeleton.graph[point].inscribed_radius));
    }
    nlohmann::ordered_json arc = {{"source", places.of_points[points.front()]},
                                  {"target", places.of_points[points.back()]}};
    arc["polyline"] = flat_polyline(line, frame);
    arc["radii"] = std::move(radii);
    arc["inscribed_radii"] = std::move(inscribed_radii);
    arc["junctions"] = std::move(are_in_junction);
    arc["plane"] = flat_drawing(plane, value_scale);
    add_columns(table, i, arc);
    arc["chain"] = nullptr;
    arc["contours"] = nullptr;
    arcs.push_back(std::move(arc));
  }
  auto nodes = nlohmann::ordered_json::array();
  for(std::size_t i = 0; i != places.nodes.size(); ++i)
  {
    const std::size_t point = places.nodes[i];
    nodes.push_back({{"value", number_or_string(distances[point])},
                     {"kind", degrees[i] == 1   ? "end"
                              : degrees[i] == 2 ? "loop"
                                                : "junction"},
                     {"vertex", point},
                     {"point", frame.coordinates(skeleton.graph[point].point)},
                     {"column", layout.columns[point]}});
  }
  return {{"nodes", std::move(nodes)}, {"arcs", std::move(arcs)}};
}

nlohmann::ordered_json page_counts(const CGAL::Reeb_graph::Skeleton_certificate& known)
{
  return {{"components", known.number_of_components},
          {"arcs", known.number_of_arcs},
          {"ends", known.number_of_ends},
          {"border_ends", known.number_of_border_ends},
          {"junctions", known.number_of_junctions},
          {"loops", known.number_of_loops}};
}

} // namespace

nlohmann::ordered_json page_data(const Page_of_skeleton& page)
{
  const Skeleton& skeleton = page.skeleton;
  const Page_frame frame(page.surface);
  const Skeleton_places places(page);
  const std::vector<double> distances = distances_along_lines(skeleton);
  const Scalar_map map =
    page.surface.add_property_map<Surface::Vertex_index, double>("v:distance_along_lines", 0).first;
  for(const Surface::Vertex_index v : page.surface.vertices())
    if(skeleton.vertex_map[v] != Skeleton::none)
      map[v] = distances[skeleton.vertex_map[v]];
  const Display_surface surface = display_surface(
    {page.surface, map, places.of_vertices, places.nodes.size(), places.vertices_at_nodes, std::nullopt}, frame);
  const Arc_table table = table_of_skeleton(skeleton, places.numbers_of_vertices);

  nlohmann::ordered_json data =
    begin_data(page.title, page.up, {"distance along the lines", page.unit}, Value_scale(distances));
  data["skeleton"] = page_counts(skeleton.certificate);
  data["surface"] = page_surface(page.surface.number_of_faces(), surface, frame);
  data["columns"] = page_columns(table);
  data["graph"] = page_graph(skeleton, distances, places, table, frame);
  data["graph"]["is_simplified"] = false;
  data["graph"]["arcs_of_input"] = skeleton.arcs.size();
  data["graph"]["threshold"] = 0;
  Numbers arcs(skeleton.arcs.size());
  std::iota(arcs.begin(), arcs.end(), std::size_t(0));
  data["levels"] = nlohmann::ordered_json::array();
  data["levels"].push_back({{"threshold", 0}, {"arcs", arcs}});
  for(const char* name : {"ticks", "curves", "loops"})
    data[name] = nlohmann::ordered_json::array();
  return data;
}

} // namespace reeb_graph_program
