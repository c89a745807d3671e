// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_LEVEL_BORDER_FIELDS_H
#define CGAL_REEB_GRAPH_TEST_LEVEL_BORDER_FIELDS_H

#include "random_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace random_meshes {
// the vertices of each border loop
inline std::vector<std::vector<std::size_t>> border_loops(const Combinatorial_mesh& mesh)
{
  const Directed_edges edges = directed_edges(mesh);
  std::map<std::size_t, std::size_t> next_on_border;
  for(const auto& edge : edges)
    if(edges.count({edge.first.second, edge.first.first}) == 0)
      next_on_border[edge.first.first] = edge.first.second;
  std::vector<std::vector<std::size_t>> loops;
  while(!next_on_border.empty())
  {
    loops.emplace_back();
    for(auto step = next_on_border.begin(); step != next_on_border.end();)
    {
      loops.back().push_back(step->first);
      const std::size_t next = step->second;
      next_on_border.erase(step);
      step = next_on_border.find(next);
    }
  }
  return loops;
}

// gives each border loop one of a few values below or above all finite values, so that it is an extremum
inline void make_borders_extremal(const Combinatorial_mesh& mesh, std::vector<double>& values, Random& random)
{
  double bound = 0;
  for(const double value : values)
    if(std::isfinite(value))
      bound = (std::max)(bound, std::abs(value));
  for(double& value : values)
    if(!std::isfinite(value))
      value = value < 0 ? -bound : bound;
  for(const auto& loop : border_loops(mesh))
  {
    const bool is_minimum = random.below(2) == 0;
    const double level = bound + static_cast<double>(random.below(3));
    for(const std::size_t v : loop)
      values[v] = is_minimum ? -level : level;
  }
}

// removes all triangles of vertices, no two of which have a common neighbor: the holes have many vertices, and some of
// the edges that are left join two of them
inline void remove_far_stars(Combinatorial_mesh& mesh, std::size_t number, Random& random)
{
  std::vector<bool> is_used(mesh.number_of_vertices, false);
  for(std::size_t trial = 0; trial < 20 * number && number > 0; ++trial)
  {
    const std::size_t center = random.below(mesh.number_of_vertices);
    const auto is_in_star = [&](const Vertex_triple& t) { return std::count(t.begin(), t.end(), center) != 0; };
    bool is_far = true;
    for(const Vertex_triple& t : mesh.triangles)
      is_far = is_far && !(is_in_star(t) && (is_used[t[0]] || is_used[t[1]] || is_used[t[2]]));
    if(!is_far)
      continue;
    for(const Vertex_triple& t : mesh.triangles)
      if(is_in_star(t))
        is_used[t[0]] = is_used[t[1]] = is_used[t[2]] = true;
    mesh.triangles.erase(std::remove_if(mesh.triangles.begin(), mesh.triangles.end(), is_in_star),
                         mesh.triangles.end());
    --number;
  }
}

// removes triangles no two of which have a common vertex
inline void remove_far_triangles(Combinatorial_mesh& mesh, std::size_t number, Random& random)
{
  std::vector<bool> is_used(mesh.number_of_vertices, false);
  for(std::size_t trial = 0; trial < 20 * number && number > 0; ++trial)
  {
    const std::size_t chosen = random.below(mesh.triangles.size());
    const Vertex_triple t = mesh.triangles[chosen];
    if(is_used[t[0]] || is_used[t[1]] || is_used[t[2]])
      continue;
    is_used[t[0]] = is_used[t[1]] = is_used[t[2]] = true;
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(chosen));
    --number;
  }
}

} // namespace random_meshes

#endif // CGAL_REEB_GRAPH_TEST_LEVEL_BORDER_FIELDS_H
