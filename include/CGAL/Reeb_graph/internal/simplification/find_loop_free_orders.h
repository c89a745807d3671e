// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_FIND_LOOP_FREE_ORDERS_H
#define CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_FIND_LOOP_FREE_ORDERS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Weighted_graph.h>
#include <CGAL/Reeb_graph/internal/simplification/Loop_free_order.h>
#include <CGAL/Reeb_graph/internal/simplification/Moved_pieces.h>
#include <CGAL/Reeb_graph/internal/simplification/Piece_sweep.h>
#include <CGAL/Reeb_graph/internal/simplification/Triangle_neighbors.h>
#include <CGAL/Reeb_graph/simplification/exceptions.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Whether all members of a sweep but one are regular when they pass in their order.
template <class Sweep>
bool are_regular_but_one(Sweep& sweep, scalar_fields::Position exception)
{
  bool are_regular = true;
  for(const Member_index m : sweep.members().keys())
  {
    const auto step = sweep.step(m);
    if(sweep.members()[m] == exception ? step == Sweep::Step::IMPOSSIBLE : step != Sweep::Step::REGULAR)
    {
      are_regular = false;
      break;
    }
    sweep.add(m);
  }
  while(!sweep.swept().empty())
    sweep.remove_last();
  return are_regular;
}

// Orders without leaves and loops for the pieces with critical vertices, where `moved` are the values that Moved_pieces
// has given them. Without critical vertices, a piece changes no contour of its surroundings, be there borders or not.
// An order that is found is given to each of the others, also if it is that of the values: they may be mixed with those
// of critical vertices elsewhere.
template <class Scalar>
typename Moved_pieces<Scalar>::Orders find_loop_free_orders(const scalar_fields::Weighted_graph& graph,
                                                            const Triangle_neighbors& triangles,
                                                            const std::vector<Index>& saddles,
                                                            const std::vector<Scalar>& values,
                                                            const std::vector<Scalar>& moved)
{
  typename Moved_pieces<Scalar>::Orders pieces, orders;
  for(Index v = 0; v != saddles.size(); ++v)
  {
    if(saddles[v] == no_index)
      continue;
    auto& members = pieces[saddles[v]];
    if(members.empty())
      members.push_back(saddles[v]);
    members.push_back(v);
  }
  for(auto& [saddle, members] : pieces)
  {
    const auto is_below_saddle = [&, saddle = saddle](Index v) {
      const Index place = saddles[v] == no_index ? v : saddles[v];
      return std::make_pair(values[place], place) < std::make_pair(values[saddle], saddle);
    };
    std::sort(members.begin(), members.end(),
              [&](Index u, Index v) { return std::make_pair(moved[u], u) < std::make_pair(moved[v], v); });
    Piece_sweep sweep(graph, triangles, members, is_below_saddle);
    if(are_regular_but_one(sweep, saddle))
      continue;
    if(!Loop_free_order(sweep).find())
      throw Piece_topology_error(saddle);
    auto& order = orders[saddle];
    for(const Member_index m : sweep.swept())
      order.push_back(sweep.members()[m]);
  }
  return orders;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_FIND_LOOP_FREE_ORDERS_H
