// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_FIND_ARCS_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_FIND_ARCS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/engine/Tree_combination.h>
#include <CGAL/Reeb_graph/internal/engine/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/cut_loops.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL::Reeb_graph::internal {

// Contour trees joined by loop surgery: near-linear for any field. The surface is cut along the few contours that
// close loops; what is left has a tree as Reeb graph, which comes from its join tree and its split tree. The sweep for
// the split tree comes down to a contour just below a vertex after all that is above: it can cut there and go on.
// (J. Tierny, A. Gyulassy, E. Simon, V. Pascucci, Loop surgery for volumetric meshes: Reeb graphs reduced to contour
// trees, 2009, for volumes.)
template <class Complex>
class Contour_trees_engine
{
  typedef Merge_tree_sweep<Complex, Side::LOWER> Upward_sweep;
  typedef Cutting_sweep<Complex> Downward_sweep;

public:
  Contour_trees_engine(const Slab<Complex>& slab, const Vertex_order& order)
    : slab_(slab),
      order_(order),
      critical_vertices_(slab.critical_vertices())
  {}

  // Answers the queries on the way, and calls report(fraction) now and then.
  template <class Report, class Queries>
  Swept_arcs find_arcs(const Threads& threads, const Report& report, Queries& queries) const
  {
    std::optional<Upward_sweep> upwards;
    std::optional<Downward_sweep> downwards;
    threads.invoke_both([&] { upwards.emplace(slab_, order_); }, [&] { downwards.emplace(slab_, order_); });
    find_path_ends<Queries>(threads, *upwards);
    report(0.25);

    const bool is_forest = sweep_first_trees(threads, *upwards, downwards, queries);
    report(0.5);

    Shrinking_tree join_tree, split_tree;
    threads.invoke_both(
      [&] {
        if(!is_forest)
          sweep_downwards_and_cut(*downwards, upwards->tree(), queries);
      },
      [&] { join_tree = Shrinking_tree(upwards->tree().parents); });
    Contour_cuts cuts = downwards->take_cuts();
    insert_cuts(cuts, join_tree);
    report(0.75);

    Indexed_vector<Tree_node, Ascending_step> first_steps;
    threads.invoke_both(
      [&] { split_tree = Shrinking_tree(downwards->tree().parents); },
      [&] { first_steps = find_first_steps(threads, downwards->tree().classes, cuts.number_of_nodes()); });
    Tree_combination<Queries::are_any> combination(std::move(join_tree), std::move(split_tree), std::move(first_steps));
    Swept_arcs arcs = combination();
    if constexpr(Queries::are_any)
    {
      Arcs_of_classes arcs_of_classes = combination.find_arcs_of_classes(arcs);
      if(cuts.size() != 0)
      {
        Indexed_vector<Swept_arc_index, Swept_arc_index> new_names(arcs.size(), no_index); // of those that are kept
        glue_cuts(cuts, arcs, [&](Swept_arc_index arc, Swept_arc_index name) { new_names[arc] = name; });
        for(const Side side : both_sides)
          for(Swept_arc_index& arc : arcs_of_classes[side])
            arc = arc == no_index ? arc : new_names[arc];
        cuts.register_edges();
      }
      queries.find_arcs(threads, arcs_of_classes, Trees_with_cuts{{&upwards->tree(), &downwards->tree()}, cuts});
    }
    else if(cuts.size() != 0)
      glue_cuts(cuts, arcs, [](Swept_arc_index, Swept_arc_index) {});
    return arcs;
  }

private:
  template <class Queries, class Sweep>
  static void find_path_ends(const Threads& threads, Sweep& sweep)
  {
    sweep.find_path_ends(threads);
    if constexpr(Queries::are_in_order)
      sweep.find_path_ends_of_vertices(threads);
  }

