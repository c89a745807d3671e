// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_ARC_SPREADING_H
#define CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_ARC_SPREADING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/engine/Slab.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/Vertex_queries.h>
#include <CGAL/Reeb_graph/internal/engine/contour_tracing.h>
#include <CGAL/Reeb_graph/internal/engine/monotone_paths.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Finds the arc between critical vertices that each regular vertex is on, without sorting the vertices.
//
// Along an edge whose ends lie strictly between the ends of an arc there is no place of another arc if one of its ends
// is on this one. So arcs spread from their chains over the edges. A vertex that they do not reach has no neighbor
// inside of its arc: that one is found along its contour, which crosses the chain of the arc.
template <class Complex, class Order>
class Arc_spreading
{
public:
  Arc_spreading(const Complex& complex,
                const Order& order,
                const Swept_vertices& critical_vertices,
                const Slab_arcs& arcs)
    : complex_(complex),
      order_(order),
      critical_vertices_(critical_vertices),
      arcs_(arcs),
      arc_of_vertex_(complex.number_of_vertices(), no_index)
  {}

  // Whether the arcs are short, so that many vertices have no neighbor inside of their arc: sweeping is faster then.
  static bool are_arcs_short(const Complex& complex, const Swept_vertices& critical_vertices)
  {
    return critical_vertices.size() > complex.number_of_vertices() / 16;
  }

  // Whether the arcs of all vertices have been found. It gives up if more than the given share of the vertices is out
  // of reach, or if their contours are long.
  template <class ConcurrencyTag>
  bool find_arcs_of_vertices(Arc_of_vertex& arc_of_vertex, double largest_share_out_of_reach = 0.125)
  {
    // Arcs have no vertex in common, unless the order contradicts itself.
    typedef std::conditional_t<Order::is_sure, ConcurrencyTag, Sequential_tag> Tag;
    for_each_index<Tag>(arcs_.size(), [&](std::size_t i) {
      std::vector<Vertex_index> reached;
      spread<Tag>(Slab_arc_index(i), arcs_[Slab_arc_index(i)].first_step.target, reached);
    });
    set_critical();
    const std::vector<Vertex_index> others = vertices_without_arc();
    const double largest_number = largest_share_out_of_reach * complex_.number_of_vertices();
    if(static_cast<double>(others.size()) > largest_number)
      return false;
    const bool are_all_found = others.empty() || find_arcs_along_contours(others, 8 * largest_number);
    arc_of_vertex = std::move(arc_of_vertex_);
    return are_all_found;
  }

private:
  // The arcs that begin, and those that end, at a critical vertex: their number, and one of them.
  struct Ends_of_arcs
  {
    Number number = 0;
    Slab_arc_index arc = no_index;

    void add(Slab_arc_index added)
    {
      ++number;
      arc = added;
    }
  };

  Vertex_index lower_vertex(Slab_arc_index arc) const { return critical_vertices_.vertex(arcs_[arc].lower_vertex()); }
  Vertex_index upper_vertex(Slab_arc_index arc) const { return critical_vertices_.vertex(arcs_[arc].upper_vertex()); }

  // Gives the arc to `start`, if that lies between its ends, and to all that can be reached from there.
  template <class Tag>
  void spread(Slab_arc_index arc, Vertex_index start, std::vector<Vertex_index>& reached)
  {
    const Vertex_index lower = lower_vertex(arc), upper = upper_vertex(arc);
    const auto is_between = [&](Vertex_index vertex) { return order_(lower, vertex) && order_(vertex, upper); };
    const auto is_free = [&](Vertex_index vertex) { return arc_of_vertex_[vertex] == no_index; };
    const auto reach = [&](Vertex_index vertex) {
      // Another thread may be writing the arc of a vertex that is not between the ends; alone, the fast test comes
      // first.
      if(is_parallel<Tag>() ? !is_between(vertex) || !is_free(vertex) : !is_free(vertex) || !is_between(vertex))
        return;
      arc_of_vertex_[vertex] = arc;
      reached.push_back(vertex);
    };
    reach(start);
    while(!reached.empty())
    {
      const Vertex_index vertex = reached.back();
      reached.pop_back();
      complex_.for_each_edge_around(vertex, [&](Vertex_index neighbor, Halfedge_index) { reach(neighbor); });
    }
  }

