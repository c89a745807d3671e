// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_ARC_CONTOURS_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_ARC_CONTOURS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Contour.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/walks/contour_tracing.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The contours of arcs at levels that cross their chains. They throw Graph_mismatch_error if a chain does not.
template <class GraphOnMesh>
class Arc_contours
{
  typedef typename GraphOnMesh::halfedge_descriptor halfedge_descriptor;
  typedef typename GraphOnMesh::arc_descriptor arc_descriptor;

public:
  typedef Reeb_graph::Contour<arc_descriptor, halfedge_descriptor> Contour;

  explicit Arc_contours(const GraphOnMesh& on_mesh) : on_mesh_(on_mesh) {}

  template <class Level>
  Contour trace(arc_descriptor arc, const Level& level) const
  {
    return trace_from(arc, find_start(arc, level.is_below), level);
  }

  // The contours of several arcs at one level.
  template <class ConcurrencyTag, class Level>
  std::vector<Contour> trace_all(const std::vector<arc_descriptor>& arcs, const Level& level) const
  {
    std::vector<Halfedge_index> starts;
    starts.reserve(arcs.size());
    for(const arc_descriptor arc : arcs)
      starts.push_back(find_start(arc, level.is_below));
    std::vector<Contour> contours(arcs.size());
    for_each_index<ConcurrencyTag>(arcs.size(),
                                   [&](std::size_t i) { contours[i] = trace_from(arcs[i], starts[i], level); });
    return contours;
  }

private:
  // A halfedge of a triangle on the edge at which the chain of the arc crosses the level. Chains can overlap where a
  // piece ends; then the later one is inside the arc.
  template <class IsBelow>
  Halfedge_index find_start(arc_descriptor arc, const IsBelow& is_below) const
  {
    const auto& chain = on_mesh_.chain(arc);
    const auto is_source_below = [&](halfedge_descriptor h) { return is_below(on_mesh_.checked_source(h)); };
    const halfedge_descriptor h = std::partition_point(chain.begin() + 1, chain.end(), is_source_below)[-1];
    if(!is_source_below(h) || is_source_below(opposite(h, on_mesh_.mesh())))
      throw Graph_mismatch_error();
    return on_mesh_.number_of_edge(h);
  }

  template <class Level>
  Contour trace_from(arc_descriptor arc, Halfedge_index start, const Level& level) const
  {
    Contour contour;
    contour.arc = arc;
    contour.value = level.value;
    std::vector<Halfedge_index> crossed;
    contour.is_closed = trace_oriented_contour(on_mesh_.complex(), start, level.is_below, crossed);
    contour.halfedges.reserve(crossed.size());
    for(const Halfedge_index halfedge : crossed)
    {
      const bool is_target_below = level.is_below(on_mesh_.complex().target(halfedge));
      contour.halfedges.push_back(on_mesh_.halfedge(is_target_below ? opposite_of(halfedge) : halfedge));
    }
    return contour;
  }

  const GraphOnMesh& on_mesh_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_ARC_CONTOURS_H
