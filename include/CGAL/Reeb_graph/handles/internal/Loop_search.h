// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_INTERNAL_LOOP_SEARCH_H
#define CGAL_REEB_GRAPH_HANDLES_INTERNAL_LOOP_SEARCH_H

#include <CGAL/Reeb_graph/handles/internal/Closed_surface.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <CGAL/license/Reeb_graph.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// How short loops across a closed walk can be. The walk is a sum of simple loops, and a loop whose intersection number
// with it is not 0 has one with one of these that is not 0. It has a part, in one of its directions, that leaves this one
// on the left, comes back on the right, and does not meet it in between: else it would cross as often to the one side as
// to the other. One search finds the shortest such parts of a simple loop.
class Crossing_bounds
{
public:
  explicit Crossing_bounds(const Closed_surface& surface)
    : surface_(surface),
      distances_(surface.points.size(), infinity),
      positions_(surface.points.size(), no_index)
  {}

  // For each vertex of a walk, by the halfedge that leaves it, the least length of the parts that come back there, or
  // infinity if it is greater than `bound`. A loop across the walk is as long as the bound of one of its vertices, or
  // longer.
  std::vector<double> operator()(const Halfedge_walk& walk, double bound)
  {
    least_.assign(walk.size(), infinity);
    std::vector<Index> path; // positions in the walk, of vertices that are passed once
    const auto end_simple_loop = [&](std::size_t begin) {
      const std::vector<Index> simple(path.begin() + static_cast<std::ptrdiff_t>(begin), path.end());
      path.resize(begin);
      if(simple.size() > 2) // it is no edge that is passed to and fro
        search_from(walk, simple, bound);
    };
    std::unordered_map<Index, std::size_t> places; // in the path, if the vertex is there
    for(std::size_t k = 0; k != walk.size(); ++k)
    {
      const Index v = surface_.source(walk[k]);
      const auto found = places.find(v);
      if(found != places.end() && found->second < path.size() && surface_.source(walk[path[found->second]]) == v)
        end_simple_loop(found->second);
      places[v] = path.size();
      path.push_back(static_cast<Index>(k));
    }
    end_simple_loop(0);
    return least_;
  }

private:
  typedef std::pair<double, Index> Queued;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  void search_from(const Halfedge_walk& walk, const std::vector<Index>& loop, double bound)
  {
    from_right_.clear();
    for(const Index k : loop)
      positions_[surface_.source(walk[k])] = k;
    const auto back = [&](std::size_t i) { return surface_.opposite(walk[loop[(i + loop.size() - 1) % loop.size()]]); };
    for(std::size_t i = 0; i != loop.size(); ++i)
      for(Index h = surface_.turned(back(i)); h != walk[loop[i]]; h = surface_.turned(h))
        from_right_.insert(surface_.opposite(h));
    number_to_reach_ = loop.size();
    for(std::size_t i = 0; i != loop.size(); ++i)
      for(Index h = surface_.turned(walk[loop[i]]); h != back(i); h = surface_.turned(h))
        follow(h, 0);
    while(!queue_.empty() && queue_.top().first < bound)
    {
      const auto [distance, v] = queue_.top();
      queue_.pop();
      if(distance != distances_[v])
        continue;
      surface_.for_each_outgoing(v, [&](Index h) { follow(h, distances_[v]); });
      if(number_to_reach_ != 0)
        continue;
      bound = 0; // What is farther from the loop is on no shorter way back.
      for(const Index k : loop)
        bound = (std::max)(bound, least_[k]);
      number_to_reach_ = no_index;
    }
    queue_ = {};
    for(const Index v : reached_)
      distances_[v] = infinity;
    reached_.clear();
    for(const Index k : loop)
      positions_[surface_.source(walk[k])] = no_index;
  }

  void follow(Index h, double distance)
  {
    if(!surface_.is_given(h))
      return;
    distance += surface_.length(h);
    const Index w = surface_.target[h], position = positions_[w];
    if(position != no_index)
    {
      if(distance < least_[position] && from_right_.count(h) != 0)
      {
        number_to_reach_ -= least_[position] == infinity ? 1 : 0;
        least_[position] = distance;
      }
      return;
    }
    if(distance < distances_[w])
    {
      if(distances_[w] == infinity)
        reached_.push_back(w);
      distances_[w] = distance;
      queue_.emplace(distance, w);
    }
  }

