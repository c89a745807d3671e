// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_REMOVE_EXTREMA_H
#define CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_REMOVE_EXTREMA_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Extremum_free_order.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Weighted_graph.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

template <class Scalar>
Scalar next_above(Scalar value)
{
  return std::nextafter(value, std::numeric_limits<Scalar>::infinity());
}

template <class Scalar>
Scalar next_below(Scalar value)
{
  return std::nextafter(value, -std::numeric_limits<Scalar>::infinity());
}

// The supports of each free vertex: a neighbor that is to be strictly lower, and one that is to be strictly higher.
struct Supports
{
  std::vector<Position> lower, upper; // no_position for fixed and constant vertices

  template <class Scalar>
  Supports(const Weighted_graph& graph, const std::vector<bool>& is_fixed, const Extremum_free_order<Scalar>& order)
    : lower(graph.number_of_vertices(), no_position),
      upper(graph.number_of_vertices(), no_position)
  {
    std::vector<Position> ranks(graph.number_of_vertices(), no_position);
    Position rank = 0;
    for(const Position v : order.ascending())
      ranks[v] = rank++;
    const auto is_lower = [&](const auto& a, const auto& b) { return ranks[a.vertex] < ranks[b.vertex]; };
    for(const Position v : order.ascending())
      if(!is_fixed[v])
      {
        const auto neighbors = graph.neighbors(v);
        const auto lowest_and_highest = std::minmax_element(neighbors.begin(), neighbors.end(), is_lower);
        lower[v] = lowest_and_highest.first->vertex;
        upper[v] = lowest_and_highest.second->vertex;
      }
  }
};

// Sweeps over the vertices in ascending order, and raises each to `raise` of its lower neighbors.
template <class Scalar, class Raise>
std::vector<Scalar> sweep_upwards(const std::vector<Position>& ascending,
                                  const Supports& supports,
                                  std::vector<Scalar> values,
                                  const Raise& raise)
{
  for(const Position v : ascending)
  {
    if(supports.lower[v] == no_position)
      continue;
    values[v] = (std::max)(values[v], raise(values[supports.lower[v]]));
    const Position upper = supports.upper[v];
    if(supports.upper[upper] != no_position)
      values[upper] = (std::max)(values[upper], raise(values[v]));
  }
  return values;
}

// Sweeps over the vertices in descending order, and lowers each to `lower` of its higher neighbors.
template <class Scalar, class Lower>
std::vector<Scalar> sweep_downwards(const std::vector<Position>& ascending,
                                    const Supports& supports,
                                    std::vector<Scalar> values,
                                    const Lower& lower)
{
  for(auto it = ascending.rbegin(); it != ascending.rend(); ++it)
  {
    const Position v = *it;
    if(supports.upper[v] == no_position)
      continue;
    values[v] = (std::min)(values[v], lower(values[supports.upper[v]]));
    const Position below = supports.lower[v];
    if(supports.lower[below] != no_position)
      values[below] = (std::min)(values[below], lower(values[v]));
  }
  return values;
}

// Moves values of free vertices as little as it takes, so that each has a neighbor of strictly lower and one of
// strictly higher value. Without rounding to neighboring numbers it would be the least in the maximum norm: the mean
// of the lowest monotone function above the values and of the highest one below them.
template <class Scalar>
void remove_extrema(const Weighted_graph& graph, const std::vector<bool>& is_fixed, std::vector<Scalar>& values)
{
  const Extremum_free_order<Scalar> order(graph, is_fixed, values);
  if(!order.is_changed())
    return;
  const Supports supports(graph, is_fixed, order);
  const auto& ascending = order.ascending();
  const auto same = [](Scalar value) { return value; };

  const Scalar infinity = std::numeric_limits<Scalar>::infinity();
  std::vector<Scalar> lowest = values, highest = values;
  for(const Position v : ascending)
    if(!is_fixed[v])
    {
      lowest[v] = -infinity;
      highest[v] = infinity;
    }
  lowest = sweep_upwards(ascending, supports, std::move(lowest), next_above<Scalar>);
  highest = sweep_downwards(ascending, supports, std::move(highest), next_below<Scalar>);

  const std::vector<Scalar> above = sweep_upwards(ascending, supports, values, same);
  const std::vector<Scalar> below = sweep_downwards(ascending, supports, values, same);
  for(const Position v : ascending)
  {
    if(is_fixed[v])
      continue;
    if(!(lowest[v] <= highest[v]))
      throw Scalar_resolution_error(v);
    if(above[v] != below[v])
      values[v] = above[v] / 2 + below[v] / 2;
  }
  for(const Position v : ascending)
    if(!is_fixed[v])
      values[v] = (std::min)((std::max)(values[v], lowest[v]), highest[v]);
  values = sweep_upwards(ascending, supports, std::move(values), next_above<Scalar>);
  for(Position v = 0; v != graph.number_of_vertices(); ++v)
    if(order.is_constant(v))
      values[v] = order.constant_value(v);
}

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_REMOVE_EXTREMA_H
