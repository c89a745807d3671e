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
#include <array>

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

// Upper and lower link sectors alternate, so it is enough to know how many there are and with which a turn begins.
struct Link_summary
{
  Index number_of_sectors;
  bool is_first_upper;

  Index number_of_upper_sectors() const { return (number_of_sectors + is_first_upper) / 2; }
  Index number_of_lower_sectors() const { return number_of_sectors - number_of_upper_sectors(); }
};

// The number of link sectors is how often the neighbors change between lower and higher ones as one turns around the
// vertex. At a border vertex it is one more, as the link is a path.
template <class Order>
Link_summary summarize_link(const Triangle_complex& complex, const Order& order, Index vertex)
{
  const Index first = complex.first_halfedge(vertex);
  if(first == no_index)
    return {0, false};
  const bool is_first_upper = order(vertex, complex.source(first));
  bool is_upper = is_first_upper;
  Index number_of_changes = 0;
  complex.for_each_halfedge_around(vertex, [&](Index halfedge) {
    const bool is_next_upper = order(vertex, complex.target(complex.next(halfedge)));
    number_of_changes += is_upper != is_next_upper;
    is_upper = is_next_upper;
  });
  return {complex.is_on_border(vertex) ? number_of_changes + 1 : (std::max)(number_of_changes, Index(1)),
          is_first_upper};
}

// Writes the link sectors of `vertex`, the lower ones and the upper ones each in clockwise order, to the two places.
template <class Order>
void find_link_sectors(const Triangle_complex& complex,
                       const Order& order,
                       Index vertex,
                       const Link_summary& summary,
                       const std::array<Link_sector*, 2>& places)
{
  bool is_last_upper = summary.is_first_upper;
  for(Index i = 0; i != summary.number_of_sectors; ++i, is_last_upper = !is_last_upper)
    places[is_last_upper][i / 2] = {vertex, no_index};

  // Without a branch that could not be predicted.
  is_last_upper = summary.is_first_upper;
  Index i = 0;
  complex.for_each_edge_around(vertex, [&](Index neighbor, Index halfedge) {
    const bool is_upper = order(vertex, neighbor);
    i += is_upper != is_last_upper;
    i = i == summary.number_of_sectors ? 0 : i; // The turn has begun within a sector, which goes on here.
    is_last_upper = is_upper;
    Link_sector sector = places[is_upper][i / 2];
    const bool is_more_extreme = order(sector.extreme_neighbor, neighbor) == is_upper;
    sector.extreme_neighbor = is_more_extreme ? neighbor : sector.extreme_neighbor;
    sector.edge = is_more_extreme ? halfedge : sector.edge;
    places[is_upper][i / 2] = sector;
  });
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_LINK_SECTORS_H
