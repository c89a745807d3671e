// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_ORIENTED_TETRAHEDRA_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_ORIENTED_TETRAHEDRA_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/augmentation/Cell_list.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

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

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_ORIENTED_TETRAHEDRA_H
