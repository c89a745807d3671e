// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "Table.h"
#include "handle_samples.h"
#include "random_meshes.h"
#include "surfaces.h"

#include <CGAL/Reeb_graph/skeleton/extract_curve_skeleton.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

// Curve skeletons, by distances and by a given field. On noise, contours at branches are as long as the surface is large.
namespace growth {
namespace {
typedef Surface_with_field Subject;

std::vector<Function<Subject>> functions()
{
  return {{"extract_curve_skeleton",
           [](const Subject& s) {
             CGAL::Reeb_graph::Curve_skeleton<Mesh> skeleton;
             CGAL::Reeb_graph::extract_curve_skeleton(s.mesh, skeleton);
             return num_vertices(skeleton);
           }},
          {"extract_curve_skeleton, of a field", [](const Subject& s) {
             CGAL::Reeb_graph::Curve_skeleton<Mesh> skeleton;
             CGAL::Reeb_graph::extract_curve_skeleton(s.mesh, skeleton, CGAL::parameters::scalar_map(s.field));
             return num_vertices(skeleton);
           }}};
}

// A torus whose points are moved by up to 15 percent of the radius of the tube.
Input noisy_torus(std::size_t number_of_vertices)
{
  const auto around = static_cast<std::size_t>(std::sqrt(static_cast<double>(number_of_vertices) / 2.5));
  Input input = {"torus, 15 % noise", generated_surfaces::torus(around, around * 5 / 2), {}};
  random_meshes::Random random(around);
  for(auto& p : input.soup.points)
  {
    const double rho = std::hypot(p[0], p[1]), share = 0.15 * (static_cast<double>(random.below(2001)) / 1000 - 1);
    const double factor = (rho + share * (rho - 1)) / rho; // away from the middle of the tube
    p = {factor * p[0], factor * p[1], (1 + share) * p[2]};
  }
  input.values = tilted_height(input.soup);
  return input;
}

typedef std::array<double, 3> Position;

// A square grid with noise whose standard deviation is ten edges.
Input noisy_terrain(std::size_t number_of_vertices)
{
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(number_of_vertices)));
  random_meshes::Random random(side);
  Input input = {"terrain of noise", {}, {}};
  input.soup = generated_surfaces::internal::grid(side, side, false, false, [&](std::size_t i, std::size_t k) {
    return Position{static_cast<double>(i), static_cast<double>(k), static_cast<double>(random.below(34642)) / 1000};
  });
  input.values = tilted_height(input.soup);
  return input;
}

// A block less random balls, of a genus that grows with it: centers of contours make no basis of its loops.
Input sponge(std::size_t number_of_vertices)
{
  const std::size_t number_of_balls = number_of_vertices / 350;
  const double side = std::cbrt(static_cast<double>(number_of_balls) / 0.007);
  Input input = {"sponge", handle_samples::sponge(number_of_balls, side, 1), {}};
  input.values = tilted_height(input.soup);
  return input;
}

// A cylinder with few rings, and with lids that are fans of triangles around one vertex: in the middle, or on the rim.
Input cylinder_with_lids(std::size_t number_of_vertices, bool is_hub_on_rim)
{
  const std::size_t sides = number_of_vertices / 3;
  Input input = {is_hub_on_rim ? "lids around a corner" : "lids around a center", {}, {}};
  input.soup = generated_surfaces::internal::grid(sides, 3, true, false, [&](std::size_t i, std::size_t k) {
    const double turn = 2 * std::acos(-1.) * static_cast<double>(i) / static_cast<double>(sides);
    return Position{std::cos(turn), std::sin(turn), 2 * static_cast<double>(k)};
  });
  for(const std::size_t rim : {std::size_t(0), 2 * sides})
  {
    const std::size_t hub = is_hub_on_rim ? rim : input.soup.points.size();
    if(!is_hub_on_rim)
      input.soup.points.push_back({0, 0, rim == 0 ? 0. : 4.});
    for(std::size_t i = 0; i != sides; ++i)
      if(const std::size_t a = rim + i, b = rim + (i + 1) % sides; a != hub && b != hub)
        input.soup.triangles.push_back(rim == 0 ? std::array<std::size_t, 3>{hub, b, a}
                                                : std::array<std::size_t, 3>{hub, a, b});
  }
  input.values = tilted_height(input.soup);
  return input;
}

