// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_WALKS_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_WALKS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/engine/Between_stages.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The step from `vertex`, which is no maximum, to its highest neighbor. Without a branch, as none could be predicted.
template <class Complex>
Ascending_step steepest_step(const Complex& complex, const Vertex_order& order, Vertex_index vertex)
{
  Ascending_step step = {no_index, vertex};
  complex.for_each_edge_around(vertex, [&](Vertex_index neighbor, Halfedge_index halfedge) {
    const bool is_higher = order(step.target, neighbor);
    step.edge = is_higher ? halfedge : step.edge;
    step.target = is_higher ? neighbor : step.target;
  });
  return step;
}

// Takes steepest steps from `vertex` on as long as goes_on(vertex reached), and calls visit(step) before each. Returns the vertex reached.
template <class Complex, class GoesOn, class Visit>
Vertex_index climb(const Complex& complex,
                   const Vertex_order& order,
                   Vertex_index vertex,
                   const GoesOn& goes_on,
                   const Visit& visit)
{
  while(goes_on(vertex))
  {
    const Ascending_step step = steepest_step(complex, order, vertex);
    visit(step);
    vertex = step.target;
  }
  return vertex;
}

// Finds the component in whose extremum a monotone path ends: a minimum if it descends, to the lower side, for the join
// tree, a maximum if it ascends for the split tree.
// A vertex is passed once: its end is kept. Several threads that pass it keep the same end.
template <class Complex, Side direction>
class Monotone_path_ends
{
public:
  Monotone_path_ends(const Complex& complex, const Vertex_order& order, const Kept_neighbors& kept_neighbors)
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
    return walk(next_step(vertex), end_of_step, passed);
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
  const Vertex_order* order_;
  const Kept_neighbors* kept_neighbors_;
  Indexed_vector<Vertex_index, Relaxed_value<Index>> ends_; // the number behind that of the end, so that 0 is no_index
};

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
      is_source_below_(is_below(complex.source(start))),
      is_border_reached_(complex.is_on_border_edge(start))
  {}

  // Goes to the next crossing edge. Returns whether there was one.
  template <class IsBelow>
  bool go_on(const IsBelow& is_below)
  {
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
  // A walk that enters a triangle over an edge has the source of that edge on the left.
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

// Finds contours of one level in steps by turns, so that the longest one costs no more than the next one. There is a
// search for each start. A class `Search` derived from this one has
// - begin(starts, is_below), which gives each search the first edge that it crosses,
// - go_on(i, is_below), which takes a step, unless search i has come to its end, and joins searches that meet, and
// - is_border_reached(i).
template <class Search>
class Contours_by_turns
{
public:
  // Calls visit(halfedges of the crossed edges, each from its lower end to its higher one, whether they reach the
  // border) for all but one of the contours that cross the edges of `starts`.
  template <class IsBelow, class Visit>
  void visit_all_but_one(const Plain_vector<Halfedge_index>& starts, const IsBelow& is_below, const Visit& visit)
  {
    Search& search = static_cast<Search&>(*this);
    leaders_.resize(starts.size());
    std::iota(leaders_.begin(), leaders_.end(), std::size_t(0));
    turns_ = leaders_;
    number_of_open_ = starts.size();
    is_open_.assign(starts.size(), true);
    crossed_edges_.assign(starts.size(), {});
    search.begin(starts, is_below);
    while(number_of_open_ > 1)
    {
      for(const std::size_t i : turns_)
      {
        if(!is_open(i))
          continue;
        ++number_of_steps_;
        if(search.go_on(i, is_below))
          continue;
        visit(crossed_edges_[i], search.is_border_reached(i));
        close(i, i);
        if(number_of_open_ == 1)
          return;
      }
      if(number_of_open_ != turns_.size())
        turns_.erase(std::remove_if(turns_.begin(), turns_.end(), [this](std::size_t i) { return !is_open(i); }),
                     turns_.end());
    }
  }

  // How many steps have been taken, in all searches.
  std::size_t number_of_steps() const { return number_of_steps_; }

protected:
  // The search that goes on for a search that has met others along its contour.
  std::size_t leader(std::size_t i)
  {
    return find_root(i, [this](std::size_t j) -> std::size_t& { return leaders_[j]; });
  }

  // Ends a search, for which its leader goes on, if that is another one.
  void close(std::size_t i, std::size_t leader)
  {
    leaders_[i] = leader;
    is_open_[i] = false;
    crossed_edges_[i] = {};
    --number_of_open_;
  }

  std::vector<Plain_vector<Halfedge_index>> crossed_edges_; // by search, as all else here

private:
  // Whether a search goes on: it leads, and has not found all of its contour.
  bool is_open(std::size_t i) const { return is_open_[i]; }

  std::vector<bool> is_open_;
  Plain_vector<std::size_t> leaders_;
  Plain_vector<std::size_t> turns_; // those that go on
  std::size_t number_of_open_ = 0;
  std::size_t number_of_steps_ = 0;
};

// Contours of a surface, side by side, by walks. Where a walk comes to the start of another one, both are along one contour.
template <class Complex>
class Contours_side_by_side : public Contours_by_turns<Contours_side_by_side<Complex>>
{
public:
  explicit Contours_side_by_side(const Complex& complex) : complex_(complex) {}

  template <class IsBelow>
  void begin(const Plain_vector<Halfedge_index>& starts, const IsBelow& is_below)
  {
    walks_.clear();
    starts_.clear();
    for(const Halfedge_index start : starts)
    {
      this->crossed_edges_[walks_.size()] = {is_below(complex_.source(start)) ? start : opposite_of(start)};
      starts_.emplace_back(edge_of(start), walks_.size());
      walks_.emplace_back(complex_, start, is_below);
    }
    std::sort(starts_.begin(), starts_.end());
  }

  template <class IsBelow>
  bool go_on(std::size_t i, const IsBelow& is_below)
  {
    if(!walks_[i].go_on(is_below))
      return false;
    const Halfedge_index ascending = walks_[i].ascending_edge();
    this->crossed_edges_[i].push_back(ascending);
    meet_start(i, edge_of(ascending));
    return true;
  }

  bool is_border_reached(std::size_t i) const { return walks_[i].is_border_reached(); }

private:
  void meet_start(std::size_t i, Edge_index edge)
  {
    if(starts_.size() == 2 && edge != starts_[0].first && edge != starts_[1].first)
      return; // In nearly all cases, so that no way through a search has to be guessed.
    const auto start = std::lower_bound(starts_.begin(), starts_.end(), std::make_pair(edge, std::size_t(0)));
    if(start == starts_.end() || start->first != edge)
      return;
    if(const std::size_t other = this->leader(start->second); other != i)
      this->close(other, i);
  }

  const Complex& complex_;
  std::vector<Contour_walk<Complex>> walks_;
  std::vector<std::pair<Edge_index, std::size_t>> starts_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_WALKS_H
