// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_PERSISTENCE_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_PERSISTENCE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/graph_topology.h>
#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/simplification/exceptions.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Exact numbers are rounded one by one, each with an error of its own. One that comes out of order by that, seen from the
// last one, is taken to be equal.
template <class Scalar>
double number_in_order(const Scalar& value, double number, const Scalar& last_value, double last_number)
{
  const bool is_out_of_order = last_value < value ? number < last_number
                             : value < last_value ? number > last_number
                                                  : number != last_number;
  return is_out_of_order ? last_number : number;
}

// By node, the numbers of the values.
template <class ReebGraph, class NamedParameters>
std::vector<double> numbers_of_nodes(const ReebGraph& graph, const NamedParameters& np)
{
  typedef Traits_of_nodes<ReebGraph, NamedParameters> Traits;
  constexpr bool are_exact = !std::is_arithmetic_v<Value_of_node<ReebGraph>> && !Has<Scalar_to_double, Traits>::value;
  const auto conversion = choose_conversion_of_nodes<ReebGraph>(np);
  std::vector<double> numbers;
  numbers.reserve(num_vertices(graph));
  for(std::size_t node = 0; node != num_vertices(graph); ++node)
  {
    numbers.push_back(conversion.to_double(graph[node].value));
    if(std::isnan(numbers.back()))
      throw Measure_error("value of a node");
    if constexpr(are_exact)
    {
      if(node != 0)
        numbers[node] = number_in_order(graph[node].value, numbers[node], graph[node - 1].value, numbers[node - 1]);
    }
  }
  return numbers;
}

// With another order than that of numbers, values can fall along an arc. The difference of infinities is no number.
inline double persistence(double lower, double upper) { return lower == upper ? 0 : std::abs(upper - lower); }

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

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_PERSISTENCE_H
