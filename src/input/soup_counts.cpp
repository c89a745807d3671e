// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/soup_counts.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <vector>

namespace reeb_graph_program {
namespace {
class Union_find_of_indices
{
public:
  explicit Union_find_of_indices(std::size_t size)
    : ranks_(size, 0),
      parents_(size),
      sets_(ranks_.data(), parents_.data())
  {
    std::iota(parents_.begin(), parents_.end(), std::size_t(0));
  }
  std::size_t find(std::size_t i) { return sets_.find_set(i); }
  void unite(std::size_t i, std::size_t j) { sets_.union_set(i, j); }
  bool is_root(std::size_t i) { return find(i) == i; }

private:
  std::vector<std::size_t> ranks_, parents_;
  boost::disjoint_sets<std::size_t*, std::size_t*> sets_;
};

// A side of a polygon, by its vertices in ascending order, and which corners of all polygons it has there.
struct Polygon_side
{
  Corner u, v;
  std::size_t corner_of_u, corner_of_v;
  bool is_descending; // along the polygon

  bool operator<(const Polygon_side& other) const { return std::tie(u, v) < std::tie(other.u, other.v); }
};

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
        sides.push_back({a, b, first + j, first + next, false});
      else
        sides.push_back({b, a, first + next, first + j, true});
    }
    first += size;
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

} // namespace

Soup_counts count_soup(const Polygons& polygons, std::size_t number_of_vertices)
{
  const std::vector<Polygon_side> sides = sides_of(polygons);
  Soup_counts counts;
  counts.vertices = number_of_vertices;
  counts.faces = polygons.size();
  Union_find_of_indices vertices(number_of_vertices), borders(number_of_vertices), fans(sides.size());
  std::vector<char> is_on_border(number_of_vertices, 0);
  for(std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    const Polygon_side& first = sides[begin];
    for(end = begin + 1; end < sides.size() && !(first < sides[end]); ++end)
    {
      fans.unite(first.corner_of_u, sides[end].corner_of_u);
      fans.unite(first.corner_of_v, sides[end].corner_of_v);
    }
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
  std::vector<std::size_t> fans_of_vertices(number_of_vertices, 0);
  std::size_t corner = 0;
  for(std::size_t i = 0; i < polygons.size(); ++i)
    for(const Corner v : polygons[i])
      if(fans.is_root(corner++) && ++fans_of_vertices[v] == 2)
        ++counts.vertices_of_several_fans;
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
