// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CRITICAL_VERTICES_MONOTONE_NEIGHBORS_H
#define CGAL_REEB_GRAPH_INTERNAL_CRITICAL_VERTICES_MONOTONE_NEIGHBORS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Side.h>
#include <CGAL/Reeb_graph/internal/base/Zeroed_array.h>
#include <CGAL/Reeb_graph/internal/base/prefetch.h>
#include <CGAL/Reeb_graph/internal/base/tuning.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A lower neighbor of a vertex and a higher one, no_index if there is none.
typedef By_side<Vertex_index> Monotone_neighbors;

// The monotone neighbors of the vertices in blocks of which many are critical. There, nearly each vertex is on a
// monotone path; elsewhere, to find the few steps of paths again takes less than to keep all of them.
class Kept_neighbors
{
public:
  static constexpr std::size_t block_size = 512;
  typedef std::array<Monotone_neighbors, block_size> Block;

  explicit Kept_neighbors(std::size_t number_of_vertices) : neighbors_(number_of_vertices) {}

  static bool are_worth_keeping(std::size_t number_of_critical_vertices, std::size_t number_of_vertices)
  {
    return is_used(Tuned_part::KEPT_NEIGHBORS) && number_of_critical_vertices > number_of_vertices / 8;
  }

  void keep(const Block& block, std::size_t begin, std::size_t end)
  {
    std::copy_n(block.begin(), end - begin, &neighbors_[Vertex_index(begin)]);
  }

  // Whether neighbors have been kept: in unset places, both are the same.
  bool has_neighbors(Vertex_index vertex) const
  {
    return neighbors_[vertex][Side::LOWER] != neighbors_[vertex][Side::UPPER];
  }
  Vertex_index neighbor(Vertex_index vertex, Side side) const { return neighbors_[vertex][side]; }

  void prefetch(Vertex_index vertex) const { internal::prefetch(&neighbors_[vertex]); }

private:
  Zeroed_array<Vertex_index, Monotone_neighbors> neighbors_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CRITICAL_VERTICES_MONOTONE_NEIGHBORS_H
