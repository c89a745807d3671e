// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_LOOP_SURGERY_H
#define CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_LOOP_SURGERY_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Disjoint_sets.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Large_vector.h>
#include <CGAL/Reeb_graph/internal/contour_trees/Merge_tree.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab.h>
#include <CGAL/Reeb_graph/internal/walks/contour_tracing.h>

#include <algorithm>
#include <array>
#include <unordered_set>
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
    : complex_(slab.complex()),
      order_(order),
      critical_vertices_(slab.critical_vertices()),
      join_tree_(join_tree),
      split_tree_(split_tree)
  {}

  // Whether two lower contours at the vertex might be in one sublevel component. May err to the safe side. The classes
  // of the superlevel components can be those of the surface with the cuts further up: that can only exclude more.
  bool can_close_loop(Index critical)
  {
    if(!join_tree_.is_class_shared[critical])
      return false;
    // With closed contours on one side, as many loops are closed at the vertex, here or above and below, as its
    // multiplicity exceeds the merges of both trees: none if all upper classes are different.
    const bool is_on_border = critical_vertices_.is_on_border(critical);
    if(is_on_border || (is_border_reached(critical, true) && is_border_reached(critical, false)))
      return count_joined_lower_sectors(critical, is_on_border) > count_classes(critical, false);
    return split_tree_.is_class_shared[critical]
        && critical_vertices_.number_of_lower_sectors(critical) + 1
             > count_classes(critical, false) + count_classes(critical, true);
  }

  // Traces lower contours of the vertex, and calls visit(its sublevel class, halfedges of the crossed edges, whether
  // they reach the border) for all but one of each sublevel component.
  template <class Visit>
  void visit_loop_contours(Index critical, const Visit& visit)
  {
    if(critical_vertices_.number_of_lower_sectors(critical) == 2)
      visit_shorter_contour(critical, visit);
    else
      visit_contours_of_multi_saddle(critical, visit);
  }