  const Closed_surface& surface_;
  std::vector<double> distances_; // infinity between two searches
  std::vector<Index> positions_;  // of the vertices of the simple loop in the walk; no_index for others
  std::vector<Index> reached_;
  std::unordered_set<Index> from_right_; // halfedges that lead to the loop
  std::vector<double> least_;            // by position
  std::size_t number_to_reach_ = 0;      // of vertices of the loop
  std::priority_queue<Queued, std::vector<Queued>, std::greater<Queued>> queue_;
};

// For each edge, two sums of random numbers modulo 2^64, one for each half of the coordinates of a homology class: that
// of a closed walk, from 2e to 2e + 1 positive, is 0 in the half where its coordinates are 0, and in the other one, but
// for a chance of 2^-64. What is found by them is checked exactly.
typedef std::vector<std::array<std::uint64_t, 2>> Class_codes;

inline std::uint64_t code_of(const Class_codes& codes, Index h, int half)
{
  const std::uint64_t code = codes[h / 2][half];
  return h % 2 == 0 ? code : std::uint64_t(0) - code;
}

// Removes what a closed walk passes to and fro.
inline void reduce(Halfedge_walk& walk)
{
  Halfedge_walk reduced;
  for(const Index h : walk)
  {
    if(!reduced.empty() && reduced.back() == Closed_surface::opposite(h))
      reduced.pop_back();
    else
      reduced.push_back(h);
  }
  std::size_t begin = 0, end = reduced.size();
  while(begin + 1 < end && reduced[begin] == Closed_surface::opposite(reduced[end - 1]))
  {
    ++begin;
    --end;
  }
  walk.assign(reduced.begin() + begin, reduced.begin() + end);
}

// Shortest loops through a vertex among those whose class has no part in one half of the coordinates. They are the
// closed ones of the cover of the surface in which only such loops close, and there shortest paths from a vertex form a
// tree. Each edge that joins two of its branches closes a loop.
class Loop_search
{
public:
  struct Loop
  {
    double length = std::numeric_limits<double>::infinity();
    Halfedge_walk walk;
    double least_length = 0; // no loop through the root that would be accepted is shorter
  };

  Loop_search(const Closed_surface& surface, const Class_codes& codes)
    : surface_(surface),
      codes_(codes),
      first_places_(surface.points.size(), no_index),
      least_lengths_{std::vector<double>(surface.points.size(), 0), std::vector<double>(surface.points.size(), 0)}
  {}

  // Finds a loop shorter than `bound` whose class has no part in the half `closed_half`, and which is accepted: that is
  // asked once for each class. The walk is empty if there is none, or if the search takes too many places. What is found
  // tells how short loops through vertices near by can be, so the search goes on behind the bound, until it has seen
  // `growth` times as many places.
  Loop operator()(Index root,
                  int closed_half,
                  double bound,
                  std::size_t growth,
                  std::size_t largest_number_of_places,
                  const std::function<bool(const Halfedge_walk&)>& accept)
  {
    begin(root);
    Loop best;
    best.least_length = infinity;
    least_length_ = infinity;
    std::unordered_map<std::uint64_t, bool> is_accepted;
    double reached = infinity; // a loop of each shorter class has been seen
    for(bool is_bound_reached = false; !queue_.empty();)
    {
      const Index place = queue_.top().second;
      queue_.pop();
      if(places_[place].is_settled)
        continue;
      reached = 2 * places_[place].distance;
      if(reached >= bound && !is_bound_reached)
      {
        is_bound_reached = true;
        largest_number_of_places = (std::min)(largest_number_of_places, growth * places_.size());
      }
      if(reached >= best.least_length || places_.size() >= largest_number_of_places)
        break;
      reached = infinity;
      places_[place].is_settled = true;
      settle(place, closed_half, best, [&](std::uint64_t code, const auto& make_walk) {
        const auto known = is_accepted.find(code);
        if(known != is_accepted.end())
          return known->second;
        return is_accepted[code] = is_accepted[std::uint64_t(0) - code] = accept(make_walk());
      });
    }
    best.least_length = (std::min)(best.least_length, reached);
    spread_least_length((std::min)(least_length_, reached), least_lengths_[closed_half]);
    if(!(best.length < bound))
      best.walk.clear();
    return best;
  }

