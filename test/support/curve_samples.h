// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_CURVE_SAMPLES_H
#define CGAL_REEB_GRAPH_TEST_CURVE_SAMPLES_H

#include "level_border_fields.h"
#include "mesh_builders.h"
#include "random_fields.h"
#include "random_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

// Surfaces with fields for curves, each made from a seed.
namespace curve_samples {
using generated_surfaces::Triangle_soup;
using mesh_builders::make_mesh;
using random_meshes::Combinatorial_mesh;
using random_meshes::Field_class;
using random_meshes::Random;

struct Sample
{
  Triangle_soup soup;
  std::vector<double> values;
};

// Curves are found by numbers, and only cut in another way into another mesh: there, fewer samples do.
template <class Mesh>
constexpr std::size_t number_of_samples(std::size_t number)
{
  return std::is_same_v<Mesh, mesh_builders::Surface_mesh> ? number : number / 4;
}

inline Field_class field_class(std::size_t seed)
{
  return static_cast<Field_class>(seed % static_cast<std::size_t>(Field_class::NUMBER_OF_CLASSES));
}

// a small surface of several components, genus up to 3 each, with multi-saddles, and with points in general position
inline Sample random_sample(std::size_t seed, bool has_borders, std::size_t number_of_components, unsigned least_genus)
{
  Random random(seed);
  Combinatorial_mesh mesh;
  for(; number_of_components > 0; --number_of_components)
  {
    const unsigned genus = least_genus + static_cast<unsigned>(random.below(3));
    Combinatorial_mesh component = random_meshes::random_closed_surface(genus, 5 + random.below(30), random);
    if(random.below(3) == 0)
      component = random_meshes::connected_sum(component, random_meshes::bipyramid(8 + random.below(20)), random);
    mesh = random_meshes::disjoint_union(mesh, component);
  }
  const std::size_t number_of_holes = has_borders ? 1 + random.below(5) : 0;
  if(seed % 4 == 3)
    random_meshes::remove_far_stars(mesh, number_of_holes, random);
  else
    random_meshes::remove_far_triangles(mesh, number_of_holes, random);
  random_meshes::relabel(mesh, random);
  Sample sample;
  sample.values = random_meshes::random_field(mesh, field_class(seed), random);
  if(has_borders)
    random_meshes::make_borders_extremal(mesh, sample.values, random);
  sample.soup.triangles = mesh.triangles;
  for(std::size_t v = 0; v < mesh.number_of_vertices; ++v)
    sample.soup.points.push_back({static_cast<double>(random.below(1000)), static_cast<double>(random.below(1000)),
                                  static_cast<double>(random.below(1000))});
  return sample;
}

// whether each border loop has one value, and not lower neighbors as well as higher ones
inline bool are_borders_extremal(const Sample& sample)
{
  const Combinatorial_mesh mesh = {sample.values.size(), sample.soup.triangles};
  for(const auto& loop : random_meshes::border_loops(mesh))
  {
    const double value = sample.values[loop.front()];
    bool has_lower = false, has_higher = false;
    for(const auto& t : mesh.triangles)
    {
      const bool is_at_border =
        std::any_of(t.begin(), t.end(), [&](std::size_t v) { return std::count(loop.begin(), loop.end(), v) != 0; });
      for(const std::size_t v : t)
      {
        has_lower = has_lower || (is_at_border && sample.values[v] < value);
        has_higher = has_higher || (is_at_border && sample.values[v] > value);
      }
    }
    for(const std::size_t v : loop)
      if(sample.values[v] != value)
        return false;
    if(has_lower && has_higher)
      return false;
  }
  return true;
}

// a smooth surface of about that many vertices, with a field of one of four kinds
inline Sample smooth_sample(unsigned genus, std::size_t number_of_vertices, std::size_t kind)
{
  Sample sample;
  sample.soup = generated_surfaces::closed_surface(genus, number_of_vertices);
  Random random(genus + 100 * kind);
  for(const auto& p : sample.soup.points)
    sample.values.push_back(kind == 0   ? 0.9 * p[0] + 0.4 * p[1] + 0.15 * p[2]
                            : kind == 1 ? static_cast<double>(random.below(1000000))
                            : kind == 2 ? static_cast<double>(random.below(3))
                                        : 1.);
  return sample;
}

// a mesh of any class, with points in general position
inline Sample any_sample(std::size_t seed)
{
  Random random(seed);
  const auto mesh =
    random_meshes::random_mesh(static_cast<random_meshes::Mesh_class>(
                                 seed % static_cast<std::size_t>(random_meshes::Mesh_class::NUMBER_OF_CLASSES)),
                               random);
  Sample sample;
  sample.soup.triangles = mesh.triangles;
  for(std::size_t v = 0; v < mesh.number_of_vertices; ++v)
    sample.soup.points.push_back({static_cast<double>(random.below(1000)), static_cast<double>(random.below(1000)),
                                  static_cast<double>(random.below(1000))});
  sample.values = random_meshes::random_field(mesh, field_class(seed / 6), random);
  return sample;
}

// a sphere with four long arms in the directions of a tetrahedron, and the distance to the centre as its field
inline Sample four_armed_sphere()
{
  const double arms[4][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  Sample sample;
  sample.soup = generated_surfaces::closed_surface(0, 4000);
  for(auto& p : sample.soup.points)
  {
    const double length = std::hypot(p[0], p[1], p[2]);
    double factor = 1;
    for(const auto& arm : arms)
    {
      const double cosine = (p[0] * arm[0] + p[1] * arm[1] + p[2] * arm[2]) / length / std::sqrt(3.);
      factor += 3 * std::pow((std::max)(cosine, 0.), 12);
    }
    for(double& coordinate : p)
      coordinate *= factor / length;
    sample.values.push_back(factor);
  }
  return sample;
}

} // namespace curve_samples

#endif // CGAL_REEB_GRAPH_TEST_CURVE_SAMPLES_H
