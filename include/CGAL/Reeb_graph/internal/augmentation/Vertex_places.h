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
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab_arc.h>
#include <CGAL/Reeb_graph/options.h>

#include <cstddef>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The place of each vertex in the exact graph. Nothing but the surface and the order of its vertices is asked.
//
// With all vertices in the place of the critical ones, the engine finds the arc between critical vertices that each
// regular vertex is on; reducing those arcs gives the graph once more, and says what has become of them.
template <class Complex, class Order>
class Vertex_places
{
public:
  template <class ConcurrencyTag>
  static Vertex_places make(const Complex& complex, const Order& order, Ties ties, bool are_degree_two_nodes_kept)
  {
    Vertex_places places(complex, order, ties);
    places.all_vertices_ = sort_all_vertices<ConcurrencyTag>(complex, order);
    const auto steps =
      find_arcs<ConcurrencyTag>(complex, order, places.all_vertices_, Method::CONTOUR_TREES, 1, No_progress());
    places.critical_graph_ =
      reduce_arcs<ConcurrencyTag>(complex, order, places.all_vertices_, steps, Ties::PERTURB, true, true);
    places.critical_vertices_ = classify_vertices<ConcurrencyTag>(complex, order);
    places.make_critical_arcs();
    places.graph_ = reduce_arcs<ConcurrencyTag>(complex, order, places.critical_vertices_, places.critical_arcs_, ties,
                                                are_degree_two_nodes_kept, true);
    checked_index(places.graph_.nodes.size() + places.graph_.arcs.size());
    return places;
  }

  // The exact graph.
  const Flat_graph& graph() const { return graph_; }

  std::size_t number_of_vertices() const { return all_vertices_.size(); }

  // Calls visit(vertex, place) in ascending order. A place is the number of a node, or the number of nodes plus that of
  // an arc.
  template <class Visit>
  void for_each(const Visit& visit) const
  {
    for(const Swept_index i : all_vertices_.ascending())
    {
      const Vertex_index vertex = all_vertices_.vertex(i);
      const Node_index node = critical_graph_.node_of_critical[i];
      visit(vertex, node != no_index ? place_of_critical(critical_vertices_.ascending()[node.number()])
                                     : place_on_arc(vertex, critical_graph_.arc_of_critical[i]));
    }
  }

private:
  Vertex_places(const Complex& complex, const Order& order, Ties ties)
    : complex_(&complex),
      order_(&order),
      are_ties_contracted_(ties == Ties::CONTRACT)
  {}

  // The nodes of the graph of all critical vertices are these. With an order that contradicts itself, others can be.
  void make_critical_arcs()
  {
    const auto& ascending = critical_vertices_.ascending();
    for(const Node_index node : critical_graph_.nodes.keys())
    {
      const Vertex_index vertex = critical_graph_.nodes[node].vertex;
      if(node.number() >= ascending.size() || critical_vertices_.vertex(ascending[node.number()]) != vertex)
        complex_->throw_contradiction_near(vertex);
    }
    critical_arcs_.reserve(critical_graph_.arcs.size());
    for(const Flat_arc& arc : critical_graph_.arcs)
      critical_arcs_.push_back({node_of(ascending[arc.lower.number()]), node_of(ascending[arc.upper.number()]),
                                critical_graph_.pieces[arc.first_piece].first_step});
  }

  Index place_of_critical(Swept_index critical) const
  {
    const Node_index node = graph_.node_of_critical[critical];
    return node != no_index ? node.number()
                            : place_of_arc(graph_.arc_of_critical[critical], critical_vertices_.vertex(critical));
  }

  // The place of a regular vertex on an arc between critical vertices. On a plateau, it is where the end of the arc is.
  Index place_on_arc(Vertex_index vertex, Arc_index critical_arc) const
  {
    if(critical_arc == no_index)
      complex_->throw_contradiction_near(vertex);
    const Slab_arc& arc = critical_arcs_[Slab_arc_index(critical_arc.number())];
    for(const Swept_index end : {arc.lower_vertex(), arc.upper_vertex()})
    {
      if(are_ties_contracted_ && order_->are_tied(vertex, critical_vertices_.vertex(end)))
        return place_of_critical(end);
    }
    return place_of_arc(graph_.arc_of_critical_arc[Slab_arc_index(critical_arc.number())], vertex);
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
  Swept_vertices all_vertices_;
  Flat_graph critical_graph_; // with all critical vertices as nodes
  Swept_vertices critical_vertices_;
  Slab_arcs critical_arcs_; // the same arcs
  Flat_graph graph_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_VERTEX_PLACES_H
