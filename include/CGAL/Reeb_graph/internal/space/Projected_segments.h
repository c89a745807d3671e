// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SPACE_PROJECTED_SEGMENTS_H
#define CGAL_REEB_GRAPH_INTERNAL_SPACE_PROJECTED_SEGMENTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

// Crossings of lines in space, as they are seen from afar: linking numbers are made of these.
namespace CGAL::Reeb_graph::internal {

// A direction of view in which something is not in general position.
struct Degenerate_direction
{
};

// A point as the mean of one, two or three points: a vertex, the middle of an edge, or of a triangle.
struct Mean_point
{
  std::array<const std::array<double, 3>*, 3> points;
  int size;
};

// Exact predicates on segments as they are seen in a direction. They are evaluated with intervals, and with rational
// numbers where these do not decide. What is not in general position throws Degenerate_direction.
class Projected_segments
{
  template <class FT>
  using Vector = typename Simple_cartesian<FT>::Vector_3;

public:
  typedef std::array<Mean_point, 2> Segment;

  explicit Projected_segments(const std::array<double, 3>& direction) : direction_(direction) {}

  // The sign of the crossing of `a` over `b`: 0 if they do not cross, or if `a` is below.
  int crossing_over(const Segment& a, const Segment& b) const
  {
    const auto known = crossing_by_rounded_numbers(a, b);
    return known ? *known : decide([&](auto zero) { return crossing_over<decltype(zero)>(a, b); });
  }

  // The sign of det(a[1] - a[0], b - a[0], c - a[0]) for vertices.
  int turn(const Segment& a, const Mean_point& b, const Mean_point& c) const
  {
    return decide([&](auto zero) {
      typedef decltype(zero) FT;
      const Vector<FT> origin = point<FT>(a[0]);
      return sign_of(determinant(point<FT>(a[1]) - origin, point<FT>(b) - origin, point<FT>(c) - origin));
    });
  }

  // The sign of det(a[1] - a[0], direction, b - a[0]).
  int turn_from_direction(const Segment& a, const Mean_point& b) const
  {
    return decide([&](auto zero) {
      typedef decltype(zero) FT;
      const Vector<FT> origin = point<FT>(a[0]);
      return checked(sign_of(determinant(point<FT>(a[1]) - origin, vector<FT>(direction_), point<FT>(b) - origin)));
    });
  }

  // From the origin.
  template <class FT>
  static Vector<FT> point(const Mean_point& mean)
  {
    Vector<FT> sum = vector<FT>(*mean.points[0]);
    for(int i = 1; i < mean.size; ++i)
      sum = sum + vector<FT>(*mean.points[i]);
    return mean.size == 1 ? sum : sum / FT(mean.size);
  }

  // Visits the pairs of segments whose projections may cross, by boxes of intervals, so that no error of rounding matters. Each is
  // the member `segment` of its element.
  template <class Located, class Visit>
  void for_each_pair_that_may_cross(const std::vector<Located>& over,
                                    const std::vector<Located>& under,
                                    const Visit& visit) const
  {
    auto boxes_over = boxes(over), boxes_under = boxes(under);
    box_intersection_d(boxes_over.begin(), boxes_over.end(), boxes_under.begin(), boxes_under.end(),
                       [&](const auto& a, const auto& b) { visit(*a.handle(), *b.handle()); });
  }

private:
  struct Undecided
  {
  };

