// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_CENTROID_H
#define CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_CENTROID_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

typedef std::array<double, 3> Coordinates;

template <class Point>
Coordinates coordinates_of(const Point& point)
{
  return {CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z())};
}

template <class Point>
Point make_point(const Coordinates& coordinates)
{
  typedef std::decay_t<decltype(std::declval<const Point&>().x())> Number;
  return Point(Number(coordinates[0]), Number(coordinates[1]), Number(coordinates[2]));
}

inline Coordinates mix(double t, const Coordinates& a, const Coordinates& b)
{
  return {(1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1], (1 - t) * a[2] + t * b[2]};
}

inline double distance(const Coordinates& a, const Coordinates& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

inline double area(const Coordinates& a, const Coordinates& b, const Coordinates& c)
{
  const Coordinates u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}

// The centroid of curves, or of triangles: the mean of their points, each piece with the weight of its length or area,
// so that it does not count into how many pieces they are split. Where all weights are 0, it is that of the first
// point.
class Centroid
{
public:
  template <class Point>
  void add_curve(const std::vector<Point>& points, bool is_closed)
  {
    for(std::size_t i = 0; i + 1 < points.size(); ++i)
      add_segment(coordinates_of(points[i]), coordinates_of(points[i + 1]));
    if(is_closed && !points.empty())
      add_segment(coordinates_of(points.back()), coordinates_of(points.front()));
    if(points.size() == 1)
      add_segment(coordinates_of(points[0]), coordinates_of(points[0]));
  }

  void add_triangle(const Coordinates& a, const Coordinates& b, const Coordinates& c)
  {
    add_piece(a, {(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3, (a[2] + b[2] + c[2]) / 3}, area(a, b, c));
  }

  bool is_of_length_zero() const { return !(length_ > 0); }

  Coordinates operator()() const
  {
    return is_of_length_zero() ? first_ : mix(1, {}, {sum_[0] / length_, sum_[1] / length_, sum_[2] / length_});
  }

private:
  void add_segment(const Coordinates& a, const Coordinates& b) { add_piece(a, mix(0.5, a, b), distance(a, b)); }

  void add_piece(const Coordinates& first, const Coordinates& middle, double weight)
  {
    if(!has_first_)
      first_ = first;
    has_first_ = true;
    length_ += weight;
    for(std::size_t i = 0; i != 3; ++i)
      sum_[i] += weight * middle[i];
  }

  bool has_first_ = false;
  double length_ = 0;
  Coordinates first_ = {}, sum_ = {};
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_CENTROID_H
