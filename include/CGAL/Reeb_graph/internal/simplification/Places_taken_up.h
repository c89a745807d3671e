// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_PLACES_TAKEN_UP_H
#define CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_PLACES_TAKEN_UP_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The places of a graph, first the nodes, numbered in ascending order, and behind them the arcs, some of which have
// been taken up by others. A weight is a number, or several, which `+=` adds up.
template <class Weight>
class Places_taken_up
{
public:
  // What a place is made of: itself and all that it has taken up.
  struct Content
  {
    Weight weight;
    Index lowest, highest; // of the nodes

    void add(const Content& other)
    {
      weight += other.weight;
      lowest = (std::min)(lowest, other.lowest);
      highest = (std::max)(highest, other.highest);
    }
  };

  // By place, how much each weighs.
  Places_taken_up(Index number_of_nodes, std::size_t number_of_places, const std::vector<Weight>& weights)
    : number_of_nodes_(number_of_nodes),
      places_(number_of_places)
  {
    for(Index place = 0; place != places_.size(); ++place)
    {
      const bool is_node = place < number_of_nodes;
      places_[place] = {place, {weights[place], is_node ? place : Index(no_index), is_node ? place : 0}};
    }
  }

  bool is_left(Index place) const { return places_[place].owner == place; }
  const Content& content(Index place) const { return places_[place].content; }

  // Lets the place `owner` take up another one.
  void take_up(Index place, Index owner)
  {
    places_[place].owner = owner;
    places_[owner].content.add(places_[place].content);
  }

  // By place, the place that has taken it up in the end.
  std::vector<Index> find_owners() const
  {
    return follow_owners(
      [](Index owner, Index result_of_owner) { return result_of_owner == no_index ? owner : result_of_owner; });
  }

  // By place, the node at which the last branch was that has been removed with it, no_index if none has: so each place
  // that has been removed together with a branch is told from those that arcs consist of.
  std::vector<Index> find_saddles() const
  {
    return follow_owners([&](Index owner, Index result_of_owner) {
      return result_of_owner == no_index && owner < number_of_nodes_ ? owner : result_of_owner;
    });
  }

private:
  // By place, what choose(owner, result of the owner) gives; no_index for a place that is left.
  template <class Choose>
  std::vector<Index> follow_owners(const Choose& choose) const
  {
    std::vector<Index> results(places_.size(), no_index), path;
    std::vector<bool> is_known(places_.size(), false);
    for(Index first = 0; first != places_.size(); ++first)
    {
      for(Index place = first; !is_known[place] && !is_left(place); place = places_[place].owner)
        path.push_back(place);
      for(; !path.empty(); path.pop_back())
      {
        const Index place = path.back();
        results[place] = choose(places_[place].owner, results[places_[place].owner]);
        is_known[place] = true;
      }
    }
    return results;
  }

  struct Place
  {
    Index owner; // itself, if it is left
    Content content;
  };

  Index number_of_nodes_;
  std::vector<Place> places_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_PLACES_TAKEN_UP_H