  // The crossing of `a` over `b` by rounded numbers, if they tell: errors stay below a share of the size.
  std::optional<int> crossing_by_rounded_numbers(const Segment& a, const Segment& b) const
  {
    double size = 0;
    std::array<Vector<double>, 4> ends;
    std::array<std::array<double, 2>, 4> seen;
    for(std::size_t i = 0; i != seen.size(); ++i)
    {
      const Vector<double> p = ends[i] = point<double>(i < 2 ? a[i] : b[i - 2]);
      seen[i] = {p.x() - direction_[0] / direction_[2] * p.z(), p.y() - direction_[1] / direction_[2] * p.z()};
      size = (std::max)({size, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
    }
    const double least = std::numeric_limits<double>::epsilon() * size * size, error = 256 * least;
    const auto turn = [&](std::size_t i, std::size_t j, std::size_t k) {
      return (seen[j][0] - seen[i][0]) * (seen[k][1] - seen[i][1])
           - (seen[j][1] - seen[i][1]) * (seen[k][0] - seen[i][0]);
    };
    const auto are_beside = [&](double p, double q) { return (p > error && q > error) || (p < -error && q < -error); };
    const std::array<double, 4> turns = {turn(0, 1, 2), turn(0, 1, 3), turn(2, 3, 0), turn(2, 3, 1)};
    if(are_beside(turns[0], turns[1]) || are_beside(turns[2], turns[3]))
      return 0;
    const Vector<double> normal = cross_product(ends[1] - ends[0], ends[3] - ends[2]);
    const double slope = normal * vector<double>(direction_), height = (ends[2] - ends[0]) * normal;
    if(!are_beside(turns[0], -turns[1]) || !are_beside(turns[2], -turns[3]) || !(std::abs(slope) > 1024 * least)
       || !(std::abs(height) > 4096 * least * size))
      return std::nullopt;
    return (slope > 0) == (height > 0) ? 0 : slope > 0 ? 1 : -1;
  }

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
  static int checked(int sign) { return sign == 0 ? throw Degenerate_direction() : sign; }

  template <class Located>
  auto boxes(const std::vector<Located>& segments) const
  {
    typedef Interval_nt<> Interval;
    typedef Box_intersection_d::Box_with_handle_d<double, 2, const Located*> Box;
    const Interval slope_x = Interval(direction_[0]) / direction_[2], slope_y = Interval(direction_[1]) / direction_[2];
    std::vector<Box> result;
    result.reserve(segments.size());
    for(const Located& located : segments)
    {
      Box box(false, &located);
      for(const Mean_point& end : located.segment)
      {
        const auto p = point<Interval>(end);
        std::array<std::pair<double, double>, 2> seen = {(p.x() - slope_x * p.z()).pair(),
                                                         (p.y() - slope_y * p.z()).pair()};
        box.extend(seen.data());
      }
      result.push_back(box);
    }
    return result;
  }

  template <class FT>
  static Vector<FT> vector(const std::array<double, 3>& a)
  {
    return {FT(a[0]), FT(a[1]), FT(a[2])};
  }

  template <class FT>
  int crossing_over(const Segment& a, const Segment& b) const
  {
    const Vector<FT> a0 = point<FT>(a[0]), a1 = point<FT>(a[1]), b0 = point<FT>(b[0]), b1 = point<FT>(b[1]);
    const Vector<FT> d = vector<FT>(direction_), along_a = a1 - a0, along_b = b1 - b0;
    const Vector<FT> across_a = cross_product(d, along_a), across_b = cross_product(d, along_b), between = b0 - a0;
    const int sides_of_b = sign_of(across_a * between) * sign_of(across_a * (b1 - a0));
    if(sides_of_b > 0)
      return 0;
    const int sides_of_a = sign_of(across_b * between) * sign_of(across_b * (b0 - a1));
    if(sides_of_a > 0) // also if `b` begins on the line of `a`, beyond its end: this looks so from everywhere
      return 0;
    if(sides_of_b == 0 || sides_of_a == 0)
      throw Degenerate_direction();
    // If they cross, the direction that is common to the normals of both tells which one is above.
    const Vector<FT> normal = cross_product(along_a, along_b);
    const int sign = checked(sign_of(normal * d));
    return sign_of(between * normal) * sign < 0 ? sign : 0;
  }

  std::array<double, 3> direction_;
};

// Calls compute(direction) until a direction is in general position, and returns its result, or an empty one if there is none.
template <class Result, class Compute>
Result in_general_direction(const Compute& compute)
{
  std::uint64_t random = 20130617;
  for(int trial = 0; trial != 16; ++trial)
  {
    std::array<double, 3> direction;
    for(double& coordinate : direction)
    {
      random = random * 6364136223846793005u + 1442695040888963407u;
      coordinate = static_cast<double>(random >> 40) / static_cast<double>(1 << 24) - 0.5;
    }
    direction[2] += direction[2] < 0 ? -1 : 1;
    try
    {
      return compute(direction);
    }
    catch(const Degenerate_direction&)
    {}
  }
  return {};
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_SPACE_PROJECTED_SEGMENTS_H
