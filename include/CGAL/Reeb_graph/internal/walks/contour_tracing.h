// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_WALKS_CONTOUR_TRACING_H
#define CGAL_REEB_GRAPH_INTERNAL_WALKS_CONTOUR_TRACING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Plain_vector.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Walks along a contour, from the edge of the halfedge `start` into its triangle. At the border it goes back to the
// start, and on to the other side.
//
// All along a contour the source of the entered edge stays on the same side of the level, so that one comparison
// per triangle tells the way: the contour keeps its apex on the side of that end which it does not separate from it.
template <class Complex>
class Contour_walk
{
public:
  template <class IsBelow>
  Contour_walk(const Complex& complex, Halfedge_index start, const IsBelow& is_below)
    : complex_(&complex),
      start_(start),
      entered_(start),
      steps_left_(std::size_t(complex.number_of_edges()) + 2),
      is_source_below_(is_below(complex.source(start))),
      is_border_reached_(complex.is_on_border_edge(start))
  {}

  // Goes to the next crossing edge. Returns whether there was one. Around an edge whose ends are on one side of the
  // level, as an order that contradicts itself may have it, the walk might never end.
  template <class IsBelow>
  bool go_on(const IsBelow& is_below)
  {
    if(--steps_left_ == 0)
      complex_->throw_contradiction_near(complex_->source(start_));
    if(!complex_->has_triangle(entered_) && !turn_round())
      return false;
    const Halfedge_index next = complex_->next(entered_);
    const Halfedge_index left = is_below(complex_->target(next)) == is_source_below_ ? next : complex_->next(next);
    entered_ = opposite_of(left);
    is_border_reached_ |= !complex_->has_triangle(entered_);
    return entered_ != start_;
  }

  // A halfedge of a triangle on the edge that has been reached, and the one from its lower end to its higher one.
  Halfedge_index crossed_edge() const { return opposite_of(entered_); }
  Halfedge_index ascending_edge() const { return is_source_below_ ? entered_ : opposite_of(entered_); }
  bool is_border_reached() const { return is_border_reached_; }
  bool has_turned() const { return has_turned_; }

  // Whether the contour is closed, when the walk has ended.
  bool is_closed() const { return complex_->has_triangle(entered_); }

private:
  bool turn_round()
  {
    if(has_turned_ || !complex_->has_triangle(opposite_of(start_)))
      return false;
    has_turned_ = true;
    entered_ = opposite_of(start_);
    is_source_below_ = !is_source_below_;
    return true;
  }

  const Complex* complex_;
  Halfedge_index start_;
  Halfedge_index entered_;
  std::size_t steps_left_;
  bool is_source_below_;
  bool is_border_reached_;
  bool has_turned_ = false;
};

// Calls visit(halfedge) once for each edge of the contour that crosses the edge of `start`, which has a triangle, as
// have all the other ones, until a call returns true.
template <class Complex, class IsBelow, class Visit>
void visit_contour(const Complex& complex, Halfedge_index start, const IsBelow& is_below, const Visit& visit)
{
  if(visit(start))
    return;
  Contour_walk walk(complex, start, is_below);
  while(walk.go_on(is_below))
  {
    if(visit(walk.crossed_edge()))
      return;
  }
}

// Calls visit(halfedge) in the same way for all edges of the contour.
template <class Complex, class IsBelow, class Visit>
void trace_contour(const Complex& complex, Halfedge_index start, const IsBelow& is_below, const Visit& visit)
{
  visit_contour(complex, start, is_below, [&](Halfedge_index halfedge) {
    visit(halfedge);
    return false;
  });
}

// Replaces the content of `crossed` by halfedges of the edges of the contour that crosses the edge of `start`, in the
// order in which they follow each other with the higher side on the left. Returns whether the contour is closed.
template <class Complex, class IsBelow>
bool trace_oriented_contour(const Complex& complex,
                            Halfedge_index start,
                            const IsBelow& is_below,
                            Plain_vector<Halfedge_index>& crossed)
{
  // Who enters a triangle over an edge has the source of that edge on the left.
  const Halfedge_index forward = is_below(complex.source(start)) ? opposite_of(start) : start;
  Contour_walk walk(complex, forward, is_below);
  crossed.clear();
  std::ptrdiff_t number_of_forward_edges = 0;
  while(walk.go_on(is_below))
  {
    crossed.push_back(walk.crossed_edge());
    number_of_forward_edges += walk.has_turned() ? 0 : 1;
  }
  std::reverse(crossed.begin() + number_of_forward_edges, crossed.end());
  crossed.push_back(start);
  std::rotate(crossed.begin(), crossed.begin() + number_of_forward_edges, crossed.end());
  return walk.is_closed();
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_WALKS_CONTOUR_TRACING_H