  // The sweep for the join tree, and for the split tree as much as can be done: all of it where no loop can be, as the
  // sweeps do not need each other then. Whether that is so, the result, is only known after the first one; to run the
  // second one beside it is a guess. Of a complex that may be no surface, the Euler characteristic tells nothing.
  template <class Queries>
  bool sweep_first_trees(const Threads& threads,
                         Upward_sweep& upwards,
                         std::optional<Downward_sweep>& downwards,
                         Queries& queries) const
  {
    const std::ptrdiff_t characteristic =
      Complex::is_surface && slab_.is_whole_surface() ? euler_characteristic(critical_vertices_) : 0;
    const bool is_guess_made = threads.are_parallel() && characteristic > 0;
    const auto no_cuts = [](Swept_index) {};
    threads.invoke_both([&] { sweep_from<Side::LOWER>(upwards, queries, no_cuts); },
                        [&] {
                          if(is_guess_made || has_many_critical_vertices())
                            find_path_ends<Queries>(threads, *downwards);
                          if(is_guess_made)
                            sweep_from<Side::UPPER>(*downwards, queries, no_cuts);
                        });
    const bool is_forest = characteristic > 0 && characteristic == largest_euler_characteristic(upwards.tree());
    if(is_forest && !is_guess_made)
      sweep_from<Side::UPPER>(*downwards, queries, no_cuts);
    if(!is_forest && is_guess_made)
    {
      downwards.emplace(slab_, order_);
      if(has_many_critical_vertices())
        find_path_ends<Queries>(threads, *downwards);
    }
    return is_forest;
  }

  // Sweeps over the critical vertices from one side, lets the sweep know ahead, and calls visit(critical vertex) when one
  // has been merged.
  template <Side side, class Sweep, class Queries, class Visit>
  void sweep_from(Sweep& sweep, Queries& queries, const Visit& visit) const
  {
    constexpr std::size_t far_ahead = 24, ahead = 16, near_ahead = 8;
    const std::size_t size = critical_vertices_.size();
    const auto place = [&](std::size_t i) { return side == Side::LOWER ? i : size - 1 - i; };
    const auto critical = [&, ascending = critical_vertices_.ascending().data()](std::size_t i) {
      return ascending[place(i)];
    };
    for(std::size_t i = 0; i != size; ++i)
    {
      if(i + far_ahead < size)
        critical_vertices_.prefetch(critical(i + far_ahead));
      if(i + ahead < size)
        sweep.prefetch_classes(critical(i + ahead));
      if(i + near_ahead < size)
        sweep.prefetch_components(critical(i + near_ahead));
      sweep.merge_at(critical(i));
      visit(critical(i));
      queries.template ask_beyond<side>(place(i), sweep);
    }
    sweep.merge_last_contours();
  }

  // Whether paths are best walked in the order of the mesh. Where critical vertices are few, paths are long, and cuts
  // change most of their ends.
  bool has_many_critical_vertices() const
  {
    return critical_vertices_.size() > slab_.complex().number_of_vertices() / 64;
  }

  // The Euler characteristic that the surface has if its components, with and without border, are spheres, disks, and
  // single vertices. Those have no loops, and all other ones smaller Euler characteristics.
  std::ptrdiff_t largest_euler_characteristic(const Merge_tree& join_tree) const
  {
    std::ptrdiff_t result = 0;
    for(const Swept_index i : critical_vertices_.indices())
    {
      if(join_tree.parents[node_of(i)] != no_index)
        continue;
      const bool is_sphere =
        !join_tree.is_border_reached[node_of(i)] && critical_vertices_.number_of_lower_sectors(i) != 0;
      result += is_sphere ? 2 : 1;
    }
    return result;
  }

  template <class Queries>
  void sweep_downwards_and_cut(Downward_sweep& sweep, const Merge_tree& join_tree, Queries& queries) const
  {
    Loop_surgery<Complex> surgery(slab_, order_, join_tree, sweep.tree());
    sweep_from<Side::UPPER>(sweep, queries, [&](Swept_index critical) {
      if(surgery.can_close_loop(critical))
      {
        surgery.visit_loop_contours(
          critical, [&](Tree_node sublevel_class, const Plain_vector<Halfedge_index>& crossed_edges, bool has_border) {
            sweep.cut(critical, sublevel_class, crossed_edges, has_border);
          });
      }
    });
  }

