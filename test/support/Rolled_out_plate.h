// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_ROLLED_OUT_PLATE_H
#define CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_ROLLED_OUT_PLATE_H

#include <algorithm>
#include <array>
#include <cmath>

namespace generated_surfaces::internal {
constexpr double pi = 3.14159265358979323846;

// A plate with round holes, and the same plate with its rounded rim rolled out into the plane. A point of the rolled
// out plate that is `distance` away from the border lies at the angle distance / thickness on the rim.
class Rolled_out_plate
{
public:
  struct Location
  {
    double distance;             // to the nearest border, negative outside of the plate
    double inwards_x, inwards_y; // the unit vector away from that border
  };
  static constexpr double thickness = 0.17; // the half of it; the centres of the holes are one unit apart
  static constexpr double rim = pi / 2 * thickness;
  static constexpr double hole_radius = 0.5 - rim;

  explicit Rolled_out_plate(unsigned genus)
    : genus_(genus),
      rows_((genus + 7) / 8),
      columns_(genus == 0 ? 0 : (genus + rows_ - 1) / rows_),
      corner_radius_(genus == 0 ? rim : hole_radius + 2 * rim),
      half_core_x_(genus == 0 ? 0 : (columns_ - 1) / 2.),
      half_core_y_(genus == 0 ? 0 : (rows_ - 1) / 2.)
  {}

  double half_width() const { return half_core_x_ + corner_radius_; }
  double half_height() const { return half_core_y_ + corner_radius_; }
  double area() const
  {
    return 4 * (half_core_x_ * half_core_y_ + (half_core_x_ + half_core_y_) * corner_radius_)
         + pi * (corner_radius_ * corner_radius_ - genus_ * hole_radius * hole_radius);
  }

  Location locate(double x, double y) const
  {
    const Location outer = locate_outer_border(x, y);
    const Location hole = locate_hole(x, y);
    return hole.distance < outer.distance ? hole : outer;
  }

  // rolls the rim up again, on the upper side
  std::array<double, 3> roll_up(double x, double y) const
  {
    const Location location = locate(x, y);
    const double distance = std::max(location.distance, 0.);
    if(distance >= rim)
      return {x, y, thickness};
    const double angle = distance / thickness;
    const double shift = rim - thickness * std::cos(angle) - distance;
    return {x + shift * location.inwards_x, y + shift * location.inwards_y, thickness * std::sin(angle)};
  }

private:
  Location locate_outer_border(double x, double y) const
  {
    const double dx = x - std::clamp(x, -half_core_x_, half_core_x_);
    const double dy = y - std::clamp(y, -half_core_y_, half_core_y_);
    const double length = std::hypot(dx, dy);
    if(length > 0)
      return {corner_radius_ - length, -dx / length, -dy / length};
    const double distance = std::min(half_core_x_ - std::abs(x), half_core_y_ - std::abs(y)) + corner_radius_;
    return {distance, 0, 0};
  }

  Location locate_hole(double x, double y) const
  {
    if(genus_ == 0)
      return {2 * rim, 0, 0};
    const double column = std::clamp(std::round(x + half_core_x_), 0., columns_ - 1.);
    const double row = std::clamp(std::round(y + half_core_y_), 0., rows_ - 1.);
    const double dx = x + half_core_x_ - column;
    const double dy = y + half_core_y_ - row;
    const double length = std::hypot(dx, dy);
    if(row * columns_ + column >= genus_ || length == 0)
      return {length == 0 ? -hole_radius : 2 * rim, 1, 0};
    return {length - hole_radius, dx / length, dy / length};
  }

  unsigned genus_, rows_, columns_;
  double corner_radius_, half_core_x_, half_core_y_;
};

} // namespace generated_surfaces::internal

#endif // CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_ROLLED_OUT_PLATE_H
