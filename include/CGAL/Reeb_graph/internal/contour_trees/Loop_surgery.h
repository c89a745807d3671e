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
#include <CGAL/Reeb_graph/internal/base/Plain_vector.h>
#include <CGAL/Reeb_graph/internal/base/Side.h>
#include <CGAL/Reeb_graph/internal/contour_trees/Merge_tree.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab_arc.h>
#include <CGAL/Reeb_graph/internal/walks/contour_tracing.h>

#include <algorithm>
#include <array>
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

  // Traces lower contours of the vertex, and calls visit(its sublevel class, halfedges of the crossed edges, whether
  // they reach the border) for all but one of each sublevel component.
  template <class Visit>
  void visit_loop_contours(Swept_index critical, const Visit& visit)
  {
    if(critical_vertices_.number_of_lower_sectors(critical) == 2)
      visit_shorter_contour(critical, visit);
    else
      visit_contours_of_multi_saddle(critical, visit);
  }

private:
  // Visits the shorter contour of two lower sectors of one sublevel component. Both are walked at once, so that the
  // longer one costs no more than the shorter one.
  template <class Visit>
  void visit_shorter_contour(Swept_index critical, const Visit& visit)
  {
    const Sector_index first = critical_vertices_.first_sector(critical, Side::LOWER), second(first.number() + 1);
    const auto is_below = [&, vertex = critical_vertices_.vertex(critical)](Vertex_index u) {
      return order_(u, vertex);
    };
    const std::array<Halfedge_index, 2> starts = {critical_vertices_.sector(Side::LOWER, first).edge,
                                                  critical_vertices_.sector(Side::LOWER, second).edge};
    std::array<Contour_walk<Complex>, 2> walks = {Contour_walk(complex_, starts[0], is_below),
                                                  Contour_walk(complex_, starts[1], is_below)};
    std::size_t turn = 0;
    std::array<Plain_vector<Halfedge_index>, 2> crossed_edges = {Plain_vector<Halfedge_index>(1, starts[0]),
                                                                 Plain_vector<Halfedge_index>(1, starts[1])};
    for(; walks[turn].go_on(is_below); turn = 1 - turn)
    {
      crossed_edges[turn].push_back(walks[turn].crossed_edge());
      const bool is_same_contour = edge_of(walks[turn].crossed_edge()) == edge_of(starts[1 - turn]);
      if(is_same_contour)
        return;
    }
    visit(join_tree_.classes[first], crossed_edges[turn], walks[turn].is_border_reached());
  }

  template <class Visit>
  void visit_contours_of_multi_saddle(Swept_index critical, const Visit& visit)
  {
    const Vertex_index vertex = critical_vertices_.vertex(critical);
    const auto is_below = [&](Vertex_index u) { return order_(u, vertex); };
    Plain_vector<Edge_index> sector_edges;
    Plain_vector<Halfedge_index> crossed_edges;
    for(const Sector_index i : critical_vertices_.sectors(critical, Side::LOWER))
      sector_edges.push_back(edge_of(critical_vertices_.sector(Side::LOWER, i).edge));
    std::sort(sector_edges.begin(), sector_edges.end());
    const auto place = [&](Edge_index edge) {
      return std::lower_bound(sector_edges.begin(), sector_edges.end(), edge) - sector_edges.begin();
    };
    std::vector<bool> is_traced(sector_edges.size(), false);
    sort_classes(critical, Side::LOWER);
    std::vector<bool> is_class_kept(classes_.size(), false); // by the first place of the class
    for(const Sector_index i : critical_vertices_.sectors(critical, Side::LOWER))
    {
      const Halfedge_index start = critical_vertices_.sector(Side::LOWER, i).edge;
      if(is_traced[place(edge_of(start))])
        continue;
      crossed_edges.clear();
      bool has_border = false;
      trace_contour(complex_, start, is_below, [&](Halfedge_index halfedge) {
        crossed_edges.push_back(halfedge);
        has_border |= complex_.is_on_border_edge(halfedge);
        const bool is_at_vertex = complex_.source(halfedge) == vertex || complex_.target(halfedge) == vertex;
        if(is_at_vertex && std::binary_search(sector_edges.begin(), sector_edges.end(), edge_of(halfedge)))
          is_traced[place(edge_of(halfedge))] = true;
      });
      const Slab_node sublevel_class = join_tree_.classes[i];
      const auto place_of_class = std::lower_bound(classes_.begin(), classes_.end(), sublevel_class) - classes_.begin();
      if(is_class_kept[place_of_class])
        visit(sublevel_class, crossed_edges, has_border);
      is_class_kept[place_of_class] = true;
    }
  }

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
  // contour just above that sector is that component's only one here, and one contour just below runs along it.
  Number count_joined_lower_sectors(Swept_index critical, bool is_on_border)
  {
    sort_classes(critical, Side::UPPER);
    const Number number_of_lower_sectors = critical_vertices_.number_of_lower_sectors(critical);
    const Number number_of_upper_sectors = critical_vertices_.number_of_upper_sectors(critical);
    const Sector_index first = critical_vertices_.first_sector(critical, Side::UPPER);
    const bool is_first_upper = critical_vertices_.is_first_upper(critical);
    struct Lower_place_tag;
    typedef Index_of<Lower_place_tag> Lower_place;
    Disjoint_sets<Lower_place> sets(number_of_lower_sectors);
    Number number_of_sets = number_of_lower_sectors;
    for(Number i = 0; i != number_of_upper_sectors; ++i)
    {
      const Slab_node upper_class = split_tree_.classes[Sector_index(first.number() + i)];
      const auto range = std::equal_range(classes_.begin(), classes_.end(), upper_class);
      // The lower sector before upper sector i, and the one behind it.
      const Number behind = is_first_upper ? i : i + 1, before = behind + number_of_lower_sectors - 1;
      const bool is_at_end = behind % number_of_lower_sectors == 0;
      if((is_on_border && is_at_end) || range.second - range.first != 1 || split_tree_.is_border_reached[upper_class])
        continue;
      const Lower_place left = sets.find(Lower_place(before % number_of_lower_sectors));
      const Lower_place right = sets.find(Lower_place(behind % number_of_lower_sectors));
      if(left == right)
        continue;
      sets.link(left, right);
      --number_of_sets;
    }
    return number_of_sets;
  }

  const Merge_tree& tree(Side side) const { return side == Side::UPPER ? split_tree_ : join_tree_; }

  const Complex& complex_;
  const Order& order_;
  const Swept_vertices& critical_vertices_;
  const Merge_tree& join_tree_;
  const Merge_tree& split_tree_;
  Plain_vector<Slab_node> classes_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_LOOP_SURGERY_H
