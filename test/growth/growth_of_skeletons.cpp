// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "Table.h"
#include "generated_surfaces/implicit_surface.h"
#include "random_meshes.h"
#include "surfaces.h"

#include <CGAL/Reeb_graph/skeleton/extract_curve_skeleton.h>

#include <algorithm>
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

// A number from -1 to 1.
double noise(random_meshes::Random& random) { return static_cast<double>(random.below(2001)) / 1000 - 1; }

Input with_height(const std::string& name, const Triangle_soup& soup) { return {name, soup, tilted_height(soup)}; }

// A torus whose points are moved by up to twice a share of the radius of the tube towards its middle, or beyond.
Input noisy_torus(std::size_t number_of_vertices, double amplitude)
{
  const auto around = static_cast<std::size_t>(std::sqrt(static_cast<double>(number_of_vertices) / 2.5));
  Triangle_soup soup = generated_surfaces::torus(around, around * 5 / 2);
  random_meshes::Random random(around);
  for(auto& p : soup.points)
  {
    const double rho = std::hypot(p[0], p[1]), share = amplitude * (noise(random) - 1);
    const double factor = (rho + share * (rho - 1)) / rho; // away from the middle of the tube
    p = {factor * p[0], factor * p[1], (1 + share) * p[2]};
  }
  return with_height("torus, noise", soup);
}

Input noisy_sphere(std::size_t number_of_vertices)
{
  Triangle_soup soup = generated_surfaces::closed_surface(0, number_of_vertices);
  random_meshes::Random random(number_of_vertices);
  for(auto& p : soup.points)
  {
    const double factor = 1 + 0.5 * noise(random);
    p = {factor * p[0], factor * p[1], factor * p[2]};
  }
  return with_height("sphere of spikes", soup);
}

// A square grid with noise of ten edges.
Input noisy_terrain(std::size_t number_of_vertices)
{
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(number_of_vertices)));
  random_meshes::Random random(side);
  return with_height("terrain of noise",
                     generated_surfaces::internal::grid(side, side, false, false, [&](std::size_t i, std::size_t j) {
                       return std::array<double, 3>{static_cast<double>(i), static_cast<double>(j), 5 * noise(random)};
                     }));
}

// What waves in random directions are above 0 in a box, as a sponge: its genus grows with the number of vertices.
Input noisy_solid(std::size_t number_of_vertices)
{
  const double side = std::cbrt(static_cast<double>(number_of_vertices) / 3);
  random_meshes::Random random(1);
  std::vector<std::array<double, 4>> waves(40);
  for(auto& wave : waves)
    for(double& number : wave)
      number = 1.5 * noise(random);
  const auto function = [&](const std::array<double, 3>& p) {
    double value = 0;
    for(const auto& wave : waves)
      value -= std::sin(wave[0] * p[0] + wave[1] * p[1] + wave[2] * p[2] + 4 * wave[3]);
    for(const double x : p)
      value = std::max({value, 4 * (x - side), -4 * x});
    return value;
  };
  const double low = -1.03, high = side + 2;
  return with_height(
    "solid of noise",
    generated_surfaces::internal::Marching_tetrahedra(function, {low, low, low}, {high, high, high}, 1).take_surface());
}
} // namespace

void measure_skeletons(Table& table)
{
  Function<Subject> of_distances = functions()[0];
  of_distances.largest_exponent = 1.5; // Contours of all branches would take 2.7.
  table.measure("torus, 15 % noise",
                at_three_sizes<Subject>(9000, [](std::size_t size) { return noisy_torus(size, 0.15); }), of_distances);
  of_distances.largest_exponent = 1.4; // 2.6 a doubling
  table.measure("torus, 100 % noise",
                at_three_sizes<Subject>(1000, [](std::size_t size) { return noisy_torus(size, 1); }), of_distances);
  table.measure("sphere of spikes", at_three_sizes<Subject>(1000, noisy_sphere), of_distances);
  table.measure("terrain of noise", at_three_sizes<Subject>(500, noisy_terrain), of_distances);
  table.measure("solid of noise", at_three_sizes<Subject>(2000, noisy_solid), of_distances);
  const std::size_t n = 3000, number_of_inputs = all_inputs(100).size();
  for(std::size_t i = 0; i < number_of_inputs; ++i)
  {
    const std::string name = all_inputs(100)[i].name;
    if(name.find("noise") != std::string::npos)
      continue; // Its contours are as long as the surface is large.
    const auto subjects = at_three_sizes<Subject>(n, [i](std::size_t size) { return all_inputs(size)[i]; });
    for(const Function<Subject>& function : functions())
      table.measure(name, subjects, function);
  }
}
} // namespace growth
