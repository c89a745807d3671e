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
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/Threads.h>

#include <CGAL/license/Reeb_graph.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <queue>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// How short loops across a simple loop can be. A loop whose intersection number with it is 1 or -1 has a part, in one of
// its directions, that leaves it on the left, comes back on the right, and does not meet it in between: else it would
// cross as often to the one side as to the other. One search finds the shortest such parts.
class Crossing_bounds
{
public:
  explicit Crossing_bounds(const Closed_surface& surface)
    : surface_(surface),
      distances_(surface.points.size(), infinity),
      positions_(surface.points.size(), no_index),
      last_steps_(surface.points.size(), no_index)
  {}

  // For each vertex of a walk, by the halfedge that leaves it, the least length of the parts that come back there;
  // infinity if it is greater than `bound`, and 0 if the walk is not simple. A loop across the walk is as long as the
  // bound of one of its vertices, or longer.
  std::vector<double> operator()(const Halfedge_walk& walk, double bound)
  {
    bool is_simple = true;
    for(std::size_t k = 0; k != walk.size(); ++k)
    {
      Index& position = positions_[surface_.source(walk[k])];
      is_simple = is_simple && position == no_index;
      position = static_cast<Index>(k);
    }
    least_.assign(walk.size(), is_simple ? infinity : 0);
    shortest_part_.clear();
    if(is_simple)
    {
      search_from(walk, bound);
      trace_shortest_part(walk);
    }
    for(const Index h : walk)
      positions_[surface_.source(h)] = no_index;
    return least_;
  }

  // The shortest of these parts, of all that come back to the walk; empty if there is none.
  const Halfedge_walk& shortest_part() const { return shortest_part_; }

private:
  typedef std::pair<double, Index> Queued;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  void search_from(const Halfedge_walk& walk, double bound)
  {
    const auto back = [&](std::size_t k) { return surface_.opposite(walk[(k + walk.size() - 1) % walk.size()]); };
    from_right_.clear();
    for(std::size_t k = 0; k != walk.size(); ++k)
      for(Index h = surface_.turned(back(k)); h != walk[k]; h = surface_.turned(h))
        from_right_.insert(surface_.opposite(h));
    bound_ = bound;
    number_to_reach_ = walk.size();
    last_steps_of_parts_.assign(walk.size(), no_index);
    for(std::size_t k = 0; k != walk.size(); ++k)
      for(Index h = surface_.turned(walk[k]); h != back(k); h = surface_.turned(h))
        follow(h, 0);
    while(!queue_.empty() && queue_.top().first < bound_)
    {
      const auto [distance, v] = queue_.top();
      queue_.pop();
      if(distance != distances_[v])
        continue;
      surface_.for_each_outgoing(v, [&, from = distance](Index h) { follow(h, from); });
      if(number_to_reach_ != 0)
        continue;
      bound_ = *std::max_element(least_.begin(), least_.end()); // What is farther is on no shorter way back.
      number_to_reach_ = no_index;
    }
    queue_ = {};
    for(const Index v : reached_)
      distances_[v] = infinity;
    reached_.clear();
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
        last_steps_of_parts_[position] = h;
      }
    }
    else if(distance < distances_[w] && distance < bound_)
    {
      if(distances_[w] == infinity)
        reached_.push_back(w);
      distances_[w] = distance;
      last_steps_[w] = h;
      queue_.emplace(distance, w);
    }
  }

  void trace_shortest_part(const Halfedge_walk& walk)
  {
    const auto least = std::min_element(least_.begin(), least_.end()) - least_.begin();
    if(walk.empty() || least_[least] == infinity)
      return;
    Index h = last_steps_of_parts_[least];
    for(; positions_[surface_.source(h)] == no_index; h = last_steps_[surface_.source(h)])
      shortest_part_.push_back(h);
    shortest_part_.push_back(h);
    std::reverse(shortest_part_.begin(), shortest_part_.end());
  }

  const Closed_surface& surface_;
  std::vector<double> distances_; // infinity between two searches
  std::vector<Index> positions_;  // of the vertices of the walk in it; no_index for others, and between two searches
  std::vector<Index> last_steps_; // to vertices that have been reached
  std::vector<Index> reached_;
  std::vector<Index> last_steps_of_parts_; // by position in the walk
  Halfedge_walk shortest_part_;
  std::unordered_set<Index> from_right_; // halfedges that lead to the walk
  std::vector<double> least_;
  std::size_t number_to_reach_ = 0; // of vertices of the walk
  double bound_ = 0;                // of what is looked for
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

