// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/skeleton.h"

#include "base/progress_bar.h"

#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/skeleton/extract_curve_skeleton.h>
#include <CGAL/Reeb_graph/skeleton/find_branch_faces.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
// A point and its distance along a line, of which the nearest comes first out of a queue.
typedef std::pair<double, std::size_t> Way;

// Finds distances along lines from a point, by the ways from each point to its neighbors, and returns what is reached: what
// had a smaller mark than this one, and gets it.
std::vector<std::size_t> spread(const std::vector<std::vector<Way>>& ways,
                                std::size_t from,
                                std::vector<double>& distances,
                                std::vector<int>& marks,
                                int mark)
{
  std::vector<std::size_t> reached;
  std::priority_queue<Way, std::vector<Way>, std::greater<>> queue;
  for(queue.emplace(0, from); !queue.empty();)
  {
    const auto [length, point] = queue.top();
    queue.pop();
    if(marks[point] == mark)
      continue;
    marks[point] = mark;
    distances[point] = length;
    reached.push_back(point);
    for(const auto& [more, neighbor] : ways[point])
      queue.emplace(length + more, neighbor);
  }
  return reached;
}

} // namespace

void complete(Skeleton& skeleton)
{
  CGAL::Reeb_graph::mark_junctions(skeleton.graph);
  skeleton.arcs = CGAL::Reeb_graph::skeleton_arcs(skeleton.graph);
  skeleton.trees = CGAL::Reeb_graph::skeleton_trees(skeleton.graph);
  skeleton.branches = CGAL::Reeb_graph::measure_branches(skeleton.graph, skeleton.trees);
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
                    .ends_at_borders(settings.are_borders_ends)
                    .callback(std::ref(progress_bar));
  skeleton.certificate = scalar_map
                         ? CGAL::Reeb_graph::extract_curve_skeleton(surface, graph, np.scalar_map(*scalar_map))
                         : CGAL::Reeb_graph::extract_curve_skeleton(surface, graph, np);
  skeleton.vertex_map.assign(surface.num_vertices(), Skeleton::none);
  for(const auto v : CGAL::make_range(vertices(graph)))
    for(const Surface::Vertex_index of_surface : graph[v].vertices)
      skeleton.vertex_map[of_surface] = v;
  complete(skeleton);
  skeleton.face_arcs.resize(surface.num_faces());
  skeleton.are_faces_in_junctions.resize(surface.num_faces());
  const auto face_index_map = get(CGAL::face_index, surface);
  CGAL::Reeb_graph::find_branch_faces(
    surface, graph, boost::make_iterator_property_map(skeleton.face_arcs.begin(), face_index_map),
    boost::make_iterator_property_map(skeleton.are_faces_in_junctions.begin(), face_index_map));
  for(auto& branch : skeleton.branches)
    branch.area = 0;
  for(const Surface::Face_index f : surface.faces())
  {
    std::vector<Point> corners;
    for(const Surface::Vertex_index v : surface.vertices_around_face(surface.halfedge(f)))
      corners.push_back(surface.point(v));
    skeleton.branches[skeleton.face_arcs[f]].area +=
      CGAL::Reeb_graph::internal::area_of(corners[0], corners[1], corners[2]);
  }
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
  std::vector<std::vector<Way>> ways(num_vertices(graph));
  for(const auto e : CGAL::make_range(edges(graph)))
  {
    const std::size_t a = source(e, graph), b = target(e, graph);
    const double length = CGAL::Reeb_graph::internal::distance_between(graph[a].point, graph[b].point);
    ways[a].emplace_back(length, b);
    ways[b].emplace_back(length, a);
  }
  std::vector<double> distances(ways.size(), 0);
  std::vector<int> marks(ways.size(), 0);
  for(const auto& arc : skeleton.arcs)
  {
    if(marks[arc.front()] != 0)
      continue;
    const std::vector<std::size_t> component = spread(ways, arc.front(), distances, marks, 1);
    const auto end = std::find_if(component.rbegin(), component.rend(), // the farthest one
                                  [&](std::size_t point) { return ways[point].size() == 1; });
    if(end != component.rend())
      spread(ways, *end, distances, marks, 2);
  }
  return distances;
}

std::vector<Polyline> polylines_of(const Skeleton& skeleton)
{
  std::vector<Polyline> polylines;
  for(const auto& arc : skeleton.arcs)
  {
    polylines.emplace_back();
    for(const std::size_t v : arc)
      polylines.back().push_back(skeleton.graph[v].point);
  }
  return polylines;
}

} // namespace reeb_graph_program
