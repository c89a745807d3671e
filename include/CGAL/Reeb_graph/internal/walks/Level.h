// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_WALKS_LEVEL_H
#define CGAL_REEB_GRAPH_INTERNAL_WALKS_LEVEL_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <optional>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A level: the place in the total order just above or just below a vertex, or the place that a value has.
template <class Scalar, class Order>
class Level
{
public:
  static Level above_vertex(const Order& order, Vertex_index vertex)
  {
    return Level(order, true, vertex, std::nullopt);
  }
  static Level below_vertex(const Order& order, Vertex_index vertex)
  {
    return Level(order, false, vertex, std::nullopt);
  }

  // The level just above the last vertex that is not higher than the value, or just below the first that is not lower.
  static Level above_value(const Order& order, const Scalar& value) { return Level(order, true, no_index, value); }
  static Level below_value(const Order& order, const Scalar& value) { return Level(order, false, no_index, value); }

  // Whether the vertex is below the level.
  bool operator()(Vertex_index u) const
  {
    if(value_)
      return is_above_ ? !order_->is_higher(u, *value_) : order_->is_lower(u, *value_);
    return u == vertex_ ? is_above_ : (*order_)(u, vertex_);
  }

private:
  Level(const Order& order, bool is_above, Vertex_index vertex, std::optional<Scalar> value)
    : order_(&order),
      is_above_(is_above),
      vertex_(vertex),
      value_(std::move(value))
  {}

  const Order* order_;
  bool is_above_;
  Vertex_index vertex_;
  std::optional<Scalar> value_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_WALKS_LEVEL_H
