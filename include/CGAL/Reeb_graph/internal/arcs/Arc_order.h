// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ARCS_ARC_ORDER_H
#define CGAL_REEB_GRAPH_INTERNAL_ARCS_ARC_ORDER_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/arcs/Flat_graph.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/walks/ascending_path.h>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The canonical order of the arcs that leave one node: by upper node, then by the second and the first vertex of their
// chains. Nothing in it depends on how the arcs were found.
template <class Complex, class Order>
class Arc_order
{
public:
  Arc_order(const Complex& complex, const Order& order, const Indexed_vector<Piece_index, Chain_piece>& pieces)
    : complex_(complex),
      order_(order),
      pieces_(pieces)
  {}

  bool operator()(const Flat_arc& a, const Flat_arc& b) const
  {
    return a.upper != b.upper ? a.upper < b.upper
                              : is_before(pieces_[a.first_piece].first_step, pieces_[b.first_piece].first_step);
  }

private:
  // Halfedges count only if there are several between two vertices: meshes number them in different ways.
  bool is_before(const Ascending_step& a, const Ascending_step& b) const
  {
    if(a.target != b.target)
      return order_(a.target, b.target);
    const Vertex_index first_of_a = first_vertex(a), first_of_b = first_vertex(b);
    return first_of_a != first_of_b ? order_(first_of_a, first_of_b) : a.edge < b.edge;
  }

  Vertex_index first_vertex(const Ascending_step& step) const
  {
    const Vertex_index source = complex_.source(step.edge);
    return source == step.target ? complex_.target(step.edge) : source;
  }

  const Complex& complex_;
  const Order& order_;
  const Indexed_vector<Piece_index, Chain_piece>& pieces_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_ARCS_ARC_ORDER_H
