// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_VERTEX_PLACES_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_VERTEX_PLACES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/arcs/Flat_graph.h>
#include <CGAL/Reeb_graph/internal/arcs/find_arcs.h>
#include <CGAL/Reeb_graph/internal/arcs/reduce_arcs.h>
#include <CGAL/Reeb_graph/internal/augmentation/Arc_spreading.h>
#include <CGAL/Reeb_graph/internal/augmentation/Vertex_lists.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab_arc.h>
#include <CGAL/Reeb_graph/options.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The place of each vertex in the exact graph. Nothing but the surface and the order of its vertices is asked.
//
// First the arc between critical vertices is found that each regular vertex is on: by spreading the arcs, or, where
// they are short, by asking the sweeps of the engine. Reducing those arcs gives the graph once more, and says what has
// become of them.
template <class Complex, class Order>
class Vertex_places
{
public:
  template <class ConcurrencyTag>
  static Vertex_places make(const Complex& complex,
                            const Order& order,
                            Ties ties,
                            bool are_degree_two_nodes_kept,
                            const Progress& progress)
  {
    Vertex_places places(complex, order, ties);
    progress.report(0);
    places.critical_vertices_ = classify_vertices<ConcurrencyTag>(complex, order);
    if(!places.template spread_arcs<ConcurrencyTag>(Stage_progress(progress, 0.3, 0.4)))
    {
      places.critical_arcs_ = find_arcs_of_vertices<ConcurrencyTag>(
        complex, order, places.critical_vertices_, places.arc_of_vertex_, Stage_progress(progress, 0.4, 0.85));
    }
    progress.report(0.9);
    places.graph_ = reduce_arcs<ConcurrencyTag>(complex, order, places.critical_vertices_, places.critical_arcs_, ties,
                                                are_degree_two_nodes_kept, true);
    checked_index(places.graph_.nodes.size() + places.graph_.arcs.size());
    progress.report(0.95);
    places.template find_places<ConcurrencyTag>();
    return places;
  }

  // The exact graph.
  const Flat_graph& graph() const { return graph_; }

  // The place of each vertex: the number of a node, or the number of nodes plus that of an arc.
  Place_of_vertex release() && { return std::move(places_); }

private:
  typedef Arc_spreading<Complex, Order> Spreading;

  Vertex_places(const Complex& complex, const Order& order, Ties ties)
    : complex_(&complex),
      order_(&order),
      are_ties_contracted_(ties == Ties::CONTRACT)
  {}

  template <class ConcurrencyTag>
  bool spread_arcs(const Stage_progress& progress)
  {
    if(Spreading::are_arcs_short(*complex_, critical_vertices_))
      return false;
    critical_arcs_ = find_arcs<ConcurrencyTag>(*complex_, *order_, critical_vertices_, Default_method(),
                                               Default_number_of_slabs(), progress);
    Spreading spreading(*complex_, *order_, critical_vertices_, critical_arcs_);
    return spreading.template find_arcs_of_vertices<ConcurrencyTag>(arc_of_vertex_);
  }

  template <class ConcurrencyTag>
  void find_places()
  {
    places_.assign(complex_->number_of_vertices(), no_index);
    for(const Swept_index critical : critical_vertices_.indices())
      places_[critical_vertices_.vertex(critical)] = place_of_critical(critical);
    for_each_block<ConcurrencyTag>(places_.size(), [&](std::size_t begin, std::size_t end) {
      for(const Vertex_index vertex : Index_range(Vertex_index(begin), Vertex_index(end)))
      {
        if(places_[vertex] == no_index && complex_->has_vertex(vertex))
          places_[vertex] = place_on_arc(vertex, arc_of_vertex_[vertex]);
      }
    });
  }

  Index place_of_critical(Swept_index critical) const
  {
    const Node_index node = graph_.node_of_critical[critical];
    return node != no_index ? node.number()
                            : place_of_arc(graph_.arc_of_critical[critical], critical_vertices_.vertex(critical));
  }

  // The place of a regular vertex on an arc between critical vertices. On a plateau, it is where the end of the arc is.
  Index place_on_arc(Vertex_index vertex, Slab_arc_index critical_arc) const
  {
    if(critical_arc == no_index)
      complex_->throw_contradiction_near(vertex);
    if(are_ties_contracted_)
    {
      const Slab_arc& arc = critical_arcs_[critical_arc];
      for(const Swept_index end : {arc.lower_vertex(), arc.upper_vertex()})
      {
        if(order_->are_tied(vertex, critical_vertices_.vertex(end)))
          return place_of_critical(end);
      }
    }
    return place_of_arc(graph_.arc_of_critical_arc[critical_arc], vertex);
  }

  Index place_of_arc(Arc_index arc, Vertex_index vertex) const
  {
    if(arc == no_index)
      complex_->throw_contradiction_near(vertex);
    return static_cast<Index>(graph_.nodes.size()) + arc.number();
  }

  const Complex* complex_;
  const Order* order_;
  bool are_ties_contracted_;
  Swept_vertices critical_vertices_;
  Slab_arcs critical_arcs_;
  Arc_of_vertex arc_of_vertex_;
  Flat_graph graph_;
  Place_of_vertex places_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_VERTEX_PLACES_H
