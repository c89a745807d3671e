// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_REMOVE_EXTREMA_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_REMOVE_EXTREMA_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>
#include <CGAL/Reeb_graph/options.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

// An order of the vertices in which each free one has a lower and a higher neighbor, as close to that of the values as
// this needs. Vertices that are monotone already, those from which a path of strictly falling values and one of
// strictly rising values lead to fixed vertices, stay in the order of their values. Each connected part of the other
// ones, such as a thin leg where the field is flat to all digits, is numbered anew, in one place between two of its
// monotone or fixed neighbors.
//
// Such a place exists: no vertex of a connected surface parts it, as its link is connected. So if some of the
// neighbors become one source and the other ones one sink, the part with both has an st-numbering, in which each
// vertex has a lower and a higher neighbor. The only exception is a part whose neighbors are fixed to one value; it
// is constant.
template <class Scalar>
class Extremum_free_order
{
public:
  Extremum_free_order(const Weighted_graph& graph, const std::vector<bool>& is_fixed, const std::vector<Scalar>& values)
    : graph_(graph),
      is_fixed_(is_fixed),
      values_(values),
      is_monotone_(graph.number_of_vertices(), true)
  {
    find_monotone_vertices();
    if(is_changed())
    {
      place_other_vertices();
      merge();
    }
  }

  // Whether there is a vertex that is not monotone. Only then is there an order.
  bool is_changed() const { return std::find(is_monotone_.begin(), is_monotone_.end(), false) != is_monotone_.end(); }

  // The vertices, from the lowest to the highest one.
  const std::vector<Index>& ascending() const { return ascending_; }

  // Gives the vertices of parts that can have no value but that of the fixed vertices around them this value.
  void set_constant_values(std::vector<Scalar>& values) const
  {
    for(const Part& part : parts_)
      if(part.lower_neighbor == no_index)
        for(const Index v : part.vertices)
          values[v] = part.constant_value;
  }

private:
  // The order by value; of equal values, fixed vertices come first, so that a value is fixed once or not at all.
  bool is_lower(Index u, Index v) const
  {
    return std::make_tuple(values_[u], !is_fixed_[u], u) < std::make_tuple(values_[v], !is_fixed_[v], v);
  }

  template <class IsStrictlyHigher>
  std::vector<bool> reach_from_fixed_vertices(const IsStrictlyHigher& is_strictly_higher) const
  {
    std::vector<bool> is_reached = is_fixed_;
    std::vector<Index> stack;
    for(Index v = 0; v != graph_.number_of_vertices(); ++v)
      if(is_fixed_[v])
        stack.push_back(v);
    while(!stack.empty())
    {
      const Index v = stack.back();
      stack.pop_back();
      for(const auto& n : graph_.neighbors(v))
        if(!is_reached[n.vertex] && is_strictly_higher(values_[n.vertex], values_[v]))
        {
          is_reached[n.vertex] = true;
          stack.push_back(n.vertex);
        }
    }
    return is_reached;
  }

  void find_monotone_vertices()
  {
    const auto is_reached_upwards = reach_from_fixed_vertices([](Scalar a, Scalar b) { return a > b; });
    const auto is_reached_downwards = reach_from_fixed_vertices([](Scalar a, Scalar b) { return a < b; });
    for(Index v = 0; v != graph_.number_of_vertices(); ++v)
      is_monotone_[v] = is_reached_upwards[v] && is_reached_downwards[v];
  }

  struct Part
  {
    std::vector<Index> vertices;     // ascending once the part is placed
    Index lower_neighbor = no_index; // none for a constant part
    Scalar constant_value = 0;
  };

  void place_other_vertices()
  {
    part_of_vertex_.assign(graph_.number_of_vertices(), no_index);
    St_numbering st_numbering(graph_);
    for(Index v = 0; v != graph_.number_of_vertices(); ++v)
    {
      if(is_monotone_[v] || part_of_vertex_[v] != no_index)
        continue;
      const auto number = static_cast<Index>(parts_.size());
      parts_.push_back(collect_part(v, number));
      place(parts_.back(), number, st_numbering);
    }
  }

  Part collect_part(Index first, Index number)
  {
    Part part;
    part.vertices.push_back(first);
    part_of_vertex_[first] = number;
    for(std::size_t i = 0; i != part.vertices.size(); ++i)
      for(const auto& n : graph_.neighbors(part.vertices[i]))
        if(!is_monotone_[n.vertex] && part_of_vertex_[n.vertex] == no_index)
        {
          part_of_vertex_[n.vertex] = number;
          part.vertices.push_back(n.vertex);
        }
    return part;
  }

