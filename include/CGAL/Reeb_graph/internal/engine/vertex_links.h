// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_VERTEX_LINKS_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_VERTEX_LINKS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/complex/Unchecked_complex.h>

#include <algorithm>

namespace CGAL::Reeb_graph::internal {

// A lower neighbor of a vertex and a higher one, no_index if there is none.
typedef By_side<Vertex_index> Monotone_neighbors;

// A connected component of the upper or of the lower link of a vertex, given by its extreme neighbor: the highest
// one of an upper sector, the lowest one of a lower sector.
struct Link_sector
{
  Vertex_index extreme_neighbor;
  Halfedge_index edge; // a halfedge of a triangle on the edge to that neighbor
};

// Upper and lower link sectors alternate, so it is enough to know how many there are and with which a turn begins.
struct Link_summary
{
  Number number_of_sectors;
  bool is_first_upper;

  Number number_of_upper_sectors() const { return (number_of_sectors + is_first_upper) / 2; }
  Number number_of_lower_sectors() const { return number_of_sectors - number_of_upper_sectors(); }
  Side first_side() const { return side_of(is_first_upper); }
};

// Findings of one turn around a vertex.
struct Vertex_link
{
  Link_summary summary;
  Monotone_neighbors neighbors;
};

// The link of a vertex that is known to be regular, without a turn.
inline constexpr Vertex_link regular_link = {{2, false}, {no_index, no_index}};

// Counts how often the neighbors of a vertex change between lower and higher ones. That is the number of link sectors
// if the last neighbor is the first one again; on the border, where the link is a path, there is one more.
template <class Order>
class Link_changes
{
public:
  Link_changes(const Order& order, Vertex_index vertex) : order_(order), vertex_(vertex) {}

  void begin(Vertex_index neighbor)
  {
    is_first_upper_ = is_last_upper_ = order_(vertex_, neighbor);
    set_neighbor(neighbor);
  }
  void add(Vertex_index neighbor)
  {
    const bool is_upper = order_(vertex_, neighbor);
    number_ += is_upper != is_last_upper_;
    is_last_upper_ = is_upper;
    set_neighbor(neighbor);
  }

  Vertex_link closed_link() const { return {{(std::max)(number_, Number(1)), is_first_upper_}, {lower_, higher_}}; }
  Vertex_link path() const { return {{number_ + 1, is_first_upper_}, {lower_, higher_}}; }

private:
  // Keeps a neighbor, without a branch that could not be predicted, nor an array, which would have to be in memory.
  void set_neighbor(Vertex_index neighbor)
  {
    lower_ = is_last_upper_ ? lower_ : neighbor;
    higher_ = is_last_upper_ ? neighbor : higher_;
  }

  const Order& order_;
  const Vertex_index vertex_;
  Number number_ = 0;
  Vertex_index lower_ = no_index;
  Vertex_index higher_ = no_index;
  bool is_first_upper_ = false;
  bool is_last_upper_ = false;
};

template <class Complex, class Order>
Vertex_link find_link(const Complex& complex, const Order& order, Vertex_index vertex)
{
  const Halfedge_index first = complex.first_halfedge(vertex);
  if(first == no_index)
    return {{0, false}, {no_index, no_index}};
  Link_changes<Order> changes(order, vertex);
  changes.begin(complex.source(first));
  complex.for_each_halfedge_around(
    vertex, [&](Halfedge_index halfedge) { changes.add(complex.target(complex.next(halfedge))); });
  return complex.is_on_border(vertex) ? changes.path() : changes.closed_link();
}

// Sets the fan of a vertex and finds its link: both in one turn if the vertex is inside of the surface.
template <class Complex, class Order>
Vertex_link set_fan_and_find_link(Unchecked_complex<Complex>& complex,
                                  const Order& order,
                                  Vertex_index vertex,
                                  Fan_counts& counts)
{
  Link_changes<Order> changes(order, vertex);
  return complex.set_fan(vertex, counts, changes) ? changes.closed_link()
                                                  : find_link(complex.at_set_fans(), order, vertex);
}

// Makes `neighbor` the extreme one of its sector if it is. Without a branch that could not be predicted.
template <class Order>
void add_to_sector(Link_sector& sector, const Order& order, Side side, Vertex_index neighbor, Halfedge_index halfedge)
{
  const bool is_more_extreme = order(sector.extreme_neighbor, neighbor) == (side == Side::UPPER);
  sector.extreme_neighbor = is_more_extreme ? neighbor : sector.extreme_neighbor;
  sector.edge = is_more_extreme ? halfedge : sector.edge;
}

// Writes the link sectors of `vertex`, the lower ones and the upper ones each in clockwise order, to the two places.
template <class Complex, class Order>
void find_link_sectors(const Complex& complex,
                       const Order& order,
                       Vertex_index vertex,
                       const Link_summary& summary,
                       const By_side<Link_sector*>& places)
{
  Side last_side = summary.first_side();
  for(Number i = 0; i != summary.number_of_sectors; ++i, last_side = opposite_of(last_side))
    places[last_side][i / 2] = {vertex, no_index};

  last_side = summary.first_side();
  Number i = 0;
  complex.for_each_edge_around(vertex, [&](Vertex_index neighbor, Halfedge_index halfedge) {
    const Side side = side_of(order(vertex, neighbor));
    i += side != last_side;
    i = i == summary.number_of_sectors ? 0 : i; // The turn has begun within a sector, which goes on here.
    last_side = side;
    Link_sector sector = places[side][i / 2];
    add_to_sector(sector, order, side, neighbor, halfedge);
    places[side][i / 2] = sector;
  });
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_VERTEX_LINKS_H
