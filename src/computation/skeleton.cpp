// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/skeleton.h"

#include "base/progress_bar.h"

#include <CGAL/Reeb_graph/skeleton/extract_curve_skeleton.h>

#include <functional>
#include <map>

namespace reeb_graph_program {
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
