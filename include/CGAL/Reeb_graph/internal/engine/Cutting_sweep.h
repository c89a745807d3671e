// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_CUTTING_SWEEP_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_CUTTING_SWEEP_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/tuning.h>
#include <CGAL/Reeb_graph/internal/engine/Slab.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_arcs.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/merge_trees.h>
#include <CGAL/Reeb_graph/internal/engine/vertex_links.h>

#include <cstddef>
#include <unordered_map>
#include <utility>

namespace CGAL::Reeb_graph::internal {

struct Cut_tag;
typedef Index_of<Cut_tag> Cut_index;

// Contours along which the surface is cut so that no loop is left, each just below a critical vertex that it touches. A
// cut adds two nodes to the trees: one below it, a maximum joined to the lower ends of the crossed edges, and one above
// it, a minimum joined to the upper ends.
class Contour_cuts
{
public:
  Contour_cuts(Number number_of_other_nodes, Number number_of_edges)
    : number_of_other_nodes_(number_of_other_nodes),
      number_of_edges_(number_of_edges)
  {}

  // Adds a contour just below the critical vertex `critical`, the top of whose sublevel component is
  // `sublevel_class`. Critical vertices have to come in descending order: an edge keeps its lowest contour.
  void add(Swept_index critical, Tree_node sublevel_class, const Plain_vector<Halfedge_index>& crossed_edges)
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
  Tree_node node_below(Cut_index cut) const { return Tree_node(number_of_other_nodes_ + 2 * cut.number()); }
  Tree_node node_above(Cut_index cut) const { return Tree_node(number_of_other_nodes_ + 2 * cut.number() + 1); }

  bool is_cut_node(Tree_node node) const { return node.number() >= number_of_other_nodes_; }
  Cut_index cut_of_node(Tree_node node) const { return Cut_index(place_of_node(node) / 2); }

  Swept_index critical_vertex(Cut_index cut) const { return critical_vertices_[cut]; }
  Tree_node sublevel_class(Cut_index cut) const { return sublevel_classes_[cut]; }

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

  Number place_of_node(Tree_node node) const { return node.number() - number_of_other_nodes_; }

  Number number_of_other_nodes_;
  Number number_of_edges_;
  Indexed_vector<Cut_index, Swept_index> critical_vertices_;
  Indexed_vector<Cut_index, Tree_node> sublevel_classes_;
  Plain_vector<Halfedge_index> unregistered_edges_;
  Plain_vector<std::size_t> ends_of_unregistered_; // by one of the last cuts: where its unregistered edges end
  // The lowest cuts at edges. With few cut edges, to touch the pages of an array would take longer than all else that
  // has to do with cuts; with many, a hash map would.
  std::unordered_map<Number, Cut_index> few_lowest_cuts_;
  Indexed_vector<Edge_index, Cut_index> lowest_cuts_; // unset where no cut is
  Indexed_vector<Edge_index, bool> is_edge_cut_;      // asked first; empty as long as nothing is registered
};

// Arcs that end at a cut go on to the vertex just above, and the short arcs from the cut to there are dropped: no
// vertex is on one of these. Calls rename(arc, its new name) for the other ones.
template <class Rename>
void glue_cuts(const Contour_cuts& cuts, Swept_arcs& arcs, const Rename& rename)
{
  Swept_arc_index next(0);
  for(const Swept_arc_index i : arcs.keys())
  {
    Swept_arc arc = arcs[i];
    if(cuts.is_cut_node(arc.lower))
      continue;
    if(cuts.is_cut_node(arc.upper))
      arc.upper = node_of(cuts.critical_vertex(cuts.cut_of_node(arc.upper)));
    arcs[next] = arc;
    rename(i, next);
    ++next;
  }
  arcs.resize(next.number());
}

// The sweep for the split tree of a surface that is cut on the way. A cut ends the paths of vertices further down, so
// their ends, if found before, have to be corrected.
template <class Complex, class Order>
class Cutting_sweep : public Merge_tree_sweep<Complex, Order, Side::UPPER>
{
  typedef Merge_tree_sweep<Complex, Order, Side::UPPER> Base;

public:
  Cutting_sweep(const Slab<Complex>& slab, const Order& order)
    : Base(slab, order),
      complex_(slab.complex()),
      cuts_(slab.number_of_nodes(), slab.complex().number_of_edges())
  {}

