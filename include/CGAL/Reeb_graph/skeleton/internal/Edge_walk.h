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
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// Goes away from a vertex along edges, from vertex to vertex, the nearest one next.
class Edge_walk
{
public:
  Edge_walk(const Mesh& mesh, Mesh::Vertex_index from)
    : mesh_(mesh),
      distances_(mesh.num_vertices(), std::numeric_limits<double>::infinity()),
      front_(1, {0, from}),
      last_(from)
  {
    distances_[from] = 0;
  }

  Mesh::Vertex_index last() const { return last_; }

  // Whether there was a further vertex.
  bool step()
  {
    drop_passed();
    if(front_.empty())
      return false;
    last_ = front_.front().second;
    pop();
    const double reached = distances_[last_];
    const auto first = mesh_.halfedge(last_);
    auto h = first;
    do // The halfedges end at the vertex.
    {
      const auto u = mesh_.source(h);
      if(const double old = distances_[u]; reached < old)
        if(const double next = reached + distance(mesh_.point(last_), mesh_.point(u)); next < old)
        {
          distances_[u] = next;
          front_.push_back({next, u});
          std::push_heap(front_.begin(), front_.end(), std::greater<>());
        }
      h = mesh_.opposite(mesh_.next(h));
    } while(h != first);
    return true;
  }

  // How far the next vertex is, infinite if there is none.
  double next_distance()
  {
    drop_passed();
    return front_.empty() ? std::numeric_limits<double>::infinity() : front_.front().first;
  }

  // By how much what is next is as wide as it is far: the greatest distance in it that is found, by the mean one from the
  // vertex.
  double width_by_distance() const
  {
    const Entry* from = &front_.front();
    double width = 0, sum = 0, size = 0;
    for(int i = 0; i != 3; ++i)
    {
      const Entry* farthest = from;
      for(const Entry& entry : front_)
        if(const double d = distance(mesh_.point(from->second), mesh_.point(entry.second)); d > width && is_next(entry))
        {
          width = d;
          farthest = &entry;
        }
      from = farthest;
    }
    for(const Entry& entry : front_)
      if(is_next(entry))
      {
        sum += entry.first;
        ++size;
      }
    return width * size / sum;
  }

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
  std::vector<double> distances_;
  std::vector<Entry> front_; // a heap, with longer ways to vertices that have been found
  Mesh::Vertex_index last_;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_EDGE_WALK_H
