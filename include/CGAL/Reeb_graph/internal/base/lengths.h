// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_LENGTHS_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_LENGTHS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/interpolation.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>

// Lengths and areas of points of any size: squares of numbers beyond 1e154, or below 1e-162, are infinite or 0.
namespace CGAL::Reeb_graph::internal {

// Whether a square has lost nothing by its size.
inline bool is_square_in_range(double square) { return square > 1e-290 && square < 1e300; }

// std::hypot(), whose last bit differs between standard libraries: that decides among loops that are equally short.
inline double length_of(double x, double y, double z)
{
  const double largest = (std::max)({std::abs(x), std::abs(y), std::abs(z)});
  if(!(largest > 0) || std::isinf(largest))
    return largest;
  x /= largest;
  y /= largest;
  z /= largest;
  return largest * std::sqrt(x * x + y * y + z * z);
}

template <class Vector>
double length_of(const Vector& v)
{
  const double square = CGAL::to_double(v.squared_length());
  if(is_square_in_range(square))
    return std::sqrt(square);
  // times a power of two, so that it is rounded as in any other unit
  const double x = CGAL::to_double(v.x()), y = CGAL::to_double(v.y()), z = CGAL::to_double(v.z());
  const double largest = (std::max)({std::abs(x), std::abs(y), std::abs(z)});
  if(!(largest > 0) || std::isinf(largest))
    return largest;
  const int exponent = std::ilogb(largest);
  const double a = std::scalbn(x, -exponent), b = std::scalbn(y, -exponent), c = std::scalbn(z, -exponent);
  return std::scalbn(std::sqrt(a * a + b * b + c * c), exponent);
}

template <class Point>
double distance_between(const Point& p, const Point& q)
{
  return length_of(p - q);
}

// The area of a triangle.
template <class Point>
double area_of(const Point& p, const Point& q, const Point& r)
{
  const auto u = q - p, v = r - p;
  const double square = CGAL::to_double(cross_product(u, v).squared_length());
  if(is_square_in_range(square))
    return std::sqrt(square) / 2;
  const double u_length = length_of(u), v_length = length_of(v);
  if(!(u_length > 0 && v_length > 0))
    return 0;
  const auto unit = [](const auto& w, double length) {
    return std::array<double, 3>{CGAL::to_double(w.x()) / length, CGAL::to_double(w.y()) / length,
                                 CGAL::to_double(w.z()) / length};
  };
  const std::array<double, 3> a = unit(u, u_length), b = unit(v, v_length);
  return length_of(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]) / 2 * u_length
       * v_length;
}

// The mean of values, each of which counts by a weight. It is never beyond them, nor does a sum grow too large.
struct Weighted_mean
{
  double weight = 0, mean = 0;

  void add(double value, double its_weight)
  {
    if(!(its_weight > 0))
      return;
    weight += its_weight;
    const double share = its_weight / weight;
    mean = share < 1 ? std::clamp((1 - share) * mean + share * value, (std::min)(mean, value), (std::max)(mean, value))
                     : value;
  }

  // Where nothing has a weight, the middle between the two values.
  double mean_or_middle(double lower, double upper) const
  {
    return weight > 0 ? mean : lower == upper ? lower : value_at_fraction(lower, upper, 0.5);
  }
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_LENGTHS_H
