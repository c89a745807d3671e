// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
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
#include <CGAL/Reeb_graph/internal/complex/flatten_soup.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph_soup_traits.h>
#include <CGAL/enum.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

template <class Range>
using Value_of_range = std::decay_t<decltype(*std::begin(std::declval<const Range&>()))>;

// The traits class of a soup with these values: the type of the named parameter, if that is given.
template <class Scalars, class NamedParameters>
using Soup_traits_of = Chosen_traits<Reeb_graph_soup_traits<Value_of_range<Scalars>>, NamedParameters>;

// The complex of triangles or of tetrahedra, by their number of vertices, and of the edges of a named parameter, with
// its field by numbers, after both have been checked.
template <int vertices_per_cell, class PointsOrNumber, class Cells, class Scalars, class Traits, class NamedParameters>
Flat_soup<typename Traits::Scalar> flatten_cells(const PointsOrNumber& points,
                                                 const Cells& cells,
                                                 const Scalars& scalars,
                                                 const Traits& traits,
                                                 const NamedParameters& np)
{
  const std::size_t size = count_vertices(points);
  auto edges_parameter = parameters::choose_parameter<std::array<std::array<std::size_t, 2>, 0>>(
    parameters::get_parameter(np, edges_of_soup));
  const auto& edges = unwrap_reference(edges_parameter);
  return flatten_soup<Sequential_tag>(size, scalars, traits, [&] {
    if constexpr(vertices_per_cell == 3)
      return read_triangles(size, cells, edges);
    else
      return read_tetrahedra(size, cells, edges);
  });
}

// The numbers of the cells, triangles or tetrahedra as the user lists them, at each vertex.
class Cell_list
{
public:
  static constexpr int vertices_per_cell = 3;

  // The cells have been checked. Their points do not matter.
  template <class Points, class CellRange>
  Cell_list(std::size_t number_of_vertices, const Points&, const CellRange& cells)
    : first_of_vertices_(number_of_vertices + 1, 0)
  {
    for(const auto& cell : cells)
      for(const auto vertex : cell)
        ++first_of_vertices_[Vertex_index(static_cast<std::size_t>(vertex) + 1)];
    std::partial_sum(first_of_vertices_.begin(), first_of_vertices_.end(), first_of_vertices_.begin());
    cells_of_vertices_.resize(first_of_vertices_.back());
    Indexed_vector<Vertex_index, std::size_t> places(first_of_vertices_);
    std::size_t number = 0;
    for(const auto& cell : cells)
    {
      for(const auto vertex : cell)
        cells_of_vertices_[places[Vertex_index(static_cast<std::size_t>(vertex))]++] = checked_index(number);
      ++number;
    }
  }

  // Calls visit(number) for each cell at the vertex, in ascending order.
  template <class Visit>
  void for_each_at(Vertex_index vertex, const Visit& visit) const
  {
    const std::size_t end = first_of_vertices_[Vertex_index(vertex.number() + 1)];
    for(std::size_t i = first_of_vertices_[vertex]; i != end; ++i)
      visit(cells_of_vertices_[i]);
  }

  // The numbers of the cells at the vertex, in ascending order.
  std::vector<std::size_t> at_vertex(Vertex_index vertex) const
  {
    std::vector<std::size_t> result;
    for_each_at(vertex, [&](Number cell) { result.push_back(cell); });
    return result;
  }

private:
  Indexed_vector<Vertex_index, std::size_t> first_of_vertices_; // and the end
  std::vector<Number> cells_of_vertices_;
};

// Whether points of a range are those of a three-dimensional kernel, so that tetrahedra have an orientation.
template <class Points, class = void>
struct Have_orientation : std::false_type
{
};
template <class Points>
struct Have_orientation<Points,
                        std::void_t<decltype(CGAL::orientation(*std::begin(std::declval<const Points&>()),
                                                               *std::begin(std::declval<const Points&>()),
                                                               *std::begin(std::declval<const Points&>()),
                                                               *std::begin(std::declval<const Points&>())))>>
  : std::true_type
{
};

