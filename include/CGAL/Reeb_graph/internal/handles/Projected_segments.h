// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_HANDLES_PROJECTED_SEGMENTS_H
#define CGAL_REEB_GRAPH_INTERNAL_HANDLES_PROJECTED_SEGMENTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/handles/Closed_surface.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A direction of view in which something is not in general position.
struct Degenerate_direction
{
};

// A point as the mean of one, two or three points of the surface: a vertex, the middle of an edge, or of a triangle.
struct Mean_point
{
  std::array<const Closed_surface::Point*, 3> points;
  int size;
};

// Exact predicates on segments as they are seen in a direction. They are evaluated with intervals, and with rational
// numbers where these do not decide. What is not in general position throws Degenerate_direction.
class Projected_segments
{
  template <class FT>
  using Vector = std::array<FT, 3>;

public:
  typedef std::array<Mean_point, 2> Segment;

  explicit Projected_segments(const std::array<double, 3>& direction) : direction_(direction) {}

  // The sign of the crossing of `a` over `b`: 0 if they do not cross, or if `a` is below.
  int crossing_over(const Segment& a, const Segment& b) const
  {
    return decide([&](auto zero) { return crossing_over<decltype(zero)>(a, b); });
  }

  // The sign of det(a[1] - a[0], b - a[0], c - a[0]) for vertices.
  int turn(const Segment& a, const Mean_point& b, const Mean_point& c) const
  {
    return decide([&](auto zero) {
      typedef decltype(zero) FT;
      const Vector<FT> origin = point<FT>(a[0]);
      return sign_of(determinant(difference(point<FT>(a[1]), origin), difference(point<FT>(b), origin),
                                 difference(point<FT>(c), origin)));
    });
  }

  // The sign of det(a[1] - a[0], direction, b - a[0]).
  int turn_from_direction(const Segment& a, const Mean_point& b) const
  {
    return decide([&](auto zero) {
      typedef decltype(zero) FT;
      const Vector<FT> origin = point<FT>(a[0]);
      const int sign =
        sign_of(determinant(difference(point<FT>(a[1]), origin), direction<FT>(), difference(point<FT>(b), origin)));
      return sign == 0 ? throw Degenerate_direction() : sign;
    });
  }

private:
  struct Undecided
  {
  };

  template <class Predicate>
  static int decide(const Predicate& predicate)
  {
    try
    {
      return predicate(Interval_nt<>(0));
    }
    catch(const Undecided&)
    {
      return predicate(Exact_rational(0));
    }
  }

  static int sign_of(const Interval_nt<>& a) { return a.inf() > 0 ? 1 : a.sup() < 0 ? -1 : throw Undecided(); }
  static int sign_of(const Exact_rational& a) { return static_cast<int>(CGAL::sign(a)); }

  template <class FT>
  static Vector<FT> point(const Mean_point& mean)
  {
    Vector<FT> sum = {FT((*mean.points[0])[0]), FT((*mean.points[0])[1]), FT((*mean.points[0])[2])};
    for(int i = 1; i < mean.size; ++i)
      for(std::size_t k = 0; k != 3; ++k)
        sum[k] += FT((*mean.points[i])[k]);
    if(mean.size != 1)
      for(FT& coordinate : sum)
        coordinate /= FT(mean.size);
    return sum;
  }

  template <class FT>
  Vector<FT> direction() const
  {
    return {FT(direction_[0]), FT(direction_[1]), FT(direction_[2])};
  }

  template <class FT>
  static Vector<FT> difference(const Vector<FT>& a, const Vector<FT>& b)
  {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }

  template <class FT>
  static Vector<FT> cross(const Vector<FT>& a, const Vector<FT>& b)
  {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  template <class FT>
  static FT dot(const Vector<FT>& a, const Vector<FT>& b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  template <class FT>
  static FT determinant(const Vector<FT>& a, const Vector<FT>& b, const Vector<FT>& c)
  {
    return dot(cross(a, b), c);
  }

  static int checked(int sign) { return sign == 0 ? throw Degenerate_direction() : sign; }

  template <class FT>
  int crossing_over(const Segment& a, const Segment& b) const
  {
    const Vector<FT> a0 = point<FT>(a[0]), a1 = point<FT>(a[1]), b0 = point<FT>(b[0]), b1 = point<FT>(b[1]);
    const Vector<FT> d = direction<FT>(), along_a = difference(a1, a0), along_b = difference(b1, b0);
    const Vector<FT> across_a = cross(d, along_a), across_b = cross(d, along_b);
    const Vector<FT> between = difference(b0, a0);
    if(checked(sign_of(dot(across_a, between))) == checked(sign_of(dot(across_a, difference(b1, a0)))))
      return 0;
    if(checked(sign_of(dot(across_b, between))) == checked(sign_of(dot(across_b, difference(b0, a1)))))
      return 0;
    // If they cross, the direction that is common to the normals of both tells which one is above.
    const Vector<FT> normal = cross(along_a, along_b);
    const int sign = checked(sign_of(dot(normal, d)));
    return sign_of(dot(between, normal)) * sign < 0 ? sign : 0;
  }

  std::array<double, 3> direction_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_HANDLES_PROJECTED_SEGMENTS_H
