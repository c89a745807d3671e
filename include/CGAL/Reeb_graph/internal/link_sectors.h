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

#include <algorithm>

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

// The number of link sectors: how often the neighbors change between lower and higher ones as one turns around the
// vertex. At a border vertex one more, as the link is a path.
template <class Order>
Index count_link_sectors(const Triangle_complex& complex, const Order& order, Index vertex)
{
  const Index first = complex.first_halfedge(vertex);
  if(first == no_index)
    return 0;
  bool is_upper = order(vertex, complex.source(first));
  Index number_of_changes = 0;
  complex.for_each_halfedge_around(vertex, [&](Index halfedge) {
    const bool is_next_upper = order(vertex, complex.target(complex.next(halfedge)));
    number_of_changes += is_upper != is_next_upper;
    is_upper = is_next_upper;
  });
  return complex.is_on_border(vertex) ? number_of_changes + 1 : (std::max)(number_of_changes, Index(1));
}

// Writes the link sectors of `vertex`, `size` many, to `sectors`, in clockwise order. Upper and lower ones alternate.
// Returns whether the first one is upper.
template <class Order>
bool find_link_sectors(const Triangle_complex& complex,
                       const Order& order,
                       Index vertex,
                       Index size,
                       Link_sector* sectors)
{
  bool is_first_upper = false, is_last_upper = false;
  Index number = 0;
  Link_sector* last = sectors;
  complex.for_each_edge_around(vertex, [&](Index neighbor, Index halfedge) {
    const bool is_upper = order(vertex, neighbor);
    const Link_sector edge = {neighbor, halfedge};
    const bool is_changed = number != 0 && is_last_upper != is_upper;
    is_last_upper = is_upper;
    if(number == 0)
      is_first_upper = is_upper;
    if(number == 0 || (is_changed && number != size))
    {
      last = sectors + number++;
      *last = edge;
      return;
    }
    if(is_changed) // The turn has begun within a sector, which goes on here.
      last = sectors;
    if(is_upper ? order(last->extreme_neighbor, neighbor) : order(neighbor, last->extreme_neighbor))
      *last = edge;
  });
  return is_first_upper;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_LINK_SECTORS_H