// The sum for both halves: 0 only for the class 0.
inline std::uint64_t code_of(const Class_codes& codes, Index h) { return code_of(codes, h, 0) + code_of(codes, h, 1); }

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

// Lengths, by half and vertex: no loop through the vertex whose class has no part in that half is shorter. All threads add
// to them, which has no influence on what is found: a search that is left out would have found nothing.
typedef std::array<std::vector<Relaxed_value<double>>, 2> Least_lengths;

// Shortest loops through a vertex, by shortest paths in a cover of the surface, which form a tree there.
class Loop_search
{
public:
  struct Loop
  {
    double length = 0;
    Halfedge_walk walk;
    bool is_shortest = true;          // false if the search has stopped
    std::size_t number_of_places = 0; // that it has seen
  };

  Loop_search(const Closed_surface& surface, const Class_codes& codes, Least_lengths& least_lengths)
    : surface_(surface),
      codes_(codes),
      least_lengths_(least_lengths),
      first_places_(surface.points.size(), no_index)
  {}

  // Finds a loop shorter than `bound` whose class has no part in the half `closed_half`, and which is accepted: that is
  // asked once for each class. The walk is empty if there is none, or if the search takes too many places. The cover is
  // that in which only such loops close: each edge that joins two branches of the tree closes one.
  Loop operator()(Index root,
                  int closed_half,
                  double bound,
                  std::size_t largest_number_of_places,
                  const std::function<bool(const Halfedge_walk&)>& accept)
  {
    Loop best = {bound, {}};
    if(least_lengths_[closed_half][root].get() >= bound)
      return best;
    least_length_ = bound;
    std::unordered_map<std::uint64_t, bool> is_accepted;
    const auto is_class_accepted = [&](std::uint64_t code, const auto& make_walk) {
      const auto known = is_accepted.find(code);
      if(known != is_accepted.end())
        return known->second;
      return is_accepted[code] = is_accepted[std::uint64_t(0) - code] = accept(make_walk());
    };
    visit_places(root, largest_number_of_places, best,
                 [&](Index place, Index h) { follow(place, h, closed_half, best, is_class_accepted); });
    if(best.is_shortest)
      least_lengths_[closed_half][root].set(least_length_);
    return best;
  }

  // Searches for loops of one class, or its negative, where the codes of a loop add up to `code`. In the cover no loop
  // closes that has a class, and those of this one lead from the root to its copies: the halves of a shortest one are
  // shortest paths, the second one moved to the root. An edge of a tree as above need not close a shortest one.
  Loop of_class(Index root, std::uint64_t code, double bound, std::size_t largest_number_of_places)
  {
    Loop best = {bound, {}};
    visit_places(root, largest_number_of_places, best, [&](Index place, Index h) {
      const std::uint64_t sheet = places_[place].sheet + code_of(codes_, h);
      const double distance = places_[place].distance + surface_.length(h);
      for(const std::uint64_t moved : {sheet - code, sheet + code})
      {
        const Index other = find(surface_.target[h], moved);
        if(other != no_index && distance + places_[other].distance < best.length)
          best = make_loop(place, h, other);
      }
      reach(place, h, find(surface_.target[h], sheet), sheet, 0, best.length);
    });
    return best;
  }

  // The sum of the codes of a walk.
  std::uint64_t code(const Halfedge_walk& walk) const
  {
    std::uint64_t sum = 0;
    for(const Index h : walk)
      sum += code_of(codes_, h);
    return sum;
  }

private:
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

  // Calls follow(place, halfedge) for each halfedge that leaves a place, the nearest place first, as long as a loop that
  // is shorter than the best one can be found.
  template <class Follow>
  void visit_places(Index root, std::size_t largest_number_of_places, Loop& best, const Follow& follow)
  {
    places_.clear();
    queue_ = {};
    add(root, 0, no_index, no_index, 0, 0, true);
    while(!queue_.empty() && places_.size() < largest_number_of_places)
    {
      const Index place = queue_.top().second;
      queue_.pop();
      if(places_[place].is_settled)
        continue;
      if(2 * places_[place].distance >= best.length)
        break;
      places_[place].is_settled = true;
      const Index came_from = surface_.opposite(places_[place].halfedge);
      surface_.for_each_outgoing(places_[place].vertex, [&](Index h) {
        if(surface_.is_given(h) && h != came_from)
          follow(place, h);
      });
    }
    best.is_shortest = places_.size() < largest_number_of_places;
    best.number_of_places = places_.size();
    for(const Place& place : places_)
      first_places_[place.vertex] = no_index;
  }

