// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// Bodies of several proportions in several poses, to compare: what each vertex is part of is known.

#ifndef CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_POSED_BODY_H
#define CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_POSED_BODY_H

#include "generated_surfaces/Triangle_soup.h"
#include "generated_surfaces/standing_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace generated_surfaces {
// The parts of a body: left and right ones are the same.
enum class Body_part
{
  HEAD,
  TRUNK,
  ARM,
  LEG
};

struct Posed_body
{
  Triangle_soup soup;
  std::vector<Body_part> parts; // by vertex
  std::size_t top_of_head;      // a vertex
};

namespace internal {
// A body has lengths and radii, a pose has angles; each is drawn from a seed of its own.
class Body_limbs
{
public:
  Body_limbs(unsigned body_seed, unsigned pose_seed)
  {
    std::mt19937 body(body_seed), pose(pose_seed + 1000003u);
    const double trunk = between(body, 0.42, 0.62), width = between(body, 0.16, 0.21),
                 girth = between(body, 0.11, 0.17);
    const double arm = between(body, 0.36, 0.72), arm_radius = between(body, 0.05, 0.062);
    const double leg = between(body, 0.62, 0.95), leg_radius = between(body, 0.06, 0.08);
    const double neck = between(body, 0.07, 0.12), head = between(body, 0.09, 0.125);
    const Vector neck_base{0, 0, trunk};
    add(Body_part::TRUNK, {0, 0, 0}, {0, 0, 0.85 * trunk}, 0.95 * girth, girth);
    add(Body_part::TRUNK, {-width, 0, 0.9 * trunk}, {width, 0, 0.9 * trunk}, 0.07, 0.07);
    const Vector head_base = moved(neck_base, neck + 0.05, tilted(pose, {0, 0, 1}, 0.25));
    add(Body_part::HEAD, moved(neck_base, -0.05, {0, 0, 1}), head_base, 0.05, 0.05);
    const Vector top = moved(head_base, 1.1 * head, tilted(pose, {0, 0, 1}, 0.2));
    add(Body_part::HEAD, head_base, top, head, 0.95 * head);
    top_ = moved(top, 0.95 * head, {0, 0, 1});
    for(const double side : {-1., 1.})
    {
      // an arm hangs, is held out, or lifted; the elbow bends to the front
      const double lift = between(pose, 0.55, 2.5), bend = between(pose, 0, 0.9);
      const Vector shoulder{side * width, 0, 0.9 * trunk};
      const Vector upper{side * std::sin(lift), -0.2, -std::cos(lift)};
      const Vector elbow = moved(shoulder, 0.5 * arm, unit(upper));
      const Vector hand = moved(elbow, 0.5 * arm, unit(moved(upper, bend, {0, -1, 0.2})));
      add(Body_part::ARM, shoulder, elbow, 1.15 * arm_radius, arm_radius);
      add(Body_part::ARM, elbow, hand, arm_radius, 0.95 * arm_radius);
      const double stride = between(pose, -0.45, 0.45), spread = between(pose, 0.18, 0.4), knee = between(pose, 0, 0.7);
      const Vector hip{side * 0.6 * girth, 0, -0.02};
      const Vector thigh{side * std::sin(spread), -stride, -std::cos(spread)};
      const Vector joint = moved(hip, 0.5 * leg, unit(thigh));
      const Vector ankle = moved(joint, 0.5 * leg, unit(moved(thigh, knee, {0, 1, 0})));
      add(Body_part::LEG, hip, joint, 1.2 * leg_radius, leg_radius);
      add(Body_part::LEG, joint, ankle, leg_radius, 0.8 * leg_radius);
      add(Body_part::LEG, ankle, moved(ankle, 0.13, {0, -1, 0}), 0.8 * leg_radius, 0.7 * leg_radius);
    }
  }

  double operator()(const Vector& p) const
  {
    constexpr double smoothness = 0.012;
    double sum = 0;
    for(const Limb& limb : limbs_)
      sum += std::exp(-std::max(limb.distance(p), -0.5) / smoothness);
    return -smoothness * std::log(std::max(sum, 1e-300));
  }

  Body_part part(const Vector& p) const
  {
    const auto nearest = std::min_element(limbs_.begin(), limbs_.end(),
                                          [&](const Limb& a, const Limb& b) { return a.distance(p) < b.distance(p); });
    return parts_[nearest - limbs_.begin()];
  }

  // The corners of a box around it.
  std::array<Vector, 2> box() const
  {
    Vector lowest{1e9, 1e9, 1e9}, highest{-1e9, -1e9, -1e9};
    for(const Limb& limb : limbs_)
      for(const Vector& end : {limb.from, limb.to})
        for(int i = 0; i < 3; ++i)
        {
          lowest[i] = std::min(lowest[i], end[i] - 0.25);
          highest[i] = std::max(highest[i], end[i] + 0.25);
        }
    return {lowest, highest};
  }

  const Vector& top() const { return top_; }

private:
  // The same number with each standard library.
  static double between(std::mt19937& random, double low, double high)
  {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.;
  }

  static Vector unit(const Vector& v) { return moved({0, 0, 0}, 1 / std::sqrt(dot(v, v)), v); }

  static Vector tilted(std::mt19937& random, const Vector& v, double most)
  {
    const double x = between(random, -most, most), y = between(random, -most, most);
    return unit(moved(v, 1, {x, y, 0}));
  }

  void add(Body_part part, const Vector& from, const Vector& to, double radius_from, double radius_to)
  {
    limbs_.push_back({from, to, radius_from, radius_to});
    parts_.push_back(part);
  }

  std::vector<Limb> limbs_;
  std::vector<Body_part> parts_;
  Vector top_;
};

} // namespace internal

// A body of about so many vertices: its proportions are drawn from the one seed, its pose from the other one.
inline Posed_body posed_body(unsigned body_seed, unsigned pose_seed, std::size_t number_of_vertices)
{
  const internal::Body_limbs body(body_seed, pose_seed);
  const double cell_size = std::sqrt(7.5 / static_cast<double>(std::max<std::size_t>(number_of_vertices, 1)));
  const auto [lowest, highest] = body.box();
  internal::Marching_tetrahedra surface(body, lowest, highest, cell_size);
  Posed_body result{surface.take_surface(), {}, 0};
  internal::smooth(result.soup, body, 8);
  double nearest = 1e9;
  for(std::size_t v = 0; v < result.soup.points.size(); ++v)
  {
    const auto& p = result.soup.points[v];
    result.parts.push_back(body.part(p));
    const internal::Vector offset = internal::difference(p, body.top());
    if(const double distance = internal::dot(offset, offset); distance < nearest)
    {
      nearest = distance;
      result.top_of_head = v;
    }
  }
  return result;
}

} // namespace generated_surfaces

#endif // CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_POSED_BODY_H
