// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_PAIRS_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_PAIRS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/union_find.h>
#include <CGAL/Reeb_graph/simplification/exceptions.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
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

// For each node of a graph, the other ends of its arcs on one side, one for each arc.
class Node_neighbors
{
public:
  typedef Iterator_range<const Index*> Range;

  Index number_of_nodes() const { return static_cast<Index>(begins_.size() - 1); }
  Index number_of_arcs() const { return static_cast<Index>(neighbors_.size()); }
  Index degree(Index node) const { return begins_[node + 1] - begins_[node]; }
  Range operator[](Index node) const
  {
    return Range(neighbors_.data() + begins_[node], neighbors_.data() + begins_[node + 1]);
  }

  // To be called for one node after the other, and for each arc of it in between.
  void begin_node() { begins_.push_back(static_cast<Index>(neighbors_.size())); }
  void add(Index neighbor) { neighbors_.push_back(neighbor); }
  void end_nodes() { begin_node(); }

  void reserve(Index nodes, Index arcs)
  {
    begins_.reserve(nodes + std::size_t(1));
    neighbors_.reserve(arcs);
  }

private:
  std::vector<Index> begins_; // by node, and the end of the last one
  std::vector<Index> neighbors_;
};

// The ends of the arcs of a graph whose nodes are numbered in ascending order.
struct Flat_arc_ends
{
  Node_neighbors lower, upper; // the lower ends of the arcs below a node, the upper ends of those above
};

// The arcs of a Boost graph. Throws if one of them does not ascend.
template <class ReebGraph>
Flat_arc_ends read_arc_ends(const ReebGraph& graph)
{
  const Index number_of_nodes = checked_index(num_vertices(graph)), number_of_arcs = checked_index(num_edges(graph));
  Flat_arc_ends ends;
  ends.lower.reserve(number_of_nodes, number_of_arcs);
  ends.upper.reserve(number_of_nodes, number_of_arcs);
  for(Index node = 0; node != number_of_nodes; ++node)
  {
    ends.lower.begin_node();
    ends.upper.begin_node();
    for(auto arcs = in_edges(node, graph); arcs.first != arcs.second; ++arcs.first)
    {
      const auto lower = source(*arcs.first, graph);
      if(lower >= node)
        throw Arc_direction_error();
      ends.lower.add(static_cast<Index>(lower));
    }
    for(auto arcs = out_edges(node, graph); arcs.first != arcs.second; ++arcs.first)
      ends.upper.add(static_cast<Index>(target(*arcs.first, graph)));
  }
  ends.lower.end_nodes();
  ends.upper.end_nodes();
  return ends;
}

// Sweeps over the nodes upwards. Calls visit_pair(minimum, saddle) where two components meet, for the one of higher
// minimum: the elder rule. The root of a component is its eldest node, the one that the sweep has met first. What is left
// are the components of the graph, by their lowest minima.
template <class VisitPair>
Disjoint_sets<Index> sweep_upwards(const Node_neighbors& lower_ends, const VisitPair& visit_pair)
{
  Disjoint_sets<Index> components(lower_ends.number_of_nodes());
  for(Index node = 0; node != lower_ends.number_of_nodes(); ++node)
  {
    Index root = node;
    for(const Index neighbor : lower_ends[node])
    {
      const Index other_root = components.find(neighbor);
      if(other_root == root)
        continue;
      const Index younger = (std::max)(root, other_root), elder = (std::min)(root, other_root);
      components.link(younger, elder);
      if(younger != node)
        visit_pair(younger, node);
      root = elder;
    }
  }
  return components;
}

// The same downwards: calls visit_pair(saddle, maximum).
template <class VisitPair>
void sweep_downwards(const Node_neighbors& upper_ends, const VisitPair& visit_pair)
{
  Disjoint_sets<Index> components(upper_ends.number_of_nodes());
  for(Index node = upper_ends.number_of_nodes(); node-- != 0;)
  {
    Index root = node;
    for(const Index neighbor : upper_ends[node])
    {
      const Index other_root = components.find(neighbor);
      if(other_root == root)
        continue;
      const Index younger = (std::min)(root, other_root), elder = (std::max)(root, other_root);
      components.link(younger, elder);
      if(younger != node)
        visit_pair(node, younger);
      root = elder;
    }
  }
}

// Calls visit_pair(lowest minimum, highest maximum) for each component.
template <class VisitPair>
void pair_ends_of_components(Disjoint_sets<Index> components, Index number_of_nodes, const VisitPair& visit_pair)
{
  std::vector<Index> highest(number_of_nodes);
  for(Index node = 0; node != number_of_nodes; ++node)
    highest[components.find(node)] = node;
  for(Index node = 0; node != number_of_nodes; ++node)
  {
    if(components.find(node) == node)
      visit_pair(node, highest[node]);
  }
}

// A spanning forest that is maximal by the keys of its arcs, while arcs are added.
class Highest_forest
{
public:
  struct Arc
  {
    Index lower, upper;
    Index key;
    Index label;
  };

  // The labels of the arc that leaves, and of the lowest one of the cycle besides the added one; no_index if the added
  // arc closes no cycle.
  struct Cycle
  {
    Index leaving, lowest_other;
  };

