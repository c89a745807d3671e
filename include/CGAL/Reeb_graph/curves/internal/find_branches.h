// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_INTERNAL_FIND_BRANCHES_H
#define CGAL_REEB_GRAPH_CURVES_INTERNAL_FIND_BRANCHES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/curves/curve_parameters.h>
#include <CGAL/Reeb_graph/curves/internal/Graph_retract.h>
#include <CGAL/Reeb_graph/curves/internal/simple_reeb_graph.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/piece_measures.h>
#include <CGAL/Reeb_graph/simplification/exceptions.h>
#include <CGAL/Reeb_graph/simplification/internal/Leaf_pruning.h>
#include <CGAL/Reeb_graph/simplification/internal/persistence.h>
#include <CGAL/Reeb_graph/simplification/internal/prune_graph.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// What a branch has to reach, each 0 if it does not count, and what the caller measures.
template <class NamedParameters>
struct Branch_thresholds
{
  static constexpr bool has_measure =
    is_given<decltype(parameters::get_parameter(std::declval<const NamedParameters&>(), branch_measure))>;

  double persistence, area, vertex_count, measure;
  const NamedParameters& named_parameters;

  explicit Branch_thresholds(const NamedParameters& np)
    : persistence(parameters::choose_parameter(parameters::get_parameter(np, persistence_threshold), 0.)),
      area(parameters::choose_parameter(parameters::get_parameter(np, area_threshold), 0.)),
      vertex_count(static_cast<double>(
        parameters::choose_parameter(parameters::get_parameter(np, vertex_count_threshold), std::size_t(0)))),
      measure(parameters::choose_parameter(parameters::get_parameter(np, measure_threshold), 0.)),
      named_parameters(np)
  {
    static_assert(has_measure == is_given<decltype(parameters::get_parameter(np, measure_threshold))>,
                  "The named parameters branch_measure and measure_threshold of branch_curves() go together.");
    if(!(persistence >= 0))
      throw Threshold_error("persistence threshold");
    if(!(area >= 0))
      throw Threshold_error("area threshold");
    if(!(measure >= 0))
      throw Threshold_error("measure threshold");
  }

  bool needs_areas() const { return area > 0 || (has_measure && measure > 0); }
  bool needs_vertex_counts() const { return vertex_count > 0; }

  // The size relative to the thresholds, less than 1 if one of them is not reached.
  template <class Branch>
  double relative_size(const Branch& branch, double vertex_count_of_branch) const
  {
    double size = std::numeric_limits<double>::infinity();
    if(persistence > 0)
      size = (std::min)(size, branch.persistence / persistence);
    if(area > 0)
      size = (std::min)(size, branch.weight / area);
    if(vertex_count > 0)
      size = (std::min)(size, vertex_count_of_branch / vertex_count);
    if constexpr(has_measure)
    {
      if(measure > 0)
        size = (std::min)(size, measure_of_branch(branch, named_parameters) / measure);
    }
    return size;
  }
};

// What the branches weigh.
struct Branch_weight
{
  double area = 0, vertex_count = 0;

  Branch_weight& operator+=(const Branch_weight& other)
  {
    area += other.area;
    vertex_count += other.vertex_count;
    return *this;
  }
};

// By place in the graph. The vertices that count are those of the given mesh.
template <class RankedMesh, class Thresholds>
std::vector<Branch_weight> branch_weights(const RankedMesh& ranked,
                                          const Simple_reeb_graph<RankedMesh>& simple,
                                          const Thresholds& thresholds,
                                          const Stage_progress& progress)
{
  std::vector<Branch_weight> weights(num_vertices(simple.graph) + num_edges(simple.graph));
  if(!thresholds.needs_areas() && !thresholds.needs_vertex_counts())
    return weights;
  const Augmentation<typename RankedMesh::Mesh, typename RankedMesh::Rank_map> augmentation(
    ranked.mesh(), ranked.rank_map(), simple.graph,
    parameters::ties(Ties::CONTRACT).callback(progress.part(0, 0.2).callback()));
  const auto locations = augmentation.locate_vertices(parameters::callback(progress.part(0.2, 0.9).callback()));
  for(const auto v : simple.given_vertices)
    ++weights[locations.index(v)].vertex_count;
  if(thresholds.needs_areas())
  {
    const auto areas =
      areas_of_pieces(ranked.mesh(), simple.graph, locations, parameters::vertex_point_map(ranked.vertex_point_map()));
    for(std::size_t place = 0; place != weights.size(); ++place)
      weights[place].area = areas[place];
  }
  return weights;
}

