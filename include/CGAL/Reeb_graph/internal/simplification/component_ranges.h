// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_COMPONENT_RANGES_H
#define CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_COMPONENT_RANGES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/graph_topology.h>
#include <CGAL/Reeb_graph/internal/simplification/persistence.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// By node, the difference between the highest and the lowest value of its connected component.
template <class ReebGraph>
std::vector<double> component_ranges(const ReebGraph& graph, const std::vector<double>& values)
{
  const std::size_t number_of_nodes = num_vertices(graph);
  std::vector<std::size_t> components(number_of_nodes), lowest(number_of_nodes, number_of_nodes),
    highest(number_of_nodes);
  number_components(
    graph, boost::make_iterator_property_map(components.begin(), boost::typed_identity_property_map<std::size_t>()));
  for(std::size_t node = 0; node != number_of_nodes; ++node)
  {
    const std::size_t component = components[node];
    highest[component] = node;
    if(lowest[component] == number_of_nodes)
      lowest[component] = node;
  }
  std::vector<double> ranges(number_of_nodes);
  for(std::size_t node = 0; node != number_of_nodes; ++node)
    ranges[node] = persistence(values[lowest[components[node]]], values[highest[components[node]]]);
  return ranges;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_COMPONENT_RANGES_H
