// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_LEVEL_SET_COMPONENT_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_LEVEL_SET_COMPONENT_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/mesh/Simplicial_complex.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/walks/contour_of_complex.h>

#include <boost/unordered_map.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A component of a level set of a complex as a graph: a point on each crossed edge, and a line in each crossed
// triangle.
struct Level_set_component
{
  typedef std::array<Number, 2> Line; // the numbers of two points

  std::vector<Edge_index> edges; // by the numbers of their points
  std::vector<Line> lines;
};

// The component on the edge `start`. Points are numbered in the order in which a search finds them, breadth first.
template <class IsBelow>
Level_set_component find_level_set_component(const Simplicial_complex& complex,
                                             Edge_index start,
                                             const IsBelow& is_below)
{
  Level_set_component component;
  boost::unordered_map<Number, Number> point_of_edge;
  const auto find_point = [&](Edge_index edge) {
    const auto inserted = point_of_edge.emplace(edge.number(), static_cast<Number>(component.edges.size()));
    if(inserted.second)
      component.edges.push_back(edge);
    return inserted.first->second;
  };
  find_point(start);
  for(Number point = 0; point != component.edges.size(); ++point)
  {
    const Edge_index edge = component.edges[point];
    for_each_crossed_edge_beside(complex, edge, is_below, [&](Edge_index beside, Triangle_index) {
      const Number other_point = find_point(beside);
      if(point < other_point) // so that each line comes once
        component.lines.push_back({point, other_point});
    });
  }
  return component;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_LEVEL_SET_COMPONENT_H
