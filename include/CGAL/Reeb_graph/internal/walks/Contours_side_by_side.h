// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_WALKS_CONTOURS_SIDE_BY_SIDE_H
#define CGAL_REEB_GRAPH_INTERNAL_WALKS_CONTOURS_SIDE_BY_SIDE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Disjoint_sets.h>
#include <CGAL/Reeb_graph/internal/base/Plain_vector.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/walks/contour_tracing.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

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

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_WALKS_CONTOURS_SIDE_BY_SIDE_H
