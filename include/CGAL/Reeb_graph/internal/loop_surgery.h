// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_LOOP_SURGERY_H
#define CGAL_REEB_GRAPH_INTERNAL_LOOP_SURGERY_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/Cut_contours.h>
#include <CGAL/Reeb_graph/internal/Disjoint_sets.h>
#include <CGAL/Reeb_graph/internal/Triangle_complex.h>
#include <CGAL/Reeb_graph/internal/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/contour_tracing.h>
#include <CGAL/Reeb_graph/internal/merge_trees.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Finds contours along which the surface has to be cut so that its Reeb graph becomes a tree: at each vertex where
// several lower contours meet, one of each sublevel component stays, the others close loops. Contours are traced only
// where counting the components cannot exclude a loop.
template <class Order>
class Loop_surgery
{
public:
  Loop_surgery(const Triangle_complex& complex,
               const Order& order,
               const Critical_vertices& critical_vertices,
               const Merge_tree& join_tree,
               const Merge_tree& split_tree)
    : complex_(complex),
      order_(order),
      critical_vertices_(critical_vertices),
      join_tree_(join_tree),
      split_tree_(split_tree),
      cuts_(critical_vertices.size())
  {}

  Cut_contours operator()()
  {
    std::vector<Index> loop_closers;
    for(Index i = 0; i != critical_vertices_.size(); ++i)
    {
      if(critical_vertices_.number_of_lower_sectors(i) > 1 && can_close_loop(i))
        loop_closers.push_back(i);
    }
    std::sort(loop_closers.begin(), loop_closers.end(),
              [&](Index i, Index j) { return order_(critical_vertices_.vertex(i), critical_vertices_.vertex(j)); });
    for(const Index critical : loop_closers)
      cut_at(critical);
    if(cuts_.size() != 0)
      cuts_.prepare_look_up(complex_);
    return std::move(cuts_);
  }

private:
  Index sector_class(const Merge_tree& tree, Index critical, std::size_t sector) const
  {
    return tree.sector_classes[critical_vertices_.first_sector(critical) + sector];
  }

  static Index count_distinct(std::vector<Index>& sorted)
  {
    std::sort(sorted.begin(), sorted.end());
    return static_cast<Index>(std::unique(sorted.begin(), sorted.end()) - sorted.begin());
  }

  // Whether two lower contours at the vertex might be in one sublevel component. May err to the safe side.
  bool can_close_loop(Index critical)
  {
    lower_classes_.clear();
    upper_classes_.clear();
    bool is_border_below = false, is_border_above = false;
    const auto sectors = critical_vertices_.sectors(critical);
    for(std::size_t s = 0; s != sectors.size(); ++s)
    {
      const bool is_upper = sectors.begin()[s].is_upper;
      const Merge_tree& tree = is_upper ? split_tree_ : join_tree_;
      const Index top = sector_class(tree, critical, s);
      (is_upper ? upper_classes_ : lower_classes_).push_back(top);
      (is_upper ? is_border_above : is_border_below) |= tree.is_border_reached[top];
    }
    const Index number_of_lower_sectors = critical_vertices_.number_of_lower_sectors(critical);
    const Index number_of_lower_classes = count_distinct(lower_classes_);
    if(number_of_lower_classes == number_of_lower_sectors)
      return false;
    // With closed contours on one side, as many loops are closed at the vertex, here or above and below, as its
    // multiplicity exceeds the merges of both trees.
    if(!complex_.is_on_border(critical_vertices_.vertex(critical)) && !(is_border_below && is_border_above))
      return number_of_lower_sectors + 1 > number_of_lower_classes + count_distinct(upper_classes_);
    return count_joined_lower_sectors(critical) > number_of_lower_classes;
  }

  // Joins the two lower sectors beside each upper one that is alone in a component without border, as the closed
  // contour just above that sector is that component's only one here, and one contour just below runs along it.
  Index count_joined_lower_sectors(Index critical)
  {
    const auto sectors = critical_vertices_.sectors(critical);
    const std::size_t size = sectors.size();
    std::vector<Index> upper_classes;
    for(std::size_t s = 0; s != size; ++s)
      if(sectors.begin()[s].is_upper)
        upper_classes.push_back(sector_class(split_tree_, critical, s));
    std::sort(upper_classes.begin(), upper_classes.end());

    const bool is_cyclic = !complex_.is_on_border(critical_vertices_.vertex(critical));
    Disjoint_sets sets(static_cast<Index>(size));
    Index number_of_sets = critical_vertices_.number_of_lower_sectors(critical);
    for(std::size_t s = 0; s != size; ++s)
    {
      if(!sectors.begin()[s].is_upper || (!is_cyclic && (s == 0 || s + 1 == size)))
        continue;
      const Index upper_class = sector_class(split_tree_, critical, s);
      const auto range = std::equal_range(upper_classes.begin(), upper_classes.end(), upper_class);
      if(range.second - range.first != 1 || split_tree_.is_border_reached[upper_class])
        continue;
      const Index left = sets.top(static_cast<Index>((s + size - 1) % size));
      const Index right = sets.top(static_cast<Index>((s + 1) % size));
      if(left == right)
        continue;
      sets.put_on(left, right);
      --number_of_sets;
    }
    return number_of_sets;
  }

  // Traces the lower contours of the vertex and cuts all but one of each sublevel component.
  void cut_at(Index critical)
  {
    const Index vertex = critical_vertices_.vertex(critical);
    const auto is_below = [&](Index u) { return order_(u, vertex); };
    const auto sectors = critical_vertices_.sectors(critical);
    std::vector<Index> kept_classes, edges_of_traced_sectors, crossed_edges;
    for(std::size_t s = 0; s != sectors.size(); ++s)
    {
      const Link_sector& sector = sectors.begin()[s];
      const Index sector_edge = complex_.representative_of_edge(sector.edge);
      if(sector.is_upper || contains(edges_of_traced_sectors, sector_edge))
        continue;
      crossed_edges.clear();
      trace_contour(complex_, sector.edge, is_below, [&](Index corner) {
        crossed_edges.push_back(corner);
        if(complex_.edge_source(corner) == vertex || complex_.edge_target(corner) == vertex)
          edges_of_traced_sectors.push_back(complex_.representative_of_edge(corner));
      });
      std::sort(edges_of_traced_sectors.begin(), edges_of_traced_sectors.end());
      const Index sublevel_class = sector_class(join_tree_, critical, s);
      if(contains(kept_classes, sublevel_class))
        cuts_.add(complex_, critical, sublevel_class, crossed_edges);
      else
        kept_classes.insert(std::upper_bound(kept_classes.begin(), kept_classes.end(), sublevel_class), sublevel_class);
    }
  }

  static bool contains(const std::vector<Index>& sorted, Index i)
  {
    return std::binary_search(sorted.begin(), sorted.end(), i);
  }

  const Triangle_complex& complex_;
  const Order& order_;
  const Critical_vertices& critical_vertices_;
  const Merge_tree& join_tree_;
  const Merge_tree& split_tree_;
  Cut_contours cuts_;
  std::vector<Index> lower_classes_;
  std::vector<Index> upper_classes_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_LOOP_SURGERY_H