  // The monotone and fixed vertices next to a part, from the lowest to the highest.
  std::vector<Index> neighbors_of_part(const Part& part) const
  {
    std::vector<Index> result;
    for(const Index v : part.vertices)
      for(const auto& n : graph_.neighbors(v))
        if(is_monotone_[n.vertex])
          result.push_back(n.vertex);
    std::sort(result.begin(), result.end(), [&](Index u, Index v) { return is_lower(u, v); });
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // Places a part in the largest gap between the values of its neighbors, where there is the most room.
  void place(Part& part, Index number, St_numbering& st_numbering)
  {
    const std::vector<Index> neighbors = neighbors_of_part(part);
    std::size_t best = 0;
    for(std::size_t i = 1; i < neighbors.size(); ++i)
    {
      const Index u = neighbors[i - 1], v = neighbors[i];
      const bool are_fixed_to_one_value = is_fixed_[u] && is_fixed_[v] && values_[u] == values_[v];
      if(!are_fixed_to_one_value && (best == 0 || gap(neighbors, i) > gap(neighbors, best)))
        best = i;
    }
    if(best == 0)
    {
      part.constant_value = values_[neighbors.front()];
      return;
    }
    const Index lowest_of_upper = neighbors[best];
    part.lower_neighbor = neighbors[best - 1];
    part.vertices = st_numbering(
      part.vertices, [&](Index v) { return part_of_vertex_[v] == number; },
      [&](Index v) { return is_lower(v, lowest_of_upper); });
  }

  Scalar gap(const std::vector<Index>& neighbors, std::size_t i) const
  {
    return values_[neighbors[i]] - values_[neighbors[i - 1]];
  }

  // Merges the parts into the order of the monotone vertices; each follows its lower neighbor.
  void merge()
  {
    std::vector<Index> monotone_vertices;
    for(Index v = 0; v != graph_.number_of_vertices(); ++v)
      if(is_monotone_[v])
        monotone_vertices.push_back(v);
    std::sort(monotone_vertices.begin(), monotone_vertices.end(), [&](Index u, Index v) { return is_lower(u, v); });
    std::vector<std::size_t> next_part(parts_.size(), parts_.size());
    std::vector<std::size_t> first_part(graph_.number_of_vertices(), parts_.size());
    for(std::size_t i = parts_.size(); i-- > 0;)
      if(parts_[i].lower_neighbor != no_index)
      {
        next_part[i] = first_part[parts_[i].lower_neighbor];
        first_part[parts_[i].lower_neighbor] = i;
      }
    ascending_.reserve(graph_.number_of_vertices());
    for(const Index v : monotone_vertices)
    {
      ascending_.push_back(v);
      for(std::size_t i = first_part[v]; i != parts_.size(); i = next_part[i])
        ascending_.insert(ascending_.end(), parts_[i].vertices.begin(), parts_[i].vertices.end());
    }
  }

  const Weighted_graph& graph_;
  const std::vector<bool>& is_fixed_;
  const std::vector<Scalar>& values_;
  std::vector<bool> is_monotone_;
  std::vector<Part> parts_;
  std::vector<Index> part_of_vertex_;
  std::vector<Index> ascending_;
};

// The supports of each free vertex: a neighbor that is to be strictly lower, and one that is to be strictly higher.
struct Supports
{
  std::vector<Index> lower, upper; // no_index for fixed and constant vertices

  template <class Scalar>
  Supports(const Weighted_graph& graph, const std::vector<bool>& is_fixed, const Extremum_free_order<Scalar>& order)
    : lower(graph.number_of_vertices(), no_index),
      upper(graph.number_of_vertices(), no_index)
  {
    std::vector<Index> ranks(graph.number_of_vertices(), no_index);
    Index rank = 0;
    for(const Index v : order.ascending())
      ranks[v] = rank++;
    const auto is_lower = [&](const auto& a, const auto& b) { return ranks[a.vertex] < ranks[b.vertex]; };
    for(const Index v : order.ascending())
      if(!is_fixed[v])
      {
        const auto neighbors = graph.neighbors(v);
        const auto lowest_and_highest = std::minmax_element(neighbors.begin(), neighbors.end(), is_lower);
        lower[v] = lowest_and_highest.first->vertex;
        upper[v] = lowest_and_highest.second->vertex;
      }
  }
};

// Sweeps over the vertices upwards, and raises each to `move` of its lower support, and its upper support to that of
// it; or sweeps downwards, and lowers them.
template <class Scalar, class Move>
std::vector<Scalar> sweep(Side begin,
                          const std::vector<Index>& ascending,
                          const Supports& supports,
                          std::vector<Scalar> values,
                          const Move& move)
{
  const bool is_upwards = begin == Side::LOWER;
  const std::vector<Index>&before = is_upwards ? supports.lower : supports.upper,
        &behind = is_upwards ? supports.upper : supports.lower;
  const auto push = [&](Index v, Index support) {
    const Scalar bound = move(values[support]);
    values[v] = is_upwards ? (std::max)(values[v], bound) : (std::min)(values[v], bound);
  };
  for(std::size_t i = 0; i != ascending.size(); ++i)
  {
    const Index v = ascending[is_upwards ? i : ascending.size() - 1 - i];
    if(before[v] == no_index)
      continue;
    push(v, before[v]);
    if(before[behind[v]] != no_index)
      push(behind[v], v);
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
  constexpr Scalar infinity = std::numeric_limits<Scalar>::infinity();
  const auto same = [](Scalar value) { return value; };
  const auto next_above = [](Scalar value) { return std::nextafter(value, infinity); };
  const auto next_below = [](Scalar value) { return std::nextafter(value, -infinity); };
  std::vector<Scalar> lowest = values, highest = values;
  for(const Index v : ascending)
    if(!is_fixed[v])
    {
      lowest[v] = -infinity;
      highest[v] = infinity;
    }
  lowest = sweep(Side::LOWER, ascending, supports, std::move(lowest), next_above);
  highest = sweep(Side::UPPER, ascending, supports, std::move(highest), next_below);

  const std::vector<Scalar> above = sweep(Side::LOWER, ascending, supports, values, same);
  const std::vector<Scalar> below = sweep(Side::UPPER, ascending, supports, values, same);
  for(const Index v : ascending)
  {
    if(is_fixed[v])
      continue;
    if(!(lowest[v] <= highest[v]))
      throw Scalar_resolution_error(v);
    if(above[v] != below[v])
      values[v] = above[v] / 2 + below[v] / 2;
  }
  for(const Index v : ascending)
    if(!is_fixed[v])
      values[v] = (std::min)((std::max)(values[v], lowest[v]), highest[v]);
  values = sweep(Side::LOWER, ascending, supports, std::move(values), next_above);
  order.set_constant_values(values);
}

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_REMOVE_EXTREMA_H
