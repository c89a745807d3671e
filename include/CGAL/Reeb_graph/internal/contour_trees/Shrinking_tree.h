// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_SHRINKING_TREE_H
#define CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_SHRINKING_TREE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/base/prefetch.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab_arc.h>

#include <cstddef>

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

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_SHRINKING_TREE_H
