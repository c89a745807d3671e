// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "Table.h"
#include "random_meshes.h"
#include "surfaces.h"

#include <CGAL/Reeb_graph/skeleton/extract_curve_skeleton.h>

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
} // namespace

void measure_skeletons(Table& table)
{
  Function<Subject> of_distances = functions()[0];
  of_distances.largest_exponent = 1.5; // Contours of all branches would take 2.7.
  table.measure("torus, 15 % noise", at_three_sizes<Subject>(9000, noisy_torus), of_distances);
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
