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

#include <CGAL/Reeb_graph/internal/Triangle_complex.h>

#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A connected component of the upper or of the lower link of a vertex, given by its extreme neighbor: the highest
// one of an upper sector, the lowest one of a lower sector.
struct Link_sector
{
  bool is_upper;
  Index extreme_neighbor;
  Index edge; // the corner that faces the edge to that neighbor
};

template <class Order>
bool is_more_extreme(const Link_sector& a, const Link_sector& b, const Order& order)
{
  return a.is_upper ? order(b.extreme_neighbor, a.extreme_neighbor) : order(a.extreme_neighbor, b.extreme_neighbor);
}

// Appends the link sectors of `vertex` to `sectors`, in counterclockwise order. Upper and lower ones alternate.
template <class Order>
void append_link_sectors(const Triangle_complex& complex,
                         const Order& order,
                         Index vertex,
                         std::vector<Link_sector>& sectors)
{
  const std::size_t first = sectors.size();
  complex.for_each_edge_around(vertex, [&](Index neighbor, Index corner) {
    const Link_sector edge = {order(vertex, neighbor), neighbor, corner};
    if(sectors.size() == first || sectors.back().is_upper != edge.is_upper)
      sectors.push_back(edge);
    else if(is_more_extreme(edge, sectors.back(), order))
      sectors.back() = edge;
  });
  const bool is_split_by_the_start =
    sectors.size() > first + 1 && sectors[first].is_upper == sectors.back().is_upper && !complex.is_on_border(vertex);
  if(is_split_by_the_start)
  {
    if(is_more_extreme(sectors.back(), sectors[first], order))
      sectors[first] = sectors.back();
    sectors.pop_back();
  }
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_LINK_SECTORS_H
