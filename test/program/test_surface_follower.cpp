// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "page/surface_follower.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <random>
#include <vector>

// The lines of a page do not leave the surface: of a torus, whose inside is known by a formula.

using reeb_graph_program::Point;
using reeb_graph_program::Polyline;
using reeb_graph_program::Surface;
using reeb_graph_program::Surface_follower;

namespace {
int number_of_failures = 0;

void expect(bool is_true, const char* what, unsigned seed)
{
  if(is_true)
    return;
  std::cerr << "seed " << seed << ": " << what << '\n';
  ++number_of_failures;
}

// A torus around the z-axis with the radii 2 and 1, without so many of its first faces.
Surface torus(bool is_inside_out, std::size_t left_out)
{
  constexpr std::size_t around = 60, along = 120;
  Surface surface;
  const double turn = 2 * std::acos(-1.);
  for(std::size_t i = 0; i < along; ++i)
    for(std::size_t j = 0; j < around; ++j)
    {
      const double a = turn * static_cast<double>(i) / along, b = turn * static_cast<double>(j) / around;
      const double radius = 2 + std::cos(b);
      surface.add_vertex(Point(radius * std::cos(a), radius * std::sin(a), std::sin(b)));
    }
  const auto vertex = [&](std::size_t i, std::size_t j) {
    return Surface::Vertex_index(static_cast<Surface::size_type>(i % along * around + j % around));
  };
  for(std::size_t i = 0; i < along; ++i)
    for(std::size_t j = 0; j < around; ++j)
    {
      if(i * around + j < left_out)
        continue;
      const auto p = vertex(i, j), q = vertex(i + 1, j), r = vertex(i + 1, j + 1), s = vertex(i, j + 1);
      if(is_inside_out)
      {
        surface.add_face(p, r, q);
        surface.add_face(p, s, r);
      }
      else
      {
        surface.add_face(p, q, r);
        surface.add_face(p, r, s);
      }
    }
  return surface;
}

// Two cones with the tip at the origin and above it, between which a ring goes up and down.
Surface hub(std::size_t size)
{
  Surface surface;
  const auto low = surface.add_vertex(Point(0, 0, 0)), high = surface.add_vertex(Point(0, 0, 0.5));
  std::vector<Surface::Vertex_index> ring;
  for(std::size_t i = 0; i < size; ++i)
  {
    const double part = static_cast<double>(i) / static_cast<double>(size), angle = 2 * std::acos(-1.) * part;
    ring.push_back(
      surface.add_vertex(Point(std::cos(angle), std::sin(angle), (i % 2 == 0 ? 1 : -1) * (1 + part / 10))));
  }
  for(std::size_t i = 0; i < size; ++i)
  {
    surface.add_face(high, ring[i], ring[(i + 1) % size]);
    surface.add_face(low, ring[(i + 1) % size], ring[i]);
  }
  return surface;
}

double depth(const Point& p) { return 1 - std::hypot(std::hypot(p.x(), p.y()) - 2, p.z()); }

double least_depth(const Polyline& line)
{
  double least = 1;
  for(std::size_t i = 1; i < line.size(); ++i)
    for(const double t : {0., 0.2, 0.4, 0.6, 0.8, 1.})
      least = (std::min)(least, depth(line[i - 1] + t * (line[i] - line[i - 1])));
  return least;
}

} // namespace

int main()
{
  constexpr double tolerance = 0.01; // of a chord between places on the inside of the ring
  for(unsigned seed = 0; seed < 60; ++seed)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-3, 3);
    const auto random_point = [&] {
      const double x = coordinate(random), y = coordinate(random); // in this order
      return Point(x, y, coordinate(random) / 3);
    };
    const Surface surface = torus(seed % 2 == 1, 0);
    const Surface_follower follow(surface);
    const Polyline line = {random_point(), random_point(), random_point()};
    const Polyline followed = follow(line);
    expect(followed.front() == follow(line.front()) && followed.back() == follow(line.back()), "other ends", seed);
    expect(least_depth(followed) > -tolerance, "the line leaves the surface", seed);
    for(const Point& point : line)
      expect(depth(point) < 0 || follow(point) == point, "a point inside is moved", seed);
  }
  // a line inside, and one through a hole of the surface
  const Surface surface = torus(false, 600);
  const Surface_follower follow(surface);
  const Polyline inside = {Point(-2, 0.3, 0), Point(-2, -0.3, 0.5)}, outwards = {Point(2, 0.5, 0), Point(4, 1, 0)};
  expect(follow(inside) == inside, "a line inside is moved", 0);
  expect(follow(outwards) == outwards, "a line through a hole is moved", 0);
  expect(follow(Polyline()).empty(), "no points give some", 0);
  const Surface fan = hub(40000);
  const Polyline through = {Point(0, 0, 0.25), Point(0, 0, 3)};
  expect(Surface_follower(fan)(through).front() == through.front(), "a point between two tips is moved", 0);
  const Surface nothing;
  expect(Surface_follower(nothing)(outwards) == outwards, "a line is moved though there is no surface", 0);
  return number_of_failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
