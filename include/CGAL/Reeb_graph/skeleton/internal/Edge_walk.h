// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_EDGE_WALK_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_EDGE_WALK_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/skeleton/internal/Component_filling.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// Goes away from a vertex along edges, from vertex to vertex, the nearest one next. What it needs is kept for the next start.
class Edge_walk
{
public:
  // Edges count by their given lengths, if there are any.
  explicit Edge_walk(const Mesh& mesh, const std::vector<double>& given_lengths = {})
    : mesh_(mesh),
      given_lengths_(given_lengths),
      distances_(mesh.num_vertices(), std::numeric_limits<double>::infinity())
  {}

  void start(Mesh::Vertex_index v)
  {
    for(const auto u : reached_)
      distances_[u] = std::numeric_limits<double>::infinity();
    reached_.assign(1, v);
    front_.assign(1, {0, v});
    distances_[v] = 0;
    last_ = v;
    longest_edge_ = 0;
  }

  Mesh::Vertex_index last() const { return last_; }
  double passed() const { return distances_[last_]; }

  // The longest edge at a vertex that has been passed.
  double longest_edge() const { return longest_edge_; }

  // Passes the next vertex, if there is one.
  void step()
  {
    drop_passed();
    if(front_.empty())
      return;
    last_ = front_.front().second;
    pop();
    const double passed = distances_[last_];
    const auto first = mesh_.halfedge(last_);
    auto h = first;
    do // The halfedges end at the vertex.
    {
      const auto u = mesh_.source(h);
      if(const double old = distances_[u]; passed < old)
      {
        const double size = distance(mesh_.point(last_), mesh_.point(u));
        longest_edge_ = (std::max)(longest_edge_, given_lengths_.empty() ? size : given_lengths_[mesh_.edge(h)]);
        if(passed + size < old)
        {
          if(!std::isfinite(old))
            reached_.push_back(u);
          distances_[u] = passed + size;
          front_.push_back({passed + size, u});
          std::push_heap(front_.begin(), front_.end(), std::greater<>());
        }
      }
      h = mesh_.opposite(mesh_.next(h));
    } while(h != first);
  }

  // How far the next vertex is, infinite if there is none.
  double next_distance()
  {
    drop_passed();
    return front_.empty() ? std::numeric_limits<double>::infinity() : front_.front().first;
  }

  // By how much what is next is as wide as it is far, in a straight line from the start, in the mean.
  double width_by_distance() const
  {
    std::vector<Point> next;
    Vector to_middle = NULL_VECTOR;
    for(const Entry& entry : front_)
      if(is_next(entry))
      {
        next.push_back(mesh_.point(entry.second));
        to_middle = to_middle + (next.back() - next[0]);
      }
    const Point middle = next[0] + to_middle / static_cast<double>(next.size());
    double radius = 0, sum = 0;
    for(const Point& p : next)
    {
      radius = (std::max)(radius, distance(middle, p));
      sum += distance(mesh_.point(reached_[0]), p);
    }
    return 2 * radius * static_cast<double>(next.size()) / sum;
  }

  static constexpr double width_of_limb = 1.6; // by distance: at most

private:
  typedef std::pair<double, Mesh::Vertex_index> Entry;

  bool is_next(const Entry& entry) const { return entry.first == distances_[entry.second]; }

  void drop_passed()
  {
    while(!front_.empty() && !is_next(front_.front()))
      pop();
  }

  void pop()
  {
    std::pop_heap(front_.begin(), front_.end(), std::greater<>());
    front_.pop_back();
  }

  const Mesh& mesh_;
  const std::vector<double> given_lengths_;
  std::vector<double> distances_;
  std::vector<Mesh::Vertex_index> reached_; // since the start
  std::vector<Entry> front_;                // a heap, with longer ways to vertices that have been found
  Mesh::Vertex_index last_;
  double longest_edge_ = 0;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_EDGE_WALK_H
