// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/skeleton.h"

#include "base/progress_bar.h"
#include "computation/nearest_place.h"

#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/skeleton/extract_curve_skeleton.h>
#include <CGAL/Reeb_graph/skeleton/find_branch_faces.h>
#include <CGAL/Reeb_graph/skeleton/measure_branch_faces.h>
#include <CGAL/Reeb_graph/skeleton/skeleton_paths.h>

#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace reeb_graph_program {
std::vector<std::size_t> points_at(const Skeleton& skeleton, const Skeleton_place& place)
{
  const auto& graph = skeleton.graph;
  std::vector<std::size_t> points;
  for(const auto v : CGAL::make_range(vertices(graph)))
    if(place.kind != Skeleton_place::TIPS || out_degree(v, graph) == 1)
      points.push_back(v);
  if(place.kind == Skeleton_place::TIPS || points.empty())
    return points;
  if(place.kind == Skeleton_place::VERTEX)
  {
    const auto& map = skeleton.vertex_map;
    if(place.vertex >= map.size() || map[place.vertex] == Skeleton::none)
      throw std::runtime_error("the surface has no vertex " + std::to_string(place.vertex)
                               + (place.vertex < map.size() ? " with faces" : ""));
    return {map[place.vertex]};
  }
  const auto rank = [&](std::size_t v) {
    return place.kind == Skeleton_place::THICKEST
           ? -graph[v].inscribed_radius
           : CGAL::Reeb_graph::internal::distance_between(graph[v].point, place.point);
  };
  std::stable_sort(points.begin(), points.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  return points;
}

namespace {
double distance_from_lines(const Skeleton& skeleton, const Point& point)
{
  const auto& graph = skeleton.graph;
  double least = std::numeric_limits<double>::infinity();
  const auto visit = [&](const Point& a, const Point& b) {
    least = (std::min)(least, CGAL::Reeb_graph::internal::distance_between(nearest_point(point, {a, b, b}), point));
  };
  for(const auto v : CGAL::make_range(vertices(graph))) // some have no segment
    visit(graph[v].point, graph[v].point);
  for(const auto e : CGAL::make_range(edges(graph)))
    visit(graph[source(e, graph)].point, graph[target(e, graph)].point);
  return least;
}
} // namespace

void find_paths(Skeleton& skeleton, const std::vector<Skeleton_place>& from, const std::vector<Skeleton_place>& to)
{
  const auto points = [&](const std::vector<Skeleton_place>& places) {
    std::vector<std::size_t> result;
    for(const Skeleton_place& place : places)
    {
      const std::vector<std::size_t> found = points_at(skeleton, place);
      const auto end = place.kind == Skeleton_place::TIPS || found.empty() ? found.end() : found.begin() + 1;
      result.insert(result.end(), found.begin(), end);
      if(place.kind == Skeleton_place::POINT && !found.empty())
        skeleton.places.push_back({place.point, found.front(), distance_from_lines(skeleton, place.point)});
    }
    return result;
  };
  const std::vector<std::size_t> first = points(from), last = points(to);
  for(const std::size_t v : first)
    for(std::vector<std::size_t>& path : CGAL::Reeb_graph::skeleton_paths(skeleton.graph, v, last))
      if(path.size() > 1)
        skeleton.paths.push_back(std::move(path));
}

double length_of_path(const Skeleton& skeleton, const std::vector<std::size_t>& path)
{
  double length = 0;
  for(std::size_t i = 1; i < path.size(); ++i)
    length +=
      CGAL::Reeb_graph::internal::distance_between(skeleton.graph[path[i - 1]].point, skeleton.graph[path[i]].point);
  return length;
}

void complete(Skeleton& skeleton, const std::optional<Skeleton_place>& root)
{
  CGAL::Reeb_graph::mark_junctions(skeleton.graph);
  skeleton.arcs = CGAL::Reeb_graph::skeleton_arcs(skeleton.graph);
  skeleton.trees =
    CGAL::Reeb_graph::skeleton_trees(skeleton.graph, root ? points_at(skeleton, *root) : std::vector<std::size_t>());
  skeleton.branches = CGAL::Reeb_graph::measure_branches(skeleton.graph, skeleton.trees);
  if(!root || root->kind != Skeleton_place::THICKEST)
    return;
  std::vector<double> lengths;
  for(const auto& branch : skeleton.branches)
  {
    lengths.resize((std::max)(lengths.size(), branch.component + 1), 0);
    lengths[branch.component] += branch.length;
  }
  std::ptrdiff_t tree = std::max_element(lengths.begin(), lengths.end()) - lengths.begin();
  for(std::size_t i = 0; i != skeleton.trees.size(); ++i)
    if(skeleton.trees[i].parent == Skeleton::none && tree-- == 0)
      skeleton.soma = i;
}

Skeleton extract_skeleton(const Surface& surface,
                          const std::optional<Scalar_map>& scalar_map,
                          const Skeleton_settings& settings)
{
  Skeleton skeleton;
  auto& graph = skeleton.graph;
  Progress_bar progress_bar("skeleton");
  const auto np = CGAL::parameters::pruning_ratio(settings.pruning_ratio)
                    .sampling_ratio(settings.sampling_ratio)
                    .smooth(settings.smooth)
                    .spacing(settings.spacing)
                    .ends_at_borders(settings.are_borders_ends)
                    .callback(std::ref(progress_bar));
  skeleton.certificate = scalar_map
                         ? CGAL::Reeb_graph::extract_curve_skeleton(surface, graph, np.scalar_map(*scalar_map))
                         : CGAL::Reeb_graph::extract_curve_skeleton(surface, graph, np);
  skeleton.vertex_map.assign(surface.num_vertices(), Skeleton::none);
  for(const auto v : CGAL::make_range(vertices(graph)))
    for(const Surface::Vertex_index of_surface : graph[v].vertices)
      skeleton.vertex_map[of_surface] = v;
  complete(skeleton, settings.root);
  skeleton.face_arcs.resize(surface.num_faces());
  skeleton.are_faces_in_junctions.resize(surface.num_faces());
  const auto face_index_map = get(CGAL::face_index, surface);
  const auto arc_map = boost::make_iterator_property_map(skeleton.face_arcs.begin(), face_index_map);
  const auto junction_map = boost::make_iterator_property_map(skeleton.are_faces_in_junctions.begin(), face_index_map);
  CGAL::Reeb_graph::find_branch_faces(surface, graph, arc_map, junction_map);
  skeleton.number_inside_out =
    CGAL::Reeb_graph::measure_branch_faces(surface, arc_map, junction_map, skeleton.branches);
  return skeleton;
}

Skeleton_numbers numbers_of(const Skeleton& skeleton)
{
  Skeleton_numbers numbers;
  double sum = 0;
  std::size_t number_of_open = 0;
  for(const auto& branch : skeleton.branches)
  {
    numbers.cable_length += branch.length;
    numbers.area += branch.area;
    numbers.volume += branch.volume;
    numbers.junction_area += branch.junction_area;
    numbers.junction_volume += branch.junction_volume;
    if(std::isnan(branch.tortuosity))
      continue;
    sum += branch.tortuosity;
    ++number_of_open;
  }
  if(number_of_open > 0)
    numbers.mean_tortuosity = sum / static_cast<double>(number_of_open);
  for(const std::size_t order : CGAL::Reeb_graph::strahler_orders(skeleton.trees))
    numbers.order = (std::max)(numbers.order, order);
  return numbers;
}

std::vector<double> distances_along_lines(const Skeleton& skeleton)
{
  const auto& graph = skeleton.graph;
  typedef boost::graph_traits<std::decay_t<decltype(graph)>>::edge_descriptor Edge;
  const auto length = [&](Edge e) {
    return CGAL::Reeb_graph::internal::distance_between(graph[source(e, graph)].point, graph[target(e, graph)].point);
  };
  const auto index_map = get(boost::vertex_index, graph);
  std::vector<double> distances(num_vertices(graph));
  const auto find_distances_from = [&](const std::vector<std::size_t>& points) {
    boost::dijkstra_shortest_paths(graph, points.begin(), points.end(), boost::dummy_property_map(),
                                   boost::make_iterator_property_map(distances.begin(), index_map),
                                   boost::make_function_property_map<Edge, double>(length), index_map, std::less<>(),
                                   std::plus<>(), std::numeric_limits<double>::infinity(), 0.,
                                   boost::dijkstra_visitor<>(),
                                   boost::make_two_bit_color_map(distances.size(), index_map));
  };
  std::vector<std::size_t> components(distances.size());
  std::vector<std::size_t> firsts(
    boost::connected_components(graph, boost::make_iterator_property_map(components.begin(), index_map)));
  for(std::size_t v = distances.size(); v-- > 0;)
    firsts[components[v]] = v;
  for(auto arc = skeleton.arcs.rbegin(); arc != skeleton.arcs.rend(); ++arc)
    firsts[components[arc->front()]] = arc->front();
  find_distances_from(firsts);
  std::vector<std::size_t> ends = firsts; // the farthest ones
  for(std::size_t v = 0; v != distances.size(); ++v)
  {
    std::size_t& end = ends[components[v]];
    if(out_degree(v, graph) == 1 && (out_degree(end, graph) != 1 || distances[v] >= distances[end]))
      end = v;
  }
  find_distances_from(ends);
  return distances;
}

std::vector<Polyline> polylines_of(const Skeleton& skeleton)
{
  std::vector<Polyline> polylines;
  for(const auto& line : skeleton.paths.empty() ? skeleton.arcs : skeleton.paths)
  {
    polylines.emplace_back();
    for(const std::size_t v : line)
      polylines.back().push_back(skeleton.graph[v].point);
  }
  return polylines;
}

} // namespace reeb_graph_program
