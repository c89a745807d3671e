// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_VERTEX_ORDER_H
#define CGAL_REEB_GRAPH_INTERNAL_VERTEX_ORDER_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/Triangle_complex.h>

#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The total order of the vertices: by value, then by index (simulation of simplicity). Everything that the stages
// decide about the field, they decide by this comparison.
template <class Scalar, class Less>
class Vertex_order
{
public:
  Vertex_order(const std::vector<Scalar>& values, const Less& less) : values_(&values), less_(less) {}

  // Whether vertex u is lower than vertex v.
  bool operator()(Index u, Index v) const
  {
    const Scalar& value_u = (*values_)[u];
    const Scalar& value_v = (*values_)[v];
    return less_(value_u, value_v) || (!less_(value_v, value_u) && u < v);
  }

private:
  const std::vector<Scalar>* values_;
  Less less_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_VERTEX_ORDER_H
