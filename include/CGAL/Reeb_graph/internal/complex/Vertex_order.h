// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_VERTEX_ORDER_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_VERTEX_ORDER_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>

#include <optional>
#include <utility>

namespace CGAL::Reeb_graph::internal {

// The total order of the vertices: by value, then by index (simulation of simplicity). Everything that the stages
// decide about the field, they decide by this comparison.
template <class Scalar, class Less>
class Vertex_order
{
public:
  // Whether the order cannot contradict itself, whatever the values are.
  static constexpr bool is_sure = is_order_of_numbers<Scalar, Less>;

  // A name of a vertex with its value, to be sorted without access to the array of all values. Names are in the order
  // of the vertices' indices.
  template <class Name>
  struct Key
  {
    Scalar value;
    Name name;
  };

  Vertex_order(const Indexed_vector<Vertex_index, Scalar>& values, const Less& less) : values_(&values), less_(less) {}

  // Whether vertex u is lower than vertex v. Sweeps ask in the order of the mesh, in which a branch on the first
  // comparison is foreseen where the field is smooth, and what depends on the answer need not wait for the values.
  bool operator()(Vertex_index u, Vertex_index v) const { return is_before((*values_)[u], u, (*values_)[v], v); }

  void prefetch(Vertex_index v) const { prefetch_element(*values_, v); }

  template <class Name>
  Key<Name> key(Vertex_index v, Name name) const
  {
    return {(*values_)[v], name};
  }

  // Sorting asks what cannot be foreseen, so the answer is computed without a branch but on ties, which are few or come
  // in a row.
  template <class Name>
  bool operator()(const Key<Name>& a, const Key<Name>& b) const
  {
    if constexpr(is_sure && is_used(Tuned_part::BRANCHLESS_ORDER))
      return a.value == b.value ? a.name < b.name : less_(a.value, b.value);
    else
      return is_before(a.value, a.name, b.value, b.name);
  }

  // Tells the order without a branch, where the answer cannot be foreseen.
  bool is_lower(Vertex_index u, Vertex_index v) const
  {
    if constexpr(is_sure)
      return (*this)(key(u, u), key(v, v));
    else
      return (*this)(u, v);
  }

  // Whether the values are the same, so that only the indices order the vertices.
  bool are_tied(Vertex_index u, Vertex_index v) const
  {
    return !less_((*values_)[u], (*values_)[v]) && !less_((*values_)[v], (*values_)[u]);
  }

  // Whether the value of vertex u is lower than `value`, or `value` lower than that of u.
  bool is_lower(Vertex_index u, const Scalar& value) const { return less_((*values_)[u], value); }
  bool is_higher(Vertex_index u, const Scalar& value) const { return less_(value, (*values_)[u]); }

private:
  template <class Name>
  bool is_before(const Scalar& value_u, Name u, const Scalar& value_v, Name v) const
  {
    return less_(value_u, value_v) || (!less_(value_v, value_u) && u < v);
  }

  const Indexed_vector<Vertex_index, Scalar>* values_;
  Less less_;
};

// A level: the place in the total order just above or just below a vertex, or the place that a value has: just above the
// last vertex that is not higher, or just below the first that is not lower.
template <class Scalar, class Order>
class Level
{
public:
  Level(const Order& order, Side side, Vertex_index vertex) : order_(&order), side_(side), vertex_(vertex) {}
  Level(const Order& order, Side side, Scalar value)
    : order_(&order),
      side_(side),
      vertex_(no_index),
      value_(std::move(value))
  {}

  // Whether the vertex is below the level.
  bool operator()(Vertex_index u) const
  {
    if(value_)
      return side_ == Side::UPPER ? !order_->is_higher(u, *value_) : order_->is_lower(u, *value_);
    return u == vertex_ ? side_ == Side::UPPER : (*order_)(u, vertex_);
  }

private:
  const Order* order_;
  Side side_;
  Vertex_index vertex_;
  std::optional<Scalar> value_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_VERTEX_ORDER_H
