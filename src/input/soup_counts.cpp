// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/soup_counts.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace reeb_graph_program {
std::vector<Polygon_side> sides_of(const Polygons& polygons)
{
  std::vector<Polygon_side> sides;
  sides.reserve(polygons.number_of_corners());
  std::size_t first = 0;
  for(std::size_t i = 0; i < polygons.size(); ++i)
  {
    const Polygons::Polygon polygon = polygons[i];
    const auto size = static_cast<std::size_t>(polygon.end() - polygon.begin());
    for(std::size_t j = 0; j < size; ++j)
    {
      const std::size_t next = (j + 1) % size;
      const Corner a = polygon.begin()[j], b = polygon.begin()[next];
      if(a < b)
        sides.push_back({a, b, first + j, first + next, i, false});
      else
        sides.push_back({b, a, first + next, first + j, i, true});
    }
    first += size;
  }
  std::sort(sides.begin(), sides.end(), [](const Polygon_side& a, const Polygon_side& b) {
    return std::tie(a.u, a.v, a.face) < std::tie(b.u, b.v, b.face);
  });
  return sides;
}

std::vector<std::size_t> count_fans(const Polygons& polygons,
                                    const std::vector<Polygon_side>& sides,
                                    std::size_t number_of_vertices)
{
  Union_find_of_indices fans(sides.size());
  for(std::size_t i = 1; i < sides.size(); ++i)
    if(!(sides[i - 1] < sides[i]))
    {
      fans.unite(sides[i - 1].corner_of_u, sides[i].corner_of_u);
      fans.unite(sides[i - 1].corner_of_v, sides[i].corner_of_v);
    }
  std::vector<std::size_t> numbers(number_of_vertices, 0);
  std::size_t corner = 0;
  for(std::size_t i = 0; i < polygons.size(); ++i)
    for(const Corner v : polygons[i])
      numbers[v] += fans.is_root(corner++) ? 1 : 0;
  return numbers;
}

Soup_counts count_soup(const Polygons& polygons, std::size_t number_of_vertices)
{
  const std::vector<Polygon_side> sides = sides_of(polygons);
  Soup_counts counts;
  counts.vertices = number_of_vertices;
  counts.faces = polygons.size();
  Union_find_of_indices vertices(number_of_vertices), borders(number_of_vertices);
  std::vector<char> is_on_border(number_of_vertices, 0);
  for(std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    const Polygon_side& first = sides[begin];
    end = end_of_edge(sides, begin);
    ++counts.edges;
    vertices.unite(first.u, first.v);
    counts.edges_of_many_faces += end - begin > 2 ? 1 : 0;
    counts.edges_without_orientation +=
      end - begin == 2 && first.is_descending == sides[begin + 1].is_descending ? 1 : 0;
    if(end - begin > 1)
      continue;
    ++counts.border_edges;
    borders.unite(first.u, first.v);
    is_on_border[first.u] = is_on_border[first.v] = 1;
  }
  for(const std::size_t fans : count_fans(polygons, sides, number_of_vertices))
    counts.vertices_of_several_fans += fans > 1 ? 1 : 0;
  for(std::size_t v = 0; v < number_of_vertices; ++v)
  {
    counts.components += vertices.is_root(v) ? 1 : 0;
    counts.border_loops += is_on_border[v] != 0 && borders.is_root(v) ? 1 : 0;
  }
  return counts;
}

std::vector<std::size_t> components_of_polygons(const Polygons& polygons, std::size_t number_of_vertices)
{
  Union_find_of_indices vertices(number_of_vertices);
  for(std::size_t i = 0; i < polygons.size(); ++i)
    for(const Corner v : polygons[i])
      vertices.unite(*polygons[i].begin(), v);
  std::vector<std::size_t> components;
  for(std::size_t i = 0; i < polygons.size(); ++i)
    components.push_back(vertices.find(*polygons[i].begin()));
  return components;
}

} // namespace reeb_graph_program
