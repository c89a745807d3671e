// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// The predicates that the headers call, on points that are nearly or exactly degenerate, against rational numbers. For
// machines that round in one way only: there, floating-point filters of the wrong kind say what is not so.

#include <CGAL/AABB_traits.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

#include <cmath>
#include <iostream>
#include <random>
#include <string>

namespace {
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Exact_rational Rational;
typedef CGAL::Simple_cartesian<Rational> Exact_kernel;

std::mt19937_64 engine(20130617);
double random_number() { return std::uniform_real_distribution<double>(-1, 1)(engine); }

Kernel::Point_3 random_point() { return {random_number(), random_number(), random_number()}; }

// A few units in the last place away, or not at all
double shaken(double x)
{
  for(auto steps = engine() % 3; steps > 0; --steps)
    x = std::nextafter(x, engine() % 2 == 0 ? -2 : 2);
  return x;
}

// Near the plane through three points, or their triangle, one of its edges or corners, on it as rounding has it
Kernel::Point_3 point_near(const Kernel::Point_3& p, const Kernel::Point_3& q, const Kernel::Point_3& r)
{
  const double s = engine() % 4 == 0 ? 0 : random_number(), t = engine() % 4 == 0 ? 0 : random_number();
  const Kernel::Point_3 x = p + s * (q - p) + t * (r - p);
  return {shaken(x.x()), shaken(x.y()), shaken(x.z())};
}

Kernel::Point_3 point_near_sphere()
{
  const Kernel::Point_3 x = random_point();
  const double length = std::sqrt((x - CGAL::ORIGIN).squared_length());
  return {shaken(x.x() / length), shaken(x.y() / length), shaken(x.z() / length)};
}

Exact_kernel::Point_3 exact(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }
Exact_kernel::Triangle_3 exact(const Kernel::Triangle_3& t) { return {exact(t[0]), exact(t[1]), exact(t[2])}; }
Exact_kernel::Segment_3 exact(const Kernel::Segment_3& s) { return {exact(s[0]), exact(s[1])}; }
Kernel::Point_2 seen(const Kernel::Point_3& p) { return {p.y(), p.z()}; }
Exact_kernel::Point_2 seen(const Exact_kernel::Point_3& p) { return {p.y(), p.z()}; }

int number_of_faults = 0;

// Counts where the two answers of test(), which makes its own input, are not the same.
template <class Test>
void compare(const std::string& name, const Test& test)
{
  constexpr int number = 20000;
  int wrong = 0;
  for(int i = 0; i != number; ++i)
    wrong += test() ? 0 : 1;
  std::cout << name << ": " << wrong << " of " << number << " wrong\n";
  number_of_faults += wrong;
}
} // namespace

int main()
{
  compare("orientation in space", [] {
    const Kernel::Point_3 p = random_point(), q = random_point(), r = random_point(), s = point_near(p, q, r);
    return orientation(p, q, r, s) == orientation(exact(p), exact(q), exact(r), exact(s))
        && coplanar(p, q, r, s) == coplanar(exact(p), exact(q), exact(r), exact(s));
  });
  compare("orientation in the plane", [] {
    const Kernel::Point_3 p = random_point(), q = random_point(), r = point_near(p, q, p);
    return orientation(seen(p), seen(q), seen(r)) == orientation(seen(exact(p)), seen(exact(q)), seen(exact(r)))
        && collinear(p, q, r) == collinear(exact(p), exact(q), exact(r));
  });
  compare("orientation in a plane in space", [] {
    // exactly in a plane, as its coordinates are small
    const auto small = [] { return Kernel::Point_3(double(engine() % 5), double(engine() % 5), 1); };
    const Kernel::Point_3 p = small(), q = small(), r = small(), s = small();
    return collinear(p, q, r)
        || coplanar_orientation(p, q, r, s) == coplanar_orientation(exact(p), exact(q), exact(r), exact(s));
  });
  compare("side of a sphere", [] {
    const Kernel::Point_3 p = point_near_sphere(), q = point_near_sphere(), r = point_near_sphere();
    const Kernel::Point_3 s = point_near_sphere(), t = point_near_sphere();
    return side_of_oriented_sphere(p, q, r, s, t)
        == side_of_oriented_sphere(exact(p), exact(q), exact(r), exact(s), exact(t));
  });
  compare("distances", [] {
    const Kernel::Point_3 center(0, 0, 0), p = point_near_sphere(), q = point_near_sphere();
    return compare_distance_to_point(center, p, q) == compare_distance_to_point(exact(center), exact(p), exact(q));
  });
  const auto random_triangle = [] { return Kernel::Triangle_3(random_point(), random_point(), random_point()); };
  compare("a point and a triangle", [&] {
    const Kernel::Triangle_3 s = random_triangle();
    const Kernel::Point_3 p = point_near(s[0], s[1], s[2]);
    return s.has_on(p) == exact(s).has_on(exact(p));
  });
  compare("a segment and a triangle", [&] {
    const Kernel::Triangle_3 s = random_triangle();
    const Kernel::Segment_3 t(point_near(s[0], s[1], s[2]), random_point());
    return do_intersect(s, t) == do_intersect(exact(s), exact(t));
  });
  compare("two triangles", [&] {
    const Kernel::Triangle_3 s = random_triangle();
    const Kernel::Triangle_3 t(point_near(s[0], s[1], s[2]), random_point(), random_point());
    return do_intersect(s, t) == do_intersect(exact(s), exact(t));
  });
  compare("boxes of trees", [&] {
    const Kernel::Triangle_3 s = random_triangle();
    const Kernel::Point_3 p = point_near(s[0], s[1], s[2]);
    const CGAL::Bbox_3 box(p.x(), p.y(), p.z(), p.x() + 1, p.y() + 1, p.z() + 1);
    return do_intersect(s, box) == do_intersect(exact(s), box)
        && do_intersect(Kernel::Segment_3(s[0], s[1]), box) == do_intersect(exact(Kernel::Segment_3(s[0], s[1])), box);
  });
  compare("intervals", [] {
    const CGAL::Interval_nt<>::Protector protector;
    const double a = random_number(), b = random_number(), c = shaken(-a * b), d = random_number();
    const CGAL::Interval_nt<> interval = (CGAL::Interval_nt<>(a) * b + c) / d - a;
    const Rational number = (Rational(a) * Rational(b) + Rational(c)) / Rational(d) - Rational(a);
    return Rational(interval.inf()) <= number && number <= Rational(interval.sup());
  });
  return number_of_faults == 0 ? 0 : 1;
}
