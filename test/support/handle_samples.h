// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_HANDLE_SAMPLES_H
#define CGAL_REEB_GRAPH_TEST_HANDLE_SAMPLES_H

#include "generated_surfaces.h"
#include "generated_surfaces/implicit_surface.h"
#include "mesh_builders.h"
#include "random_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// Surfaces in space whose handles and tunnels are known.
namespace handle_samples {
using generated_surfaces::Triangle_soup;
typedef std::array<double, 3> Vector;

struct Sample
{
  std::string name;
  Triangle_soup soup;
  std::vector<std::size_t> genera; // of the components
};

inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector sum(const Vector& a, double t, const Vector& b)
{
  return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}
inline Vector cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vector unit(const Vector& a) { return sum({0, 0, 0}, 1 / std::sqrt(dot(a, a)), a); }

// A tube around a closed curve whose curvature is nowhere 0.
template <class Curve>
Triangle_soup tube(const Curve& curve, std::size_t along, std::size_t around, double radius)
{
  const double pi = generated_surfaces::internal::pi;
  return generated_surfaces::internal::grid(around, along, true, true, [&](std::size_t column, std::size_t row) {
    const double t = 2 * pi * row / along, u = 2 * pi * column / around, step = 1e-3;
    const Vector tangent = unit(sum(curve(t + step), -1, curve(t - step)));
    Vector normal = sum(sum(curve(t + step), 1, curve(t - step)), -2, curve(t));
    normal = unit(sum(normal, -dot(normal, tangent), tangent));
    return sum(sum(curve(t), radius * std::cos(u), normal), radius * std::sin(u), cross(tangent, normal));
  });
}

inline Vector trefoil(double t)
{
  return {std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t)};
}

inline Triangle_soup knotted_torus() { return tube(trefoil, 160, 12, 0.35); }

inline Triangle_soup turned_over(Triangle_soup soup)
{
  for(auto& t : soup.triangles)
    std::swap(t[0], t[1]);
  return soup;
}

inline Triangle_soup scaled_and_moved(Triangle_soup soup, double factor, const Vector& offset)
{
  for(auto& p : soup.points)
    p = sum(offset, factor, p);
  return soup;
}

inline Triangle_soup together(Triangle_soup a, const Triangle_soup& b)
{
  const std::size_t size = a.points.size();
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for(const auto& t : b.triangles)
    a.triangles.push_back({t[0] + size, t[1] + size, t[2] + size});
  return a;
}

// Two rings, one of which passes through the other.
inline Triangle_soup linked_tori()
{
  const auto upright = [](double t) { return Vector{1 + std::cos(t), 0, std::sin(t)}; };
  const auto flat = [](double t) { return Vector{std::cos(t), std::sin(t), 0}; };
  return together(tube(flat, 30, 8, 0.2), tube(upright, 30, 8, 0.2));
}

// One torus inside of the tube of another one, with the normals of the inner one pointing to its inside.
inline Triangle_soup nested_tori()
{
  const auto circle = [](double t) { return Vector{std::cos(t), std::sin(t), 0}; };
  return together(tube(circle, 30, 8, 0.4), turned_over(tube(circle, 24, 6, 0.15)));
}

// What lies near to a gyroid in a ball, of a genus that grows with the ball.
inline Triangle_soup gyroid(double radius, double cell_size)
{
  const auto function = [&](const Vector& p) {
    const double value =
      std::sin(p[0]) * std::cos(p[1]) + std::sin(p[1]) * std::cos(p[2]) + std::sin(p[2]) * std::cos(p[0]);
    return std::max(value - 0.2, 0.3 * (std::sqrt(dot(p, p)) - radius));
  };
  const double side = radius + 2 * cell_size;
  return generated_surfaces::internal::Marching_tetrahedra(function, {-side, -side, -side}, {side, side, side},
                                                           cell_size)
    .take_surface();
}

// A block less balls at random places, whose radii are at least 2.
inline Triangle_soup sponge(std::size_t number_of_balls, double side, std::size_t seed, double greatest_radius = 4)
{
  random_meshes::Random random(seed);
  std::vector<std::array<double, 4>> balls(number_of_balls); // centers and radii
  for(auto& ball : balls)
  {
    for(std::size_t i = 0; i != 3; ++i)
      ball[i] = side * static_cast<double>(random.below(1000)) / 1000;
    ball[3] = 2 + (greatest_radius - 2) * static_cast<double>(random.below(1000)) / 1000;
  }
  const auto function = [&](const Vector& p) {
    double value = -side;
    for(const double x : p)
      value = std::max({value, x - side, -x});
    for(const auto& [x, y, z, radius] : balls)
      value = std::max(value, radius - std::sqrt(dot(sum(p, -1, {x, y, z}), sum(p, -1, {x, y, z}))));
    return value;
  };
  return generated_surfaces::internal::Marching_tetrahedra(function, {-1.6, -1.6, -1.6}, {side + 2, side + 2, side + 2},
                                                           1)
    .take_surface();
}

inline std::vector<Sample> closed_samples()
{
  return {{"torus", generated_surfaces::torus(12, 24), {1}},
          {"torus turned over", turned_over(generated_surfaces::torus(9, 14)), {1}},
          {"knotted torus", knotted_torus(), {1}},
          {"knotted torus turned over", turned_over(knotted_torus()), {1}},
          {"linked tori", linked_tori(), {1, 1}},
          {"nested tori", nested_tori(), {1, 1}},
          {"genus 2", generated_surfaces::closed_surface(2, 500), {2}},
          {"genus 7", generated_surfaces::closed_surface(7, 2000), {7}}};
}

} // namespace handle_samples

#endif // CGAL_REEB_GRAPH_TEST_HANDLE_SAMPLES_H
