// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_GRAPH_READ_GRAPH_H
#define CGAL_REEB_GRAPH_INTERNAL_GRAPH_READ_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The nodes of an arc, which are numbered in ascending order.
struct Ascending_arc
{
  Index lower, upper;
};

// The arcs of a Boost graph. Throws if one of them does not ascend.
template <class ReebGraph>
std::vector<Ascending_arc> read_arcs(const ReebGraph& graph)
{
  std::vector<Ascending_arc> arcs;
  arcs.reserve(num_edges(graph));
  checked_index(num_vertices(graph) + num_edges(graph));
  for(auto range = edges(graph); range.first != range.second; ++range.first)
  {
    const auto lower = source(*range.first, graph), upper = target(*range.first, graph);
    if(!(lower < upper))
      throw Graph_mismatch_error("an arc of the graph does not lead to a node of higher number");
    arcs.push_back({static_cast<Index>(lower), static_cast<Index>(upper)});
  }
  return arcs;
}

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
      throw Parameter_error("the value of a node is not a number (NaN)");
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

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_GRAPH_READ_GRAPH_H
