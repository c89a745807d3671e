// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_INTERNAL_CROSSING_BOUNDS_H
#define CGAL_REEB_GRAPH_HANDLES_INTERNAL_CROSSING_BOUNDS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/handles/internal/Closed_surface.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// How short loops across a simple loop can be. A loop whose intersection number with it is 1 or -1 has a part, in one of
// its directions, that leaves it on the left, comes back on the right, and does not meet it in between: else it would
// cross as often to the one side as to the other. One search finds the shortest such parts.
class Crossing_bounds
{
public:
  explicit Crossing_bounds(const Closed_surface& surface)
    : surface_(surface),
      distances_(surface.points.size(), infinity)
  {}

  // For each vertex of a walk, by the halfedge that leaves it, the least length of the parts that come back there;
  // infinity if it is greater than `bound`, and 0 if the walk is not simple. A loop across the walk is as long as the
  // bound of one of its vertices, or longer.
  std::vector<double> operator()(const Halfedge_walk& walk, double bound)
  {
    positions_.clear();
    for(std::size_t k = 0; k != walk.size(); ++k)
      positions_.emplace(surface_.source(walk[k]), k);
    if(positions_.size() != walk.size())
      return std::vector<double>(walk.size(), 0);
    least_.assign(walk.size(), infinity);
    from_right_.clear();
    for(std::size_t k = 0; k != walk.size(); ++k)
    {
      const Index back = surface_.opposite(walk[(k + walk.size() - 1) % walk.size()]);
      for(Index h = surface_.turned(back); h != walk[k]; h = surface_.turned(h))
        from_right_.insert(surface_.opposite(h));
    }
    for(std::size_t k = 0; k != walk.size(); ++k)
    {
      const Index back = surface_.opposite(walk[(k + walk.size() - 1) % walk.size()]);
      for(Index h = surface_.turned(walk[k]); h != back; h = surface_.turned(h))
        follow(h, 0);
    }
    while(!queue_.empty() && queue_.top().first < bound)
    {
      const auto [distance, v] = queue_.top();
      queue_.pop();
      if(distance == distances_[v])
        follow_all(v);
    }
    queue_ = {};
    for(const Index v : reached_)
      distances_[v] = infinity;
    reached_.clear();
    return least_;
  }

private:
  typedef std::pair<double, Index> Queued;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  void follow_all(Index v)
  {
    const Index first = surface_.outgoing[v];
    Index h = first;
    do
    {
      follow(h, distances_[v]);
      h = surface_.turned(h);
    } while(h != first);
  }

  void follow(Index h, double distance)
  {
    if(!surface_.is_given(h))
      return;
    distance += surface_.length(h);
    const Index w = surface_.target[h];
    const auto position = positions_.find(w);
    if(position != positions_.end())
    {
      if(from_right_.count(h) != 0)
        least_[position->second] = (std::min)(least_[position->second], distance);
      return;
    }
    if(distances_[w] == infinity)
      reached_.push_back(w);
    if(distance < distances_[w])
    {
      distances_[w] = distance;
      queue_.emplace(distance, w);
    }
  }

  const Closed_surface& surface_;
  std::vector<double> distances_; // infinity between two searches
  std::vector<Index> reached_;
  std::unordered_map<Index, std::size_t> positions_; // of the vertices of the walk
  std::unordered_set<Index> from_right_;             // halfedges that lead to the walk
  std::vector<double> least_;
  std::priority_queue<Queued, std::vector<Queued>, std::greater<Queued>> queue_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_CROSSING_BOUNDS_H