  template <class ConcurrencyTag>
  void find_path_ends()
  {
    Base::template find_path_ends<ConcurrencyTag>();
    are_paths_walked_late_ = false;
  }

  void prefetch_components(Swept_index critical) const
  {
    if(!are_paths_walked_late_)
      Base::prefetch_components(critical);
  }

  void merge_at(Swept_index critical)
  {
    if(are_paths_walked_late_)
    {
      for(const Sector_index i : critical_vertices_.sectors(critical, Side::UPPER))
        this->find_path_end(i, end_at_cut_or_level(), passed_);
    }
    Base::merge_at(critical);
  }

  // The class of a regular vertex; see Merge_tree_sweep.
  Tree_node class_of(Vertex_index vertex)
  {
    return are_paths_walked_late_ ? Base::class_of(vertex, end_at_cut_or_level(), passed_) : Base::class_of(vertex);
  }

  // Cuts along a contour just below the critical vertex that has been merged at last; see Contour_cuts. Its halfedges are
  // ascending.
  void cut(Swept_index critical,
           Tree_node sublevel_class,
           const Plain_vector<Halfedge_index>& crossed_edges,
           bool has_border)
  {
    const Cut_index cut = cuts_.next_cut();
    cuts_.add(critical, sublevel_class, crossed_edges);
    this->put_on_last(critical, cuts_.node_above(cut));
    components_of_cuts_.push_back(this->add_component_of_cut(cuts_.node_below(cut), has_border));
    if(!are_paths_walked_late_)
      correct_path_ends(crossed_edges);
    if(are_paths_walked_late_)
      cuts_.register_edges();
  }

  Contour_cuts take_cuts() { return std::move(cuts_); }

  // How many edges and sectors corrections have looked at.
  std::size_t number_of_steps() const { return number_of_steps_; }

private:
  // A path meets a cut before the upper level of the slab.
  auto end_at_cut_or_level() const
  {
    return [this, end_at_level = this->end_at_level()](Vertex_index target, const auto& find_edge) {
      const Cut_index cut = cuts_.has_registered_edges() ? cuts_.lowest_at_edge(find_edge()) : no_index;
      return cut == no_index ? end_at_level(target, find_edge) : components_of_cuts_[cut];
    };
  }

  // Goes down against the paths from where they meet the last cut. If that gets more expensive than to walk all of them
  // again, this is left to merge_at(); then no later cut, as it is further down, can change an end that is known.
  void correct_path_ends(const Plain_vector<Halfedge_index>& crossed_edges)
  {
    if(critical_numbers_.empty())
      number_critical_vertices();
    Plain_vector<Vertex_index> lower_ends;
    lower_ends.reserve(crossed_edges.size());
    for(const Halfedge_index edge : crossed_edges)
      lower_ends.push_back(complex_.source(edge));
    Plain_vector<Vertex_index> corrected;
    Vertex_index last = no_index, next_of_last = no_index; // Many edges in a row can end at one vertex.
    for(std::size_t i = 0; i != crossed_edges.size(); ++i)
    {
      prefetch_ahead(lower_ends, i);
      const Vertex_index lower = lower_ends[i];
      const Edge_index edge = edge_of(crossed_edges[i]);
      correct_components(lower, [edge](const Link_sector& sector) { return edge_of(sector.edge) == edge; });
      if(are_corrections_expensive())
      {
        are_paths_walked_late_ = true;
        break;
      }
      if(lower != last)
      {
        last = lower;
        next_of_last = path_ends_.is_known(lower) ? path_ends_.next_vertex(lower) : no_index;
      }
      if(complex_.target(crossed_edges[i]) == next_of_last && edge_of(path_ends_.next_edge(lower)) == edge)
        correct_path_end(lower, corrected);
    }
    for(; !corrected.empty() && !are_paths_walked_late_; ++number_of_corrections_)
    {
      const Vertex_index vertex = corrected.back();
      corrected.pop_back();
      complex_.for_each_edge_around(vertex, [&](Vertex_index neighbor, Halfedge_index) {
        ++number_of_steps_;
        if(!order_(neighbor, vertex))
          return;
        correct_components(neighbor, [vertex](const Link_sector& sector) { return sector.extreme_neighbor == vertex; });
        if(is_on_known_path(neighbor, vertex))
          correct_path_end(neighbor, corrected);
      });
      are_paths_walked_late_ = number_of_corrections_ >= critical_vertices_.size() || are_corrections_expensive();
    }
    if(are_paths_walked_late_)
      this->forget_path_ends();
  }

