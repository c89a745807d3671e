// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_CONTOUR_TRACING_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_CONTOUR_TRACING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/union_find.h>
#include <CGAL/Reeb_graph/internal/complex/Simplicial_complex.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

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
// have all the other ones.
template <class Complex, class IsBelow, class Visit>
void trace_contour(const Complex& complex, Halfedge_index start, const IsBelow& is_below, const Visit& visit)
{
  visit(start);
  Contour_walk walk(complex, start, is_below);
  while(walk.go_on(is_below))
    visit(walk.crossed_edge());
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

// The other edge that the level crosses of a triangle at a crossed edge.
template <class IsBelow>
Edge_index crossed_edge_beside(const Simplicial_complex& complex,
                               Edge_index crossed_edge,
                               Triangle_index triangle,
                               const IsBelow& is_below)
{
  // The edges of a triangle are those of its vertices 0 and 1, 0 and 2, 1 and 2.
  constexpr std::array<std::array<std::size_t, 2>, 3> other_edges = {{{1, 2}, {0, 2}, {0, 1}}};
  const std::array<Edge_index, 3>& edges = complex.edges_of(triangle);
  const std::size_t place = edges[0] == crossed_edge ? 0 : (edges[1] == crossed_edge ? 1 : 2);
  // The first of the two other edges has the lower end of the crossed one; it is not crossed if the apex is on the side
  // of that end.
  const bool is_apex_with_end =
    is_below(complex.vertices_of(triangle)[2 - place]) == is_below(complex.lower_end(crossed_edge));
  return edges[other_edges[place][is_apex_with_end ? 1 : 0]];
}

// Calls visit(edge, triangle) for the other edge of each triangle at a crossed edge that the level crosses.
template <class IsBelow, class Visit>
void for_each_crossed_edge_beside(const Simplicial_complex& complex,
                                  Edge_index crossed_edge,
                                  const IsBelow& is_below,
                                  const Visit& visit)
{
  for(const Triangle_index triangle : complex.triangles_of(crossed_edge))
    visit(crossed_edge_beside(complex, crossed_edge, triangle, is_below), triangle);
}

// The same in a complex, where a contour is any connected graph.
template <class IsBelow, class Visit>
void trace_contour(const Simplicial_complex& complex, Halfedge_index start, const IsBelow& is_below, const Visit& visit)
{
  std::unordered_set<Number> found = {edge_of(start).number()};
  Plain_vector<Edge_index> pending = {edge_of(start)};
  visit(start);
  while(!pending.empty())
  {
    const Edge_index edge = pending.back();
    pending.pop_back();
    for_each_crossed_edge_beside(complex, edge, is_below, [&](Edge_index beside, Triangle_index) {
      if(!found.insert(beside.number()).second)
        return;
      visit(even_halfedge(beside));
      pending.push_back(beside);
    });
  }
}

// Traces contours of one level of a surface, in steps by turns, so that the longest one costs no more than the next
// one.
template <class Complex>
class Contours_side_by_side
{
public:
  explicit Contours_side_by_side(const Complex& complex) : complex_(complex) {}

  // Calls visit(halfedges of the crossed edges, each from its lower end to its higher one, whether they reach the
  // border) for all but one of the contours that cross the edges of `starts`.
  template <class IsBelow, class Visit>
  void visit_all_but_one(const Plain_vector<Halfedge_index>& starts, const IsBelow& is_below, const Visit& visit)
  {
    begin(starts, is_below);
    while(number_of_open_ > 1)
    {
      for(const std::size_t i : turns_)
      {
        Walk& walk = walks_[i];
        if(!walk.is_open)
          continue;
        if(walk.contour.go_on(is_below))
        {
          walk.crossed_edges.push_back(walk.contour.ascending_edge());
          meet_start(i, edge_of(walk.contour.ascending_edge()));
          continue;
        }
        visit(walk.crossed_edges, walk.contour.is_border_reached());
        close(walk);
        if(number_of_open_ == 1)
          return;
      }
      remove_closed_walks();
    }
  }

private:
  struct Walk
  {
    Contour_walk<Complex> contour;
    Plain_vector<Halfedge_index> crossed_edges;
    std::size_t leader; // the walk along the same contour that has met this one; itself if none has
    bool is_open;
  };

  template <class IsBelow>
  void begin(const Plain_vector<Halfedge_index>& starts, const IsBelow& is_below)
  {
    walks_.clear();
    turns_.clear();
    starts_.clear();
    for(const Halfedge_index start : starts)
    {
      const Halfedge_index ascending = is_below(complex_.source(start)) ? start : opposite_of(start);
      turns_.push_back(walks_.size());
      starts_.emplace_back(edge_of(start), walks_.size());
      walks_.push_back({Contour_walk(complex_, start, is_below), {ascending}, walks_.size(), true});
    }
    std::sort(starts_.begin(), starts_.end());
    number_of_open_ = walks_.size();
  }

  // Where a walk comes to the start of another one, both are along one contour, and the first one goes on alone.
  void meet_start(std::size_t i, Edge_index edge)
  {
    if(starts_.size() == 2 && edge != starts_[0].first && edge != starts_[1].first)
      return; // In nearly all cases, so that no way through a search has to be guessed.
    const auto start = std::lower_bound(starts_.begin(), starts_.end(), std::make_pair(edge, std::size_t(0)));
    if(start == starts_.end() || start->first != edge)
      return;
    const std::size_t other =
      find_root(start->second, [this](std::size_t j) -> std::size_t& { return walks_[j].leader; });
    if(other == i)
      return;
    walks_[other].leader = i;
    close(walks_[other]);
  }

  void close(Walk& walk)
  {
    walk.is_open = false;
    walk.crossed_edges = {};
    --number_of_open_;
    has_closed_walks_ = true;
  }

  void remove_closed_walks()
  {
    if(!has_closed_walks_)
      return;
    const auto is_closed = [this](std::size_t i) { return !walks_[i].is_open; };
    turns_.erase(std::remove_if(turns_.begin(), turns_.end(), is_closed), turns_.end());
    has_closed_walks_ = false;
  }

  const Complex& complex_;
  std::vector<Walk> walks_;         // by start
  Plain_vector<std::size_t> turns_; // those that go on
  std::vector<std::pair<Edge_index, std::size_t>> starts_;
  std::size_t number_of_open_ = 0;
  bool has_closed_walks_ = false;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_CONTOUR_TRACING_H