  explicit Highest_forest(Index number_of_nodes)
    : number_of_nodes_(number_of_nodes),
      components_(number_of_nodes),
      forest_(2 * number_of_nodes)
  {
    arcs_.reserve(number_of_nodes);
  }

  // Adds an arc. If it closes a cycle, the arc of lowest key leaves; of equal ones the new one.
  Cycle add(const Arc& arc)
  {
    const Index lower_root = components_.find(arc.lower), upper_root = components_.find(arc.upper);
    if(lower_root != upper_root)
    {
      components_.link((std::max)(lower_root, upper_root), (std::min)(lower_root, upper_root));
      arcs_.push_back(arc);
      insert(static_cast<Index>(number_of_nodes_ + arcs_.size() - 1));
      return {no_index, no_index};
    }
    const Index lowest = forest_.lowest_on_path(arc.lower, arc.upper);
    Arc& lowest_arc = arcs_[lowest - number_of_nodes_];
    const Index lowest_label = lowest_arc.label;
    if(arc.key <= lowest_arc.key)
      return {arc.label, lowest_label};
    forest_.cut(lowest_arc.lower, lowest);
    forest_.cut(lowest_arc.upper, lowest);
    lowest_arc = arc;
    insert(lowest);
    return {lowest_label, lowest_label};
  }

private:
  // Arcs are nodes of the forest, too.
  void insert(Index place)
  {
    const Arc& arc = arcs_[place - number_of_nodes_];
    forest_.set_key(place, arc.key);
    forest_.link(place, arc.lower);
    forest_.link(place, arc.upper);
  }

  Index number_of_nodes_;
  Disjoint_sets<Index> components_;
  Link_cut_forest forest_;
  std::vector<Arc> arcs_; // those that are in the forest
};

// The part of a graph that loops are in, its 2-core: what is left when leaves are removed one after the other. Of a
// noisy field it is small.
class Graph_core
{
public:
  explicit Graph_core(const Flat_arc_ends& ends)
    : ends_(ends),
      is_in_(ends.lower.number_of_nodes(), true),
      degrees_(ends.lower.number_of_nodes())
  {
    for(Index node = 0; node != size(); ++node)
      degrees_[node] = ends.lower.degree(node) + ends.upper.degree(node);
    for(Index node = 0; node != size(); ++node)
      remove_leaves(node);
  }

  Index size() const { return static_cast<Index>(is_in_.size()); }
  bool contains(Index node) const { return is_in_[node]; }

  // Whether one arc of the core enters the node and one leaves it.
  bool is_passed(Index node) const { return degrees_[node] == 2 && degree_in_core(ends_.lower, node) == 1; }

  // Calls visit(lower end) for each arc of the core below a node, where arcs that meet at passed nodes are one.
  template <class Visit>
  void for_each_arc_below(Index node, const Visit& visit) const
  {
    for(const Index neighbor : ends_.lower[node])
    {
      if(!is_in_[neighbor])
        continue;
      Index lower = neighbor;
      while(is_passed(lower))
        lower = neighbor_in_core(lower);
      visit(lower);
    }
  }

private:
  void remove_leaves(Index node)
  {
    while(node != no_index && is_in_[node] && degrees_[node] <= 1)
    {
      is_in_[node] = false;
      const Index next = degrees_[node] == 0 ? no_index : any_neighbor_in_core(node);
      if(next != no_index)
        --degrees_[next];
      node = next;
    }
  }

  Index degree_in_core(const Node_neighbors& neighbors, Index node) const
  {
    Index degree = 0;
    for(const Index neighbor : neighbors[node])
      degree += is_in_[neighbor] ? 1 : 0;
    return degree;
  }

  Index neighbor_in_core(Index node) const { return first_in_core(ends_.lower[node]); }

  Index any_neighbor_in_core(Index node) const
  {
    const Index lower = first_in_core(ends_.lower[node]);
    return lower != no_index ? lower : first_in_core(ends_.upper[node]);
  }

  Index first_in_core(const Node_neighbors::Range& neighbors) const
  {
    for(const Index neighbor : neighbors)
    {
      if(is_in_[neighbor])
        return neighbor;
    }
    return no_index;
  }

  const Flat_arc_ends& ends_;
  std::vector<bool> is_in_;
  std::vector<Index> degrees_; // in the core
};

// Calls visit_pair(split saddle, join saddle) for each independent loop: the upper node of an arc that closes a cycle
// is paired with the highest node that can be the lowest one of such a cycle.
template <class VisitPair>
void pair_loops(const Flat_arc_ends& ends, const VisitPair& visit_pair)
{
  const Graph_core core(ends);
  std::vector<Index> nodes, numbers(core.size(), no_index);
  for(Index node = 0; node != core.size(); ++node)
  {
    if(!core.contains(node) || core.is_passed(node))
      continue;
    numbers[node] = static_cast<Index>(nodes.size());
    nodes.push_back(node);
  }
  Highest_forest forest(checked_index(2 * nodes.size()) / 2);
  for(const Index node : nodes)
  {
    core.for_each_arc_below(node, [&](Index lower) {
      const Index partner = forest.add({numbers[lower], numbers[node], numbers[lower], lower}).leaving;
      if(partner != no_index)
        visit_pair(partner, node);
    });
  }
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_PAIRS_H
