// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_ENGINE_H
#define CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_ENGINE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/Critical_arc.h>
#include <CGAL/Reeb_graph/internal/Cut_contours.h>
#include <CGAL/Reeb_graph/internal/Cutting_sweep.h>
#include <CGAL/Reeb_graph/internal/Large_vector.h>
#include <CGAL/Reeb_graph/internal/Slab.h>
#include <CGAL/Reeb_graph/internal/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/contour_tree_merge.h>
#include <CGAL/Reeb_graph/internal/loop_surgery.h>
#include <CGAL/Reeb_graph/internal/merge_trees.h>
#include <CGAL/Reeb_graph/internal/parallel.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Contour trees joined by loop surgery: near-linear for any field. The surface is cut along the few contours that
// close loops; what is left has a tree as Reeb graph, which comes from its join tree and its split tree. The sweep for
// the split tree comes down to a contour just below a vertex after all that is above: it can cut there and go on.
template <class Order>
class Contour_trees_engine
{
public:
  Contour_trees_engine(const Slab& slab, const Order& order)
    : slab_(slab),
      order_(order),
      critical_vertices_(slab.critical_vertices()),
      sector_classes_(critical_vertices_.total_number_of_sectors(), no_index),
      cuts_(slab.number_of_nodes())
  {}

  template <class ConcurrencyTag>
  Large_vector<Critical_arc> find_arcs()
  {
    sweep<ConcurrencyTag>();
    insert_cuts_into_join_tree();
    Large_vector<Critical_arc> arcs = Contour_tree_merge(join_tree_.parents, split_tree_.parents, find_first_steps())();
    glue_cuts(arcs);
    return arcs;
  }

private:
  template <class ConcurrencyTag>
  void sweep()
  {
    Cutting_sweep<Order> cutting_sweep(slab_, order_, sector_classes_);
    invoke_both<ConcurrencyTag>([&] { sweep_upwards(); }, [&] { cutting_sweep.find_path_ends(); });
    sweep_downwards(cutting_sweep);
    split_tree_ = std::move(cutting_sweep.tree());
    cuts_ = cutting_sweep.take_cuts();
  }

  // Calls visit(critical vertex) for positions in the order of the field, and lets the sweep know ahead.
  template <class Sweep, class Iterator, class Visit>
  void visit_in_order(const Sweep& sweep, Iterator begin, Iterator end, const Visit& visit) const
  {
    constexpr std::ptrdiff_t far_ahead = 24, near_ahead = 12;
    for(Iterator critical = begin; critical != end; ++critical)
    {
      if(end - critical > far_ahead)
        critical_vertices_.prefetch(critical[far_ahead]);
      if(end - critical > near_ahead)
        sweep.prefetch(critical[near_ahead]);
      visit(*critical);
    }
  }

  void sweep_upwards()
  {
    Merge_tree_sweep<Order, false> sweep(slab_, order_, sector_classes_);
    auto path_ends = sweep.make_path_ends();
    sweep.find_path_ends(path_ends);
    const Large_vector<Index>& ascending = critical_vertices_.ascending();
    visit_in_order(sweep, ascending.begin(), ascending.end(), [&](Index critical) { sweep.merge_at(critical); });
    sweep.merge_last_contours(path_ends, [&](const Ascending_step& step) { return sweep.component_at_level(step); });
    join_tree_ = std::move(sweep.tree());
  }

  void sweep_downwards(Cutting_sweep<Order>& sweep)
  {
    Loop_surgery<Order> surgery(slab_, order_, sector_classes_, join_tree_, sweep.tree());
    const Large_vector<Index>& ascending = critical_vertices_.ascending();
    visit_in_order(sweep, ascending.rbegin(), ascending.rend(), [&](Index critical) {
      sweep.merge_at(critical);
      if(!surgery.can_close_loop(critical))
        return;
      surgery.visit_loop_contours(critical,
                                  [&](Index sublevel_class, const Large_vector<Index>& crossed_edges, bool has_border) {
                                    sweep.cut(critical, sublevel_class, crossed_edges, has_border);
                                  });
    });
    sweep.merge_last_contours();
  }

  // Cuts do not change the join tree but for their own nodes.
  void insert_cuts_into_join_tree()
  {
    Large_vector<Index>& parents = join_tree_.parents;
    parents.resize(cuts_.number_of_nodes(), no_index);
    for(Index cut = 0; cut != cuts_.size(); ++cut)
    {
      Index& parent = parents[cuts_.sublevel_class(cut)];
      parents[cuts_.node_below(cut)] = parent;
      parents[cuts_.node_above(cut)] = cuts_.critical_vertex(cut);
      parent = cuts_.node_below(cut);
    }
  }

  // By node: the first step from its parent in the split tree towards it, in the highest of the sectors that lead
  // there.
  Large_vector<Ascending_step> find_first_steps() const
  {
    Large_vector<Ascending_step> first_steps(cuts_.number_of_nodes(), Ascending_step{no_index, no_index});
    for(Index i = 0; i != critical_vertices_.size(); ++i)
    {
      critical_vertices_.for_each_sector(i, true, [&](Index position) {
        const Link_sector& sector = critical_vertices_.sector(position);
        Ascending_step& step = first_steps[sector_classes_[position]];
        if(step.edge == no_index || order_(step.target, sector.extreme_neighbor))
          step = {sector.edge, sector.extreme_neighbor};
      });
    }
    return first_steps;
  }

  // Where an arc ends at a cut it goes on to the vertex just above, and the short arc from the cut to there is dropped.
  void glue_cuts(Large_vector<Critical_arc>& arcs) const
  {
    if(cuts_.size() == 0)
      return;
    const auto begins_at_cut = [&](const Critical_arc& arc) { return cuts_.is_node_above(arc.lower); };
    arcs.erase(std::remove_if(arcs.begin(), arcs.end(), begins_at_cut), arcs.end());
    for(Critical_arc& arc : arcs)
    {
      if(cuts_.is_node_below(arc.upper))
        arc.upper = cuts_.critical_vertex(cuts_.cut_of_node(arc.upper));
    }
  }

  const Slab& slab_;
  const Order& order_;
  const Critical_vertices& critical_vertices_;
  Sector_classes sector_classes_;
  Cut_contours cuts_;
  Merge_tree join_tree_;
  Merge_tree split_tree_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_ENGINE_H
