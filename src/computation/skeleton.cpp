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

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <utility>

namespace reeb_graph_program {
namespace {
double distance(const Skeleton& skeleton, std::size_t a, std::size_t b)
{
  const Point &p = skeleton.points[a], &q = skeleton.points[b];
  return CGAL::Reeb_graph::internal::length_of(p.x() - q.x(), p.y() - q.y(), p.z() - q.z());
}

Skeleton_arc_row row_of(const Skeleton& skeleton, const std::vector<std::size_t>& arc, std::size_t component)
{
  Skeleton_arc_row row = {arc.front(), arc.back(), component};
  row.least_radius = row.greatest_radius = skeleton.radii[arc.front()];
  for(std::size_t i = 1; i != arc.size(); ++i)
  {
    const std::size_t a = arc[i - 1], b = arc[i];
    const double length = distance(skeleton, a, b);
    row.length += length;
    row.radius += length * (skeleton.radii[a] + skeleton.radii[b]) / 2;
    row.inscribed_radius += length * (skeleton.inscribed_radii[a] + skeleton.inscribed_radii[b]) / 2;
    row.least_radius = std::min(row.least_radius, skeleton.radii[b]);
    row.greatest_radius = std::max(row.greatest_radius, skeleton.radii[b]);
  }
  if(row.length > 0)
  {
    row.radius /= row.length;
    row.inscribed_radius /= row.length;
  }
  return row;
}

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

Skeleton extract_skeleton(const Surface& surface,
                          const std::optional<Scalar_map>& scalar_map,
                          const Skeleton_settings& settings)
{
  CGAL::Reeb_graph::Curve_skeleton<Surface> graph;
  Skeleton skeleton;
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
  {
    skeleton.points.push_back(graph[v].point);
    skeleton.radii.push_back(graph[v].radius);
    skeleton.inscribed_radii.push_back(graph[v].inscribed_radius);
    for(const Surface::Vertex_index of_surface : graph[v].vertices)
      skeleton.vertex_map[of_surface] = v;
  }
  skeleton.arcs = CGAL::Reeb_graph::skeleton_arcs(graph);
  return skeleton;
}

std::vector<Arc_place> places_of_arcs(const Skeleton& skeleton)
{
  std::map<std::size_t, std::vector<std::size_t>> arcs_of_nodes;
  for(std::size_t arc = 0; arc != skeleton.arcs.size(); ++arc)
    for(const std::size_t node : {skeleton.arcs[arc].front(), skeleton.arcs[arc].back()})
      arcs_of_nodes[node].push_back(arc);
  std::vector<Arc_place> places(skeleton.arcs.size());
  std::vector<bool> is_placed(skeleton.arcs.size(), false);
  std::size_t number_of_components = 0;
  for(std::size_t root = 0; root != skeleton.arcs.size(); ++root)
  {
    if(is_placed[root])
      continue;
    struct Step
    {
      std::size_t node, depth;
    };
    std::vector<Step> queue = {{skeleton.arcs[root].front(), 0}};
    for(std::size_t i = 0; i != queue.size(); ++i)
    {
      const Step step = queue[i];
      for(const std::size_t arc : arcs_of_nodes[step.node])
      {
        if(is_placed[arc])
          continue;
        is_placed[arc] = true;
        places[arc] = {number_of_components, step.depth};
        const auto& points = skeleton.arcs[arc];
        queue.push_back({points.front() == step.node ? points.back() : points.front(), step.depth + 1});
      }
    }
    ++number_of_components;
  }
  return places;
}

std::vector<Skeleton_arc_row> rows_of_arcs(const Skeleton& skeleton)
{
  const std::vector<Arc_place> places = places_of_arcs(skeleton);
  std::vector<Skeleton_arc_row> rows;
  for(std::size_t arc = 0; arc != skeleton.arcs.size(); ++arc)
    rows.push_back(row_of(skeleton, skeleton.arcs[arc], places[arc].component));
  return rows;
}

std::vector<double> distances_along_lines(const Skeleton& skeleton)
{
  std::vector<std::vector<Way>> ways(skeleton.points.size());
  for(const auto& arc : skeleton.arcs)
    for(std::size_t i = 1; i != arc.size(); ++i)
    {
      const double length = distance(skeleton, arc[i - 1], arc[i]);
      ways[arc[i - 1]].emplace_back(length, arc[i]);
      ways[arc[i]].emplace_back(length, arc[i - 1]);
    }
  std::vector<double> distances(skeleton.points.size(), 0);
  std::vector<int> marks(skeleton.points.size(), 0);
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
      polylines.back().push_back(skeleton.points[v]);
  }
  return polylines;
}

} // namespace reeb_graph_program
