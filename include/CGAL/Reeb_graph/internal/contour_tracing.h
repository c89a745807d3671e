// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TRACING_H
#define CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TRACING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/Large_vector.h>
#include <CGAL/Reeb_graph/internal/Triangle_complex.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Follows a contour from the edge of the halfedge `start` into its triangle, and calls visit(halfedge) for each further
// crossing edge, until it is back or at the border. Returns whether it came back.
//
// All along a contour the source of the entered edge stays on the same side of the level, so that one comparison
// per triangle tells the way: the contour keeps its apex on the side of that end which it does not separate from it.
template <class IsBelow, class Visit>
bool follow_contour(const Triangle_complex& complex, Index start, const IsBelow& is_below, const Visit& visit)
{
  const bool is_source_below = is_below(complex.source(start));
  Index entered = start;
  do
  {
    const Index next = complex.next(entered);
    const Index left = is_below(complex.target(next)) == is_source_below ? next : complex.next(next);
    entered = Triangle_complex::opposite(left);
    if(entered != start)
      visit(left);
  } while(entered != start && complex.has_triangle(entered));
  return entered == start;
}

// Calls visit(halfedge) once for each edge of the contour that crosses the edge of `start`. All these halfedges have
// triangles.
template <class IsBelow, class Visit>
void trace_contour(const Triangle_complex& complex, Index start, const IsBelow& is_below, const Visit& visit)
{
  visit(start);
  const bool is_closed = follow_contour(complex, start, is_below, visit);
  const Index opposite = Triangle_complex::opposite(start);
  if(!is_closed && complex.has_triangle(opposite))
    follow_contour(complex, opposite, is_below, visit);
}

// The same step by step.
class Contour_walk
{
public:
  template <class IsBelow>
  Contour_walk(const Triangle_complex& complex, Index start, const IsBelow& is_below)
    : complex_(&complex),
      start_(start),
      entered_(start),
      is_source_below_(is_below(complex.source(start))),
      is_border_reached_(complex.is_on_border_edge(start)),
      crossed_edges_(1, start)
  {}

  // Adds the next crossing edge. Returns whether there was one.
  template <class IsBelow>
  bool go_on(const IsBelow& is_below)
  {
    if(!complex_->has_triangle(entered_) && !turn_round())
      return false;
    const Index next = complex_->next(entered_);
    const Index left = is_below(complex_->target(next)) == is_source_below_ ? next : complex_->next(next);
    entered_ = Triangle_complex::opposite(left);
    if(entered_ == start_)
      return false;
    crossed_edges_.push_back(left);
    is_border_reached_ |= !complex_->has_triangle(entered_);
    return true;
  }

  // Halfedges of triangles, that of the start first.
  const Large_vector<Index>& crossed_edges() const { return crossed_edges_; }
  bool is_border_reached() const { return is_border_reached_; }

private:
  // At the border, the other part of the contour is left.
  bool turn_round()
  {
    if(has_turned_ || !complex_->has_triangle(Triangle_complex::opposite(start_)))
      return false;
    has_turned_ = true;
    entered_ = Triangle_complex::opposite(start_);
    is_source_below_ = !is_source_below_;
    return true;
  }

  const Triangle_complex* complex_;
  Index start_;
  Index entered_;
  bool is_source_below_;
  bool is_border_reached_;
  bool has_turned_ = false;
  Large_vector<Index> crossed_edges_;
};

// Replaces the content of `crossed` by halfedges of the edges of the contour that crosses the edge of `start`, in the
// order in which they follow each other with the higher side on the left. Returns whether the contour is closed.
template <class IsBelow>
bool trace_oriented_contour(const Triangle_complex& complex,
                            Index start,
                            const IsBelow& is_below,
                            Large_vector<Index>& crossed)
{
  // Who enters a triangle over an edge has the source of that edge on the left.
  Index forward = start, backward = Triangle_complex::opposite(start);
  if(is_below(complex.source(start)))
    std::swap(forward, backward);

  crossed.clear();
  const auto collect = [&](Index halfedge) { crossed.push_back(halfedge); };
  const bool is_closed = complex.has_triangle(forward) && follow_contour(complex, forward, is_below, collect);
  const std::size_t number_of_forward_edges = crossed.size();
  if(!is_closed && complex.has_triangle(backward))
    follow_contour(complex, backward, is_below, collect);
  std::reverse(crossed.begin() + number_of_forward_edges, crossed.end());
  crossed.push_back(start);
  std::rotate(crossed.begin(), crossed.begin() + number_of_forward_edges, crossed.end());
  return is_closed;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TRACING_H
