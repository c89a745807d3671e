// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_CUT_LOOPS_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_CUT_LOOPS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/engine/Merge_tree_sweep.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

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
template <class Complex>
class Cutting_sweep : public Merge_tree_sweep<Complex, Side::UPPER>
{
  typedef Merge_tree_sweep<Complex, Side::UPPER> Base;

public:
  Cutting_sweep(const Slab<Complex>& slab, const Vertex_order& order)
    : Base(slab, order),
      complex_(slab.complex()),
      cuts_(slab.number_of_nodes(), slab.complex().number_of_edges())
  {}

  void find_path_ends(const Threads& threads)
  {
    Base::find_path_ends(threads);
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
        if(path_ends_.is_known(neighbor) && path_ends_.next_vertex(neighbor) == vertex)
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
    const Index number = critical_numbers_[vertex];
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
    if(const Index number = critical_numbers_[vertices[i + ahead]]; number != 0)
      critical_vertices_.prefetch(Swept_index(number - 1));
    if(const Index number = critical_numbers_[vertices[i + near_ahead]]; number != 0)
      critical_vertices_.prefetch_sectors(Swept_index(number - 1), Side::UPPER);
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
  Indexed_vector<Vertex_index, Index> critical_numbers_; // from 1 on; 0 if it is not critical
  bool are_paths_walked_late_ = true;                    // each when its vertex is merged
  std::size_t number_of_corrections_ = 0;
  std::size_t number_of_steps_ = 0; // of corrections
};

// The lower contours of vertices, by the sublevel components that they are in, and those of them that close loops.
// `Search` finds contours of one level by turns.
template <class Complex, class Search>
class Lower_contours
{
public:
  Lower_contours(const Slab<Complex>& slab,
                 const Vertex_order& order,
                 const Merge_tree& join_tree,
                 const Merge_tree& split_tree)
    : complex_(slab.complex()),
      order_(order),
      critical_vertices_(slab.critical_vertices()),
      join_tree_(join_tree),
      split_tree_(split_tree),
      search_(complex_)
  {}

  // Traces lower contours of the vertex, and calls visit(its sublevel class, halfedges of the crossed edges, each from
  // its lower end to its higher one, whether they reach the border) for all but one of each sublevel component.
  template <class Visit>
  void visit_loop_contours(Swept_index critical, const Visit& visit)
  {
    sort_contours(critical);
    const auto is_below = [&, vertex = critical_vertices_.vertex(critical)](Vertex_index u) {
      return order_(u, vertex);
    };
    Plain_vector<Halfedge_index> starts;
    const auto end_of_all = contours_of_vertex_.end();
    for(auto begin = contours_of_vertex_.begin(), end = begin; begin != end_of_all; begin = end)
    {
      starts.clear();
      for(; end != end_of_all && end->sublevel_class == begin->sublevel_class; ++end)
        starts.push_back(critical_vertices_.sector(Side::LOWER, end->sector).edge);
      const std::size_t number_of_earlier_steps = search_.number_of_steps();
      bool is_loop_closed = false;
      search_.visit_all_but_one(starts, is_below, [&](const auto& crossed_edges, bool is_border_reached) {
        is_loop_closed = true;
        visit(begin->sublevel_class, crossed_edges, is_border_reached);
      });
      number_of_lost_steps_ += is_loop_closed ? 0 : search_.number_of_steps() - number_of_earlier_steps;
    }
  }

  // How many steps searches have taken.
  std::size_t number_of_steps() const { return search_.number_of_steps(); }

protected:
  // A lower contour of a vertex, and one sector that it passes.
  struct Lower_contour
  {
    Tree_node sublevel_class;
    Index name;
    Sector_index sector;
  };

  const Merge_tree& tree(Side side) const { return side == Side::UPPER ? split_tree_ : join_tree_; }

  void sort_classes(Swept_index critical, Side side)
  {
    classes_.clear();
    for(const Sector_index i : critical_vertices_.sectors(critical, side))
      classes_.push_back(tree(side).classes[i]);
    std::sort(classes_.begin(), classes_.end());
  }

  // The number of distinct classes at a vertex, at once for simple saddles, as nearly all are.
  Index count_classes(Swept_index critical, Side side)
  {
    if(critical_vertices_.number_of_sectors(critical, side) == 2)
      return tree(side).is_class_shared[critical] ? 1 : 2;
    sort_classes(critical, side);
    return static_cast<Index>(std::unique(classes_.begin(), classes_.end()) - classes_.begin());
  }

