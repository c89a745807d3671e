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

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Zeroed_array.h>
#include <CGAL/Reeb_graph/internal/base/prefetch.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// One of the lower neighbors of a vertex and one of its higher ones, no_index if there is none.
typedef std::array<Index, 2> Monotone_neighbors;

// Those of the vertices in blocks of which many are critical. There, nearly each vertex is on a monotone path;
// elsewhere, to find the few steps of paths again takes less than to keep all of them.
class Kept_neighbors
{
public:
  static constexpr std::size_t block_size = 512;
  typedef std::array<Monotone_neighbors, block_size> Block;

  explicit Kept_neighbors(std::size_t number_of_vertices) : neighbors_(number_of_vertices) {}

  static bool are_worth_keeping(std::size_t number_of_critical_vertices, std::size_t number_of_vertices)
  {
    return number_of_critical_vertices > number_of_vertices / 8;
  }

  void keep(const Block& block, std::size_t begin, std::size_t end)
  {
    std::copy_n(block.begin(), end - begin, &neighbors_[begin]);
  }

  // In unset places, both neighbors are the same.
  bool has_neighbors(Index vertex) const { return neighbors_[vertex][false] != neighbors_[vertex][true]; }
  Index neighbor(Index vertex, bool is_higher) const { return neighbors_[vertex][is_higher]; }

  void prefetch(Index vertex) const { internal::prefetch(&neighbors_[vertex]); }

private:
  Zeroed_array<Monotone_neighbors> neighbors_; // by vertex
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CRITICAL_VERTICES_MONOTONE_NEIGHBORS_H
