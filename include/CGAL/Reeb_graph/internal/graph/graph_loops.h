// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_GRAPH_GRAPH_LOOPS_H
#define CGAL_REEB_GRAPH_INTERNAL_GRAPH_GRAPH_LOOPS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The nodes of an arc, which are numbered in ascending order.
struct Ascending_arc
{
  Index lower, upper;
};

// The arcs of a Boost graph. Throws if one of them does not ascend.
template <class ReebGraph>
std::vector<Ascending_arc> read_arcs(const ReebGraph& graph)
{
  std::vector<Ascending_arc> arcs;
  arcs.reserve(num_edges(graph));
  checked_index(num_vertices(graph) + num_edges(graph));
  for(auto range = edges(graph); range.first != range.second; ++range.first)
  {
    const auto lower = source(*range.first, graph), upper = target(*range.first, graph);
    if(!(lower < upper))
      throw Graph_mismatch_error("an arc of the graph does not lead to a node of higher number");
    arcs.push_back({static_cast<Index>(lower), static_cast<Index>(upper)});
  }
  return arcs;
}

// Exact numbers are rounded one by one, each with an error of its own. One that comes out of order by that, seen from the
// last one, is taken to be equal.
template <class Scalar>
double number_in_order(const Scalar& value, double number, const Scalar& last_value, double last_number)
{
  const bool is_out_of_order = last_value < value ? number < last_number
                             : value < last_value ? number > last_number
                                                  : number != last_number;
  return is_out_of_order ? last_number : number;
}

// By node, the numbers of the values.
template <class ReebGraph, class NamedParameters>
std::vector<double> numbers_of_nodes(const ReebGraph& graph, const NamedParameters& np)
{
  typedef Traits_of_nodes<ReebGraph, NamedParameters> Traits;
  constexpr bool are_exact = !std::is_arithmetic_v<Value_of_node<ReebGraph>> && !Has<Scalar_to_double, Traits>::value;
  const auto conversion = choose_conversion_of_nodes<ReebGraph>(np);
  std::vector<double> numbers;
  numbers.reserve(num_vertices(graph));
  for(std::size_t node = 0; node != num_vertices(graph); ++node)
  {
    numbers.push_back(conversion.to_double(graph[node].value));
    if(std::isnan(numbers.back()))
      throw Parameter_error("the value of a node is not a number (NaN)");
    if constexpr(are_exact)
    {
      if(node != 0)
        numbers[node] = number_in_order(graph[node].value, numbers[node], graph[node - 1].value, numbers[node - 1]);
    }
  }
  return numbers;
}

// With another order than that of numbers, values can fall along an arc. The difference of infinities is no number.
inline double persistence(double lower, double upper) { return lower == upper ? 0 : std::abs(upper - lower); }

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

// The part of a graph that loops are in, its 2-core: the arcs that stay when leaves are removed one after the other,
// unless they are to be kept. They are sorted by their upper nodes. Of a noisy field they are few. `ends(arc)` are its
// nodes, `is_there` tells by arc which there are, and `is_kept` by node.
template <class Ends>
std::vector<Index> core_arcs(Index number_of_nodes,
                             std::vector<bool> is_there,
                             const Ends& ends,
                             const std::vector<bool>& is_kept = {})
{
  struct Node
  {
    Index degree = 0;
    Index arcs = 0; // the exclusive or of their numbers
  };
  std::vector<Node> nodes(number_of_nodes);
  const auto count = [&](Index arc, Index change) {
    for(const Index node : {ends(arc).lower, ends(arc).upper})
    {
      nodes[node].degree += change;
      nodes[node].arcs ^= arc;
    }
  };
  for(Index arc = 0; arc != is_there.size(); ++arc)
  {
    if(is_there[arc])
      count(arc, 1);
  }
  for(Index leaf = 0; leaf != number_of_nodes; ++leaf)
  {
    for(Index node = leaf; nodes[node].degree == 1 && (is_kept.empty() || !is_kept[node]);)
    {
      const Index arc = nodes[node].arcs;
      is_there[arc] = false;
      count(arc, static_cast<Index>(-1));
      node = ends(arc).lower == node ? ends(arc).upper : ends(arc).lower;
    }
  }
  std::vector<Index> arcs;
  for(Index arc = 0; arc != is_there.size(); ++arc)
  {
    if(is_there[arc])
      arcs.push_back(arc);
  }
  std::stable_sort(arcs.begin(), arcs.end(), [&](Index a, Index b) { return ends(a).upper < ends(b).upper; });
  return arcs;
}

// The core of a graph that is as it was given.
inline std::vector<Index> core_arcs(Index number_of_nodes,
                                    const std::vector<Ascending_arc>& arcs,
                                    const std::vector<bool>& is_kept = {})
{
  return core_arcs(
    number_of_nodes, std::vector<bool>(arcs.size(), true), [&](Index arc) { return arcs[arc]; }, is_kept);
}

// Calls visit_pair(split saddle, join saddle) for each independent loop: the upper node of an arc that closes a cycle
// is paired with the highest node that can be the lowest one of such a cycle. Arcs that meet at a node with one arc
// below and one above in the core count as one.
template <class VisitPair>
void pair_loops(const std::vector<Ascending_arc>& arcs, Index number_of_nodes, const VisitPair& visit_pair)
{
  struct Node
  {
    Index degree_below = 0, degree_above = 0;
    Index begin = no_index;  // of the arc that passes it, at first the lower end of the part below
    Index number = no_index; // among those that are not passed
  };
  const std::vector<Index> core = core_arcs(number_of_nodes, arcs);
  std::vector<Node> nodes(number_of_nodes);
  for(const Index arc : core)
  {
    ++nodes[arcs[arc].lower].degree_above;
    ++nodes[arcs[arc].upper].degree_below;
    nodes[arcs[arc].upper].begin = arcs[arc].lower;
  }
  Index size = 0;
  for(Index i = 0; i != number_of_nodes; ++i)
  {
    Node& node = nodes[i];
    if(node.degree_below == 1 && node.degree_above == 1)
      node.begin = nodes[node.begin].begin;
    else if(node.degree_below + node.degree_above != 0)
    {
      node.begin = i;
      node.number = size++;
    }
  }
  Highest_forest forest(checked_index(2 * std::size_t(size)) / 2);
  for(const Index arc : core)
  {
    const Node& upper = nodes[arcs[arc].upper];
    if(upper.number == no_index)
      continue;
    const Index begin = nodes[arcs[arc].lower].begin, number = nodes[begin].number;
    const Index partner = forest.add({number, upper.number, number, begin}).leaving;
    if(partner != no_index)
      visit_pair(partner, arcs[arc].upper);
  }
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_GRAPH_GRAPH_LOOPS_H
