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
#include <CGAL/Reeb_graph/internal/base/Large_vector.h>
#include <CGAL/Reeb_graph/internal/base/prefetch.h>

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
  explicit Shrinking_tree(const Large_vector<Index>& parents)
  {
    nodes_.reserve(parents.capacity());
    nodes_.assign(parents.size(), Node{no_index, 0, 0});
    constexpr Index ahead = 16;
    for(Index node = 0; node != parents.size(); ++node)
    {
      if(node + ahead < parents.size() && parents[node + ahead] != no_index)
        prefetch(&nodes_[parents[node + ahead]]);
      nodes_[node].parent = parents[node];
      if(parents[node] == no_index)
      {
        ++number_of_roots_;
        continue;
      }
      ++nodes_[parents[node]].number_of_children;
      nodes_[parents[node]].child_names ^= node;
    }
  }

  // Adds nodes, which have to be put somewhere then.
  void resize(std::size_t number_of_nodes) { nodes_.resize(number_of_nodes); }

  void put_above(Index child, Index node)
  {
    const Index parent = nodes_[child].parent;
    nodes_[node] = {parent, 1, child};
    nodes_[child].parent = node;
    if(parent != no_index)
      nodes_[parent].child_names ^= node ^ child;
  }

  void put_leaf_below(Index parent, Index node)
  {
    nodes_[node] = {parent, 0, 0};
    ++nodes_[parent].number_of_children;
    nodes_[parent].child_names ^= node;
  }

  // That of the tree before any node has been removed.
  Index number_of_roots() const { return number_of_roots_; }

  Index parent(Index node) const { return nodes_[node].parent; }
  Index number_of_children(Index node) const { return nodes_[node].number_of_children; }
  Index only_child(Index node) const { return nodes_[node].child_names; }

  void remove_leaf(Index node)
  {
    Node& parent = nodes_[nodes_[node].parent];
    --parent.number_of_children;
    parent.child_names ^= node;
  }

  // The only child takes the place of the node.
  void remove_inner_node(Index node)
  {
    const Index child = only_child(node), parent = nodes_[node].parent;
    nodes_[child].parent = parent;
    if(parent != no_index)
      nodes_[parent].child_names ^= node ^ child;
    nodes_[node].number_of_children = 0;
  }

private:
  struct Node
  {
    Index parent;
    Index number_of_children;
    Index child_names;
  };

  Large_vector<Node> nodes_;
  Index number_of_roots_ = 0;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_SHRINKING_TREE_H
