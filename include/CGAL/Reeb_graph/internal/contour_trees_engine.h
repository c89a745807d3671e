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
#include <CGAL/Reeb_graph/internal/Triangle_complex.h>
#include <CGAL/Reeb_graph/internal/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/loop_surgery.h>
#include <CGAL/Reeb_graph/internal/merge_trees.h>
#include <CGAL/Reeb_graph/internal/parallel.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A rooted tree from which leaves and nodes with one child are taken away. The children of a node are known by their
// number and by the exclusive or of their names, which is the name of the last one.
class Shrinking_tree
{
public:
  explicit Shrinking_tree(std::vector<Index> parents)
    : parents_(std::move(parents)),
      child_counts_(parents_.size(), 0),
      child_names_(parents_.size(), 0)
  {
    for(Index node = 0; node != parents_.size(); ++node)
    {
      if(parents_[node] == no_index)
        continue;
      ++child_counts_[parents_[node]];
      child_names_[parents_[node]] ^= node;
    }
  }

  Index parent(Index node) const { return parents_[node]; }
  Index number_of_children(Index node) const { return child_counts_[node]; }
  Index only_child(Index node) const { return child_names_[node]; }

  void remove_leaf(Index node)
  {
    --child_counts_[parents_[node]];
    child_names_[parents_[node]] ^= node;
  }

  // The only child takes the place of the node.
  void remove_inner_node(Index node)
  {
    const Index child = only_child(node);
    parents_[child] = parents_[node];
    if(parents_[node] != no_index)
      child_names_[parents_[node]] ^= node ^ child;
    child_counts_[node] = 0;
  }

private:
  std::vector<Index> parents_;
  std::vector<Index> child_counts_;
  std::vector<Index> child_names_;
};

// Merges a join tree and a split tree of the same nodes into the arcs of the contour tree, leaf by leaf. (H. Carr,
// J. Snoeyink, U. Axen, Computing contour trees in all dimensions, 2003.)
class Contour_tree_merge
{
public:
  Contour_tree_merge(Merge_tree&& join_tree, Merge_tree&& split_tree)
    : join_tree_(std::move(join_tree.parents)),
      split_tree_(std::move(split_tree.parents)),
      first_steps_(std::move(split_tree.first_steps))
  {}

  std::vector<Critical_arc> operator()()
  {
    for(Index node = 0; node != first_steps_.size(); ++node)
      take_leaves_from(node);
    return std::move(arcs_);
  }

private:
  bool is_lower_leaf(Index node) const
  {
    return join_tree_.number_of_children(node) == 0 && split_tree_.number_of_children(node) == 1;
  }

  bool is_upper_leaf(Index node) const
  {
    return split_tree_.number_of_children(node) == 0 && join_tree_.number_of_children(node) == 1;
  }

  // Takes the node away if it is a leaf, and then its neighbor if that makes it one, and so on.
  void take_leaves_from(Index node)
  {
    while(node != no_index)
    {
      if(is_lower_leaf(node))
        node = take_lower_leaf(node);
      else if(is_upper_leaf(node))
        node = take_upper_leaf(node);
      else
        node = no_index;
    }
  }

  Index take_lower_leaf(Index node)
  {
    const Index upper = join_tree_.parent(node), child = split_tree_.only_child(node);
    arcs_.push_back({node, upper, first_steps_[child]});
    first_steps_[child] = first_steps_[node];
    join_tree_.remove_leaf(node);
    split_tree_.remove_inner_node(node);
    return upper;
  }

  Index take_upper_leaf(Index node)
  {
    const Index lower = split_tree_.parent(node);
    arcs_.push_back({lower, node, first_steps_[node]});
    split_tree_.remove_leaf(node);
    join_tree_.remove_inner_node(node);
    return lower;
  }

  Shrinking_tree join_tree_;
  Shrinking_tree split_tree_;
  std::vector<Ascending_step> first_steps_;
  std::vector<Critical_arc> arcs_;
};

// Where an arc ends at a cut it goes on to the vertex just above, and the short arc from the cut to there is dropped.
inline void glue_cuts(const Cut_contours& cuts, std::vector<Critical_arc>& arcs)
{
  arcs.erase(
    std::remove_if(arcs.begin(), arcs.end(), [&](const Critical_arc& arc) { return cuts.is_node_above(arc.lower); }),
    arcs.end());
  for(Critical_arc& arc : arcs)
  {
    if(cuts.is_node_below(arc.upper))
      arc.upper = cuts.critical_vertex(cuts.cut_of_node(arc.upper));
  }
}

// Contour trees joined by loop surgery: near-linear for any field. The surface is cut along the few contours that
// close loops; what is left has a tree as Reeb graph, which comes from its join tree and its split tree.
template <class ConcurrencyTag, class Order>
std::vector<Critical_arc> find_arcs_by_contour_trees(const Triangle_complex& complex,
                                                     const Order& order,
                                                     const Critical_vertices& critical_vertices)
{
  const Cut_contours no_cuts(critical_vertices.size());
  Merge_tree join_tree, split_tree;
  invoke_both<ConcurrencyTag>([&] { join_tree = compute_join_tree(complex, order, critical_vertices); },
                              [&] { split_tree = compute_split_tree(complex, order, critical_vertices, no_cuts); });
  const Cut_contours cuts = Loop_surgery<Order>(complex, order, critical_vertices, join_tree, split_tree)();
  if(cuts.size() != 0)
  {
    split_tree = compute_split_tree(complex, order, critical_vertices, cuts);
    insert_cuts(cuts, join_tree);
  }
  std::vector<Critical_arc> arcs = Contour_tree_merge(std::move(join_tree), std::move(split_tree))();
  glue_cuts(cuts, arcs);
  return arcs;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_ENGINE_H