// The way from the saddle to the leaf along the arcs that have become one leaf arc.
template <class GraphArcs>
auto path_of_branch(const Weighted_leaf_pruning<Branch_weight>& pruned,
                    const Weighted_leaf_arc<Branch_weight>& leaf_arc,
                    const GraphArcs& graph_arcs)
{
  Arc_path<typename GraphArcs::value_type> path;
  path.first_node = leaf_arc.saddle;
  path.last_node = leaf_arc.leaf;
  pruned.for_each_piece(pruned.arc_of_leaf(leaf_arc.leaf), [&](Index arc) {
    path.arcs.push_back({graph_arcs[arc], !leaf_arc.is_minimum});
  });
  if(leaf_arc.is_minimum)
    std::reverse(path.arcs.begin(), path.arcs.end());
  return path;
}

// The branches of a surface: leaf arcs that reach the thresholds, once those that do not have been removed from the
// graph as by simplify(). A leaf at a border is no branch, and an arc between two leaves has none.
template <class RankedMesh, class Thresholds>
auto find_branches(const RankedMesh& ranked,
                   const Simple_reeb_graph<RankedMesh>& simple,
                   const Thresholds& thresholds,
                   const Stage_progress& progress)
{
  typedef typename RankedMesh::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<typename Simple_reeb_graph<RankedMesh>::Graph>::edge_descriptor arc_descriptor;
  const auto& graph = simple.graph;
  const auto difference = [&](Index a, Index b) {
    return persistence(ranked.value(graph[a].vertex), ranked.value(graph[b].vertex));
  };
  typedef Weighted_leaf_arc<Branch_weight> Leaf_arc;
  const auto size = [&](const Leaf_arc& arc) {
    const Branch<vertex_descriptor> branch = {graph[arc.leaf].vertex, graph[arc.saddle].vertex, arc.is_minimum,
                                              persistence_of_leaf_arc(arc, difference), arc.weight.area};
    return thresholds.relative_size(branch, arc.weight.vertex_count);
  };
  Weighted_leaf_pruning<Branch_weight> pruned(static_cast<Index>(num_vertices(graph)), read_arcs(graph),
                                              branch_weights(ranked, simple, thresholds, progress));
  pruned(
    size, [&](const Leaf_arc& arc) { return !simple.is_border[arc.leaf]; },
    [](double relative_size) { return relative_size < 1; }, [](Index) { return true; });

  const std::vector<arc_descriptor> graph_arcs(edges(graph).first, edges(graph).second);
  std::vector<Arc_path<arc_descriptor>> branches;
  for(Index arc = 0; arc != pruned.number_of_arcs(); ++arc)
  {
    const auto [lower, upper] = pruned.arc(arc);
    if(!pruned.is_left(pruned.place_of_arc(arc)) || pruned.is_leaf(lower) == pruned.is_leaf(upper))
      continue;
    const Leaf_arc leaf_arc = pruned.leaf_arc_of(pruned.is_leaf(lower) ? lower : upper);
    if(!simple.is_border[leaf_arc.leaf] && size(leaf_arc) >= 1)
      branches.push_back(path_of_branch(pruned, leaf_arc, graph_arcs));
  }
  return branches;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_CURVES_INTERNAL_FIND_BRANCHES_H
