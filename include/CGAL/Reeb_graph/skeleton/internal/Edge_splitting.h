// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_EDGE_SPLITTING_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_EDGE_SPLITTING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/skeleton/internal/Component_filling.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <queue>
#include <utility>

namespace CGAL::Reeb_graph::internal::skeleton {

// Cuts edges in halves, the longest ones first, and the triangles beside them, until none is longer than those of some hundreds
// of vertices that are spread evenly, or until some thousands have been cut: where edges are as long as limbs, fronts do not see
// where these fork. Fillings of borders and triangles without area stay, and so does what is beside longer edges of them. New edges
// keep the length of the given one that has been cut for them.
class Edge_splitting
{
public:
  explicit Edge_splitting(Filled_component& component)
    : component_(component),
      mesh_(component.mesh),
      number_before_(mesh_.num_vertices())
  {
    for(const auto f : mesh_.faces())
    {
      const auto [a, b, c] = corners(mesh_.halfedge(f));
      largest_square_ += length(cross_product(b - a, c - a)) / 2 * share_of_area;
    }
    for(const auto e : mesh_.edges())
      add(mesh_.halfedge(e));
    if(longest_.empty())
      return;
    for(const auto e : mesh_.edges())
      component_.given_lengths.push_back(std::sqrt(square(mesh_.halfedge(e))));
    while(!longest_.empty() && mesh_.num_vertices() < number_before_ + most_cut)
    {
      const auto h = mesh_.halfedge(longest_.top().second);
      longest_.pop();
      if(is_longest(h) && is_longest(mesh_.opposite(h)))
        split(h);
    }
  }

private:
  std::array<Point, 3> corners(Mesh::Halfedge_index h) const
  {
    return {mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h)), mesh_.point(mesh_.target(mesh_.next(h)))};
  }

  double square(Mesh::Halfedge_index h) const
  {
    return squared_distance(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h)));
  }

  void add(Mesh::Halfedge_index h)
  {
    if(square(h) > largest_square_ && may_change(h) && may_change(mesh_.opposite(h)))
      longest_.emplace(square(h), mesh_.edge(h));
  }

  bool may_change(Mesh::Halfedge_index h) const
  {
    for(const auto v : {mesh_.source(h), mesh_.target(h), mesh_.target(mesh_.next(h))})
      if(!component_.is_given(v) && v.idx() < number_before_)
        return false;
    const auto [a, b, c] = corners(h);
    return !collinear(a, b, c);
  }

  // Whether it is that of its triangle: else a longer one has stayed, and there would be no end.
  bool is_longest(Mesh::Halfedge_index h) const
  {
    return !(square(mesh_.next(h)) > square(h)) && !(square(mesh_.prev(h)) > square(h));
  }

  void split(Mesh::Halfedge_index h)
  {
    const Point middle = CGAL::midpoint(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h)));
    const auto first_half = CGAL::Euler::split_edge(h, mesh_), back = mesh_.opposite(h);
    mesh_.point(mesh_.target(first_half)) = middle;
    CGAL::Euler::split_face(first_half, mesh_.next(h), mesh_);
    CGAL::Euler::split_face(back, mesh_.next(mesh_.next(back)), mesh_);
    component_.given_lengths.resize(mesh_.num_edges(), component_.given_lengths[mesh_.edge(h)]);
    for(const auto to_middle : CGAL::halfedges_around_target(first_half, mesh_))
      add(to_middle);
  }

  static constexpr double share_of_area = 1. / 500;
  static constexpr std::size_t most_cut = 2000;

  Filled_component& component_;
  Mesh& mesh_;
  const std::size_t number_before_;
  double largest_square_ = 0;
  std::priority_queue<std::pair<double, Mesh::Edge_index>> longest_; // by the squares of their lengths
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_EDGE_SPLITTING_H
