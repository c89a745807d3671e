// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_BEAD_WAYS_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_BEAD_WAYS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/skeleton/internal/Component_filling.h>
#include <CGAL/Reeb_graph/skeleton/internal/Skeleton_lines.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_tree.h>

#include <optional>

namespace CGAL::Reeb_graph::internal::skeleton {

// The points of lines as beads, which know how far the surface is, and what ways between them the surface does not meet.
class Bead_ways
{
protected:
  struct Bead
  {
    Line_point point;  // with the closest point of the surface
    double depth = 0;  // the distance from the surface; 0 at a tip
    double pace = 0.5; // of its steps
    double way = 0;    // that it has gone in a turn of rounds, by depths
    bool is_settled = false, is_fixed = false;
    bool is_across_tube = false;              // the contour that has the radius
    std::optional<Mesh::Vertex_index> vertex; // of the surface, at an end, which stays,
    std::optional<Mesh::Face_index> face;     // or in whose middle that is

    bool is_on_surface() const { return vertex || face; }
    Surface_place place() const { return {point.point, vertex, face}; }
  };

  explicit Bead_ways(const Surface_tree& tree) : tree_(tree) {}

  Bead make_bead(Line_point point) const
  {
    Bead bead;
    point.on_surface = tree_.closest_on_wall(point.point, point.on_surface);
    bead.depth = distance(point.point, point.on_surface);
    bead.point = point;
    return bead;
  }

  // Whether the surface does not meet a triangle of two beads and a place, other than in an end. Balls around beads are free.
  bool is_free(const Bead& a, const Bead& b, const Surface_place& c) const
  {
    if(is_in_ball(b, a, c) || is_in_ball(a, b, c))
      return true;
    if(a.is_on_surface() || b.is_on_surface() || c.is_on_surface()) // no part of a loop
      return !tree_.is_crossed(a.place(), c) && !tree_.is_crossed(b.place(), c);
    return !tree_.is_met_by_triangle(a.point.point, b.point.point, c.point);
  }

  // Whether the surface does not meet the edge between two beads, other than in an end.
  bool is_free(const Bead& a, const Bead& b) const
  {
    return is_in_ball(a, a, b.place()) || is_in_ball(b, b, a.place()) || !tree_.is_crossed(a.place(), b.place());
  }

  // Openings do not count in depths.
  bool is_in_ball(const Bead& center, const Bead& other, const Surface_place& third) const
  {
    const double radius = (1 - 1e-6) * center.depth;
    const Point& p = center.point.point;
    return !tree_.has_openings() && distance(p, other.point.point) < radius && distance(p, third.point) < radius;
  }

  const Surface_tree& tree_;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_BEAD_WAYS_H
