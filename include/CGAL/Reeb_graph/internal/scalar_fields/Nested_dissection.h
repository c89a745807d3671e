// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_NESTED_DISSECTION_H
#define CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_NESTED_DISSECTION_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/scalar_fields/Weighted_graph.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

// Orders the vertices of a surface so that the factor of a matrix with one entry per edge has few entries: first those
// of one half, then those of the other half, then those that separate them, and so on in both halves (A. George, Nested
// Dissection of a Regular Finite Element Mesh, 1973). The halves are those along the longest side of the bounding box.
class Nested_dissection
{
public:
  Nested_dissection(const Indexed_surface& surface, const Weighted_graph& graph)
    : surface_(surface),
      graph_(graph),
      vertices_(graph.number_of_vertices()),
      halves_(graph.number_of_vertices(), 0)
  {
    std::iota(vertices_.begin(), vertices_.end(), Position(0));
    dissect(vertices_.begin(), vertices_.end());
  }

  const std::vector<Position>& vertices() const { return vertices_; }

private:
  typedef std::vector<Position>::iterator Iterator;

  int longest_side(Iterator begin, Iterator end) const
  {
    Vector lowest = surface_.point(*begin), highest = lowest;
    for(Iterator it = begin; it != end; ++it)
      for(int i = 0; i != 3; ++i)
      {
        lowest[i] = (std::min)(lowest[i], surface_.point(*it)[i]);
        highest[i] = (std::max)(highest[i], surface_.point(*it)[i]);
      }
    const Vector sides = highest - lowest;
    return static_cast<int>(std::max_element(sides.begin(), sides.end()) - sides.begin());
  }

  void dissect(Iterator begin, Iterator end)
  {
    constexpr std::ptrdiff_t smallest_size = 16;
    if(end - begin < smallest_size)
      return;
    const int side = longest_side(begin, end);
    const Iterator middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, [&](Position u, Position v) {
      const double a = surface_.point(u)[side], b = surface_.point(v)[side];
      return a < b || (a == b && u < v);
    });
    ++last_half_;
    for(Iterator it = middle; it != end; ++it)
      halves_[*it] = last_half_;
    const Iterator first_separator = std::partition(begin, middle, [&](Position v) {
      const auto neighbors = graph_.neighbors(v);
      return std::none_of(neighbors.begin(), neighbors.end(),
                          [&](const auto& n) { return halves_[n.vertex] == last_half_; });
    });
    const Iterator end_of_upper_half = std::rotate(first_separator, middle, end);
    dissect(begin, first_separator);
    dissect(first_separator, end_of_upper_half);
  }

  const Indexed_surface& surface_;
  const Weighted_graph& graph_;
  std::vector<Position> vertices_;
  std::vector<Position> halves_; // number of the last upper half that a vertex was in, by vertex
  Position last_half_ = 0;
};

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_NESTED_DISSECTION_H
