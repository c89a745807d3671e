// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_DRAWING_BRANCH_TREE_H
#define CGAL_REEB_GRAPH_INTERNAL_DRAWING_BRANCH_TREE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/union_find.h>
#include <CGAL/Reeb_graph/internal/graph/Leaf_pruning.h>
#include <CGAL/Reeb_graph/internal/graph/read_graph.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// An ascending path of arcs that is drawn in one column.
struct Drawn_branch
{
  std::size_t first_arc, end_of_arcs;        // in Branch_tree::arcs
  Index lower, upper;                        // its nodes
  bool is_lower_attached, is_upper_attached; // whether it ends there at a node of its parent
  bool is_closing = false;                   // whether it closes a loop at its upper node, which is no leaf then
  Index parent = no_index;                   // the branch at which it is attached, none for a trunk
};

// A Reeb graph as branches at branches: the graph is cut open below each node at which loops close, so that it is a
// forest, and the leaf arcs of that are removed, the less persistent first. What is left of each component is its
// trunk. With n nodes and arcs it takes O(n log n) time.
class Branch_tree
{
public:
  typedef Leaf_pruning::Arc Arc;

  std::vector<Drawn_branch> branches; // each before its parent
  std::vector<Index> arcs;            // of the branches, each from below to above
  std::vector<Index> branch_of_node;

  // By node, the heights, which ascend.
  Branch_tree(const std::vector<Arc>& graph_arcs, const std::vector<double>& heights)
    : branch_of_node(heights.size(), no_index)
  {
    const auto number_of_nodes = static_cast<Index>(heights.size());
    std::vector<bool> is_cut = find_closing_arcs(graph_arcs, heights);

    // the new nodes, where arcs have been cut, lie just below the old ones
    std::vector<Index> new_numbers(number_of_nodes, 0), old_numbers;
    for(Index arc = 0; arc != graph_arcs.size(); ++arc)
      new_numbers[graph_arcs[arc].upper] += is_cut[arc] ? 1 : 0;
    for(Index node = 0; node != number_of_nodes; ++node)
    {
      old_numbers.insert(old_numbers.end(), new_numbers[node] + std::size_t(1), node);
      new_numbers[node] = static_cast<Index>(old_numbers.size() - 1);
    }
    std::vector<Index> next_new(number_of_nodes, 1);
    std::vector<Arc> forest;
    for(Index arc = 0; arc != graph_arcs.size(); ++arc)
    {
      const auto [lower, upper] = graph_arcs[arc];
      forest.push_back({new_numbers[lower], is_cut[arc] ? new_numbers[upper] - next_new[upper]++ : new_numbers[upper]});
    }
    find_branches(forest, old_numbers, heights);
    for(Drawn_branch& branch : branches)
    {
      branch.is_closing = branch.first_arc != branch.end_of_arcs && is_cut[arcs[branch.end_of_arcs - 1]];
      for(std::size_t i = branch.first_arc; i != branch.end_of_arcs; ++i)
      {
        if(i != branch.first_arc || !branch.is_lower_attached)
          branch_of_node[graph_arcs[arcs[i]].lower] = number_of(branch);
      }
      if(!branch.is_upper_attached && !branch.is_closing)
        branch_of_node[branch.upper] = number_of(branch);
    }
    for(Drawn_branch& branch : branches)
    {
      if(branch.is_lower_attached || branch.is_upper_attached)
        branch.parent = branch_of_node[branch.is_lower_attached ? branch.lower : branch.upper];
    }
  }

private:
  Index number_of(const Drawn_branch& branch) const { return static_cast<Index>(&branch - branches.data()); }

  // Of the arcs by which a node is reached from one component of what is below it, all but one close a loop: that on
  // the longest ascending path stays, so that long paths are not cut, and of several the shortest one.
  static std::vector<bool> find_closing_arcs(const std::vector<Arc>& graph_arcs, const std::vector<double>& heights)
  {
    std::vector<double> starts = heights; // by node, of the longest path that ends there
    std::vector<Index> order(graph_arcs.size());
    std::iota(order.begin(), order.end(), Index(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return graph_arcs[a].upper < graph_arcs[b].upper; });
    std::vector<bool> is_closing(graph_arcs.size());
    Disjoint_sets<Index> components(static_cast<Index>(heights.size()));
    for(auto begin = order.begin(); begin != order.end();)
    {
      const Index node = graph_arcs[*begin].upper;
      const auto end = std::find_if(begin, order.end(), [&](Index arc) { return graph_arcs[arc].upper != node; });
      std::stable_sort(begin, end, [&](Index a, Index b) {
        const Index first = graph_arcs[a].lower, second = graph_arcs[b].lower;
        return starts[first] != starts[second] ? starts[first] < starts[second] : first > second;
      });
      starts[node] = starts[graph_arcs[*begin].lower];
      for(; begin != end; ++begin)
      {
        const Index below = components.find(graph_arcs[*begin].lower), above = components.find(node);
        is_closing[*begin] = below == above;
        if(below != above)
          components.link((std::max)(below, above), (std::min)(below, above));
      }
    }
    return is_closing;
  }

  void find_branches(const std::vector<Arc>& forest,
                     const std::vector<Index>& old_numbers,
                     const std::vector<double>& heights)
  {
    const auto size = static_cast<Index>(old_numbers.size());
    Leaf_pruning pruning(size, forest, std::vector<double>(size + forest.size(), 0));
    const auto add_branch = [&](Index arc, bool is_lower_attached, bool is_upper_attached) {
      const std::size_t first_arc = arcs.size();
      pruning.for_each_piece(arc, [&](Index piece) { arcs.push_back(piece); });
      branches.push_back({first_arc, arcs.size(), old_numbers[pruning.arc(arc).lower],
                          old_numbers[pruning.arc(arc).upper], is_lower_attached, is_upper_attached});
    };
    const auto difference = [&](Index lower, Index upper) {
      return persistence(heights[old_numbers[lower]], heights[old_numbers[upper]]);
    };
    pruning([&](const Leaf_arc& arc) { return persistence_of_leaf_arc(arc, difference); },
            [&](Index leaf, double) {
              const bool is_minimum = pruning.in_degree(leaf) == 0;
              add_branch(pruning.arc_of_leaf(leaf), !is_minimum, is_minimum);
              return true;
            });
    for(Index arc = 0; arc != pruning.number_of_arcs(); ++arc)
    {
      if(pruning.is_left(pruning.place_of_arc(arc)))
        add_branch(arc, false, false);
    }
    for(Index node = 0; node != size; ++node)
    {
      if(pruning.is_left(node) && pruning.in_degree(node) + pruning.out_degree(node) == 0)
        branches.push_back({arcs.size(), arcs.size(), old_numbers[node], old_numbers[node], false, false});
    }
  }
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_DRAWING_BRANCH_TREE_H
