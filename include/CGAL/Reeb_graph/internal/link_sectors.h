// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_LINK_SECTORS_H
#define CGAL_REEB_GRAPH_INTERNAL_LINK_SECTORS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/Large_vector.h>
#include <CGAL/Reeb_graph/internal/Triangle_complex.h>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A connected component of the upper or of the lower link of a vertex, given by its extreme neighbor: the highest
// one of an upper sector, the lowest one of a lower sector.
struct Link_sector
{
  Index extreme_neighbor;
  Index edge; // a halfedge of a triangle on the edge to that neighbor
};

// Appends the link sectors of `vertex` to `sectors`, in clockwise order. Upper and lower ones alternate.
// Returns whether the first one is an upper one.
template <class Order>
bool append_link_sectors(const Triangle_complex& complex,
                         const Order& order,
                         Index vertex,
                         Large_vector<Link_sector>& sectors)
{
  const auto is_more_extreme = [&](const Link_sector& a, const Link_sector& b, bool is_upper) {
    return is_upper ? order(b.extreme_neighbor, a.extreme_neighbor) : order(a.extreme_neighbor, b.extreme_neighbor);
  };
  const std::size_t first = sectors.size();
  bool is_first_upper = false, is_last_upper = false;
  complex.for_each_edge_around(vertex, [&](Index neighbor, Index halfedge) {
    const bool is_upper = order(vertex, neighbor);
    const Link_sector edge = {neighbor, halfedge};
    if(sectors.size() == first)
      is_first_upper = is_upper;
    if(sectors.size() == first || is_last_upper != is_upper)
      sectors.push_back(edge);
    else if(is_more_extreme(edge, sectors.back(), is_upper))
      sectors.back() = edge;
    is_last_upper = is_upper;
  });
  const bool is_split_by_the_start =
    sectors.size() > first + 1 && is_first_upper == is_last_upper && !complex.is_on_border(vertex);
  if(is_split_by_the_start)
  {
    if(is_more_extreme(sectors.back(), sectors[first], is_last_upper))
      sectors[first] = sectors.back();
    sectors.pop_back();
  }
  return is_first_upper;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_LINK_SECTORS_H
