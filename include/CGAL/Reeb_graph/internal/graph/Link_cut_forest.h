// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_GRAPH_LINK_CUT_FOREST_H
#define CGAL_REEB_GRAPH_INTERNAL_GRAPH_LINK_CUT_FOREST_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <array>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// A forest of numbered nodes with keys, whose edges come and go: the link-cut trees of D. D. Sleator and R. E. Tarjan,
// Self-Adjusting Binary Search Trees, 1985. Each operation takes amortized logarithmic time. An edge that needs a key
// is best made a node between its ends.
class Link_cut_forest
{
public:
  // Nodes without an edge, all with the highest key.
  explicit Link_cut_forest(Index size) : records_(size)
  {
    for(Index node = 0; node != size; ++node)
      records_[node].lowest = node;
  }

  // For a node without an edge.
  void set_key(Index node, Index key) { records_[node].key = key; }

  Index key(Index node) const { return records_[node].key; }

  // Adds an edge between nodes of different trees.
  void link(Index a, Index b)
  {
    make_root(a);
    records_[a].parent = b;
  }

  // Removes the edge between two nodes.
  void cut(Index a, Index b)
  {
    expose_path(a, b);
    records_[b].children[0] = no_index;
    records_[a].parent = no_index;
    update(b);
  }

  // The node of lowest key on the path between two nodes of a tree, both of them included.
  Index lowest_on_path(Index a, Index b)
  {
    expose_path(a, b);
    return records_[b].lowest;
  }

private:
  // Each tree is divided into paths, and the nodes of a path are in a binary search tree, in the order of their depth.
  struct Record
  {
    Index parent = no_index; // in the search tree; at its root, the node of the forest above the path
    std::array<Index, 2> children = {no_index, no_index};
    Index key = no_index;
    Index lowest = no_index; // of the nodes below this one in the search tree, and itself
    bool is_reversed = false;
  };

  bool is_root_of_path(Index node) const
  {
    const Index parent = records_[node].parent;
    return parent == no_index || (records_[parent].children[0] != node && records_[parent].children[1] != node);
  }

  void update(Index node)
  {
    Record& record = records_[node];
    record.lowest = node;
    for(const Index child : record.children)
    {
      if(child != no_index && key(records_[child].lowest) < key(record.lowest))
        record.lowest = records_[child].lowest;
    }
  }

  void push_reversal(Index node)
  {
    Record& record = records_[node];
    if(!record.is_reversed)
      return;
    record.is_reversed = false;
    std::swap(record.children[0], record.children[1]);
    for(const Index child : record.children)
    {
      if(child != no_index)
        records_[child].is_reversed = !records_[child].is_reversed;
    }
  }

  void rotate_up(Index node)
  {
    const Index parent = records_[node].parent, grandparent = records_[parent].parent;
    const int side = records_[parent].children[0] == node ? 0 : 1;
    const Index middle = records_[node].children[1 - side];
    if(!is_root_of_path(parent))
      records_[grandparent].children[records_[grandparent].children[0] == parent ? 0 : 1] = node;
    records_[node].parent = grandparent;
    records_[node].children[1 - side] = parent;
    records_[parent].parent = node;
    records_[parent].children[side] = middle;
    if(middle != no_index)
      records_[middle].parent = parent;
    update(parent);
    update(node);
  }

  // Makes a node the root of its search tree.
  void splay(Index node)
  {
    path_.assign(1, node);
    while(!is_root_of_path(path_.back()))
      path_.push_back(records_[path_.back()].parent);
    for(auto it = path_.rbegin(); it != path_.rend(); ++it)
      push_reversal(*it);
    while(!is_root_of_path(node))
    {
      const Index parent = records_[node].parent;
      if(!is_root_of_path(parent))
      {
        const Index grandparent = records_[parent].parent;
        const bool are_on_one_side =
          (records_[parent].children[0] == node) == (records_[grandparent].children[0] == parent);
        rotate_up(are_on_one_side ? parent : node);
      }
      rotate_up(node);
    }
  }

  // Makes the nodes from the root of the tree to this one a path, and this one the root of its search tree.
  void expose(Index node)
  {
    Index lower_part = no_index;
    for(Index top = node; top != no_index; top = records_[top].parent)
    {
      splay(top);
      records_[top].children[1] = lower_part;
      update(top);
      lower_part = top;
    }
    splay(node);
  }

  void make_root(Index node)
  {
    expose(node);
    records_[node].is_reversed = !records_[node].is_reversed;
    push_reversal(node);
  }

  void expose_path(Index a, Index b)
  {
    make_root(a);
    expose(b);
  }

  std::vector<Record> records_;
  std::vector<Index> path_; // kept so that its memory is
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_GRAPH_LINK_CUT_FOREST_H
