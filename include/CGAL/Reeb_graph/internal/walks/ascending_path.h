// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_WALKS_ASCENDING_PATH_H
#define CGAL_REEB_GRAPH_INTERNAL_WALKS_ASCENDING_PATH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A step of an ascending path: the edge of which `edge` is a halfedge that has a triangle, up to its higher end
// `target`.
struct Ascending_step
{
  Halfedge_index edge;
  Vertex_index target;
};

// The step from `vertex`, which is no maximum, to its highest neighbor. Without a branch, as none could be predicted.
template <class Complex, class Order>
Ascending_step steepest_step(const Complex& complex, const Order& order, Vertex_index vertex)
{
  Ascending_step step = {no_index, vertex};
  complex.for_each_edge_around(vertex, [&](Vertex_index neighbor, Halfedge_index halfedge) {
    const bool is_higher = order(step.target, neighbor);
    step.edge = is_higher ? halfedge : step.edge;
    step.target = is_higher ? neighbor : step.target;
  });
  return step;
}

// Takes steepest steps from `vertex` on as long as goes_on(vertex reached), and calls visit(vertex, step from it)
// before each. Returns the vertex reached.
template <class Complex, class Order, class GoesOn, class Visit>
Vertex_index climb(const Complex& complex,
                   const Order& order,
                   Vertex_index vertex,
                   const GoesOn& goes_on,
                   const Visit& visit)
{
  while(goes_on(vertex))
  {
    const Ascending_step step = steepest_step(complex, order, vertex);
    if(step.edge == no_index)
      complex.throw_contradiction_near(vertex);
    visit(vertex, step);
    vertex = step.target;
  }
  return vertex;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_WALKS_ASCENDING_PATH_H
