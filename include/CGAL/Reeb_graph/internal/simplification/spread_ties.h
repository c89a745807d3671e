// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_SPREAD_TIES_H
#define CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_SPREAD_TIES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/crossing_fraction.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Weighted_graph.h>
#include <CGAL/Reeb_graph/simplification/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The part of the threshold, and of the range of the values, that vertices of one value are spread over at the most.
inline constexpr int largest_spread_divisor = 1024;

// The saddles of one value with which other vertices are tied where there has to be room for a piece.
template <class Scalar>
struct Tied_saddles
{
  std::set<Index> saddles;
  Scalar largest_change; // keeps the changes in the pieces below the threshold
};

// These saddles, by value: those of pieces with a neighbor of the value of the saddle, as no number is between the two.
// `saddles` are those of Moved_pieces.
template <class Scalar>
std::map<Scalar, Tied_saddles<Scalar>> find_tied_saddles(const scalar_fields::Weighted_graph& graph,
                                                         const std::vector<Index>& saddles,
                                                         const std::vector<Scalar>& values,
                                                         Scalar threshold)
{
  std::map<Scalar, Tied_saddles<Scalar>> tied_saddles;
  const auto add = [&](Index saddle) {
    auto& tied = tied_saddles[values[saddle]];
    tied.saddles.insert(saddle);
    tied.largest_change = threshold / largest_spread_divisor;
  };
  const auto place = [&](Index v) { return saddles[v] == no_index ? v : saddles[v]; };
  for(Index v = 0; v != values.size(); ++v)
  {
    if(saddles[v] == no_index)
      continue;
    for(const auto& neighbor : graph.neighbors(v))
    {
      if(place(neighbor.vertex) != saddles[v] && values[place(neighbor.vertex)] == values[saddles[v]])
        add(saddles[v]);
    }
  }
  for(Index v = 0; v != values.size() && !tied_saddles.empty(); ++v)
  {
    const auto tied = saddles[v] == no_index ? tied_saddles.end() : tied_saddles.find(values[saddles[v]]);
    if(tied != tied_saddles.end())
      tied->second.largest_change =
        (std::min)(tied->second.largest_change, (threshold - std::abs(values[v] - tied->first)) / 2);
  }
  return tied_saddles;
}

// Tells these saddles apart from the vertices tied with them, by values between this one and the next larger one: those
// of the value that come before the first saddle keep it, and those between two saddles have one value. The order of
// all vertices, and so the graph, stays the same.
template <class Complex, class Scalar>
std::vector<Scalar> spread_ties(const Complex& complex,
                                const std::vector<Scalar>& values,
                                const std::map<Scalar, Tied_saddles<Scalar>>& tied_saddles)
{
  std::vector<Scalar> spread = values;
  if(tied_saddles.empty())
    return spread;
  std::vector<Index> ascending;
  for(const Vertex_index v : complex.vertices())
  {
    if(complex.has_vertex(v))
      ascending.push_back(v.number());
  }
  std::stable_sort(ascending.begin(), ascending.end(), [&](Index u, Index v) { return values[u] < values[v]; });
  const Scalar infinity = std::numeric_limits<Scalar>::infinity();
  const Scalar lowest = values[ascending.front()], highest = values[ascending.back()];
  const Scalar largest_spread =
    lowest < highest ? part_of_difference(lowest, highest, largest_spread_divisor) : infinity;
  for(const auto& [value, tied] : tied_saddles)
  {
    const auto begin = std::partition_point(ascending.begin(), ascending.end(),
                                            [&, value = value](Index v) { return values[v] < value; });
    const auto end =
      std::partition_point(begin, ascending.end(), [&, value = value](Index v) { return !(value < values[v]); });
    const Scalar next = end == ascending.end() ? infinity : values[*end];
    const Scalar room = (std::min)({tied.largest_change, largest_spread, (next - value) / 2});
    const auto size = static_cast<Scalar>(2 * tied.saddles.size() + 1);
    std::size_t number_of_steps = 0;
    for(auto it = begin; it != end; ++it)
    {
      const bool is_step = it != begin && (tied.saddles.count(*it) != 0 || tied.saddles.count(it[-1]) != 0);
      number_of_steps += is_step ? 1 : 0;
      if(number_of_steps != 0)
        spread[*it] = value + room * (static_cast<Scalar>(number_of_steps) / size);
      if((is_step && !(spread[it[-1]] < spread[*it])) || !(spread[*it] < next || number_of_steps == 0))
        throw Perturbed_ties_error(complex.position(Vertex_index(*it)));
    }
  }
  return spread;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_SPREAD_TIES_H
