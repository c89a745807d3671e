// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#ifndef CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_ORDER_KEY_H
#define CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_ORDER_KEY_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/distributed/Slab_surface.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A vertex with its value: its place in the total order of the vertices of all ranks.
template <class Scalar>
struct Order_key
{
  static_assert(std::is_arithmetic_v<Scalar>, "On several ranks, scalar values are numbers.");

  Scalar value;
  Global_vertex vertex;

  friend bool operator<(const Order_key& a, const Order_key& b)
  {
    return a.value < b.value || (a.value == b.value && a.vertex < b.vertex);
  }
};

// The highest place of each slab but the last one, ascending.
template <class Scalar>
using Splitters = std::vector<Order_key<Scalar>>;

// The slab in which a place is.
template <class Scalar>
std::size_t slab_of(const Splitters<Scalar>& splitters, const Order_key<Scalar>& place)
{
  return static_cast<std::size_t>(std::lower_bound(splitters.begin(), splitters.end(), place) - splitters.begin());
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_ORDER_KEY_H