  // Cuts do not change the join tree but for their own nodes.
  static void insert_cuts(const Contour_cuts& cuts, Shrinking_tree& join_tree)
  {
    join_tree.resize(cuts.number_of_nodes());
    for(const Cut_index cut : cuts.cuts())
    {
      join_tree.put_above(cuts.sublevel_class(cut), cuts.node_below(cut));
      join_tree.put_leaf_below(node_of(cuts.critical_vertex(cut)), cuts.node_above(cut));
    }
  }

  // The first step to each node from its parent in the split tree, in the highest of the sectors that lead
  // there. No node has two parents, so all sectors that lead to it are at one vertex.
  Indexed_vector<Tree_node, Ascending_step> find_first_steps(
    const Threads& threads,
    const Indexed_vector<Sector_index, Tree_node>& superlevel_classes,
    Index number_of_nodes) const
  {
    constexpr Index ahead = 24;
    Indexed_vector<Tree_node, Ascending_step> first_steps(number_of_nodes, Ascending_step{no_index, no_index});
    threads.for_each_block(critical_vertices_.size(), [&](std::size_t begin, std::size_t end) {
      const Sector_index first = critical_vertices_.first_sector(Swept_index(begin), Side::UPPER),
                         last = critical_vertices_.first_sector(Swept_index(end), Side::UPPER);
      for(const Sector_index i : Index_range(first, last))
      {
        const Sector_index later(i.number() + ahead);
        if(later < last)
          prefetch_element(first_steps, superlevel_classes[later]);
        const Link_sector& sector = critical_vertices_.sector(Side::UPPER, i);
        Ascending_step& step = first_steps[superlevel_classes[i]];
        if(step.edge == no_index || order_(step.target, sector.extreme_neighbor))
          step = {sector.edge, sector.extreme_neighbor};
      }
    });
    return first_steps;
  }

  const Slab<Complex>& slab_;
  const Vertex_order& order_;
  const Swept_vertices& critical_vertices_;
};

// Critical sets and ascending paths (the paper, Sections 4.1 to 4.5): the contours just below each critical vertex
// are registered at the edges that they cross; then a path climbs from each upper sector of each critical vertex to
// the first edge where a contour is registered, which names the upper end of the arc. Each such contour ends one
// arc. Cost: the lengths of the registered contours, and of the paths; those of different arcs do not overlap.
template <class Complex>
class Critical_sets_engine
{
public:
  Critical_sets_engine(const Slab<Complex>& slab, const Vertex_order& order)
    : slab_(slab),
      complex_(slab.complex()),
      order_(order),
      critical_vertices_(slab.critical_vertices()),
      contour_at_edge_(complex_.number_of_edges(), no_index)
  {}

  // An edge keeps the contour of the lowest level: that is where an ascending path meets it first. Calls
  // report(fraction) now and then.
  template <class Report>
  Swept_arcs find_arcs(const Report& report)
  {
    for(const Contour_index i : slab_.contours(Side::UPPER))
      arcs_.push_back({no_index, slab_.contour_node(Side::UPPER, i), {no_index, no_index}});
    constexpr std::size_t vertices_per_report = 4096;
    const Plain_vector<Swept_index>& ascending = critical_vertices_.ascending();
    for(std::size_t i = ascending.size(); i-- != 0;)
    {
      register_lower_contours(ascending[i]);
      if(i % vertices_per_report == 0)
        report(0.7 * static_cast<double>(ascending.size() - i) / static_cast<double>(ascending.size()));
    }
    for(const Swept_index i : critical_vertices_.indices())
      climb_from(i);
    for(const Contour_index i : slab_.contours(Side::LOWER))
      arcs_[contour_above(slab_.step_from_contour(Side::LOWER, i))].lower = slab_.contour_node(Side::LOWER, i);
    return std::move(arcs_);
  }

private:
  void register_lower_contours(Swept_index critical)
  {
    const Vertex_index vertex = critical_vertices_.vertex(critical);
    const auto is_below = [&](Vertex_index u) { return order_(u, vertex); };
    for(const Sector_index i : critical_vertices_.sectors(critical, Side::LOWER))
    {
      // A contour can pass several sectors of the vertex; then the earlier trace has been here. Those of higher vertices
      // do not cross an edge that ends at this one.
      const Halfedge_index edge = critical_vertices_.sector(Side::LOWER, i).edge;
      if(contour_at(edge) != no_index)
        continue;
      arcs_.push_back({no_index, node_of(critical), {no_index, no_index}});
      trace_contour(complex_, edge, is_below,
                    [&](Halfedge_index halfedge) { contour_at_edge_[edge_of(halfedge)] = arcs_.last_key(); });
    }
  }

