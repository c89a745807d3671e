// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_CELL_LIST_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_CELL_LIST_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

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

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_CELL_LIST_H
