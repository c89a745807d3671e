// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/nearest_place.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>

// The nearest place does not depend on the unit: all times a power of two, it is the same one.
using namespace reeb_graph_program;

namespace {
template <class Points>
Points scaled(Points points, int exponent)
{
  for(Point& p : points)
    p = Point(std::scalbn(p.x(), exponent), std::scalbn(p.y(), exponent), std::scalbn(p.z(), exponent));
  return points;
}

template <class Add>
bool is_same_in_all_units(const Point& point, const std::array<Point, 4>& corners, const Add& add)
{
  Nearest_place expected(point);
  add(expected, corners);
  for(const int exponent : {-900, -560, -300, 300, 560, 900})
  {
    Nearest_place place(scaled(std::array<Point, 1>{point}, exponent)[0]);
    add(place, scaled(corners, exponent));
    const Point there = scaled(std::array<Point, 1>{expected.place()}, exponent)[0];
    if(!place.is_found() || place.place() != there || place.value() != expected.value())
      return false;
  }
  return true;
}
} // namespace

int main()
{
  std::mt19937 random(7);
  const auto random_point = [&] {
    const auto coordinate = [&] { return static_cast<double>(random() % 2001) / 1000 - 1; };
    const double x = coordinate(), y = coordinate();
    return Point(x, y, coordinate());
  };
  for(int i = 0; i != 5000; ++i)
  {
    std::array<Point, 4> corners = {random_point(), random_point(), random_point(), random_point()};
    if(i % 5 == 0)
      corners[2] = corners[1]; // an edge
    if(i % 11 == 0)
      corners[1] = corners[0];
    const Point point = random_point();
    const bool is_right = is_same_in_all_units(point, corners,
                                               [](Nearest_place& place, const auto& c) {
                                                 place.add_triangle({c[0], c[1], c[2]}, {1, 2, 3});
                                               })
                       && is_same_in_all_units(point, corners, [](Nearest_place& place, const auto& c) {
                            place.add_tetrahedron(c, {1, 2, 3, 4});
                          });
    if(!is_right)
    {
      std::cerr << "case " << i << " has another nearest place in another unit\n";
      return EXIT_FAILURE;
    }
  }
}
