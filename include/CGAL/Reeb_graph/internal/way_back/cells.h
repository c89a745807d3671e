// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_CELLS_H
#define CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_CELLS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/internal/complex/flatten_soup.h>
#include <CGAL/Reeb_graph_soup_traits.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The traits class of a soup with these values: the type of the named parameter, if that is given.
template <class Scalars, class NamedParameters>
using Soup_traits_of = Chosen_traits<Reeb_graph_soup_traits<Value_of_range<Scalars>>, NamedParameters>;

// The numbers of the cells, triangles or tetrahedra as the user lists them, at each vertex, in ascending order.
class Cell_list
{
public:
  static constexpr std::size_t vertices_per_cell = 3;

  // The cells have been checked. Their points do not matter.
  template <class Points, class CellRange>
  Cell_list(std::size_t number_of_vertices, const Points&, const CellRange& cells)
    : cells_of_vertices_(number_of_vertices, [&](const auto& visit) {
        Index number = 0;
        for(const auto& cell : cells)
        {
          for(const auto vertex : cell)
            visit(Vertex_index(static_cast<std::size_t>(vertex)), number);
          ++number;
        }
      })
  {}

  auto at_vertex(Vertex_index vertex) const { return cells_of_vertices_[vertex]; }

private:
  Buckets<Vertex_index, Index> cells_of_vertices_;
};

// The orientation of tetrahedra, which points of a three-dimensional kernel have.
template <class Points>
using Orientation_of = decltype(CGAL::orientation(*std::begin(std::declval<const Points&>()),
                                                  *std::begin(std::declval<const Points&>()),
                                                  *std::begin(std::declval<const Points&>()),
                                                  *std::begin(std::declval<const Points&>())));

// Tetrahedra with a sign each, by the way their vertices are listed: positively, as far as their points do not tell
// otherwise. One that is listed again is replaced by one of its vertices, which no level crosses.
class Oriented_tetrahedra : public Cell_list
{
public:
  static constexpr std::size_t vertices_per_cell = 4;
  typedef std::array<Vertex_index, 4> Tetrahedron;

  // `points` is a range of points, or the number of vertices. The tetrahedra have been checked.
  template <class Points, class TetrahedronRange>
  Oriented_tetrahedra(std::size_t number_of_vertices, const Points& points, const TetrahedronRange& tetrahedra)
    : Cell_list(number_of_vertices, points, tetrahedra)
  {
    for(const auto& vertices : tetrahedra)
    {
      Tetrahedron tetrahedron;
      auto end = tetrahedron.begin();
      for(const auto v : vertices)
        *end++ = Vertex_index(static_cast<std::size_t>(v));
      if(is_negative(points, tetrahedron))
        std::swap(tetrahedron[2], tetrahedron[3]);
      tetrahedra_.push_back(tetrahedron);
    }
    replace_repeated(number_of_vertices);
  }

  const Tetrahedron& operator[](std::size_t number) const { return tetrahedra_[number]; }
  auto begin() const { return tetrahedra_.begin(); }
  auto end() const { return tetrahedra_.end(); }

private:
  template <class Points>
  static bool is_negative(const Points& points, const Tetrahedron& t)
  {
    if constexpr(Has<Orientation_of, Points>::value)
    {
      const auto point = [&](Vertex_index v) -> decltype(auto) { return *(std::begin(points) + v.number()); };
      return CGAL::orientation(point(t[0]), point(t[1]), point(t[2]), point(t[3])) == CGAL::NEGATIVE;
    }
    else
      return static_cast<void>(points), static_cast<void>(t), false;
  }

  void replace_repeated(std::size_t number_of_vertices)
  {
    std::vector<std::pair<Tetrahedron, Index>> sorted;
    for(const Vertex_index least : Index_range<Vertex_index>(number_of_vertices))
    {
      sorted.clear();
      for(const Index number : at_vertex(least))
      {
        Tetrahedron vertices = tetrahedra_[number];
        std::sort(vertices.begin(), vertices.end());
        if(vertices[0] == least)
          sorted.push_back({vertices, number});
      }
      std::sort(sorted.begin(), sorted.end());
      for(std::size_t i = 1; i < sorted.size(); ++i)
      {
        if(sorted[i - 1].first == sorted[i].first)
          tetrahedra_[sorted[i].second].fill(least);
      }
    }
  }

  std::vector<Tetrahedron> tetrahedra_;
};

// A triangle that shares an edge with another one, and with no third one.
struct Neighboring_triangle
{
  std::size_t triangle;
  bool is_alike; // whether the two triangles pass their edge in opposite directions
};

inline std::vector<std::vector<Neighboring_triangle>> find_neighbors(
  const std::vector<std::array<std::size_t, 3>>& triangles)
{
  typedef std::tuple<std::size_t, std::size_t, std::size_t, bool> Side_of_triangle; // ends, triangle, is it ascending
  std::vector<Side_of_triangle> sides;
  sides.reserve(3 * triangles.size());
  for(std::size_t t = 0; t != triangles.size(); ++t)
  {
    for(std::size_t i = 0; i != 3; ++i)
    {
      const std::size_t from = triangles[t][i], to = triangles[t][(i + 1) % 3];
      sides.emplace_back((std::min)(from, to), (std::max)(from, to), t, from < to);
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<std::vector<Neighboring_triangle>> neighbors(triangles.size());
  for(auto side = sides.begin(), end = side; side != sides.end(); side = end)
  {
    end = std::find_if(side, sides.end(), [&](const Side_of_triangle& other) {
      return std::get<0>(other) != std::get<0>(*side) || std::get<1>(other) != std::get<1>(*side);
    });
    if(end - side != 2)
      continue;
    const std::size_t a = std::get<2>(side[0]), b = std::get<2>(side[1]);
    const bool is_alike = std::get<3>(side[0]) != std::get<3>(side[1]);
    neighbors[a].push_back({b, is_alike});
    neighbors[b].push_back({a, is_alike});
  }
  return neighbors;
}

// Orients triangles alike that share an edge with no third one. In each part that is connected in this way, the way in
// which most triangles are oriented before wins. A part that cannot be oriented is as the search leaves it.
inline void orient_alike(std::vector<std::array<std::size_t, 3>>& triangles)
{
  const std::vector<std::vector<Neighboring_triangle>> neighbors = find_neighbors(triangles);
  std::vector<bool> is_reached(triangles.size(), false), is_turned(triangles.size(), false);
  for(std::size_t first = 0; first != triangles.size(); ++first)
  {
    if(is_reached[first])
      continue;
    is_reached[first] = true;
    std::vector<std::size_t> part = {first};
    for(std::size_t i = 0; i != part.size(); ++i)
    {
      for(const Neighboring_triangle& neighbor : neighbors[part[i]])
      {
        if(is_reached[neighbor.triangle])
          continue;
        is_reached[neighbor.triangle] = true;
        is_turned[neighbor.triangle] = neighbor.is_alike ? is_turned[part[i]] : !is_turned[part[i]];
        part.push_back(neighbor.triangle);
      }
    }
    const auto number_of_turned = std::count_if(part.begin(), part.end(), [&](std::size_t t) { return is_turned[t]; });
    const bool are_most_turned = 2 * static_cast<std::size_t>(number_of_turned) > part.size();
    for(const std::size_t t : part)
    {
      if(is_turned[t] != are_most_turned)
        std::swap(triangles[t][1], triangles[t][2]);
    }
  }
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_CELLS_H
