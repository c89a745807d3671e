// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_RANDOM_FIELDS_H
#define CGAL_REEB_GRAPH_TEST_RANDOM_FIELDS_H

#include "random_meshes.h"

#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace random_meshes {
enum class Field_class
{
  PERMUTATION, // white noise without ties
  FEW_VALUES,  // two to four values
  CONSTANT,
  INTEGERS,      // noise with some ties
  SMOOTH,        // averaged noise
  BORDER_LEVELS, // noise, constant on each border loop
  HUB,           // the neighbours of the vertex of highest degree are alternately below and above it
  INFINITIES,    // noise with many infinite values of both signs
  NUMBER_OF_CLASSES
};

inline std::vector<double> random_permutation(std::size_t size, Random& random)
{
  std::vector<double> values(size);
  std::iota(values.begin(), values.end(), 0.);
  random.shuffle(values);
  return values;
}

inline std::vector<double> random_integers(std::size_t size, std::size_t bound, Random& random)
{
  std::vector<double> values(size);
  for(double& value : values)
    value = static_cast<double>(random.below(bound));
  return values;
}

inline std::vector<double> smooth_field(const Combinatorial_mesh& mesh, Random& random)
{
  std::vector<double> values = random_permutation(mesh.number_of_vertices, random);
  for(std::size_t round = 1 + random.below(4); round > 0; --round)
  {
    std::vector<double> sums = values, weights(values.size(), 1);
    for(const Vertex_triple& t : mesh.triangles)
      for(int i = 0; i < 3; ++i)
      {
        sums[t[i]] += values[t[(i + 1) % 3]];
        ++weights[t[i]];
      }
    for(std::size_t v = 0; v < values.size(); ++v)
      values[v] = sums[v] / weights[v];
  }
  return values;
}

inline std::vector<double> border_level_field(const Combinatorial_mesh& mesh, Random& random)
{
  std::vector<double> values = random_permutation(mesh.number_of_vertices, random);
  const Directed_edges edges = directed_edges(mesh);
  std::map<std::size_t, std::size_t> next_on_border;
  for(const auto& edge : edges)
    if(edges.count({edge.first.second, edge.first.first}) == 0)
      next_on_border[edge.first.first] = edge.first.second;
  while(!next_on_border.empty())
  {
    const double n = static_cast<double>(mesh.number_of_vertices);
    const double levels[3] = {-1. - random.below(3), n / 2, n + random.below(3)};
    const double level = levels[random.below(3)];
    for(auto step = next_on_border.begin(); step != next_on_border.end();)
    {
      values[step->first] = level;
      const std::size_t next = step->second;
      next_on_border.erase(step);
      step = next_on_border.find(next);
    }
  }
  return values;
}

inline std::vector<double> hub_field(const Combinatorial_mesh& mesh, Random& random)
{
  std::vector<double> values = random_permutation(mesh.number_of_vertices, random);
  std::vector<std::size_t> degrees(mesh.number_of_vertices);
  for(const Vertex_triple& t : mesh.triangles)
    for(std::size_t v : t)
      ++degrees[v];
  if(mesh.triangles.empty())
    return values;
  const std::size_t hub = std::max_element(degrees.begin(), degrees.end()) - degrees.begin();
  const Directed_edges edges = directed_edges(mesh);
  std::size_t v = edges.lower_bound({hub, 0})->first.second;
  values[hub] = 0;
  for(std::size_t i = 0; i < degrees[hub]; ++i)
  {
    values[v] = (i % 2 == 0 ? 1. : -1.) * (1 + values[v]);
    const auto next = edges.find({hub, v});
    if(next == edges.end())
      break;
    v = next->second.second;
  }
  return values;
}

inline std::vector<double> random_field(const Combinatorial_mesh& mesh, Field_class field_class, Random& random)
{
  const std::size_t n = mesh.number_of_vertices;
  switch(field_class)
  {
  case Field_class::PERMUTATION: return random_permutation(n, random);
  case Field_class::FEW_VALUES: return random_integers(n, 2 + random.below(3), random);
  case Field_class::CONSTANT: return std::vector<double>(n, 3.5);
  case Field_class::INTEGERS: return random_integers(n, n, random);
  case Field_class::SMOOTH: return smooth_field(mesh, random);
  case Field_class::BORDER_LEVELS: return border_level_field(mesh, random);
  case Field_class::HUB: return hub_field(mesh, random);
  default: break;
  }
  std::vector<double> values = random_permutation(n, random);
  for(double& value : values)
    if(random.below(2) == 0)
      value = (random.below(2) == 0 ? 1 : -1) * std::numeric_limits<double>::infinity();
  return values;
}

} // namespace random_meshes

#endif // CGAL_REEB_GRAPH_TEST_RANDOM_FIELDS_H
