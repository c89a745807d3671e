// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_FIND_ARCS_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_FIND_ARCS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/engine/Contour_trees_engine.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL::Reeb_graph::internal {

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
  Swept_arcs find_arcs(const Report& report)
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

  Swept_arc_index contour_at(Halfedge_index halfedge) const { return contour_at_edge_[edge_of(halfedge)]; }

  void climb_from(Swept_index critical)
  {
    for(const Sector_index i : critical_vertices_.sectors(critical, Side::UPPER))
    {
      const Link_sector& sector = critical_vertices_.sector(Side::UPPER, i);
      const Ascending_step first_step = {sector.edge, sector.extreme_neighbor};
      Swept_arc& arc = arcs_[contour_above(first_step)];
      // Several sectors can lead to one arc, whose chain begins in the highest one.
      if(arc.lower == no_index || order_(arc.first_step.target, first_step.target))
        arc.first_step = first_step;
      arc.lower = node_of(critical);
    }
  }

  Swept_arc_index contour_above(Ascending_step step) const
  {
    for(Index steps = 0; contour_at(step.edge) == no_index; ++steps)
    {
      const Contour_index contour = slab_.contour_at_step(Side::UPPER, step.target, [&] { return step.edge; });
      if(contour != no_index)
        return Swept_arc_index(contour.number()); // as the first arcs end at the contours of the upper level
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
  Indexed_vector<Edge_index, Swept_arc_index> contour_at_edge_; // a contour has the name of the arc that ends there
  Swept_arcs arcs_;
};

// Options that a program leaves at their defaults are types: what it never asks for is not compiled.
typedef std::integral_constant<Method, Method::CONTOUR_TREES> Default_method;
typedef std::integral_constant<std::size_t, 1> Default_number_of_slabs;

// Throws if an arc lacks a node of the slab at an end, or has no step to begin with at a vertex: the order of the
// vertices has contradicted itself.
template <class Complex>
void check_arcs(const Slab<Complex>& slab, const Swept_arcs& arcs)
{
  const Tree_node end_of_nodes(slab.number_of_nodes());
  for(const Swept_arc& arc : arcs)
  {
    const bool has_first_step = arc.first_step.edge != no_index || slab.is_contour(arc.lower);
    if(arc.lower >= end_of_nodes || arc.upper >= end_of_nodes || !has_first_step)
      slab.throw_contradiction_near(arc);
  }
}

// Finds the arcs between the nodes of a slab by the engine for the method. All return the same arcs, in any order.
// First steps are those of arcs that begin at a critical vertex.
template <class ConcurrencyTag, class Complex, class Order, class Report>
Swept_arcs find_arcs_of_slab(const Slab<Complex>& slab, const Order& order, Default_method, const Report& report)
{
  Locate_nothing no_queries;
  Swept_arcs arcs =
    Contour_trees_engine<Complex, Order>(slab, order).template find_arcs<ConcurrencyTag>(report, no_queries);
  check_arcs(slab, arcs);
  return arcs;
}

template <class ConcurrencyTag, class Complex, class Order, class Report>
Swept_arcs find_arcs_of_slab(const Slab<Complex>& slab, const Order& order, Method method, const Report& report)
{
  if(method != Method::CRITICAL_SETS)
    return find_arcs_of_slab<ConcurrencyTag>(slab, order, Default_method(), report);
  Swept_arcs arcs = Critical_sets_engine<Complex, Order>(slab, order).find_arcs(report);
  check_arcs(slab, arcs);
  return arcs;
}

// Cuts the surface into several slabs, finds the arcs slab by slab, and glues them.
template <class ConcurrencyTag, class Complex, class Order, class ChosenMethod, class Report>
Swept_arcs find_and_glue_arcs(const Complex& complex,
                              const Order& order,
                              const Swept_vertices& critical_vertices,
                              ChosenMethod method,
                              Index number_of_slabs,
                              const Report& report)
{
  const Slicing<Complex> slicing(ConcurrencyTag(), complex, order, critical_vertices, number_of_slabs);
  report(0.2);
  Indexed_vector<Slab_index, Swept_arcs> arcs_of_slabs(slicing.number_of_slabs());
  for_each_index<ConcurrencyTag>(arcs_of_slabs.size(), [&](std::size_t i) {
    arcs_of_slabs[Slab_index(i)] =
      find_arcs_of_slab<ConcurrencyTag>(slicing.slab(Slab_index(i)), order, method, No_progress());
  });
  return glue_slabs(slicing, arcs_of_slabs, critical_vertices.size());
}

// The slab stage between partition and gluing: finds the arcs between critical vertices, slab by slab. With one slab,
// which needs neither, the engine itself runs in parallel where it can.
template <class ConcurrencyTag, class Complex, class Order, class ChosenMethod, class ChosenNumberOfSlabs, class Report>
Swept_arcs find_arcs(const Complex& complex,
                     const Order& order,
                     const Swept_vertices& critical_vertices,
                     ChosenMethod method,
                     ChosenNumberOfSlabs chosen_number_of_slabs,
                     const Report& report)
{
  if constexpr(!std::is_same_v<ChosenNumberOfSlabs, Default_number_of_slabs>)
  {
    const Index number_of_slabs(std::min<std::size_t>(chosen_number_of_slabs, critical_vertices.size()));
    if(number_of_slabs > 1)
      return find_and_glue_arcs<ConcurrencyTag>(complex, order, critical_vertices, method, number_of_slabs, report);
  }
  return find_arcs_of_slab<ConcurrencyTag>(Slab(complex, critical_vertices), order, method, report);
}

// Finds the arcs by the default method, and the one that each regular vertex is on.
template <class ConcurrencyTag, class Complex, class Order>
Swept_arcs find_arcs_and_locate_vertices(const Complex& complex,
                                         const Order& order,
                                         const Swept_vertices& critical_vertices,
                                         Arc_of_vertex& arc_of_vertex,
                                         const Stage_progress& progress)
{
  const Slab slab(complex, critical_vertices);
  const auto find = [&](auto& queries) {
    Swept_arcs arcs =
      Contour_trees_engine<Complex, Order>(slab, order).template find_arcs<ConcurrencyTag>(progress, queries);
    check_arcs(slab, arcs);
    arc_of_vertex = queries.take_arc_of_vertex();
    return arcs;
  };
  if(Locate_by_climbing<Complex, Order>::are_fast(complex, critical_vertices))
  {
    Locate_by_climbing<Complex, Order> queries(complex, order, critical_vertices);
    return find(queries);
  }
  Locate_by_sorting<Complex, Order> queries(complex, order, critical_vertices);
  queries.template sort<ConcurrencyTag>();
  return find(queries);
}

#define CGAL_REEB_GRAPH_FIND_ARCS_BY(PREFIX, TAG, COMPLEX, SCALAR, METHOD, NUMBER_OF_SLABS)                            \
  PREFIX template Swept_arcs find_arcs<TAG>(const COMPLEX&, const Natural_order<SCALAR>&, const Swept_vertices&,       \
                                            METHOD, NUMBER_OF_SLABS, const Stage_progress&);
#define CGAL_REEB_GRAPH_FIND_ARCS(PREFIX, TAG, COMPLEX, SCALAR)                                                        \
  CGAL_REEB_GRAPH_FIND_ARCS_BY(PREFIX, TAG, COMPLEX, SCALAR, Default_method, Default_number_of_slabs)
#define CGAL_REEB_GRAPH_FIND_ARCS_BY_CHOICE(PREFIX, TAG, COMPLEX, SCALAR)                                              \
  CGAL_REEB_GRAPH_FIND_ARCS_BY(PREFIX, TAG, COMPLEX, SCALAR, Method, Default_number_of_slabs)                          \
  CGAL_REEB_GRAPH_FIND_ARCS_BY(PREFIX, TAG, COMPLEX, SCALAR, Default_method, std::size_t)                              \
  CGAL_REEB_GRAPH_FIND_ARCS_BY(PREFIX, TAG, COMPLEX, SCALAR, Method, std::size_t)
#define CGAL_REEB_GRAPH_FIND_ARCS_OF_VERTICES(PREFIX, TAG, COMPLEX, SCALAR)                                            \
  PREFIX template Swept_arcs find_arcs_and_locate_vertices<TAG>(                                                       \
    const COMPLEX&, const Natural_order<SCALAR>&, const Swept_vertices&, Arc_of_vertex&, const Stage_progress&);
CGAL_REEB_GRAPH_FOR_COMPLEXES(CGAL_REEB_GRAPH_FIND_ARCS)
CGAL_REEB_GRAPH_FOR_COMPLEXES_OF_DOUBLES(CGAL_REEB_GRAPH_FIND_ARCS_OF_VERTICES)
CGAL_REEB_GRAPH_FOR_COMPLEXES_OF_DOUBLES(CGAL_REEB_GRAPH_FIND_ARCS_BY_CHOICE)

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_FIND_ARCS_H