// A closed tube of squares around a curve over t from 0 to 1, which is nowhere vertical.
template <class Curve>
Input tube(const std::string& name, std::size_t number_of_vertices, double radius, const Curve& curve)
{
  const std::size_t number = number_of_vertices / 4, last = 4 * (number - 1);
  Input input = {name, {}, {}};
  input.soup = generated_surfaces::internal::grid(4, number, true, false, [&](std::size_t corner, std::size_t i) {
    const double t = static_cast<double>(i) / static_cast<double>(number - 1);
    const Position p = curve(t), before = curve(t - 1e-6), after = curve(t + 1e-6);
    const double x = after[0] - before[0], y = after[1] - before[1];
    const double side = (corner == 1 || corner == 2 ? radius : -radius) / std::hypot(x, y);
    return Position{p[0] - side * y, p[1] + side * x, p[2] + (corner < 2 ? -radius : radius)};
  });
  for(const std::size_t i : {1u, 2u})
  {
    input.soup.triangles.push_back({i + 1, i, 0});
    input.soup.triangles.push_back({last, last + i, last + i + 1});
  }
  input.values = tilted_height(input.soup);
  return input;
}

// Long tubes, of which lines have thousands of points: as of voxels along an axis, turned, bent and of varied density, and a
// spiral.
std::vector<Input> tubes(std::size_t number_of_vertices)
{
  const double length = static_cast<double>(number_of_vertices) / 4, pi = std::acos(-1.);
  return {tube("tube of voxels", number_of_vertices, 0.5,
               [&](double t) {
                 return Position{length * t, 0, 0};
               }),
          tube("tube of voxels, turned", number_of_vertices, 0.5,
               [&](double t) {
                 return Position{0.6 * length * t, 0.48 * length * t, 0.64 * length * t};
               }),
          tube("bent tube", number_of_vertices, 0.5,
               [&](double t) {
                 const double s = t + 0.9 * std::sin(8 * pi * t) / (8 * pi), turn = 5 * s;
                 return Position{0.2 * length * std::cos(turn), 0.2 * length * std::sin(turn), 0};
               }),
          tube("spiral", number_of_vertices, 0.2, [&](double t) {
            const double turn = std::sqrt(length * t + 40);
            return Position{0.5 * turn * std::cos(turn), 0.5 * turn * std::sin(turn), 0};
          })};
}
} // namespace

void measure_skeletons(Table& table)
{
  Function<Subject> of_distances = functions()[0];
  of_distances.largest_exponent = 1.32; // 2.5 for twice as many
  for(std::size_t i = 0; i != tubes(100).size(); ++i)
    table.measure(tubes(100)[i].name, at_three_sizes<Subject>(2400, [i](std::size_t size) { return tubes(size)[i]; }),
                  of_distances);
  for(const bool is_hub_on_rim : {false, true})
  {
    if(is_hub_on_rim) // There are more tips on finer rims, and balls on the axis are as far from all sides.
      of_distances.largest_exponent = near_linear;
    table.measure(
      cylinder_with_lids(100, is_hub_on_rim).name,
      at_three_sizes<Subject>(3000, [=](std::size_t size) { return cylinder_with_lids(size, is_hub_on_rim); }),
      of_distances);
  }
  of_distances.largest_exponent = 1.4; // 2.6 for twice as many
  table.measure("terrain of noise", at_three_sizes<Subject>(500, noisy_terrain), of_distances);
  of_distances.largest_exponent = 1.5; // Contours of all branches would take 2.7.
  table.measure("torus, 15 % noise", at_three_sizes<Subject>(9000, noisy_torus), of_distances);
  table.measure("sponge", at_three_sizes<Subject>(7000, sponge), functions()[0]);
  of_distances.largest_exponent = 2.2; // Points of lines at the hub are about as near to one of its faces as to all.
  table.measure("hub", at_three_sizes<Subject>(94, hub), of_distances);
  const std::size_t n = 3000, number_of_inputs = all_inputs(100).size();
  for(std::size_t i = 0; i < number_of_inputs; ++i)
  {
    const std::string name = all_inputs(100)[i].name;
    if(name.find("noise") != std::string::npos || name == "hub")
      continue; // Contours of noise are as long as the surface is large.
    const auto subjects = at_three_sizes<Subject>(n, [i](std::size_t size) { return all_inputs(size)[i]; });
    for(const Function<Subject>& function : functions())
      table.measure(name, subjects, function);
  }
}
} // namespace growth
