// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_JUNCTION_BALLS_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_JUNCTION_BALLS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/skeleton/Curve_skeleton.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// A ball around each junction, as wide as the widest of the lines that begin there, where they leave it. The part of a line from
// a junction until it leaves the ball is what lies in the junction.
template <class CurveSkeleton>
class Junction_balls
{
public:
  explicit Junction_balls(const CurveSkeleton& skeleton)
    : skeleton_(skeleton),
      arcs_(skeleton_arcs(skeleton)),
      radii_(num_vertices(skeleton), -1)
  {
    for(std::size_t v = 0; v != radii_.size(); ++v)
      if(out_degree(v, skeleton) > 2)
        radii_[v] = skeleton[v].radius;
    for(const auto& arc : arcs_)
      for(const bool is_last : {false, true})
      {
        const std::size_t node = at(arc, 0, is_last), neighbor = at(arc, 1, is_last);
        if(radii_[node] >= 0 && distance(node, neighbor) < 2 * skeleton[neighbor].radius)
          radii_[node] = (std::max)(radii_[node], skeleton[neighbor].radius);
      }
    for(const auto& arc : arcs_)
      numbers_inside_.push_back({count_inside(arc, false, 1), count_inside(arc, true, 1)});
  }

  const std::vector<std::vector<std::size_t>>& arcs() const { return arcs_; }

  // The radius of the ball of a node, negative if it is no junction.
  double radius(std::size_t node) const { return radii_[node]; }

  // How many points of an arc, from one end on, are in the ball there.
  std::size_t number_inside(std::size_t arc, bool is_last) const { return numbers_inside_[arc][is_last ? 1 : 0]; }

  // How many are in a ball of twice the radius.
  std::size_t number_near(std::size_t arc, bool is_last) const { return count_inside(arcs_[arc], is_last, 2); }

  // The share of an edge of an arc, from its point i to the next one, that is outside of the balls of the ends.
  double share_outside(std::size_t arc, std::size_t i) const
  {
    double share = 1;
    for(const bool is_last : {false, true})
    {
      const std::size_t node = at(arcs_[arc], 0, is_last), nearer = is_last ? arcs_[arc].size() - 2 - i : i;
      const std::size_t inside = number_inside(arc, is_last);
      if(nearer + 1 < inside)
        return 0;
      if(nearer + 1 != inside)
        continue;
      const double from = distance(node, at(arcs_[arc], nearer, is_last));
      const double to = distance(node, at(arcs_[arc], nearer + 1, is_last));
      share -= (radii_[node] - from) / (to - from);
    }
    return (std::max)(share, 0.);
  }

  // The point of an arc that is the i-th one from an end.
  static std::size_t at(const std::vector<std::size_t>& arc, std::size_t i, bool is_last)
  {
    return is_last ? arc[arc.size() - 1 - i] : arc[i];
  }

private:
  std::size_t count_inside(const std::vector<std::size_t>& arc, bool is_last, double share) const
  {
    const std::size_t node = at(arc, 0, is_last);
    std::size_t i = 0;
    while(i != arc.size() && distance(node, at(arc, i, is_last)) <= share * radii_[node])
      ++i;
    return i;
  }

  double distance(std::size_t a, std::size_t b) const
  {
    return distance_between(skeleton_[a].point, skeleton_[b].point);
  }

  const CurveSkeleton& skeleton_;
  const std::vector<std::vector<std::size_t>> arcs_;
  std::vector<double> radii_;
  std::vector<std::array<std::size_t, 2>> numbers_inside_; // of each arc
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_JUNCTION_BALLS_H
