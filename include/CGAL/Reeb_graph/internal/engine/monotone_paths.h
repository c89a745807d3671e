// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_MONOTONE_PATHS_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_MONOTONE_PATHS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/base/tuning.h>
#include <CGAL/Reeb_graph/internal/base/union_find.h>
#include <CGAL/Reeb_graph/internal/complex/Unchecked_complex.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL::Reeb_graph::internal {

// A lower neighbor of a vertex and a higher one, no_index if there is none.
typedef By_side<Vertex_index> Monotone_neighbors;

// The monotone neighbors of the vertices in blocks of which many are critical. There, nearly each vertex is on a
// monotone path; elsewhere, to find the few steps of paths again takes less than to keep all of them.
class Kept_neighbors
{
public:
  static constexpr std::size_t block_size = 512;
  typedef std::array<Monotone_neighbors, block_size> Block;

  explicit Kept_neighbors(std::size_t number_of_vertices) : neighbors_(number_of_vertices, {no_index, no_index}) {}

  static bool are_worth_keeping(std::size_t number_of_critical_vertices, std::size_t number_of_vertices)
  {
    return is_used(Tuned_part::KEPT_NEIGHBORS) && number_of_critical_vertices > number_of_vertices / 8;
  }

  void keep(const Block& block, std::size_t begin, std::size_t end)
  {
    std::copy_n(block.begin(), end - begin, &neighbors_[Vertex_index(begin)]);
  }

  // Whether neighbors have been kept: in unset places, both are the same.
  bool has_neighbors(Vertex_index vertex) const
  {
    return neighbors_[vertex][Side::LOWER] != neighbors_[vertex][Side::UPPER];
  }
  Vertex_index neighbor(Vertex_index vertex, Side side) const { return neighbors_[vertex][side]; }

  void prefetch(Vertex_index vertex) const { internal::prefetch(&neighbors_[vertex]); }

private:
  Indexed_vector<Vertex_index, Monotone_neighbors> neighbors_;
};

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

// What one turn around a vertex finds.
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

// A step of an ascending path: the edge of which `edge` is a halfedge that has a triangle, up to its higher end
// `target`.
struct Ascending_step
{
  Halfedge_index edge;
  Vertex_index target;
};

// The step from `vertex`, which is no maximum, to its highest neighbor. Without a branch, as none could be predicted.
template <class Complex, class Order>
Ascending_step steepest_step(const Complex& complex, const Order& order, Vertex_index vertex)
{
  Ascending_step step = {no_index, vertex};
  complex.for_each_edge_around(vertex, [&](Vertex_index neighbor, Halfedge_index halfedge) {
    const bool is_higher = order(step.target, neighbor);
    step.edge = is_higher ? halfedge : step.edge;
    step.target = is_higher ? neighbor : step.target;
  });
  return step;
}

// Takes steepest steps from `vertex` on as long as goes_on(vertex reached), and calls visit(vertex, step from it)
// before each. Returns the vertex reached.
template <class Complex, class Order, class GoesOn, class Visit>
Vertex_index climb(const Complex& complex,
                   const Order& order,
                   Vertex_index vertex,
                   const GoesOn& goes_on,
                   const Visit& visit)
{
  while(goes_on(vertex))
  {
    const Ascending_step step = steepest_step(complex, order, vertex);
    if(step.edge == no_index)
      complex.throw_contradiction_near(vertex);
    visit(vertex, step);
    vertex = step.target;
  }
  return vertex;
}

// Finds the component in whose extremum a monotone path ends: a minimum if it descends, to the lower side, for the join
// tree, a maximum if it ascends for the split tree.
// A vertex is passed once: its end is kept. Several threads that pass it keep the same end.
template <class Complex, class Order, Side direction>
class Monotone_path_ends
{
public:
  Monotone_path_ends(const Complex& complex, const Order& order, const Kept_neighbors& kept_neighbors)
    : complex_(&complex),
      order_(&order),
      kept_neighbors_(&kept_neighbors),
      ends_(complex.number_of_vertices())
  {}

  void set_end(Vertex_index vertex, Component_index end) { ends_[vertex].set(end.number() + 1); }
  Component_index end(Vertex_index vertex) const { return Component_index(ends_[vertex].get() - 1); }
  void prefetch(Vertex_index vertex) const { internal::prefetch(&ends_[vertex]); }
  bool is_known(Vertex_index vertex) const { return end(vertex) != no_index; }

  // The neighbor to which a path goes on, always the same one.
  Vertex_index next_vertex(Vertex_index vertex) const { return next_step(vertex).target; }

  // The edge over which the path goes on.
  Halfedge_index next_edge(Vertex_index vertex) const
  {
    const Vertex_index next = next_vertex(vertex);
    return find_edge(vertex, [&](Vertex_index neighbor) { return neighbor == next; }).edge;
  }

  // The end of the path that begins with `step`. A step to `target` is the last one if end_of_step(target, find_edge)
  // is not no_index, where find_edge() tells its edge. `passed` is storage for the vertices on the way.
  template <class EndOfStep>
  Component_index operator()(Ascending_step step, const EndOfStep& end_of_step, Plain_vector<Vertex_index>& passed)
  {
    passed.clear();
    return walk(step, end_of_step, passed);
  }

  // The end of the path from a vertex.
  template <class EndOfStep>
  Component_index end_of_path(Vertex_index vertex, const EndOfStep& end_of_step, Plain_vector<Vertex_index>& passed)
  {
    if(is_known(vertex))
      return end(vertex);
    passed.assign(1, vertex);
    const Ascending_step step = next_step(vertex);
    if(step.target == no_index)
      complex_->throw_contradiction_near(vertex);
    return walk(step, end_of_step, passed);
  }

private:
  // Goes on from the last vertex that has been passed.
  template <class EndOfStep>
  Component_index walk(Ascending_step step, const EndOfStep& end_of_step, Plain_vector<Vertex_index>& passed)
  {
    const auto find_edge = [&] { return step.edge != no_index ? step.edge : next_edge(passed.back()); };
    Component_index end = end_of_step(step.target, find_edge);
    while(end == no_index && (end = this->end(step.target)) == no_index)
    {
      passed.push_back(step.target);
      step = next_step(step.target);
      if(step.target == no_index || passed.size() > complex_->number_of_vertices())
        complex_->throw_contradiction_near(passed.back());
      end = end_of_step(step.target, find_edge);
    }
    for(const Vertex_index passed_vertex : passed)
      set_end(passed_vertex, end);
    return end;
  }

  // The next step, without its edge if the neighbor is kept: few steps need it.
  Ascending_step next_step(Vertex_index vertex) const
  {
    if(kept_neighbors_->has_neighbors(vertex))
      return {no_index, kept_neighbors_->neighbor(vertex, direction)};
    return find_edge(vertex, [&](Vertex_index neighbor) { return side_of((*order_)(vertex, neighbor)) == direction; });
  }

  // The first edge that leads to a neighbor that is wanted.
  template <class IsWanted>
  Ascending_step find_edge(Vertex_index vertex, const IsWanted& is_wanted) const
  {
    Ascending_step step = {no_index, no_index};
    complex_->visit_edges_around(vertex, [&](Vertex_index neighbor, Halfedge_index halfedge) {
      if(!is_wanted(neighbor))
        return false;
      step = {halfedge, neighbor};
      return true;
    });
    return step;
  }

  const Complex* complex_;
  const Order* order_;
  const Kept_neighbors* kept_neighbors_;
  Indexed_vector<Vertex_index, Relaxed_value<Number>> ends_; // the number behind that of the end, so that 0 is no_index
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_MONOTONE_PATHS_H
