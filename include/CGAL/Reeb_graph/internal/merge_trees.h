// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_MERGE_TREES_H
#define CGAL_REEB_GRAPH_INTERNAL_MERGE_TREES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/Cut_contours.h>
#include <CGAL/Reeb_graph/internal/Disjoint_sets.h>
#include <CGAL/Reeb_graph/internal/Triangle_complex.h>
#include <CGAL/Reeb_graph/internal/ascending_path.h>
#include <CGAL/Reeb_graph/internal/classify_vertices.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Finds the node in which a monotone path ends, descending for the join tree and ascending for the split tree: the
// first critical vertex on it, or the cut contour in its way. A regular vertex is passed once: its end is kept.
template <class Order, bool is_ascending>
class Monotone_path_ends
{
public:
  Monotone_path_ends(const Triangle_complex& complex,
                     const Order& order,
                     const Critical_vertices& critical_vertices,
                     const Cut_contours& cuts)
    : complex_(complex),
      order_(order),
      cuts_(cuts),
      ends_(complex.number_of_vertices(), no_index)
  {
    for(Index i = 0; i != critical_vertices.size(); ++i)
      ends_[critical_vertices.vertex(i)] = i;
  }

  // The end of the path that begins with the edge that the corner `edge` faces, towards `target`.
  Index operator()(Index edge, Index target)
  {
    passed_.clear();
    Index end = end_of_edge(edge, target);
    while(end == no_index)
    {
      passed_.push_back(target);
      complex_.visit_edges_around(target, [&, from = target](Index neighbor, Index corner) {
        if(is_ascending ? !order_(from, neighbor) : !order_(neighbor, from))
          return false;
        edge = corner;
        target = neighbor;
        return true;
      });
      end = end_of_edge(edge, target);
    }
    for(const Index vertex : passed_)
      ends_[vertex] = end;
    return end;
  }

private:
  Index end_of_edge(Index edge, Index target) const
  {
    if constexpr(is_ascending)
    {
      const Index cut = cuts_.lowest_on_edge(edge);
      if(cut != no_index)
        return cuts_.node_below(cut);
    }
    return ends_[target];
  }

  const Triangle_complex& complex_;
  const Order& order_;
  const Cut_contours& cuts_;
  std::vector<Index> ends_; // by vertex
  std::vector<Index> passed_;
};

// How the components of the sublevel sets merge when the level rises (join tree), or those of the superlevel sets
// when it falls (split tree). Nodes are the critical vertices, and in the split tree those that cut contours add.
struct Merge_tree
{
  std::vector<Index> parents;              // by node: where its component merges; no_index at a root
  std::vector<bool> is_border_reached;     // by node: whether the component of which it is the top has border
  std::vector<Index> sector_classes;       // by link sector: the top of its component when the sweep arrives
  std::vector<Ascending_step> first_steps; // by node of a split tree: the first step from the parent to its side
};

// The sweep over the critical vertices that builds a merge tree from the ends of monotone paths. (Y. Chiang, T. Lenz,
// X. Lu, G. Rote, Simple and optimal output-sensitive construction of contour trees using monotone paths, 2005.)
template <class Order, bool is_split_tree>
class Merge_tree_sweep
{
public:
  Merge_tree_sweep(const Triangle_complex& complex,
                   const Order& order,
                   const Critical_vertices& critical_vertices,
                   const Cut_contours& cuts)
    : order_(order),
      critical_vertices_(critical_vertices),
      cuts_(cuts),
      path_ends_(complex, order, critical_vertices, cuts),
      sets_(cuts.number_of_nodes())
  {
    tree_.parents.assign(cuts.number_of_nodes(), no_index);
    tree_.is_border_reached.assign(cuts.number_of_nodes(), false);
    tree_.sector_classes.assign(critical_vertices.total_number_of_sectors(), no_index);
    if(is_split_tree)
      tree_.first_steps.assign(cuts.number_of_nodes(), {no_index, no_index});
    // A border vertex reaches a critical one along the border, downwards or upwards: the flags of those suffice.
    for(Index i = 0; i != critical_vertices.size(); ++i)
      tree_.is_border_reached[i] = complex.is_on_border(critical_vertices.vertex(i));
  }

