// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CURVES_FIND_BRANCHES_H
#define CGAL_REEB_GRAPH_INTERNAL_CURVES_FIND_BRANCHES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/curves/curve_parameters.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/curves/Graph_retract.h>
#include <CGAL/Reeb_graph/internal/curves/simple_reeb_graph.h>
#include <CGAL/Reeb_graph/internal/simplification/Leaf_pruning.h>
#include <CGAL/Reeb_graph/internal/simplification/persistence.h>
#include <CGAL/Reeb_graph/internal/simplification/prune_graph.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/simplification/exceptions.h>
#include <CGAL/Reeb_graph/simplification/piece_weights.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The least sizes of branches.
struct Branch_thresholds
{
  double persistence, area;

  template <class NamedParameters>
  explicit Branch_thresholds(const NamedParameters& np)
    : persistence(parameters::choose_parameter(parameters::get_parameter(np, persistence_threshold), 0.)),
      area(parameters::choose_parameter(parameters::get_parameter(np, area_threshold), 0.))
  {
    if(!(persistence >= 0))
      throw Threshold_error("persistence threshold");
    if(!(area >= 0))
      throw Threshold_error("area threshold");
  }

  // The size relative to the thresholds, less than 1 if one of them is not reached.
  double relative_size(double persistence_of_branch, double area_of_branch) const
  {
    double size = std::numeric_limits<double>::infinity();
    if(persistence > 0)
      size = (std::min)(size, persistence_of_branch / persistence);
    if(area > 0)
      size = (std::min)(size, area_of_branch / area);
    return size;
  }
};

// The area of each node and arc, and zeros if no area is asked for.
template <class RankedMesh>
std::vector<double> branch_weights(const RankedMesh& ranked,
                                   const Simple_reeb_graph<RankedMesh>& simple,
                                   const Branch_thresholds& thresholds)
{
  if(!(thresholds.area > 0))
    return std::vector<double>(num_vertices(simple.graph) + num_edges(simple.graph), 0);
  const Augmentation<typename RankedMesh::Mesh, typename RankedMesh::Rank_map> augmentation(
    ranked.mesh(), ranked.rank_map(), simple.graph, parameters::ties(Ties::CONTRACT));
  return areas_of_pieces(ranked.mesh(), simple.graph, augmentation.locate_vertices(),
                         parameters::vertex_point_map(ranked.vertex_point_map()));
}

// The way from the saddle to the leaf along the arcs that have become one leaf arc.
template <class GraphArcs>
auto path_of_branch(const Leaf_pruning& pruned, const Leaf_arc& leaf_arc, const GraphArcs& graph_arcs)
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
template <class RankedMesh>
auto find_branches(const RankedMesh& ranked,
                   const Simple_reeb_graph<RankedMesh>& simple,
                   const Branch_thresholds& thresholds)
{
  typedef typename boost::graph_traits<typename Simple_reeb_graph<RankedMesh>::Graph>::edge_descriptor arc_descriptor;
  const auto& graph = simple.graph;
  const auto difference = [&](Index a, Index b) {
    return persistence(ranked.value(graph[a].vertex), ranked.value(graph[b].vertex));
  };
  const auto size = [&](const Leaf_arc& arc) {
    return thresholds.relative_size(persistence_of_leaf_arc(arc, difference), arc.weight);
  };
  Leaf_pruning pruned(static_cast<Index>(num_vertices(graph)), read_arcs(graph),
                      branch_weights(ranked, simple, thresholds));
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

#endif // CGAL_REEB_GRAPH_INTERNAL_CURVES_FIND_BRANCHES_H