  void set_critical()
  {
    critical_of_vertex_.assign(complex_.number_of_vertices(), no_index);
    for(const Swept_index critical : critical_vertices_.indices())
      critical_of_vertex_[critical_vertices_.vertex(critical)] = critical;
  }

  std::vector<Vertex_index> vertices_without_arc() const
  {
    std::vector<Vertex_index> result;
    for(const Vertex_index vertex : complex_.vertices())
    {
      if(arc_of_vertex_[vertex] == no_index && critical_of_vertex_[vertex] == no_index && complex_.has_vertex(vertex))
        result.push_back(vertex);
    }
    return result;
  }

  bool find_arcs_along_contours(const std::vector<Vertex_index>& vertices, double largest_number_of_steps)
  {
    set_ends();
    std::vector<Vertex_index> reached;
    for(const Vertex_index vertex : vertices)
    {
      if(arc_of_vertex_[vertex] != no_index)
        continue;
      const Slab_arc_index arc = find_arc_along_contour(vertex, largest_number_of_steps);
      if(largest_number_of_steps < 0)
        return false;
      if(arc == no_index)
        complex_.throw_contradiction_near(vertex);
      spread<Sequential_tag>(arc, vertex, reached);
    }
    return true;
  }

  void set_ends()
  {
    upward_.resize(critical_vertices_.size());
    downward_.resize(critical_vertices_.size());
    for(const Slab_arc_index arc : arcs_.keys())
    {
      upward_[arcs_[arc].lower_vertex()].add(arc);
      downward_[arcs_[arc].upper_vertex()].add(arc);
      arc_of_first_edge_.emplace(edge_of(arcs_[arc].first_step.edge).number(), arc);
    }
  }

  // The arc of the contour just above a regular vertex, no_index if no steps are left or the order contradicts itself.
  Slab_arc_index find_arc_along_contour(Vertex_index vertex, double& steps_left) const
  {
    const auto is_below = [&](Vertex_index u) { return u == vertex || order_(u, vertex); };
    const Halfedge_index start = steepest_step(complex_, order_, vertex).edge;
    if(start == no_index)
      return no_index;
    Slab_arc_index arc = no_index;
    visit_contour(complex_, start, is_below, [&](Halfedge_index halfedge) {
      arc = arc_at_crossing(vertex, halfedge, is_below);
      return arc != no_index || --steps_left < 0;
    });
    return arc;
  }

  // The arc that an edge is on where it crosses the level just above `vertex`, if its ends tell.
  template <class IsBelow>
  Slab_arc_index arc_at_crossing(Vertex_index vertex, Halfedge_index halfedge, const IsBelow& is_below) const
  {
    Vertex_index lower = complex_.source(halfedge), upper = complex_.target(halfedge);
    if(!is_below(lower))
      std::swap(lower, upper);
    const Slab_arc_index arc_of_lower = arc_on_side(lower, upward_), arc_of_upper = arc_on_side(upper, downward_);
    if(arc_of_lower != no_index && order_(vertex, upper_vertex(arc_of_lower)))
      return arc_of_lower;
    if(arc_of_upper != no_index && order_(lower_vertex(arc_of_upper), vertex))
      return arc_of_upper;
    const auto first_edge = arc_of_first_edge_.find(edge_of(halfedge).number());
    return first_edge != arc_of_first_edge_.end() && order_(vertex, upper_vertex(first_edge->second))
           ? first_edge->second
           : Slab_arc_index(no_index);
  }

  // The arc of a regular vertex, or the only one of a critical vertex on one side.
  Slab_arc_index arc_on_side(Vertex_index vertex, const Indexed_vector<Swept_index, Ends_of_arcs>& ends) const
  {
    const Swept_index critical = critical_of_vertex_[vertex];
    if(critical == no_index)
      return arc_of_vertex_[vertex];
    return ends[critical].number == 1 ? ends[critical].arc : Slab_arc_index(no_index);
  }

  const Complex& complex_;
  const Order& order_;
  const Swept_vertices& critical_vertices_;
  const Slab_arcs& arcs_;
  Arc_of_vertex arc_of_vertex_;
  Indexed_vector<Vertex_index, Swept_index> critical_of_vertex_; // no_index if it is regular
  Indexed_vector<Swept_index, Ends_of_arcs> upward_;
  Indexed_vector<Swept_index, Ends_of_arcs> downward_;
  std::unordered_map<Number, Slab_arc_index> arc_of_first_edge_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_ARC_SPREADING_H