  Merge_tree operator()()
  {
    // Paths are walked where they are on the surface, before the order of the field jumps about on it.
    for(Index i = 0; i != critical_vertices_.size(); ++i)
      find_path_ends(i);
    const std::vector<Index>& ascending = critical_vertices_.ascending();
    if constexpr(!is_split_tree)
    {
      for(const Index critical : ascending)
        merge_at(critical);
    }
    else
    {
      Index remaining_cuts = cuts_.size();
      for(auto critical = ascending.rbegin(); critical != ascending.rend(); ++critical)
      {
        merge_at(*critical);
        while(remaining_cuts != 0 && cuts_.critical_vertex(remaining_cuts - 1) == *critical)
          put_on(sets_.top(*critical), cuts_.node_above(--remaining_cuts));
      }
    }
    return std::move(tree_);
  }

private:
  // Calls visit(sector, class of the sector) for the sectors on the side from which the sweep comes.
  template <class Visit>
  void for_each_swept_sector(Index critical, const Visit& visit)
  {
    auto sector_class = tree_.sector_classes.begin() + critical_vertices_.first_sector(critical);
    for(const Link_sector& sector : critical_vertices_.sectors(critical))
    {
      if(sector.is_upper == is_split_tree)
        visit(sector, *sector_class);
      ++sector_class;
    }
  }

  void find_path_ends(Index critical)
  {
    for_each_swept_sector(
      critical, [&](const Link_sector& sector, Index& end) { end = path_ends_(sector.edge, sector.extreme_neighbor); });
  }

  // All classes are named before the first of them gets a new top.
  void merge_at(Index critical)
  {
    for_each_swept_sector(critical,
                          [&](const Link_sector&, Index& sector_class) { sector_class = sets_.top(sector_class); });
    for_each_swept_sector(
      critical, [&](const Link_sector& sector, Index sector_class) { merge_class(sector_class, critical, sector); });
  }

  void merge_class(Index sector_class, Index critical, const Link_sector& sector)
  {
    if(tree_.parents[sector_class] == no_index)
      put_on(sector_class, critical);
    if constexpr(is_split_tree)
    {
      Ascending_step& step = tree_.first_steps[sector_class];
      if(step.edge == no_index || order_(step.target, sector.extreme_neighbor))
        step = {sector.edge, sector.extreme_neighbor};
    }
  }

  void put_on(Index old_top, Index top)
  {
    tree_.parents[old_top] = top;
    if(tree_.is_border_reached[old_top])
      tree_.is_border_reached[top] = true;
    sets_.put_on(old_top, top);
  }

  const Order& order_;
  const Critical_vertices& critical_vertices_;
  const Cut_contours& cuts_;
  Monotone_path_ends<Order, is_split_tree> path_ends_;
  Disjoint_sets sets_;
  Merge_tree tree_;
};

// The join tree of the surface. Cuts do not change it but for their own nodes, see insert_cuts().
template <class Order>
Merge_tree compute_join_tree(const Triangle_complex& complex,
                             const Order& order,
                             const Critical_vertices& critical_vertices)
{
  return Merge_tree_sweep<Order, false>(complex, order, critical_vertices, Cut_contours(critical_vertices.size()))();
}

// The split tree of the surface that is cut open along `cuts`.
template <class Order>
Merge_tree compute_split_tree(const Triangle_complex& complex,
                              const Order& order,
                              const Critical_vertices& critical_vertices,
                              const Cut_contours& cuts)
{
  return Merge_tree_sweep<Order, true>(complex, order, critical_vertices, cuts)();
}

// Adds the nodes of the cuts to the join tree. A cut is just below a vertex that another contour joins to the same
// component: the component goes on to the maximum below the cut, and the minimum above it begins a new one.
inline void insert_cuts(const Cut_contours& cuts, Merge_tree& join_tree)
{
  join_tree.parents.resize(cuts.number_of_nodes(), no_index);
  for(Index cut = 0; cut != cuts.size(); ++cut)
  {
    Index& parent = join_tree.parents[cuts.sublevel_class(cut)];
    join_tree.parents[cuts.node_below(cut)] = parent;
    join_tree.parents[cuts.node_above(cut)] = cuts.critical_vertex(cut);
    parent = cuts.node_below(cut);
  }
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_MERGE_TREES_H
