// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_PLANE_CONTOUR_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_PLANE_CONTOUR_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/skeleton/internal/Component_filling.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_tree.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// The contour of a surface around a point inside, in the plane across a direction of length 1: it is followed from face to
// face. A vertex in the plane counts as below it, so that each face that is met has one edge where the contour goes on.
class Plane_contour
{
public:
  Plane_contour(const Surface_tree& tree, const Point& p, const Vector& along, const Point& closest)
    : mesh_(tree.mesh()),
      point_(p),
      along_(along)
  {
    const Vector across = Vector(closest - p) - (closest - p) * along * along;
    const Vector first = length(across) > 0 ? across : Vector(length(closest - p) * any_across()),
                 other = cross_product(along, first);
    for(const double turn : {0.1, 1.3, 2.9, 4.3})
      if(const auto seen = tree.first_seen(p, std::cos(turn) * first + std::sin(turn) * other))
        if(const auto start = way_out(seen->second); start != Mesh::null_halfedge())
        {
          follow(start, distance(p, seen->first));
          return;
        }
  }

  // The radius of a circle with that area, if the contour stays near the point.
  const std::optional<double>& radius() const { return radius_; }

  // The centroid of what it goes around, and how far it is from there at most, if it stays near the point.
  const Point& centroid() const { return centroid_; }
  double extent() const { return extent_; }

  // Whether it is that of a tube around the point: not cut lengthwise, as where a limb leaves a trunk.
  bool is_across_tube() const { return radius_ && *radius_ < 1.5 * distance_; }

private:
  double height(Mesh::Vertex_index v) const { return (mesh_.point(v) - point_) * along_; }

  Vector any_across() const
  {
    const Vector v = cross_product(along_, std::abs(along_.x()) < 0.6 ? Vector(1, 0, 0) : Vector(0, 1, 0));
    return v / length(v);
  }

  // The halfedge of a face that leads through the plane upwards.
  Mesh::Halfedge_index way_out(Mesh::Face_index f) const
  {
    auto h = mesh_.halfedge(f);
    for(int i = 0; i != 3; ++i, h = mesh_.next(h))
      if(!(height(mesh_.source(h)) > 0) && height(mesh_.target(h)) > 0)
        return h;
    return Mesh::null_halfedge();
  }

  Vector crossing(Mesh::Halfedge_index h) const // relative to the point
  {
    const Vector from = mesh_.point(mesh_.source(h)) - point_, to = mesh_.point(mesh_.target(h)) - point_;
    const double below = from * along_, above = to * along_;
    return from + below / (below - above) * (to - from);
  }

  void follow(Mesh::Halfedge_index start, double near)
  {
    double area = 0;
    Vector last = crossing(start), moment = NULL_VECTOR;
    std::vector<Vector> all;
    auto h = start;
    do
    {
      h = way_out(mesh_.face(mesh_.opposite(h)));
      const Vector next = crossing(h), edge = next - last;
      if(!(length(next) < farthest * near))
        return;
      const double part = cross_product(last, next) * along_ / 2;
      area += part;
      moment = moment + part / 3 * (last + next);
      all.push_back(next);
      const double square = edge.squared_length();
      const double t = square > 0 ? std::clamp(-(last * edge) / square, 0., 1.) : 0;
      distance_ = (std::min)(distance_, length(last + t * edge));
      last = next;
    } while(h != start);
    radius_ = std::sqrt(std::abs(area) / pi);
    const Vector centroid = area != 0 ? moment / area : NULL_VECTOR;
    centroid_ = point_ + centroid;
    for(const Vector& p : all)
      extent_ = (std::max)(extent_, length(p - centroid));
  }

  static constexpr double farthest = 8; // times as far as what is seen first

  const Mesh& mesh_;
  const Point point_;
  const Vector along_;
  std::optional<double> radius_;
  Point centroid_ = ORIGIN;
  double extent_ = 0;
  double distance_ = std::numeric_limits<double>::infinity();
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_PLANE_CONTOUR_H
