// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_SURFACE_CONTOUR_TRACER_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_SURFACE_CONTOUR_TRACER_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Contour.h>
#include <CGAL/Reeb_graph/internal/base/Plain_vector.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/walks/contour_tracing.h>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Traces contours on an oriented surface: sequences of halfedges.
template <class GraphOnMesh>
class Surface_contour_tracer
{
  typedef typename GraphOnMesh::halfedge_descriptor halfedge_descriptor;
  typedef typename GraphOnMesh::arc_descriptor arc_descriptor;

public:
  typedef Reeb_graph::Contour<arc_descriptor, halfedge_descriptor> Contour;

  explicit Surface_contour_tracer(const GraphOnMesh& on_mesh) : on_mesh_(on_mesh) {}

  // A halfedge of a triangle on the edge of h.
  Halfedge_index find_start(halfedge_descriptor h) const { return on_mesh_.number_of_edge(h); }

  template <class Level>
  Contour trace(arc_descriptor arc, Halfedge_index start, const Level& level) const
  {
    Contour contour;
    contour.arc = arc;
    contour.value = level.value;
    Plain_vector<Halfedge_index> crossed;
    contour.is_closed = trace_oriented_contour(on_mesh_.complex(), start, level.is_below, crossed);
    contour.halfedges.reserve(crossed.size());
    for(const Halfedge_index halfedge : crossed)
    {
      const bool is_target_below = level.is_below(on_mesh_.complex().target(halfedge));
      contour.halfedges.push_back(on_mesh_.halfedge(is_target_below ? opposite_of(halfedge) : halfedge));
    }
    return contour;
  }

private:
  const GraphOnMesh& on_mesh_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_SURFACE_CONTOUR_TRACER_H
