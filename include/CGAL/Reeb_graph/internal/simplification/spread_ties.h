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

#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Weighted_graph.h>
#include <CGAL/Reeb_graph/internal/simplification/Moved_pieces.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The part of the threshold, and of the range of the values, that vertices of one value are spread over at the most.
inline constexpr int largest_spread_divisor = 1024;

// The values of saddles with which vertices around their pieces are tied, so that no number is left for the piece; each
// with the largest change that keeps the changes in the pieces below the threshold. `saddles` and `orders` are those of
// Moved_pieces: pieces in an order of their own need all vertices of the value to differ.
template <class Scalar>
std::map<Scalar, Scalar> find_tied_saddles(const scalar_fields::Weighted_graph& graph,
                                           const std::vector<Index>& saddles,
                                           const std::vector<Scalar>& values,
                                           const typename Moved_pieces<Scalar>::Orders& orders,
                                           Scalar threshold)
{
  std::map<Scalar, Scalar> rooms;
  const auto place = [&](Index v) { return saddles[v] == no_index ? v : saddles[v]; };
  for(Index v = 0; v != values.size(); ++v)
  {
    if(saddles[v] == no_index)
      continue;
    for(const auto& neighbor : graph.neighbors(v))
    {
      if(place(neighbor.vertex) != saddles[v] && values[place(neighbor.vertex)] == values[saddles[v]])
        rooms.emplace(values[saddles[v]], threshold / largest_spread_divisor);
    }
  }
  for(const auto& [saddle, order] : orders)
    rooms.emplace(values[saddle], threshold / largest_spread_divisor);
  for(Index v = 0; v != values.size() && !rooms.empty(); ++v)
  {
    const auto room = saddles[v] == no_index ? rooms.end() : rooms.find(values[saddles[v]]);
    if(room != rooms.end())
      room->second = (std::min)(room->second, (threshold - std::abs(values[v] - room->first)) / 2);
  }
  return rooms;
}

// Gives the vertices of each such value values of their own, in the order of the vertices, between it and the next larger
// value. The order of all vertices, and so the graph, stays the same.
template <class Scalar>
std::vector<Scalar> spread_ties(const std::vector<Scalar>& values, const std::map<Scalar, Scalar>& rooms)
{
  std::vector<Scalar> spread = values;
  if(rooms.empty())
    return spread;
  std::vector<Index> ascending(values.size());
  std::iota(ascending.begin(), ascending.end(), Index(0));
  std::stable_sort(ascending.begin(), ascending.end(), [&](Index u, Index v) { return values[u] < values[v]; });
  const Scalar infinity = std::numeric_limits<Scalar>::infinity();
  const Scalar range = values[ascending.back()] - values[ascending.front()]; // 0 if there are no other values
  const Scalar largest_spread = range > 0 ? range / largest_spread_divisor : infinity;
  for(const auto& [value, largest_room] : rooms)
  {
    const auto begin = std::partition_point(ascending.begin(), ascending.end(),
                                            [&, value = value](Index v) { return values[v] < value; });
    const auto end =
      std::partition_point(begin, ascending.end(), [&, value = value](Index v) { return !(value < values[v]); });
    const Scalar next = end == ascending.end() ? infinity : values[*end];
    const Scalar room = (std::min)({largest_room, largest_spread, (next - value) / 2});
    const Scalar size = static_cast<Scalar>(end - begin);
    for(auto it = begin + 1; it != end; ++it)
    {
      spread[*it] = value + room * (static_cast<Scalar>(it - begin) / size);
      if(!(spread[it[-1]] < spread[*it] && spread[*it] < next))
        throw Scalar_resolution_error(*it);
    }
  }
  return spread;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_SPREAD_TIES_H
