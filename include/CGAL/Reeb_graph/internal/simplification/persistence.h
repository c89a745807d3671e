// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_PERSISTENCE_H
#define CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_PERSISTENCE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/simplification/exceptions.h>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

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
  constexpr bool are_exact = !std::is_arithmetic_v<Value_of_node<ReebGraph>> && !Has_scalar_to_double<Traits>::value;
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

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_PERSISTENCE_H
