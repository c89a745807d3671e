// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_BLUNT_END_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_BLUNT_END_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/skeleton/internal/Component_filling.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_tree.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// The cap that closes a limb: the faces around the one that is seen along the limb, which turn from it by less than 60 degrees.
// A limb ends bluntly if the cap is flatter than half of its radius, and about half of it turns by less than 30 degrees, more than
// of half a ball.
class Blunt_end
{
public:
  // The view is from a point inside, in a direction of length 1, where the limb has about such a radius. What has other tips, as
  // the sole of a foot has those of toes, is the end of no limb.
  Blunt_end(const Surface_tree& tree,
            const Point& from,
            const Vector& along,
            double radius,
            const Point& tip,
            const std::vector<Point>& other_tips)
    : tree_(tree),
      mesh_(tree.mesh())
  {
    const auto seen = tree.first_seen(from, along);
    if(!seen)
      return;
    seen_ = place_in(seen->second, seen->first);
    const double farthest = 4 * (radius + distance(from, seen->first));
    find_middle(seen->second, along, seen->first, farthest, tip, other_tips);
    if(!middle_) // A line can come from a corner.
      find_middle(seen->second, -tree.inward_normal(seen->second), seen->first, farthest, tip, other_tips);
  }

  // Where the limb, straight on, meets the surface.
  const std::optional<Surface_place>& seen() const { return seen_; }

  // The middle of the cap, if the limb ends bluntly.
  const std::optional<Surface_place>& middle() const { return middle_; }

  double radius() const { return std::sqrt(area_ / pi); }

private:
  void find_middle(Mesh::Face_index seen,
                   const Vector& along,
                   const Point& p,
                   double farthest,
                   const Point& tip,
                   const std::vector<Point>& other_tips)
  {
    const auto axis = mean_normal(seen, along, p, farthest);
    if(!axis || !mean_normal(seen, *axis, p, farthest) || !is_flat(*axis) || !has_tip(*axis, tip)
       || std::any_of(other_tips.begin(), other_tips.end(), [&](const Point& other) { return has_tip(*axis, other); }))
      return;
    const auto [closest, face] = tree_.closest_place(centroid_);
    middle_ = place_in(face, closest);
  }

  // Finds the cap, whose faces look about the way of a direction, and the way that it looks on average. None if it is far larger than
  // the limb.
  std::optional<Vector> mean_normal(Mesh::Face_index seen, const Vector& axis, const Point& p, double farthest)
  {
    std::vector<Mesh::Face_index> waiting = {seen};
    std::set<Mesh::Face_index> found = {seen};
    Vector sum = NULL_VECTOR, moment = NULL_VECTOR;
    area_ = flat_area_ = 0;
    faces_.clear();
    while(!waiting.empty())
    {
      const auto f = waiting.back();
      waiting.pop_back();
      const auto corners = tree_.corners(f);
      const Vector normal = -tree_.inward_normal(f);
      const double turn = normal * axis,
                   size = length(cross_product(corners[1] - corners[0], corners[2] - corners[0])) / 2;
      if(turn < cosine_of_60)
        continue;
      if(distance(corners[0], p) > farthest)
        return std::nullopt;
      faces_.push_back(f);
      area_ += size;
      flat_area_ += turn < cosine_of_30 ? 0 : size;
      sum = sum + size * normal;
      moment = moment + size * (CGAL::centroid(corners[0], corners[1], corners[2]) - ORIGIN);
      for(const auto h : CGAL::halfedges_around_face(mesh_.halfedge(f), mesh_))
        if(const auto g = mesh_.face(mesh_.opposite(h)); found.insert(g).second)
          waiting.push_back(g);
    }
    if(!(area_ > 0) || !(length(sum) > 0))
      return std::nullopt;
    centroid_ = ORIGIN + moment / area_;
    return sum / length(sum);
  }

  bool is_flat(const Vector& axis) const
  {
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for(const auto f : faces_)
      for(const Point& p : tree_.corners(f))
      {
        const double height = (p - centroid_) * axis;
        lowest = (std::min)(lowest, height);
        highest = (std::max)(highest, height);
      }
    return flat_area_ > least_flat_share * area_ && highest - lowest < radius() / 2;
  }

  // Whether a tip is one of the cap, or of its rim. A line that bends can look at another side.
  bool has_tip(const Vector& axis, const Point& tip) const
  {
    return std::abs((tip - centroid_) * axis) < radius() / 2 && distance(tip, centroid_) < 2 * radius();
  }

  Surface_place place_in(Mesh::Face_index f, const Point& p) const
  {
    return {p + share_to_center * (tree_.center(f) - p), std::nullopt, f};
  }

  static constexpr double cosine_of_60 = 0.5, cosine_of_30 = 0.8660254037844386;
  static constexpr double least_flat_share = 0.45;
  static constexpr double share_to_center = 0.01; // so that the point is on no edge

  const Surface_tree& tree_;
  const Mesh& mesh_;
  std::vector<Mesh::Face_index> faces_;
  double area_ = 0, flat_area_ = 0;
  Point centroid_ = ORIGIN;
  std::optional<Surface_place> seen_, middle_;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_BLUNT_END_H