  Swept_arc_index contour_at(Halfedge_index halfedge) const { return contour_at_edge_[edge_of(halfedge)]; }

  void climb_from(Swept_index critical)
  {
    for(const Sector_index i : critical_vertices_.sectors(critical, Side::UPPER))
    {
      const Link_sector& sector = critical_vertices_.sector(Side::UPPER, i);
      const Ascending_step first_step = {sector.edge, sector.extreme_neighbor};
      Swept_arc& arc = arcs_[contour_above(first_step)];
      // Several sectors can lead to one arc, whose chain begins in the highest one.
      if(arc.lower == no_index || order_(arc.first_step.target, first_step.target))
        arc.first_step = first_step;
      arc.lower = node_of(critical);
    }
  }

  Swept_arc_index contour_above(Ascending_step step) const
  {
    for(; contour_at(step.edge) == no_index; step = steepest_step(complex_, order_, step.target))
    {
      const Contour_index contour = slab_.contour_at_step(Side::UPPER, step.target, [&] { return step.edge; });
      if(contour != no_index)
        return Swept_arc_index(contour.number()); // as the first arcs end at the contours of the upper level
    }
    return contour_at(step.edge);
  }

  const Slab<Complex>& slab_;
  const Complex& complex_;
  const Vertex_order& order_;
  const Swept_vertices& critical_vertices_;
  Indexed_vector<Edge_index, Swept_arc_index> contour_at_edge_; // a contour has the name of the arc that ends there
  Swept_arcs arcs_;
};

// Options that a program leaves at their defaults are types: what it never asks for is not compiled.
typedef std::integral_constant<Method, Method::CONTOUR_TREES> Default_method;
typedef std::integral_constant<std::size_t, 1> Default_number_of_slabs;

// Finds the arcs between the nodes of a slab by the engine for the method. All return the same arcs, in any order.
// First steps are those of arcs that begin at a critical vertex.
template <class Complex, class Report>
Swept_arcs find_arcs_of_slab(const Threads& threads,
                             const Slab<Complex>& slab,
                             const Vertex_order& order,
                             Default_method,
                             const Report& report)
{
  Locate_nothing no_queries;
  return Contour_trees_engine<Complex>(slab, order).find_arcs(threads, report, no_queries);
}

template <class Complex, class Report>
Swept_arcs find_arcs_of_slab(const Threads& threads,
                             const Slab<Complex>& slab,
                             const Vertex_order& order,
                             Method method,
                             const Report& report)
{
  if(method != Method::CRITICAL_SETS)
    return find_arcs_of_slab(threads, slab, order, Default_method(), report);
  return Critical_sets_engine<Complex>(slab, order).find_arcs(report);
}

// Cuts the surface into several slabs, finds the arcs slab by slab, and glues them.
template <class Complex, class ChosenMethod, class Report>
Swept_arcs find_and_glue_arcs(const Threads& threads,
                              const Complex& complex,
                              const Vertex_order& order,
                              const Swept_vertices& critical_vertices,
                              ChosenMethod method,
                              Index number_of_slabs,
                              const Report& report)
{
  const Slicing<Complex> slicing(threads, complex, order, critical_vertices, number_of_slabs);
  report(0.2);
  Indexed_vector<Slab_index, Swept_arcs> arcs_of_slabs(slicing.number_of_slabs());
  threads.for_each_index(arcs_of_slabs.size(), [&](std::size_t i) {
    arcs_of_slabs[Slab_index(i)] =
      find_arcs_of_slab(threads, slicing.slab(Slab_index(i)), order, method, No_progress());
  });
  return glue_slabs(slicing, arcs_of_slabs, critical_vertices.size());
}

