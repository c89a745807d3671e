// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_MESH_VERTEX_ORDER_H
#define CGAL_REEB_GRAPH_INTERNAL_MESH_VERTEX_ORDER_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Large_vector.h>
#include <CGAL/Reeb_graph/internal/base/is_ordered.h>

#include <type_traits>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The total order of the vertices: by value, then by index (simulation of simplicity). Everything that the stages
// decide about the field, they decide by this comparison.
template <class Scalar, class Less>
class Vertex_order
{
public:
  // Whether the order cannot contradict itself, whatever the values are.
  static constexpr bool is_sure = is_order_of_numbers<Scalar, Less>;

  // A vertex with its value, to be sorted without access to the array of all values.
  struct Key
  {
    Scalar value;
    Index vertex;
  };

  Vertex_order(const Large_vector<Scalar>& values, const Less& less) : values_(&values), less_(less) {}

  // Whether vertex u is lower than vertex v.
  bool operator()(Index u, Index v) const { return is_before((*values_)[u], u, (*values_)[v], v); }

  Key key(Index v) const { return {(*values_)[v], v}; }

  bool operator()(const Key& a, const Key& b) const { return is_before(a.value, a.vertex, b.value, b.vertex); }

  // Whether the values are the same, so that only the indices order the vertices.
  bool are_tied(Index u, Index v) const
  {
    return !less_((*values_)[u], (*values_)[v]) && !less_((*values_)[v], (*values_)[u]);
  }

  // Whether the value of vertex u is lower than `value`, or `value` lower than that of u.
  bool is_lower(Index u, const Scalar& value) const { return less_((*values_)[u], value); }
  bool is_higher(Index u, const Scalar& value) const { return less_(value, (*values_)[u]); }

private:
  // Cheap comparisons are all done, as a branch on the first one could not be predicted.
  bool is_before(const Scalar& value_u, Index u, const Scalar& value_v, Index v) const
  {
    if constexpr(std::is_arithmetic<Scalar>::value)
    {
      const unsigned is_lower = less_(value_u, value_v), is_higher = less_(value_v, value_u), is_first = u < v;
      return (is_lower | (is_first & ~is_higher)) != 0;
    }
    else
      return less_(value_u, value_v) || (!less_(value_v, value_u) && u < v);
  }

  const Large_vector<Scalar>* values_;
  Less less_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_MESH_VERTEX_ORDER_H
