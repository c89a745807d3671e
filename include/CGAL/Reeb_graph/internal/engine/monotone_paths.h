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
#include <CGAL/Reeb_graph/internal/engine/vertex_links.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL::Reeb_graph::internal {

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
