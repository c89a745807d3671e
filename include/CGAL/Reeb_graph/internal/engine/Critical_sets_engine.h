// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_CRITICAL_SETS_ENGINE_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_CRITICAL_SETS_ENGINE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/engine/Slab.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/contour_tracing.h>
#include <CGAL/Reeb_graph/internal/engine/link_sectors.h>
#include <CGAL/Reeb_graph/internal/engine/monotone_paths.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Critical sets and ascending paths (the paper, Sections 4.1 to 4.5): the contours just below each critical vertex
// are registered at the edges that they cross; then a path climbs from each upper sector of each critical vertex to
// the first edge where a contour is registered, which names the upper end of the arc. Each such contour ends one
// arc. Cost: the lengths of the registered contours, and of the paths; those of different arcs do not overlap.
template <class Complex, class Order>
class Critical_sets_engine
{
public:
  Critical_sets_engine(const Slab<Complex>& slab, const Order& order)
    : slab_(slab),
      complex_(slab.complex()),
      order_(order),
      critical_vertices_(slab.critical_vertices()),
      contour_at_edge_(complex_.number_of_edges(), no_index)
  {}

  // An edge keeps the contour of the lowest level: that is where an ascending path meets it first. Calls
  // report(fraction) now and then.
  template <class Report>
  Slab_arcs find_arcs(const Report& report)
  {
    for(const Contour_index i : slab_.contours(Side::UPPER))
      arcs_.push_back({no_index, slab_.contour_node(Side::UPPER, i), {no_index, no_index}});
    constexpr std::size_t vertices_per_report = 4096;
    const Plain_vector<Swept_index>& ascending = critical_vertices_.ascending();
    for(std::size_t i = ascending.size(); i-- != 0;)
    {
      register_lower_contours(ascending[i]);
      if(i % vertices_per_report == 0)
        report(0.7 * static_cast<double>(ascending.size() - i) / static_cast<double>(ascending.size()));
    }
    for(const Swept_index i : critical_vertices_.indices())
      climb_from(i);
    for(const Contour_index i : slab_.contours(Side::LOWER))
      arcs_[contour_above(slab_.step_from_contour(Side::LOWER, i))].lower = slab_.contour_node(Side::LOWER, i);
    return std::move(arcs_);
  }

private:
  void register_lower_contours(Swept_index critical)
  {
    const Vertex_index vertex = critical_vertices_.vertex(critical);
    const auto is_below = [&](Vertex_index u) { return order_(u, vertex); };
    for(const Sector_index i : critical_vertices_.sectors(critical, Side::LOWER))
    {
      // A contour can pass several sectors of the vertex; then the earlier trace has been here. Those of higher vertices
      // do not cross an edge that ends at this one.
      const Halfedge_index edge = critical_vertices_.sector(Side::LOWER, i).edge;
      if(contour_at(edge) != no_index)
        continue;
      arcs_.push_back({no_index, node_of(critical), {no_index, no_index}});
      trace_contour(complex_, edge, is_below,
                    [&](Halfedge_index halfedge) { contour_at_edge_[edge_of(halfedge)] = arcs_.last_key(); });
    }
  }

  Slab_arc_index contour_at(Halfedge_index halfedge) const { return contour_at_edge_[edge_of(halfedge)]; }

  void climb_from(Swept_index critical)
  {
    for(const Sector_index i : critical_vertices_.sectors(critical, Side::UPPER))
    {
      const Link_sector& sector = critical_vertices_.sector(Side::UPPER, i);
      const Ascending_step first_step = {sector.edge, sector.extreme_neighbor};
      Slab_arc& arc = arcs_[contour_above(first_step)];
      // Several sectors can lead to one arc, whose chain begins in the highest one.
      if(arc.lower == no_index || order_(arc.first_step.target, first_step.target))
        arc.first_step = first_step;
      arc.lower = node_of(critical);
    }
  }

  Slab_arc_index contour_above(Ascending_step step) const
  {
    for(Number steps = 0; contour_at(step.edge) == no_index; ++steps)
    {
      const Contour_index contour = slab_.contour_at_step(Side::UPPER, step.target, [&] { return step.edge; });
      if(contour != no_index)
        return Slab_arc_index(contour.number()); // as the first arcs end at the contours of the upper level
      const Vertex_index vertex = step.target;
      step = steepest_step(complex_, order_, vertex);
      if(step.edge == no_index || steps == complex_.number_of_vertices())
        complex_.throw_contradiction_near(vertex);
    }
    return contour_at(step.edge);
  }

  const Slab<Complex>& slab_;
  const Complex& complex_;
  const Order& order_;
  const Swept_vertices& critical_vertices_;
  Indexed_vector<Edge_index, Slab_arc_index> contour_at_edge_; // a contour has the name of the arc that ends there
  Slab_arcs arcs_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_CRITICAL_SETS_ENGINE_H