// Tetrahedra with a sign each, by the way their vertices are listed: positively, as far as their points do not tell
// otherwise. One that is listed again is replaced by one of its vertices, which no level crosses.
class Oriented_tetrahedra : public Cell_list
{
public:
  static constexpr int vertices_per_cell = 4;
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
    if constexpr(Have_orientation<Points>::value)
    {
      const auto point = [&](Vertex_index v) -> decltype(auto) { return *(std::begin(points) + v.number()); };
      return CGAL::orientation(point(t[0]), point(t[1]), point(t[2]), point(t[3])) == CGAL::NEGATIVE;
    }
    else
      return static_cast<void>(points), static_cast<void>(t), false;
  }

  void replace_repeated(std::size_t number_of_vertices)
  {
    std::vector<std::pair<Tetrahedron, Number>> sorted;
    for(const Vertex_index least : Index_range<Vertex_index>(number_of_vertices))
    {
      sorted.clear();
      for_each_at(least, [&](Number number) {
        Tetrahedron vertices = tetrahedra_[number];
        std::sort(vertices.begin(), vertices.end());
        if(vertices[0] == least)
          sorted.push_back({vertices, number});
      });
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

// Orients triangles alike that share an edge with no third one. In each part that is connected in this way, the way in
// which most triangles are oriented before wins. A part that cannot be oriented is as the search leaves it.
class Triangle_orientation
{
public:
  typedef std::array<std::size_t, 3> Triangle;

  static void orient(std::vector<Triangle>& triangles)
  {
    Triangle_orientation orientation(triangles);
    if(!orientation.are_all_alike_)
      orientation.turn(triangles);
  }

private:
  struct Neighbor
  {
    std::size_t triangle;
    bool is_alike; // whether the two triangles pass their edge in opposite directions
  };

  struct Side
  {
    std::size_t low, high, triangle;
    bool is_ascending;

    friend bool operator<(const Side& a, const Side& b)
    {
      return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    }
    bool is_on_edge_of(const Side& other) const { return low == other.low && high == other.high; }
  };

  explicit Triangle_orientation(const std::vector<Triangle>& triangles) : neighbors_(triangles.size())
  {
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for(std::size_t t = 0; t != triangles.size(); ++t)
    {
      for(std::size_t i = 0; i != 3; ++i)
      {
        const std::size_t from = triangles[t][i], to = triangles[t][(i + 1) % 3];
        sides.push_back({(std::min)(from, to), (std::max)(from, to), t, from < to});
      }
    }
    std::sort(sides.begin(), sides.end());
    for(auto side = sides.begin(); side != sides.end();)
    {
      const auto end = std::find_if(side, sides.end(), [&](const Side& other) { return !other.is_on_edge_of(*side); });
      if(end - side == 2)
        join(side[0], side[1]);
      side = end;
    }
  }

  void join(const Side& a, const Side& b)
  {
    const bool is_alike = a.is_ascending != b.is_ascending;
    neighbors_[a.triangle].push_back({b.triangle, is_alike});
    neighbors_[b.triangle].push_back({a.triangle, is_alike});
    are_all_alike_ &= is_alike;
  }

  void turn(std::vector<Triangle>& triangles)
  {
    std::vector<bool> is_reached(triangles.size(), false), is_turned(triangles.size(), false);
    for(std::size_t first = 0; first != triangles.size(); ++first)
    {
      if(is_reached[first])
        continue;
      is_reached[first] = true;
      std::vector<std::size_t> part = {first};
      for(std::size_t i = 0; i != part.size(); ++i)
      {
        for(const Neighbor& neighbor : neighbors_[part[i]])
        {
          if(is_reached[neighbor.triangle])
            continue;
          is_reached[neighbor.triangle] = true;
          is_turned[neighbor.triangle] = neighbor.is_alike ? is_turned[part[i]] : !is_turned[part[i]];
          part.push_back(neighbor.triangle);
        }
      }
      const auto number_of_turned =
        std::count_if(part.begin(), part.end(), [&](std::size_t t) { return is_turned[t]; });
      const bool are_most_turned = 2 * static_cast<std::size_t>(number_of_turned) > part.size();
      for(const std::size_t t : part)
      {
        if(is_turned[t] != are_most_turned)
          std::swap(triangles[t][1], triangles[t][2]);
      }
    }
  }

  std::vector<std::vector<Neighbor>> neighbors_;
  bool are_all_alike_ = true;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_CELLS_H
