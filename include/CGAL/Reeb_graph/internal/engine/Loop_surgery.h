// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_LOOP_SURGERY_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_LOOP_SURGERY_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/engine/Merge_tree_sweep.h>
#include <CGAL/Reeb_graph/internal/engine/Slab.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/contour_tracing.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Finds contours along which the surface has to be cut so that its Reeb graph becomes a tree: at each vertex where
// several lower contours meet, one of each sublevel component stays, the others close loops. Contours are traced only
// where counting the components cannot exclude a loop. (Loop surgery is that of J. Tierny, A. Gyulassy, E. Simon,
// V. Pascucci, 2009; where the loops are is counted here.)
template <class Complex, class Order>
class Loop_surgery
{
public:
  Loop_surgery(const Slab<Complex>& slab, const Order& order, const Merge_tree& join_tree, const Merge_tree& split_tree)
    : order_(order),
      critical_vertices_(slab.critical_vertices()),
      join_tree_(join_tree),
      split_tree_(split_tree),
      contours_(slab.complex())
  {}

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

  // Traces lower contours of the vertex, and calls visit(its sublevel class, halfedges of the crossed edges, each from
  // its lower end to its higher one, whether they reach the border) for all but one of each sublevel component.
  template <class Visit>
  void visit_loop_contours(Swept_index critical, const Visit& visit)
  {
    const auto is_below = [&, vertex = critical_vertices_.vertex(critical)](Vertex_index u) {
      return order_(u, vertex);
    };
    std::vector<std::pair<Slab_node, Sector_index>> sectors; // with their classes
    for(const Sector_index i : critical_vertices_.sectors(critical, Side::LOWER))
      sectors.emplace_back(join_tree_.classes[i], i);
    std::sort(sectors.begin(), sectors.end());
    Plain_vector<Halfedge_index> starts;
    for(auto begin = sectors.begin(), end = begin; begin != sectors.end(); begin = end)
    {
      starts.clear();
      for(; end != sectors.end() && end->first == begin->first; ++end)
        starts.push_back(critical_vertices_.sector(Side::LOWER, end->second).edge);
      contours_.visit_all_but_one(starts, is_below,
                                  [&](const Plain_vector<Halfedge_index>& crossed_edges, bool is_border_reached) {
                                    visit(begin->first, crossed_edges, is_border_reached);
                                  });
    }
  }

private:
  void sort_classes(Swept_index critical, Side side)
  {
    classes_.clear();
    for(const Sector_index i : critical_vertices_.sectors(critical, side))
      classes_.push_back(tree(side).classes[i]);
    std::sort(classes_.begin(), classes_.end());
  }

  // The number of distinct classes at a vertex, at once for simple saddles, as nearly all are.
  Number count_classes(Swept_index critical, Side side)
  {
    if(critical_vertices_.number_of_sectors(critical, side) == 2)
      return tree(side).is_class_shared[critical] ? 1 : 2;
    sort_classes(critical, side);
    return static_cast<Number>(std::unique(classes_.begin(), classes_.end()) - classes_.begin());
  }

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
  Number count_joined_lower_sectors(Swept_index critical, bool is_on_border)
  {
    sort_classes(critical, Side::UPPER);
    const Number number_of_lower_sectors = critical_vertices_.number_of_lower_sectors(critical);
    const Number number_of_upper_sectors = critical_vertices_.number_of_upper_sectors(critical);
    const Sector_index first = critical_vertices_.first_sector(critical, Side::UPPER);
    const bool is_first_upper = critical_vertices_.is_first_upper(critical);
    Number result = number_of_lower_sectors;
    for(Number i = 0; i != number_of_upper_sectors; ++i)
    {
      const Slab_node upper_class = split_tree_.classes[Sector_index(first.number() + i)];
      const auto range = std::equal_range(classes_.begin(), classes_.end(), upper_class);
      // On the border, an upper sector at an end of the link has one lower sector beside it.
      const bool is_at_end = is_on_border && (is_first_upper ? i : i + 1) % number_of_lower_sectors == 0;
      if(!is_at_end && range.second - range.first == 1 && !split_tree_.is_border_reached[upper_class])
        --result;
    }
    return result;
  }

  const Merge_tree& tree(Side side) const { return side == Side::UPPER ? split_tree_ : join_tree_; }

  const Order& order_;
  const Swept_vertices& critical_vertices_;
  const Merge_tree& join_tree_;
  const Merge_tree& split_tree_;
  Contours_side_by_side<Complex> contours_;
  Plain_vector<Slab_node> classes_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_LOOP_SURGERY_H