  void add(Index v, std::uint64_t sheet, Index from, Index h, std::uint64_t code, double distance, bool is_queued)
  {
    const Index place = static_cast<Index>(places_.size());
    places_.push_back({v, first_places_[v], from, h, sheet, code, distance, false});
    first_places_[v] = place;
    if(is_queued)
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
  void follow(Index place, Index h, int closed_half, Loop& best, const Accept& accept)
  {
    const std::uint64_t sheet = places_[place].sheet + code_of(codes_, h, closed_half);
    const std::uint64_t code = places_[place].code + code_of(codes_, h, 1 - closed_half);
    const Index other = find(surface_.target[h], sheet);
    if(other != no_index && places_[other].code != code)
    {
      const double length = places_[place].distance + surface_.length(h) + places_[other].distance;
      if(length < best.length)
      {
        least_length_ = (std::min)(least_length_, length);
        if(accept(code - places_[other].code, [&] { return walk_through(place, h, other); }))
          best = make_loop(place, h, other);
      }
    }
    reach(place, h, other, sheet, code, best.length);
  }

  // Notes the path along a halfedge to a place, or to a new one if `other` is none, if it is the shortest one so far.
  void reach(Index place, Index h, Index other, std::uint64_t sheet, std::uint64_t code, double bound)
  {
    const double distance = places_[place].distance + surface_.length(h);
    if(other == no_index)
    {
      if(2 * distance < bound + 2 * surface_.length(h))
        add(surface_.target[h], sheet, place, h, code, distance, 2 * distance < bound);
    }
    else if(!places_[other].is_settled && distance < places_[other].distance)
    {
      places_[other].from = place;
      places_[other].halfedge = h;
      places_[other].code = code;
      places_[other].distance = distance;
      queue_.emplace(distance, other);
    }
  }

  Loop make_loop(Index place, Index h, Index other) const
  {
    Halfedge_walk walk = walk_through(place, h, other);
    reduce(walk);
    return {surface_.length(walk), std::move(walk)};
  }

  // From the root along the halfedge, and back from the other place.
  Halfedge_walk walk_through(Index place, Index h, Index other) const
  {
    Halfedge_walk walk = walk_to(place);
    walk.push_back(h);
    const Halfedge_walk back = reversed(walk_to(other));
    walk.insert(walk.end(), back.begin(), back.end());
    return walk;
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
  Least_lengths& least_lengths_;
  std::vector<Index> first_places_; // by vertex
  double least_length_ = 0;         // of loops seen in this search, or its bound
  std::vector<Place> places_;
  std::priority_queue<Queued, std::vector<Queued>, std::greater<Queued>> queue_;
};

// Searches on many threads, of which each has what it searches with.
class Loop_searchers
{
public:
  struct Searcher
  {
    Loop_search search;
    Crossing_bounds crossing_bounds;
  };

  Loop_searchers(const Closed_surface& surface, const Class_codes& codes, const Threads& threads)
    : surface_(surface),
      codes_(codes),
      threads_(threads),
      least_lengths_{Least_lengths::value_type(surface.points.size()), Least_lengths::value_type(surface.points.size())}
  {}

  // Calls function(i, searcher, report) for i from 0 to size - 1, where report() lets it be cancelled. The calls must not
  // depend on each other.
  template <class Function>
  void operator()(std::size_t size, const Stage_progress& progress, const Function& function)
  {
    std::atomic<std::size_t> number_done{0};
    const auto report = [&] { progress(static_cast<double>(number_done) / static_cast<double>(size)); };
    threads_.for_each_index(size, [&](std::size_t i) {
      report();
      std::unique_ptr<Searcher> searcher = take();
      function(i, *searcher, report);
      put_back(std::move(searcher));
      ++number_done;
    });
  }

private:
  std::unique_ptr<Searcher> take()
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if(!idle_.empty())
      {
        std::unique_ptr<Searcher> searcher = std::move(idle_.back());
        idle_.pop_back();
        return searcher;
      }
    }
    return std::unique_ptr<Searcher>(
      new Searcher{Loop_search(surface_, codes_, least_lengths_), Crossing_bounds(surface_)});
  }

  void put_back(std::unique_ptr<Searcher> searcher)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    idle_.push_back(std::move(searcher));
  }

  const Closed_surface& surface_;
  const Class_codes& codes_;
  const Threads& threads_;
  Least_lengths least_lengths_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Searcher>> idle_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_LOOP_SEARCH_H