  // The distance of a vertex from the root of the last search, or a greater number; infinity if it has not been seen.
  double distance(Index v) const
  {
    double result = infinity;
    for(Index place = first_places_[v]; place != no_index; place = places_[place].next)
      result = (std::min)(result, places_[place].distance);
    return result;
  }

  // No loop of any class through a vertex is shorter, as far as searches have told.
  double least_length(int closed_half, Index v) const { return least_lengths_[closed_half][v]; }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // A vertex in the cover.
  struct Place
  {
    Index vertex;
    Index next; // the next place of the same vertex
    Index from; // the place before it on the shortest path, or no_index
    Index halfedge;
    std::uint64_t sheet, code;
    double distance;
    bool is_settled;
  };
  typedef std::pair<double, Index> Queued;

  void begin(Index root)
  {
    for(const Place& place : places_)
      first_places_[place.vertex] = no_index;
    places_.clear();
    queue_ = {};
    add(root, 0, no_index, no_index, 0, 0);
  }

  // A loop through a vertex, with the way to it and back, is one through the root.
  void spread_least_length(double least_length, std::vector<double>& least_lengths) const
  {
    for(const Place& place : places_)
    {
      if(4 * place.distance > least_length)
        break;
      double& least = least_lengths[place.vertex];
      least = (std::max)(least, least_length - 2 * place.distance);
    }
  }

  void add(Index v, std::uint64_t sheet, Index from, Index h, std::uint64_t code, double distance)
  {
    const Index place = static_cast<Index>(places_.size());
    places_.push_back({v, first_places_[v], from, h, sheet, code, distance, false});
    first_places_[v] = place;
    queue_.emplace(distance, place);
  }

  Index find(Index v, std::uint64_t sheet) const
  {
    Index place = first_places_[v];
    while(place != no_index && places_[place].sheet != sheet)
      place = places_[place].next;
    return place;
  }

  template <class Accept>
  void settle(Index place, int closed_half, Loop& best, const Accept& accept)
  {
    const Index came_from = surface_.opposite(places_[place].halfedge);
    surface_.for_each_outgoing(places_[place].vertex, [&](Index h) {
      if(surface_.is_given(h) && h != came_from)
        follow(place, h, surface_.target[h], closed_half, best, accept);
    });
  }

  template <class Accept>
  void follow(Index place, Index h, Index w, int closed_half, Loop& best, const Accept& accept)
  {
    const std::uint64_t sheet = places_[place].sheet + code_of(codes_, h, closed_half);
    const std::uint64_t code = places_[place].code + code_of(codes_, h, 1 - closed_half);
    const double distance = places_[place].distance + surface_.length(h);
    const Index other = find(w, sheet);
    if(other == no_index)
    {
      add(w, sheet, place, h, code, distance);
      return;
    }
    const double length = distance + places_[other].distance;
    if(places_[other].code != code && length < best.least_length)
    {
      least_length_ = (std::min)(least_length_, length);
      const auto make_walk = [&] {
        Halfedge_walk walk = walk_to(place);
        walk.push_back(h);
        const Halfedge_walk back = reversed(walk_to(other));
        walk.insert(walk.end(), back.begin(), back.end());
        return walk;
      };
      if(accept(code - places_[other].code, make_walk))
      {
        Halfedge_walk walk = make_walk();
        reduce(walk); // what is left can be shorter if it does not pass the root
        best = {surface_.length(walk), std::move(walk), length};
      }
    }
    if(!places_[other].is_settled && distance < places_[other].distance)
    {
      places_[other].from = place;
      places_[other].halfedge = h;
      places_[other].code = code;
      places_[other].distance = distance;
      queue_.emplace(distance, other);
    }
  }

  Halfedge_walk walk_to(Index place) const
  {
    Halfedge_walk walk;
    for(; places_[place].from != no_index; place = places_[place].from)
      walk.push_back(places_[place].halfedge);
    std::reverse(walk.begin(), walk.end());
    return walk;
  }

  const Closed_surface& surface_;
  const Class_codes& codes_;
  std::vector<Index> first_places_;                  // by vertex
  std::array<std::vector<double>, 2> least_lengths_; // by closed half and root: no loop of any class is shorter
  double least_length_ = 0;                          // of loops seen in this search
  std::vector<Place> places_;
  std::priority_queue<Queued, std::vector<Queued>, std::greater<Queued>> queue_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_LOOP_SEARCH_H
