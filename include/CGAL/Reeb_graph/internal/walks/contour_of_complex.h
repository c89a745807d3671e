// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_WALKS_CONTOUR_OF_COMPLEX_H
#define CGAL_REEB_GRAPH_INTERNAL_WALKS_CONTOUR_OF_COMPLEX_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Plain_vector.h>
#include <CGAL/Reeb_graph/internal/mesh/Simplicial_complex.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <array>
#include <cstddef>
#include <unordered_set>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The other edge that the level crosses of a triangle at a crossed edge.
template <class IsBelow>
Edge_index crossed_edge_beside(const Simplicial_complex& complex,
                               Edge_index crossed_edge,
                               Triangle_index triangle,
                               const IsBelow& is_below)
{
  // The edges of a triangle are those of its vertices 0 and 1, 0 and 2, 1 and 2.
  constexpr std::array<std::array<std::size_t, 2>, 3> other_edges = {{{1, 2}, {0, 2}, {0, 1}}};
  const std::array<Edge_index, 3>& edges = complex.edges_of(triangle);
  const std::size_t place = edges[0] == crossed_edge ? 0 : (edges[1] == crossed_edge ? 1 : 2);
  // The first of the two other edges has the lower end of the crossed one; it is not crossed if the apex is on the side
  // of that end.
  const bool is_apex_with_end =
    is_below(complex.vertices_of(triangle)[2 - place]) == is_below(complex.lower_end(crossed_edge));
  return edges[other_edges[place][is_apex_with_end ? 1 : 0]];
}

// Calls visit(edge, triangle) for the other edge of each triangle at a crossed edge that the level crosses.
template <class IsBelow, class Visit>
void for_each_crossed_edge_beside(const Simplicial_complex& complex,
                                  Edge_index crossed_edge,
                                  const IsBelow& is_below,
                                  const Visit& visit)
{
  for(const Triangle_index triangle : complex.triangles_of(crossed_edge))
    visit(crossed_edge_beside(complex, crossed_edge, triangle, is_below), triangle);
}

// Calls visit(halfedge) for the edges of the contour that crosses the edge of `start`, until a call returns true; see
// contour_tracing.h. In a complex a contour is any connected graph.
template <class IsBelow, class Visit>
void visit_contour(const Simplicial_complex& complex, Halfedge_index start, const IsBelow& is_below, const Visit& visit)
{
  std::unordered_set<Number> found = {edge_of(start).number()};
  Plain_vector<Edge_index> pending = {edge_of(start)};
  bool is_over = visit(start);
  while(!is_over && !pending.empty())
  {
    const Edge_index edge = pending.back();
    pending.pop_back();
    for_each_crossed_edge_beside(complex, edge, is_below, [&](Edge_index beside, Triangle_index) {
      if(is_over || !found.insert(beside.number()).second)
        return;
      is_over = visit(even_halfedge(beside));
      pending.push_back(beside);
    });
  }
}

template <class IsBelow, class Visit>
void trace_contour(const Simplicial_complex& complex, Halfedge_index start, const IsBelow& is_below, const Visit& visit)
{
  visit_contour(complex, start, is_below, [&](Halfedge_index halfedge) {
    visit(halfedge);
    return false;
  });
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_WALKS_CONTOUR_OF_COMPLEX_H