// The slab stage between partition and gluing: finds the arcs between critical vertices, slab by slab. With one slab,
// which needs neither, the engine itself runs in parallel where it can.
template <class Complex, class ChosenMethod, class ChosenNumberOfSlabs, class Report>
Swept_arcs find_arcs(const Threads& threads,
                     const Complex& complex,
                     const Vertex_order& order,
                     const Swept_vertices& critical_vertices,
                     ChosenMethod method,
                     ChosenNumberOfSlabs chosen_number_of_slabs,
                     const Report& report)
{
  if constexpr(!std::is_same_v<ChosenNumberOfSlabs, Default_number_of_slabs>)
  {
    const Index number_of_slabs(std::min<std::size_t>(chosen_number_of_slabs, critical_vertices.size()));
    if(number_of_slabs > 1)
      return find_and_glue_arcs(threads, complex, order, critical_vertices, method, number_of_slabs, report);
  }
  return find_arcs_of_slab(threads, Slab(complex, critical_vertices), order, method, report);
}

// Finds the arcs by the default method, and the one that each regular vertex is on.
template <class Complex>
Swept_arcs find_arcs_and_locate_vertices(const Threads& threads,
                                         const Complex& complex,
                                         const Vertex_order& order,
                                         const Swept_vertices& critical_vertices,
                                         Arc_of_vertex& arc_of_vertex,
                                         const Stage_progress& progress)
{
  const Slab slab(complex, critical_vertices);
  const auto find = [&](auto& queries) {
    Swept_arcs arcs = Contour_trees_engine<Complex>(slab, order).find_arcs(threads, progress, queries);
    arc_of_vertex = queries.take_arc_of_vertex();
    return arcs;
  };
  if(Locate_by_climbing<Complex>::are_fast(complex, critical_vertices))
  {
    Locate_by_climbing<Complex> queries(complex, order, critical_vertices);
    return find(queries);
  }
  Locate_by_sorting<Complex> queries(complex, order, critical_vertices);
  queries.sort(threads);
  return find(queries);
}

#define CGAL_REEB_GRAPH_FIND_ARCS_BY(PREFIX, COMPLEX, METHOD, NUMBER_OF_SLABS)                                         \
  PREFIX template Swept_arcs find_arcs(const Threads&, const COMPLEX&, const Vertex_order&, const Swept_vertices&,     \
                                       METHOD, NUMBER_OF_SLABS, const Stage_progress&);
#define CGAL_REEB_GRAPH_FIND_ARCS(PREFIX, COMPLEX)                                                                     \
  CGAL_REEB_GRAPH_FIND_ARCS_BY(PREFIX, COMPLEX, Default_method, Default_number_of_slabs)                               \
  CGAL_REEB_GRAPH_FIND_ARCS_BY(PREFIX, COMPLEX, Method, Default_number_of_slabs)                                       \
  CGAL_REEB_GRAPH_FIND_ARCS_BY(PREFIX, COMPLEX, Default_method, std::size_t)                                           \
  CGAL_REEB_GRAPH_FIND_ARCS_BY(PREFIX, COMPLEX, Method, std::size_t)                                                   \
  PREFIX template Swept_arcs find_arcs_and_locate_vertices(const Threads&, const COMPLEX&, const Vertex_order&,        \
                                                           const Swept_vertices&, Arc_of_vertex&,                      \
                                                           const Stage_progress&);
CGAL_REEB_GRAPH_FOR_COMPLEXES(CGAL_REEB_GRAPH_FIND_ARCS)

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_FIND_ARCS_H
