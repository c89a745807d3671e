// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_NESTED_DISSECTION_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_NESTED_DISSECTION_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Origin.h>

#ifdef CGAL_EIGEN3_ENABLED
#include <Eigen/OrderingMethods>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

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
    std::iota(vertices_.begin(), vertices_.end(), Dense_vertex(0));
    dissect(vertices_.begin(), vertices_.end());
  }

  const std::vector<Dense_vertex>& vertices() const { return vertices_; }

private:
  typedef std::vector<Dense_vertex>::iterator Iterator;

  int longest_side(Iterator begin, Iterator end) const
  {
    Bbox_3 box;
    for(Iterator it = begin; it != end; ++it)
      box += (ORIGIN + surface_.point(*it)).bbox();
    const std::array<double, 3> sides = {box.x_span(), box.y_span(), box.z_span()};
    return static_cast<int>(std::max_element(sides.begin(), sides.end()) - sides.begin());
  }

  void dissect(Iterator begin, Iterator end)
  {
    constexpr std::ptrdiff_t smallest_size = 16;
    if(end - begin < smallest_size)
      return;
    const int side = longest_side(begin, end);
    const Iterator middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, [&](Dense_vertex u, Dense_vertex v) {
      const double a = surface_.point(u)[side], b = surface_.point(v)[side];
      return a < b || (a == b && u < v);
    });
    ++last_half_;
    for(Iterator it = middle; it != end; ++it)
      halves_[*it] = last_half_;
    const Iterator first_separator = std::partition(begin, middle, [&](Dense_vertex v) {
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
  std::vector<Dense_vertex> vertices_;
  std::vector<Index> halves_; // number of the last upper half that a vertex was in, by vertex
  Index last_half_ = 0;
};

#ifdef CGAL_EIGEN3_ENABLED

// An ordering method of Eigen: keeps the order of the rows, as they come from a nested dissection. Where this fills the
// factor more than it should on a surface, because sheets of it are entangled in space, the minimum degrees decide.
class Given_or_minimum_degree_ordering
{
public:
  typedef Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> PermutationType;

  template <class Matrix>
  void operator()(const Matrix& matrix, PermutationType& permutation) const
  {
    if(is_fill_low(matrix))
      permutation.setIdentity(matrix.cols());
    else
      Eigen::AMDOrdering<int>()(matrix, permutation);
  }

private:
  // Counts the entries of the factor along the elimination tree, and stops when there are too many.
  template <class Matrix>
  static bool is_fill_low(const Matrix& matrix)
  {
    const auto size = static_cast<std::size_t>(matrix.cols());
    const double largest_fill = 6. * static_cast<double>(size) * (std::log2(static_cast<double>(size)) + 1);
    std::vector<std::size_t> parents(size, size), last_visits(size, size);
    double fill = 0;
    for(std::size_t column = 0; column != size && fill <= largest_fill; ++column)
    {
      last_visits[column] = column;
      for(typename Matrix::InnerIterator entry(matrix, static_cast<Eigen::Index>(column)); entry; ++entry)
        for(auto row = static_cast<std::size_t>(entry.index()); row < column && last_visits[row] != column;
            row = parents[row])
        {
          if(parents[row] == size)
            parents[row] = column;
          last_visits[row] = column;
          ++fill;
        }
    }
    return fill <= largest_fill;
  }
};

#endif // CGAL_EIGEN3_ENABLED

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_NESTED_DISSECTION_H