  // Whether corrections have looked at far more edges and sectors than there are, as many cuts near one vertex that has
  // many of them do.
  bool are_corrections_expensive() const
  {
    constexpr std::size_t most_steps_per_sector = 16;
    return number_of_steps_
         > complex_.number_of_edges() + most_steps_per_sector * critical_vertices_.total_number_of_sectors(Side::UPPER);
  }

  void number_critical_vertices()
  {
    critical_numbers_.resize(complex_.number_of_vertices(), 0);
    for(const Swept_index i : critical_vertices_.indices())
      critical_numbers_[critical_vertices_.vertex(i)] = i.number() + 1;
  }

  // Corrects the components of the upper sectors from which a path now meets the last cut.
  template <class IsChanged>
  void correct_components(Vertex_index vertex, const IsChanged& is_changed)
  {
    const Number number = critical_numbers_[vertex];
    if(number == 0)
      return;
    number_of_steps_ += critical_vertices_.number_of_upper_sectors(Swept_index(number - 1));
    for(const Sector_index i : critical_vertices_.sectors(Swept_index(number - 1), Side::UPPER))
    {
      if(is_changed(critical_vertices_.sector(Side::UPPER, i)))
        this->sector_components_[i] = components_of_cuts_.back();
    }
  }

  // Prefetches what correct_components() and the ends of paths need, which lead from one to the next.
  void prefetch_ahead(const Plain_vector<Vertex_index>& vertices, std::size_t i) const
  {
    constexpr std::size_t far_ahead = 24, ahead = 16, near_ahead = 8;
    if(i + far_ahead >= vertices.size())
      return;
    const Vertex_index vertex = vertices[i + far_ahead];
    prefetch(&critical_numbers_[vertex]);
    critical_vertices_.kept_neighbors().prefetch(vertex);
    path_ends_.prefetch(vertex);
    if(const Number number = critical_numbers_[vertices[i + ahead]]; number != 0)
      critical_vertices_.prefetch(Swept_index(number - 1));
    if(const Number number = critical_numbers_[vertices[i + near_ahead]]; number != 0)
      critical_vertices_.prefetch_sectors(Swept_index(number - 1), Side::UPPER);
  }

  // Whether the end of a path that goes from `lower` to `higher` is known.
  bool is_on_known_path(Vertex_index lower, Vertex_index higher) const
  {
    return path_ends_.is_known(lower) && path_ends_.next_vertex(lower) == higher;
  }

  // Corrects the end of the path from a vertex, once, as several edges may lead there.
  void correct_path_end(Vertex_index vertex, Plain_vector<Vertex_index>& corrected)
  {
    if(path_ends_.end(vertex) == components_of_cuts_.back())
      return;
    path_ends_.set_end(vertex, components_of_cuts_.back());
    corrected.push_back(vertex);
  }

  using Base::critical_vertices_;
  using Base::order_;
  using Base::passed_;
  using Base::path_ends_;

  const Complex& complex_;
  Contour_cuts cuts_;
  Indexed_vector<Cut_index, Component_index> components_of_cuts_;
  Indexed_vector<Vertex_index, Number> critical_numbers_; // from 1 on; 0 if it is not critical
  bool are_paths_walked_late_ = true;                     // each when its vertex is merged
  std::size_t number_of_corrections_ = 0;
  std::size_t number_of_steps_ = 0; // of corrections
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_CUTTING_SWEEP_H
