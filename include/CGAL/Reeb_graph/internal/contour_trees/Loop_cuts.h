// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_LOOP_CUTS_H
#define CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_LOOP_CUTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Large_vector.h>

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Contours along which the surface is cut, each just below a critical vertex that it touches. A cut adds two nodes
// to the trees: one below it, a maximum joined to the lower ends of the crossed edges, and one above it, a minimum
// joined to the upper ends.
class Loop_cuts
{
public:
  Loop_cuts(Index number_of_other_nodes, Index number_of_edges)
    : number_of_other_nodes_(number_of_other_nodes),
      number_of_edges_(number_of_edges)
  {}

  // Adds a contour just below the critical vertex `critical`, the top of whose sublevel component is
  // `sublevel_class`. Critical vertices have to come in descending order: an edge keeps its lowest contour.
  template <class HalfedgeRange>
  void add(Index critical, Index sublevel_class, const HalfedgeRange& crossed_edges)
  {
    critical_vertices_.push_back(critical);
    sublevel_classes_.push_back(sublevel_class);
    unregistered_edges_.insert(unregistered_edges_.end(), crossed_edges.begin(), crossed_edges.end());
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
    Index cut = size() - static_cast<Index>(ends_of_unregistered_.size());
    for(const std::size_t end : ends_of_unregistered_)
    {
      for(; i != end; ++i)
        register_edge(edge_of(unregistered_edges_[i]), cut);
      ++cut;
    }
    unregistered_edges_.clear();
    ends_of_unregistered_.clear();
  }

  Index size() const { return static_cast<Index>(critical_vertices_.size()); }
  Index number_of_nodes() const { return number_of_other_nodes_ + 2 * size(); }
  Index node_below(Index cut) const { return number_of_other_nodes_ + 2 * cut; }
  Index node_above(Index cut) const { return node_below(cut) + 1; }

  bool is_node_below(Index node) const { return is_cut_node(node) && (node - number_of_other_nodes_) % 2 == 0; }
  bool is_node_above(Index node) const { return is_cut_node(node) && (node - number_of_other_nodes_) % 2 == 1; }
  Index cut_of_node(Index node) const { return (node - number_of_other_nodes_) / 2; }

  Index critical_vertex(Index cut) const { return critical_vertices_[cut]; }
  Index sublevel_class(Index cut) const { return sublevel_classes_[cut]; }

  bool has_registered_edges() const { return !is_edge_cut_.empty(); }

  // The lowest registered contour that crosses the edge of the halfedge, no_index if there is none.
  Index lowest_at_edge(Index halfedge) const
  {
    const Index edge = edge_of(halfedge);
    if(!has_registered_edges() || !is_edge_cut_[edge])
      return no_index;
    return lowest_cuts_.empty() ? few_lowest_cuts_.find(edge)->second : lowest_cuts_[edge];
  }

private:
  void register_edge(Index edge, Index cut)
  {
    is_edge_cut_[edge] = true;
    (lowest_cuts_.empty() ? few_lowest_cuts_[edge] : lowest_cuts_[edge]) = cut;
  }

  void switch_to_array()
  {
    lowest_cuts_.resize(number_of_edges_);
    for(const auto& [edge, cut] : few_lowest_cuts_)
      lowest_cuts_[edge] = cut;
    few_lowest_cuts_.clear();
  }

  bool is_cut_node(Index node) const { return node >= number_of_other_nodes_; }

  Index number_of_other_nodes_;
  Index number_of_edges_;
  Large_vector<Index> critical_vertices_;
  Large_vector<Index> sublevel_classes_;
  Large_vector<Index> unregistered_edges_;
  std::vector<std::size_t> ends_of_unregistered_; // of the last cuts, each in unregistered_edges_
  // By edge. With few cut edges, to touch the pages of an array would take longer than all else that
  // has to do with cuts; with many, a hash map would.
  std::unordered_map<Index, Index> few_lowest_cuts_;
  Large_vector<Index> lowest_cuts_; // unset where no cut is
  std::vector<bool> is_edge_cut_;   // asked first; empty as long as nothing is registered
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_LOOP_CUTS_H