private:
  // For two lower sectors of one sublevel component. Both contours are walked at once, so that the longer one costs no
  // more than the shorter one.
  template <class Visit>
  void visit_shorter_contour(Index critical, const Visit& visit)
  {
    const Index first = critical_vertices_.first_sector(critical, false);
    const auto is_below = [&, vertex = critical_vertices_.vertex(critical)](Index u) { return order_(u, vertex); };
    const std::array<Index, 2> starts = {critical_vertices_.sector(false, first).edge,
                                         critical_vertices_.sector(false, first + 1).edge};
    std::array<Contour_walk<Complex>, 2> walks = {Contour_walk(complex_, starts[0], is_below),
                                                  Contour_walk(complex_, starts[1], is_below)};
    Index side = 0;
    std::array<Large_vector<Index>, 2> crossed_edges = {Large_vector<Index>(1, starts[0]),
                                                        Large_vector<Index>(1, starts[1])};
    for(; walks[side].go_on(is_below); side = 1 - side)
    {
      crossed_edges[side].push_back(walks[side].crossed_edge());
      const bool is_same_contour = edge_of(walks[side].crossed_edge()) == edge_of(starts[1 - side]);
      if(is_same_contour)
        return;
    }
    visit(join_tree_.sector_classes[first], crossed_edges[side], walks[side].is_border_reached());
  }

  template <class Visit>
  void visit_contours_of_multi_saddle(Index critical, const Visit& visit)
  {
    const Index vertex = critical_vertices_.vertex(critical);
    const auto is_below = [&](Index u) { return order_(u, vertex); };
    Large_vector<Index> sector_edges, crossed_edges;
    critical_vertices_.for_each_sector(critical, false, [&](Index position) {
      sector_edges.push_back(edge_of(critical_vertices_.sector(false, position).edge));
    });
    std::sort(sector_edges.begin(), sector_edges.end());
    const auto place = [&](Index edge) {
      return std::lower_bound(sector_edges.begin(), sector_edges.end(), edge) - sector_edges.begin();
    };
    std::vector<bool> is_traced(sector_edges.size(), false);
    std::unordered_set<Index> kept_classes;
    critical_vertices_.for_each_sector(critical, false, [&](Index position) {
      const Index start = critical_vertices_.sector(false, position).edge;
      if(is_traced[place(edge_of(start))])
        return;
      crossed_edges.clear();
      bool has_border = false;
      trace_contour(complex_, start, is_below, [&](Index halfedge) {
        crossed_edges.push_back(halfedge);
        has_border |= complex_.is_on_border_edge(halfedge);
        const bool is_at_vertex = complex_.source(halfedge) == vertex || complex_.target(halfedge) == vertex;
        if(is_at_vertex && std::binary_search(sector_edges.begin(), sector_edges.end(), edge_of(halfedge)))
          is_traced[place(edge_of(halfedge))] = true;
      });
      const Index sublevel_class = join_tree_.sector_classes[position];
      if(!kept_classes.insert(sublevel_class).second)
        visit(sublevel_class, crossed_edges, has_border);
    });
  }

  void sort_classes(Index critical, bool is_upper)
  {
    classes_.clear();
    critical_vertices_.for_each_sector(critical, is_upper,
                                       [&](Index i) { classes_.push_back(tree(is_upper).sector_classes[i]); });
    std::sort(classes_.begin(), classes_.end());
  }

  // Nearly all saddles are simple.
  Index count_classes(Index critical, bool is_upper)
  {
    if(critical_vertices_.number_of_sectors(critical, is_upper) == 2)
      return tree(is_upper).is_class_shared[critical] ? 1 : 2;
    sort_classes(critical, is_upper);
    return static_cast<Index>(std::unique(classes_.begin(), classes_.end()) - classes_.begin());
  }

  bool is_border_reached(Index critical, bool is_upper) const
  {
    bool result = false;
    critical_vertices_.for_each_sector(critical, is_upper, [&](Index i) {
      result |= tree(is_upper).is_border_reached[tree(is_upper).sector_classes[i]];
    });
    return result;
  }

  // Joins the two lower sectors beside each upper one that is alone in a component without border, as the closed
  // contour just above that sector is that component's only one here, and one contour just below runs along it.
  Index count_joined_lower_sectors(Index critical, bool is_on_border)
  {
    sort_classes(critical, true);
    const Index number_of_lower_sectors = critical_vertices_.number_of_lower_sectors(critical);
    const Index number_of_upper_sectors = critical_vertices_.number_of_upper_sectors(critical);
    const Index first = critical_vertices_.first_sector(critical, true);
    const bool is_first_upper = critical_vertices_.is_first_upper(critical);
    Disjoint_sets sets(number_of_lower_sectors);
    Index number_of_sets = number_of_lower_sectors;
    for(Index i = 0; i != number_of_upper_sectors; ++i)
    {
      const Index upper_class = split_tree_.sector_classes[first + i];
      const auto range = std::equal_range(classes_.begin(), classes_.end(), upper_class);
      // The lower sector before upper sector i, and the one behind it.
      const Index behind = is_first_upper ? i : i + 1, before = behind + number_of_lower_sectors - 1;
      const bool is_at_end = behind % number_of_lower_sectors == 0;
      if((is_on_border && is_at_end) || range.second - range.first != 1 || split_tree_.is_border_reached[upper_class])
        continue;
      const Index left = sets.find(before % number_of_lower_sectors),
                  right = sets.find(behind % number_of_lower_sectors);
      if(left == right)
        continue;
      sets.link(left, right);
      --number_of_sets;
    }
    return number_of_sets;
  }

  const Merge_tree& tree(bool is_upper) const { return is_upper ? split_tree_ : join_tree_; }

  const Complex& complex_;
  const Order& order_;
  const Swept_vertices& critical_vertices_;
  const Merge_tree& join_tree_;
  const Merge_tree& split_tree_;
  Large_vector<Index> classes_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_LOOP_SURGERY_H
