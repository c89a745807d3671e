// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_NEAREST_PLACE_H
#define CGAL_REEB_GRAPH_SRC_NEAREST_PLACE_H

#include "base/surface.h"

#include <CGAL/Kernel_traits.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

// The place on a mesh that is nearest to a point. All cells are looked at, once: a tree of them would take longer.
namespace reeb_graph_program {
typedef CGAL::Kernel_traits<Point>::Kernel::Vector_3 Vector;

// Vectors divided by a power of two, so that none of their products is too large or too small.
template <std::size_t size>
struct Scaled_vectors
{
  explicit Scaled_vectors(const std::array<Vector, size>& given) : vectors(given)
  {
    double largest = 0;
    for(const Vector& v : given)
      largest = (std::max)({largest, std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
    if(!(largest > 0) || std::isinf(largest))
      return;
    exponent = std::ilogb(largest);
    for(Vector& v : vectors)
      v = Vector(std::scalbn(v.x(), -exponent), std::scalbn(v.y(), -exponent), std::scalbn(v.z(), -exponent));
  }

  std::array<Vector, size> vectors;
  int exponent = 0;
};

// The weights of three points, which can coincide, for the point of their triangle that is nearest to `point`.
inline std::array<double, 3> weights_of_nearest(const Point& point, const std::array<Point, 3>& triangle)
{
  const Scaled_vectors<3> edges({triangle[1] - triangle[0], triangle[2] - triangle[1], triangle[0] - triangle[2]});
  const Scaled_vectors<3> ways({triangle[0] - point, triangle[1] - point, triangle[2] - point});
  const int exponent = ways.exponent - edges.exponent;
  const Vector normal = CGAL::cross_product(edges.vectors[0], -edges.vectors[2]);
  std::array<double, 3> weights = {0, 0, 0};
  if(normal.squared_length() > 0)
  {
    for(std::size_t i = 0; i < 3; ++i)
      weights[i] = std::scalbn(normal * CGAL::cross_product(ways.vectors[(i + 1) % 3], ways.vectors[(i + 2) % 3])
                                 / normal.squared_length(),
                               2 * exponent);
    if(*std::min_element(weights.begin(), weights.end()) >= 0)
      return weights;
  }
  double least = std::numeric_limits<double>::infinity();
  for(std::size_t i = 0; i < 3; ++i) // the nearest point is on a side
  {
    const Point &a = triangle[i], &b = triangle[(i + 1) % 3];
    const double squared_length = edges.vectors[i].squared_length();
    const double part = squared_length > 0 ? -ways.vectors[i] * edges.vectors[i] / squared_length : 0;
    const double t = std::clamp(std::scalbn(part, exponent), 0., 1.);
    const double distance = CGAL::Reeb_graph::internal::distance_between(a + t * (b - a), point);
    if(!(distance < least))
      continue;
    least = distance;
    weights = {0, 0, 0};
    weights[i] = 1 - t;
    weights[(i + 1) % 3] = t;
  }
  return weights;
}

inline Point nearest_point(const Point& point, const std::array<Point, 3>& triangle)
{
  const auto [a, b, c] = weights_of_nearest(point, triangle);
  return Point(0, 0, 0) + a * (triangle[0] - CGAL::ORIGIN) + b * (triangle[1] - CGAL::ORIGIN)
       + c * (triangle[2] - CGAL::ORIGIN);
}

class Nearest_place
{
public:
  explicit Nearest_place(const Point& point) : point_(point) {}

  bool is_found() const { return distance_ < std::numeric_limits<double>::infinity(); }
  const Point& place() const { return place_; }
  double value() const { return value_; }

  // Whether the level just above the value goes through the cell of the place.
  bool is_level_in_cell() const { return value_ < highest_; }

  // Takes a triangle into account: its points, and the values there. Two equal points make an edge of it.
  void add_triangle(const std::array<Point, 3>& points, const std::array<double, 3>& values)
  {
    const std::array<double, 3> weights = weights_of_nearest(point_, points);
    const Point place = nearest_point(point_, points);
    const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
    double value = 0;
    for(std::size_t i = 0; i < 3; ++i)
      if(weights[i] != 0)
        value += weights[i] * values[i];
    add(place, std::clamp(value, *lowest, *highest), *highest);
  }

  // The same for a tetrahedron.
  void add_tetrahedron(const std::array<Point, 4>& points, const std::array<double, 4>& values)
  {
    const auto volume = [](const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
      return (b - a) * CGAL::cross_product(c - a, d - a);
    };
    const Scaled_vectors<5> scaled({points[0] - CGAL::ORIGIN, points[1] - CGAL::ORIGIN, points[2] - CGAL::ORIGIN,
                                    points[3] - CGAL::ORIGIN, point_ - CGAL::ORIGIN});
    const auto& [a, b, c, d, p] = scaled.vectors;
    const double whole = volume(a, b, c, d);
    const std::array<double, 4> parts = {volume(p, b, c, d), volume(a, p, c, d), volume(a, b, p, d),
                                         volume(a, b, c, p)};
    const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
    double value = 0;
    bool is_inside = whole != 0;
    for(std::size_t i = 0; i < 4; ++i)
    {
      is_inside = is_inside && parts[i] / whole >= 0;
      value += parts[i] == 0 ? 0 : parts[i] / whole * values[i];
    }
    if(is_inside)
      return add(point_, std::clamp(value, *lowest, *highest), *highest);
    for(std::size_t i = 0; i < 4; ++i)
      add_triangle({points[i], points[(i + 1) % 4], points[(i + 2) % 4]},
                   {values[i], values[(i + 1) % 4], values[(i + 2) % 4]});
  }

private:
  void add(const Point& place, double value, double highest_of_cell)
  {
    const double distance = CGAL::Reeb_graph::internal::distance_between(place, point_);
    // of several cells around the place, one that the level goes through
    if(distance > distance_ || (distance == distance_ && !(value < highest_of_cell)))
      return;
    if(!(distance < std::numeric_limits<double>::infinity()))
      return;
    distance_ = distance;
    place_ = place;
    value_ = value;
    highest_ = highest_of_cell;
  }

  Point point_;
  double distance_ = std::numeric_limits<double>::infinity();
  Point place_ = CGAL::ORIGIN;
  double value_ = 0, highest_ = 0;
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_NEAREST_PLACE_H
