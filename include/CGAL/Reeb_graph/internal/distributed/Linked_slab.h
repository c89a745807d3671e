// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#ifndef CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_LINKED_SLAB_H
#define CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_LINKED_SLAB_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Plain_vector.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/distributed/Slab_complex.h>
#include <CGAL/Reeb_graph/internal/distributed/Slab_surface.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/walks/contour_tracing.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The surface that a rank holds, after its triangles have been linked. The complex refers to the arrays of the surface.
template <class Scalar, class Complex = Slab_complex>
struct Linked_slab
{
  Linked_slab() = default;
  Linked_slab(const Linked_slab&) = delete;
  Linked_slab& operator=(const Linked_slab&) = delete;

  Slab_surface<Scalar> surface;
  std::optional<Classified_complex<Complex>> classified;
};

// Calls visit(halfedges, is_closed) for each contour at the level just above the last vertex of value at most `value`,
// which must be a level of the slab: in the order of their least edges, with which closed ones begin.
template <class Scalar, class Visit>
void for_each_contour(const Linked_slab<Scalar>& slab, const Scalar& value, const Visit& visit)
{
  const Slab_complex& complex = slab.classified->complex;
  const auto is_below = [&](Vertex_index v) { return !(value < slab.surface.values[v]); };
  std::vector<bool> is_found(complex.number_of_edges(), false);
  Plain_vector<Halfedge_index> crossed;
  for(const Edge_index edge : Index_range<Edge_index>(complex.number_of_edges()))
  {
    const Halfedge_index start = complex.halfedge_of_triangle(edge);
    if(is_found[edge.number()] || is_below(complex.source(start)) == is_below(complex.target(start)))
      continue;
    const bool is_closed = trace_oriented_contour(complex, start, is_below, crossed);
    for(Halfedge_index& halfedge : crossed)
    {
      is_found[edge_of(halfedge).number()] = true;
      if(!is_below(complex.source(halfedge)))
        halfedge = opposite_of(halfedge);
    }
    visit(crossed, is_closed);
  }
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_LINKED_SLAB_H
