// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_STARS_AHEAD_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_STARS_AHEAD_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/prefetch.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL::Reeb_graph::internal {

// Visits vertices that are far from their neighbors in memory. A turn around one waits for memory at each step, as only
// the last halfedge tells where the next one is. So there is a turn before the turn, for some vertices side by side:
// what one of them waits for comes while the others ask. The visit finds all in the caches then.
template <class Complex, class Order>
class Stars_ahead
{
public:
  // If stars are not to be fetched, visits are all that is done.
  Stars_ahead(const Complex& complex, const Order& order, bool are_fetched)
    : complex_(complex),
      order_(order),
      are_fetched_(are_fetched)
  {}

  // Calls visit(i) for the numbers from `begin` to `end`, each of which turns around vertex_at(i).
  template <class VertexAt, class Visit>
  void visit(std::size_t begin, std::size_t end, const VertexAt& vertex_at, const Visit& visit) const
  {
    const std::size_t step = are_fetched_ ? side_by_side : end - begin;
    for(std::size_t block = begin; block != end;)
    {
      const std::size_t end_of_block = block + (std::min)(step, end - block);
      if(are_fetched_)
        fetch(block, end_of_block, vertex_at);
      for(; block != end_of_block; ++block)
        visit(block);
    }
  }

private:
  static constexpr std::size_t side_by_side = 32; // What they fetch stays in the first caches.
  static constexpr std::size_t most_steps = 12;   // Few turns are longer. Nothing has been checked yet.

  template <class VertexAt>
  void fetch(std::size_t begin, std::size_t end, const VertexAt& vertex_at) const
  {
    struct Turn
    {
      Halfedge_index first, halfedge;
    };
    std::array<Turn, side_by_side> turns;
    std::array<Halfedge_index, side_by_side> next;
    std::array<Vertex_index, side_by_side> neighbors;
    std::size_t size = 0;
    for(std::size_t i = begin; i != end; ++i)
    {
      const Halfedge_index first = complex_.kept_halfedge(vertex_at(i));
      turns[size] = {first, first};
      size += first.number() < complex_.number_of_halfedges() ? 1 : 0;
    }
    for(std::size_t steps = 0; size != 0 && steps != most_steps; ++steps)
    {
      // Reads in a loop of their own, so that the processor has all of them before it.
      for(std::size_t i = 0; i != size; ++i)
      {
        next[i] = complex_.next(turns[i].halfedge);
        neighbors[i] = complex_.source(turns[i].halfedge);
      }
      std::size_t number_of_unfinished = 0;
      for(std::size_t i = 0; i != size; ++i)
      {
        order_.prefetch(neighbors[i]);
        const Turn turn = {turns[i].first, opposite_of(next[i])};
        turns[number_of_unfinished] = turn;
        number_of_unfinished +=
          turn.halfedge != turn.first && turn.halfedge.number() < complex_.number_of_halfedges() ? 1 : 0;
      }
      size = number_of_unfinished;
    }
    keep_fetching();
  }

  const Complex& complex_;
  const Order& order_;
  bool are_fetched_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_STARS_AHEAD_H
