// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_LOOP_CUTS_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_LOOP_CUTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/engine/Slab.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/combine_trees.h>

#include <algorithm>
#include <cstddef>
#include <unordered_map>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

struct Cut_tag;
typedef Index_of<Cut_tag> Cut_index;

// Contours along which the surface is cut so that no loop is left, each just below a critical vertex that it touches. A
// cut adds two nodes to the trees: one below it, a maximum joined to the lower ends of the crossed edges, and one above
// it, a minimum joined to the upper ends.
class Loop_cuts
{
public:
  Loop_cuts(Number number_of_other_nodes, Number number_of_edges)
    : number_of_other_nodes_(number_of_other_nodes),
      number_of_edges_(number_of_edges)
  {}

  // Adds a contour just below the critical vertex `critical`, the top of whose sublevel component is
  // `sublevel_class`. Critical vertices have to come in descending order: an edge keeps its lowest contour.
  void add(Swept_index critical, Slab_node sublevel_class, const Plain_vector<Halfedge_index>& crossed_edges)
  {
    critical_vertices_.push_back(critical);
    sublevel_classes_.push_back(sublevel_class);
    unregistered_edges_.append(crossed_edges.begin(), crossed_edges.end());
    ends_of_unregistered_.push_back(unregistered_edges_.size());
    if(unregistered_edges_.size() > number_of_edges_) // So that they never take more memory than the registered ones.
      register_edges();
  }

  // Lets lowest_at_edge() know the contours that have been added since the last call. Done on demand, as it takes
  // longer than all else here, and is seldom needed.
  void register_edges()
  {
    is_edge_cut_.resize(number_of_edges_, false);
    if(unregistered_edges_.size() + few_lowest_cuts_.size() > number_of_edges_ / 32)
      switch_to_array();
    std::size_t i = 0;
    Cut_index cut(size() - ends_of_unregistered_.size());
    for(const std::size_t end : ends_of_unregistered_)
    {
      for(; i != end; ++i)
        register_edge(edge_of(unregistered_edges_[i]), cut);
      ++cut;
    }
    unregistered_edges_.clear();
    ends_of_unregistered_.clear();
  }

  Number size() const { return static_cast<Number>(critical_vertices_.size()); }
  Index_range<Cut_index> cuts() const { return critical_vertices_.keys(); }
  Cut_index next_cut() const { return critical_vertices_.end_key(); }

  Number number_of_nodes() const { return number_of_other_nodes_ + 2 * size(); }
  Slab_node node_below(Cut_index cut) const { return Slab_node(number_of_other_nodes_ + 2 * cut.number()); }
  Slab_node node_above(Cut_index cut) const { return Slab_node(number_of_other_nodes_ + 2 * cut.number() + 1); }

  bool is_cut_node(Slab_node node) const { return node.number() >= number_of_other_nodes_; }
  Cut_index cut_of_node(Slab_node node) const { return Cut_index(place_of_node(node) / 2); }

  Swept_index critical_vertex(Cut_index cut) const { return critical_vertices_[cut]; }
  Slab_node sublevel_class(Cut_index cut) const { return sublevel_classes_[cut]; }

  bool has_registered_edges() const { return !is_edge_cut_.empty(); }

  // The lowest registered contour that crosses the edge of the halfedge, no_index if there is none.
  Cut_index lowest_at_edge(Halfedge_index halfedge) const
  {
    const Edge_index edge = edge_of(halfedge);
    if(!has_registered_edges() || !is_edge_cut_[edge])
      return no_index;
    return lowest_cuts_.empty() ? few_lowest_cuts_.find(edge.number())->second : lowest_cuts_[edge];
  }

private:
  void register_edge(Edge_index edge, Cut_index cut)
  {
    is_edge_cut_[edge] = true;
    (lowest_cuts_.empty() ? few_lowest_cuts_[edge.number()] : lowest_cuts_[edge]) = cut;
  }

  void switch_to_array()
  {
    lowest_cuts_.resize(number_of_edges_);
    for(const auto& [edge, cut] : few_lowest_cuts_)
      lowest_cuts_[Edge_index(edge)] = cut;
    few_lowest_cuts_.clear();
  }

  Number place_of_node(Slab_node node) const { return node.number() - number_of_other_nodes_; }

  Number number_of_other_nodes_;
  Number number_of_edges_;
  Indexed_vector<Cut_index, Swept_index> critical_vertices_;
  Indexed_vector<Cut_index, Slab_node> sublevel_classes_;
  Plain_vector<Halfedge_index> unregistered_edges_;
  Plain_vector<std::size_t> ends_of_unregistered_; // by one of the last cuts: where its unregistered edges end
  // The lowest cuts at edges. With few cut edges, to touch the pages of an array would take longer than all else that
  // has to do with cuts; with many, a hash map would.
  std::unordered_map<Number, Cut_index> few_lowest_cuts_;
  Indexed_vector<Edge_index, Cut_index> lowest_cuts_; // unset where no cut is
  Indexed_vector<Edge_index, bool> is_edge_cut_;      // asked first; empty as long as nothing is registered
};

// Arcs that end at a cut go on to the vertex just above, and the short arcs from the cut to there are dropped.
inline void glue_cuts(const Loop_cuts& cuts, Slab_arcs& arcs)
{
  if(cuts.size() == 0)
    return;
  const auto begins_at_cut = [&](const Slab_arc& arc) { return cuts.is_cut_node(arc.lower); };
  arcs.erase(std::remove_if(arcs.begin(), arcs.end(), begins_at_cut), arcs.end());
  for(Slab_arc& arc : arcs)
  {
    if(cuts.is_cut_node(arc.upper))
      arc.upper = node_of(cuts.critical_vertex(cuts.cut_of_node(arc.upper)));
  }
}

// Names the arcs, which have not been glued yet, as glue_cuts() leaves them. No vertex is on one that it drops.
inline void rename_glued_arcs(const Loop_cuts& cuts, const Slab_arcs& arcs, Arcs_of_classes& arcs_of_classes)
{
  if(cuts.size() == 0)
    return;
  Indexed_vector<Slab_arc_index, Slab_arc_index> new_names(arcs.size(), no_index);
  Slab_arc_index next(0);
  for(const Slab_arc_index i : arcs.keys())
  {
    if(cuts.is_cut_node(arcs[i].lower))
      continue;
    new_names[i] = next;
    ++next;
  }
  for(const Side side : both_sides)
  {
    for(Slab_arc_index& arc : arcs_of_classes[side])
      arc = arc == no_index ? arc : new_names[arc];
  }
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_LOOP_CUTS_H