  // Sorts the lower contours of a vertex by their classes. Where contours have not been found before, each sector may
  // have one of its own.
  void sort_contours(Swept_index critical)
  {
    contours_of_vertex_.clear();
    for(const Sector_index i : critical_vertices_.sectors(critical, Side::LOWER))
    {
      const bool is_found = contours_.contains(i) && contours_[i] != no_index;
      contours_of_vertex_.push_back({join_tree_.classes[i], is_found ? contours_[i] : i.number(), i});
    }
    const auto begin = contours_of_vertex_.begin(), end = contours_of_vertex_.end();
    std::sort(begin, end, [](const Lower_contour& a, const Lower_contour& b) {
      return std::tie(a.sublevel_class, a.name) < std::tie(b.sublevel_class, b.name);
    });
    const auto are_same = [](const Lower_contour& a, const Lower_contour& b) { return a.name == b.name; };
    contours_of_vertex_.erase(std::unique(begin, end, are_same), end);
  }

  const Complex& complex_;
  const Vertex_order& order_;
  const Swept_vertices& critical_vertices_;
  const Merge_tree& join_tree_;
  const Merge_tree& split_tree_;
  Search search_;
  Plain_vector<Tree_node> classes_;
  std::vector<Lower_contour> contours_of_vertex_; // of the last one
  // By lower sector; no_index where none has been looked for. Empty on a surface, where none is.
  Indexed_vector<Sector_index, Index> contours_;
  std::size_t number_of_lost_steps_ = 0; // of searches that have closed no loop
};

// Finds contours along which the surface has to be cut so that its Reeb graph becomes a tree: at each vertex where
// several lower contours meet, one of each sublevel component stays, the others close loops. They are traced only where
// counting the components cannot exclude a loop. (Loop surgery is that of J. Tierny, A. Gyulassy, E. Simon, V. Pascucci,
// 2009; where the loops are is counted here.)
template <class Complex>
class Loop_surgery : public Lower_contours<Complex, Contours_side_by_side<Complex>>
{
  typedef Lower_contours<Complex, Contours_side_by_side<Complex>> Base;

public:
  using Base::Base;

  // Whether two lower contours at the vertex might be in one sublevel component. May err to the safe side. The classes
  // of the superlevel components can be those of the surface with the cuts further up: that can only exclude more.
  bool can_close_loop(Swept_index critical)
  {
    if(!join_tree_.is_class_shared[critical])
      return false;
    // With closed contours on one side, as many loops are closed at the vertex, here or above and below, as its
    // multiplicity exceeds the merges of both trees: none if all upper classes are different.
    const bool is_on_border = critical_vertices_.is_on_border(critical);
    if(is_on_border || (is_border_reached(critical, Side::UPPER) && is_border_reached(critical, Side::LOWER)))
      return count_joined_lower_sectors(critical, is_on_border) > count_classes(critical, Side::LOWER);
    return split_tree_.is_class_shared[critical]
        && critical_vertices_.number_of_lower_sectors(critical) + 1
             > count_classes(critical, Side::LOWER) + count_classes(critical, Side::UPPER);
  }

private:
  bool is_border_reached(Swept_index critical, Side side) const
  {
    bool result = false;
    for(const Sector_index i : critical_vertices_.sectors(critical, side))
      result |= tree(side).is_border_reached[tree(side).classes[i]];
    return result;
  }

  // Joins the two lower sectors beside each upper one that is alone in a component without border, as the closed
  // contour just above that sector is that component's only one here, and one contour just below runs along it. No two
  // are joined twice: inside of the surface, some upper sector is in a component with border.
  Index count_joined_lower_sectors(Swept_index critical, bool is_on_border)
  {
    this->sort_classes(critical, Side::UPPER);
    const Index number_of_lower_sectors = critical_vertices_.number_of_lower_sectors(critical);
    const Index number_of_upper_sectors = critical_vertices_.number_of_upper_sectors(critical);
    const Sector_index first = critical_vertices_.first_sector(critical, Side::UPPER);
    const bool is_first_upper = critical_vertices_.is_first_upper(critical);
    Index result = number_of_lower_sectors;
    for(Index i = 0; i != number_of_upper_sectors; ++i)
    {
      const Tree_node upper_class = split_tree_.classes[Sector_index(first.number() + i)];
      const auto range = std::equal_range(classes_.begin(), classes_.end(), upper_class);
      // On the border, an upper sector at an end of the link has one lower sector beside it.
      const bool is_at_end = is_on_border && (is_first_upper ? i : i + 1) % number_of_lower_sectors == 0;
      if(!is_at_end && range.second - range.first == 1 && !split_tree_.is_border_reached[upper_class])
        --result;
    }
    return result;
  }

  using Base::classes_;
  using Base::count_classes;
  using Base::critical_vertices_;
  using Base::join_tree_;
  using Base::split_tree_;
  using Base::tree;
};

// The class for a complex that may be no surface, which only headers for soups include.
template <>
class Loop_surgery<Simplicial_complex>;

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_CUT_LOOPS_H
