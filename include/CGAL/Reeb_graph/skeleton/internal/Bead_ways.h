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

  Bead make_bead(const Skeleton_lines::Node& node) const
  {
    Bead bead = make_bead(node.point);
    bead.vertex = node.vertex;
    bead.face = node.face;
    if(node.kind == Line_end::TIP)
      bead.depth = 0;
    return bead;
  }

  // A bead on the way from one to another one.
  Bead between(const Bead& a, const Bead& b, double t) const
  {
    Line_point point = a.point;
    point.point = a.point.point + t * (b.point.point - a.point.point);
    point.radius = (1 - t) * a.point.radius + t * b.point.radius;
    point.place = (1 - t) * a.point.place + t * b.point.place;
    return make_bead(point);
  }

  // Whether the surface does not meet a triangle of two beads and a place, other than in an end. Balls around beads are free.
  bool is_free(const Bead& a, const Bead& b, const Surface_place& c) const
  {
    if(is_in_balls(a, b, c.point) || is_in_balls(b, a, c.point))
      return true;
    if(a.is_on_surface() || b.is_on_surface() || c.is_on_surface()) // no part of a loop
      return !tree_.is_crossed(a.place(), c) && !tree_.is_crossed(b.place(), c);
    return !tree_.is_met_by_triangle(a.point.point, b.point.point, c.point);
  }

  // Whether the surface does not meet the edge between two beads, other than in an end.
  bool is_free(const Bead& a, const Bead& b) const
  {
    return distance(a.point.point, b.point.point) < ball(a) + ball(b) || !tree_.is_crossed(a.place(), b.place());
  }

  // Whether the balls of two beads hold a triangle of both and a point: that of the second one all but a corner, which is in that
  // of the first one.
  bool is_in_balls(const Bead& first, const Bead& second, const Point& third) const
  {
    const Point &p = first.point.point, &q = second.point.point;
    const double radius = ball(second), radius_of_first = ball(first);
    const auto leaves_inside = [&](const Point& to) {
      const double size = distance(p, to);
      const Point exit = size > radius_of_first ? p + radius_of_first / size * (to - p) : to;
      return distance(exit, q) < radius;
    };
    return distance(third, q) < radius && leaves_inside(q) && leaves_inside(third);
  }

  // The radius of a ball around a bead that neither the surface nor an opening meets.
  double ball(const Bead& bead) const
  {
    return tree_.is_near_opening(bead.point.point, bead.depth) ? 0 : (1 - 1e-6) * bead.depth;
  }

  const Surface_tree& tree_;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_BEAD_WAYS_H
