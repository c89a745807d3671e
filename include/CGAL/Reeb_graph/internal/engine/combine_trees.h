// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_COMBINE_TREES_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_COMBINE_TREES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/tuning.h>
#include <CGAL/Reeb_graph/internal/engine/Slab.h>
#include <CGAL/Reeb_graph/internal/engine/monotone_paths.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A rooted tree from which leaves and nodes with one child are taken away. The children of a node are known by their
// number and by the exclusive or of their names, which is the name of the last one.
class Shrinking_tree
{
public:
  Shrinking_tree() = default;
  // Room that is left for more nodes is left here too.
  explicit Shrinking_tree(const Indexed_vector<Slab_node, Slab_node>& parents)
  {
    nodes_.reserve(parents.capacity());
    nodes_.assign(parents.size(), Node{no_index, 0, 0});
    constexpr Number ahead = 16;
    for(const Slab_node node : parents.keys())
    {
      const Slab_node later(node.number() + ahead);
      if(parents.contains(later) && parents[later] != no_index)
        prefetch(&nodes_[parents[later]]);
      nodes_[node].parent = parents[node];
      if(parents[node] == no_index)
      {
        ++number_of_roots_;
        continue;
      }
      ++nodes_[parents[node]].number_of_children;
      nodes_[parents[node]].child_names ^= node.number();
    }
  }

  // Adds nodes, which have to be put somewhere then.
  void resize(std::size_t number_of_nodes) { nodes_.resize(number_of_nodes); }

  // The child is no root.
  void put_above(Slab_node child, Slab_node node)
  {
    const Slab_node parent = nodes_[child].parent;
    nodes_[node] = {parent, 1, child.number()};
    nodes_[child].parent = node;
    nodes_[parent].child_names ^= node.number() ^ child.number();
  }

  void put_leaf_below(Slab_node parent, Slab_node node)
  {
    nodes_[node] = {parent, 0, 0};
    ++nodes_[parent].number_of_children;
    nodes_[parent].child_names ^= node.number();
  }

  // How many roots the tree has before any node is removed.
  Number number_of_roots() const { return number_of_roots_; }

  Slab_node parent(Slab_node node) const { return nodes_[node].parent; }
  Number number_of_children(Slab_node node) const { return nodes_[node].number_of_children; }
  Slab_node only_child(Slab_node node) const { return Slab_node(nodes_[node].child_names); }

  void remove_leaf(Slab_node node)
  {
    Node& parent = nodes_[nodes_[node].parent];
    --parent.number_of_children;
    parent.child_names ^= node.number();
  }

  // The only child takes the place of the node.
  void remove_inner_node(Slab_node node)
  {
    const Slab_node child = only_child(node), parent = nodes_[node].parent;
    nodes_[child].parent = parent;
    if(parent != no_index)
      nodes_[parent].child_names ^= node.number() ^ child.number();
    nodes_[node].number_of_children = 0;
  }

private:
  struct Node
  {
    Slab_node parent;
    Number number_of_children;
    Number child_names;
  };

  Indexed_vector<Slab_node, Node> nodes_;
  Number number_of_roots_ = 0;
};

// By node of the join tree and of the split tree: the arc that the arc to the parent of the node has gone to, the first
// one if it has been split; no_index if none.
typedef By_side<Indexed_vector<Slab_node, Slab_arc_index>> Arcs_of_classes;

// Combines a join tree and a split tree of the same nodes to the arcs of the contour tree, leaf by leaf. (H. Carr,
// J. Snoeyink, U. Axen, Computing contour trees in all dimensions, 2003.) On request, it keeps what
// find_arcs_of_classes() needs.
template <bool are_leaves_kept>
class Tree_combination
{
public:
  Tree_combination(Shrinking_tree join_tree,
                   Shrinking_tree split_tree,
                   Indexed_vector<Slab_node, Ascending_step> first_steps)
    : join_tree_(std::move(join_tree)),
      split_tree_(std::move(split_tree)),
      first_steps_(std::move(first_steps))
  {
    arcs_.reserve(first_steps_.size());
  }

  Slab_arcs operator()()
  {
    for(const Slab_node node : first_steps_.keys())
      take_leaves_from(node);
    return std::move(arcs_);
  }

  // Follows the classes to the arcs that have been found: in the tree where a leaf of the other one is no leaf, the
  // only child takes its place, and goes later.
  Arcs_of_classes find_arcs_of_classes(const Slab_arcs& arcs) const
  {
    static_assert(are_leaves_kept);
    Arcs_of_classes result;
    for(const Side side : both_sides)
      result[side].renew(first_steps_.size(), no_index);
    for(std::size_t i = arcs.size(); i != 0;)
    {
      const Slab_arc_index arc(--i);
      const Side side = sides_of_leaves_[i];
      const Slab_node leaf = side == Side::LOWER ? arcs[arc].lower : arcs[arc].upper;
      const Shrinking_tree& other_tree = side == Side::LOWER ? split_tree_ : join_tree_;
      result[side][leaf] = arc;
      result[opposite_of(side)][leaf] = result[opposite_of(side)][other_tree.only_child(leaf)];
    }
    return result;
  }

private:
  // A root is no leaf, as it is none of trees of the same order.
  bool is_lower_leaf(Slab_node node) const
  {
    return join_tree_.number_of_children(node) == 0 && split_tree_.number_of_children(node) == 1
        && join_tree_.parent(node) != no_index;
  }

  bool is_upper_leaf(Slab_node node) const
  {
    return split_tree_.number_of_children(node) == 0 && join_tree_.number_of_children(node) == 1
        && split_tree_.parent(node) != no_index;
  }

  // Takes the node away if it is a leaf, and then its neighbor if that makes it one, and so on.
  void take_leaves_from(Slab_node node)
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

  Slab_node take_lower_leaf(Slab_node node)
  {
    const Slab_node upper = join_tree_.parent(node), child = split_tree_.only_child(node);
    arcs_.push_back({node, upper, first_steps_[child]});
    keep_side(Side::LOWER);
    first_steps_[child] = first_steps_[node];
    join_tree_.remove_leaf(node);
    split_tree_.remove_inner_node(node);
    return upper;
  }

  Slab_node take_upper_leaf(Slab_node node)
  {
    const Slab_node lower = split_tree_.parent(node);
    arcs_.push_back({lower, node, first_steps_[node]});
    keep_side(Side::UPPER);
    split_tree_.remove_leaf(node);
    join_tree_.remove_inner_node(node);
    return lower;
  }

  void keep_side(Side side)
  {
    if constexpr(are_leaves_kept)
      sides_of_leaves_.push_back(side);
  }

  Shrinking_tree join_tree_;
  Shrinking_tree split_tree_;
  Indexed_vector<Slab_node, Ascending_step> first_steps_; // from its parent in the split tree towards it
  Slab_arcs arcs_;
  Plain_vector<Side> sides_of_leaves_; // by arc
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_COMBINE_TREES_H
