// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_TREE_COMBINATION_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_TREE_COMBINATION_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/engine/Locate_on_arcs.h>

#include <cstddef>
#include <utility>

namespace CGAL::Reeb_graph::internal {

// A rooted tree from which leaves and nodes with one child are taken away. The children of a node are known by their
// number and by the exclusive or of their names, which is the name of the last one.
class Shrinking_tree
{
public:
  Shrinking_tree() = default;
  // Room that is left for more nodes is left here too.
  explicit Shrinking_tree(const Indexed_vector<Tree_node, Tree_node>& parents)
  {
    nodes_.reserve(parents.capacity());
    nodes_.assign(parents.size(), Node{no_index, 0, 0});
    constexpr Index ahead = 16;
    for(const Tree_node node : parents.keys())
    {
      const Tree_node later(node.number() + ahead);
      if(parents.contains(later) && parents[later] != no_index)
        prefetch(&nodes_[parents[later]]);
      nodes_[node].parent = parents[node];
      if(parents[node] == no_index)
        continue;
      ++nodes_[parents[node]].number_of_children;
      nodes_[parents[node]].child_names ^= node.number();
    }
  }

  // Adds nodes, which have to be put somewhere then.
  void resize(std::size_t number_of_nodes) { nodes_.resize(number_of_nodes); }

  // The child is no root.
  void put_above(Tree_node child, Tree_node node)
  {
    const Tree_node parent = nodes_[child].parent;
    nodes_[node] = {parent, 1, child.number()};
    nodes_[child].parent = node;
    nodes_[parent].child_names ^= node.number() ^ child.number();
  }

  void put_leaf_below(Tree_node parent, Tree_node node)
  {
    nodes_[node] = {parent, 0, 0};
    ++nodes_[parent].number_of_children;
    nodes_[parent].child_names ^= node.number();
  }

  Tree_node parent(Tree_node node) const { return nodes_[node].parent; }
  Index number_of_children(Tree_node node) const { return nodes_[node].number_of_children; }
  Tree_node only_child(Tree_node node) const { return Tree_node(nodes_[node].child_names); }

  void remove_leaf(Tree_node node)
  {
    Node& parent = nodes_[nodes_[node].parent];
    --parent.number_of_children;
    parent.child_names ^= node.number();
  }

  // The only child takes the place of the node.
  void remove_inner_node(Tree_node node)
  {
    const Tree_node child = only_child(node), parent = nodes_[node].parent;
    nodes_[child].parent = parent;
    if(parent != no_index)
      nodes_[parent].child_names ^= node.number() ^ child.number();
    nodes_[node].number_of_children = 0;
  }

private:
  struct Node
  {
    Tree_node parent;
    Index number_of_children;
    Index child_names;
  };

  Indexed_vector<Tree_node, Node> nodes_;
};

// Combines a join tree and a split tree of the same nodes to the arcs of the contour tree, leaf by leaf. (H. Carr,
// J. Snoeyink, U. Axen, Computing contour trees in all dimensions, 2003.) On request, it keeps what
// find_arcs_of_classes() needs.
template <bool are_leaves_kept>
class Tree_combination
{
public:
  Tree_combination(Shrinking_tree join_tree,
                   Shrinking_tree split_tree,
                   Indexed_vector<Tree_node, Ascending_step> first_steps)
    : trees_{{std::move(join_tree), std::move(split_tree)}},
      first_steps_(std::move(first_steps))
  {
    arcs_.reserve(first_steps_.size());
  }

  Swept_arcs operator()()
  {
    for(const Tree_node node : first_steps_.keys())
      take_leaves_from(node);
    return std::move(arcs_);
  }

  // Follows the classes to the arcs that have been found: in the tree where a leaf of the other one is no leaf, the
  // only child takes its place, and goes later.
  Arcs_of_classes find_arcs_of_classes(const Swept_arcs& arcs) const
  {
    static_assert(are_leaves_kept);
    Arcs_of_classes result;
    for(const Side side : both_sides)
      result[side].reset(first_steps_.size(), no_index);
    for(std::size_t i = arcs.size(); i != 0;)
    {
      const Swept_arc_index arc(--i);
      const Side side = sides_of_leaves_[i];
      const Tree_node leaf = side == Side::LOWER ? arcs[arc].lower : arcs[arc].upper;
      const Side other = opposite_of(side);
      result[side][leaf] = arc;
      result[other][leaf] = result[other][trees_[other].only_child(leaf)];
    }
    return result;
  }

private:
  // Whether the node is a leaf that is left at one side: the lower one in the join tree, the upper one in the split tree.
  // A root is no leaf, as it is none of trees of the same order.
  template <Side side>
  bool is_leaf(Tree_node node) const
  {
    return trees_[side].number_of_children(node) == 0 && trees_[opposite_of(side)].number_of_children(node) == 1
        && trees_[side].parent(node) != no_index;
  }

  // Takes the node away if it is a leaf, and then its neighbor if that makes it one, and so on.
  void take_leaves_from(Tree_node node)
  {
    while(node != no_index)
    {
      if(is_leaf<Side::LOWER>(node))
        node = take_leaf<Side::LOWER>(node);
      else if(is_leaf<Side::UPPER>(node))
        node = take_leaf<Side::UPPER>(node);
      else
        node = no_index;
    }
  }

  // Returns the other end of the leaf's arc.
  template <Side side>
  Tree_node take_leaf(Tree_node leaf)
  {
    const Tree_node end = trees_[side].parent(leaf);
    if constexpr(side == Side::LOWER)
    {
      const Tree_node child = trees_[Side::UPPER].only_child(leaf);
      arcs_.push_back({leaf, end, first_steps_[child]});
      first_steps_[child] = first_steps_[leaf];
    }
    else
      arcs_.push_back({end, leaf, first_steps_[leaf]});
    if constexpr(are_leaves_kept)
      sides_of_leaves_.push_back(side);
    trees_[side].remove_leaf(leaf);
    trees_[opposite_of(side)].remove_inner_node(leaf);
    return end;
  }

  By_side<Shrinking_tree> trees_;
  Indexed_vector<Tree_node, Ascending_step> first_steps_; // from its parent in the split tree towards it
  Swept_arcs arcs_;
  Plain_vector<Side> sides_of_leaves_; // by arc
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_TREE_COMBINATION_H
