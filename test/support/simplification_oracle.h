// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_SIMPLIFICATION_ORACLE_H
#define CGAL_REEB_GRAPH_TEST_SIMPLIFICATION_ORACLE_H

#include "persistence_oracle.h"
#include "random_graphs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

// Simplification word by word: look at all leaf arcs, remove the least one, begin anew.
namespace simplification_oracle {
using persistence_oracle::Arc;
using persistence_oracle::Persistence_pair_kind;

// An arc as the numbers of those it is made of, from below to above. Places are nodes, and behind them arcs.
struct Joined_arc
{
  std::size_t lower, upper;
  std::vector<std::size_t> pieces;
  std::set<std::size_t> places; // that it has taken up, and its own
};

class Simplification_oracle
{
public:
  template <class Graph>
  Simplification_oracle(const Graph& graph, double threshold, std::size_t number_of_leaves = 0)
    : Simplification_oracle(graph)
  {
    while(leaves() > number_of_leaves && remove_least(threshold))
      join_passed_nodes();
    std::sort(arcs.begin(), arcs.end(), [](const Joined_arc& a, const Joined_arc& b) {
      return std::tie(a.lower, a.upper, a.pieces) < std::tie(b.lower, b.upper, b.pieces);
    });
  }

  std::map<std::size_t, std::set<std::size_t>> nodes; // with the places that they have taken up, and their own
  std::vector<Joined_arc> arcs;

protected:
  struct Leaf_arc
  {
    double measure;
    std::size_t leaf, number;
  };

  template <class Graph>
  explicit Simplification_oracle(const Graph& graph)
  {
    for(std::size_t node = 0; node < num_vertices(graph); ++node)
    {
      nodes[node] = {node};
      values_.push_back(graph[node].value);
    }
    for(const Arc& arc : persistence_oracle::arcs_of(graph))
      arcs.push_back({arc.first, arc.second, {arcs.size()}, {values_.size() + arcs.size()}});
    join_passed_nodes();
  }

  std::size_t below(std::size_t node) const
  {
    return std::count_if(arcs.begin(), arcs.end(), [&](const Joined_arc& arc) { return arc.upper == node; });
  }
  std::size_t above(std::size_t node) const
  {
    return std::count_if(arcs.begin(), arcs.end(), [&](const Joined_arc& arc) { return arc.lower == node; });
  }
  bool is_leaf(std::size_t node) const { return below(node) + above(node) == 1; }

  std::size_t leaves() const
  {
    return std::count_if(nodes.begin(), nodes.end(), [&](const auto& node) { return is_leaf(node.first); });
  }

  void join_passed_nodes()
  {
    for(std::size_t node = 0; node < values_.size(); ++node)
    {
      if(nodes.count(node) == 0 || below(node) != 1 || above(node) != 1)
        continue;
      const auto low = std::find_if(arcs.begin(), arcs.end(), [&](const Joined_arc& arc) { return arc.upper == node; });
      const auto high =
        std::find_if(arcs.begin(), arcs.end(), [&](const Joined_arc& arc) { return arc.lower == node; });
      low->upper = high->upper;
      low->pieces.insert(low->pieces.end(), high->pieces.begin(), high->pieces.end());
      low->places.insert(high->places.begin(), high->places.end());
      low->places.insert(nodes[node].begin(), nodes[node].end());
      nodes.erase(node);
      arcs.erase(high);
    }
  }

  double measure(std::size_t saddle, const std::set<std::size_t>& places) const
  {
    double result = 0;
    for(const std::size_t place : places)
      if(place < values_.size())
        result = (std::max)(result, std::abs(values_[place] - values_[saddle]));
    return result;
  }

  // The number of leaf is no_leaf if there is none.
  Leaf_arc least_leaf_arc() const
  {
    Leaf_arc least = {0, no_leaf, 0};
    for(std::size_t i = 0; i < arcs.size(); ++i)
      for(const bool is_minimum : {true, false})
      {
        const std::size_t leaf = is_minimum ? arcs[i].lower : arcs[i].upper;
        const std::size_t saddle = is_minimum ? arcs[i].upper : arcs[i].lower;
        if(!is_leaf(leaf) || (is_minimum ? below(saddle) : above(saddle)) < 2)
          continue;
        const double size = (std::max)(measure(saddle, arcs[i].places), measure(saddle, nodes.at(leaf)));
        if(least.leaf == no_leaf || std::tie(size, leaf) < std::tie(least.measure, least.leaf))
          least = {size, leaf, i};
      }
    return least;
  }

  void remove(const Leaf_arc& leaf_arc)
  {
    const auto arc = arcs.begin() + static_cast<std::ptrdiff_t>(leaf_arc.number);
    const std::size_t leaf = leaf_arc.leaf, saddle = arc->lower == leaf ? arc->upper : arc->lower;
    nodes[saddle].insert(arc->places.begin(), arc->places.end());
    nodes[saddle].insert(nodes[leaf].begin(), nodes[leaf].end());
    nodes.erase(leaf);
    arcs.erase(arc);
  }

  bool remove_least(double threshold)
  {
    const Leaf_arc least = least_leaf_arc();
    if(least.leaf == no_leaf || !(least.measure < threshold))
      return false;
    remove(least);
    return true;
  }

  static constexpr std::size_t no_leaf = -1;
  std::vector<double> values_;
};

// Removes branches and loops one by one, and finds the loops anew each time.
class Removal_oracle : private Simplification_oracle
{
public:
  template <class Graph>
  explicit Removal_oracle(const Graph& graph)
    : Simplification_oracle(graph),
      persistences(num_edges(graph), values_.empty() ? 0 : values_.back() - values_.front())
  {
    for(double reached = 0;; join_passed_nodes())
    {
      const Leaf_arc leaf_arc = least_leaf_arc();
      const auto [size, side] = least_side_of_loop();
      const bool is_leaf_arc = leaf_arc.leaf != no_leaf && (side == arcs.size() || leaf_arc.measure <= size);
      if(!is_leaf_arc && side == arcs.size())
        return;
      reached = (std::max)(reached, is_leaf_arc ? leaf_arc.measure : size);
      for(const std::size_t piece : arcs[is_leaf_arc ? leaf_arc.number : side].pieces)
        persistences[piece] = reached;
      is_leaf_arc ? remove(leaf_arc) : remove_side(side);
    }
  }

  std::vector<double> persistences; // by arc; of a connected graph

private:
  // The persistence of the loop, and the number of the arc, that of all arcs if there is none.
  std::pair<double, std::size_t> least_side_of_loop() const
  {
    std::vector<Arc> ends;
    for(const Joined_arc& arc : arcs)
      ends.emplace_back(arc.lower, arc.upper);
    const auto pairs = persistence_oracle::found_pairs(random_graphs::make_graph(values_.size(), ends));
    std::tuple<double, std::size_t, std::size_t> least(0, 0, arcs.size());
    for(std::size_t i = 0; i < arcs.size(); ++i)
    {
      const auto size = std::make_tuple(values_[ends[i].second] - values_[ends[i].first], arcs[i].pieces.front(), i);
      const persistence_oracle::Pair loop = {ends[i].first, ends[i].second, Persistence_pair_kind::LOOP};
      if(std::binary_search(pairs.begin(), pairs.end(), loop) && (std::get<2>(least) == arcs.size() || size < least))
        least = size;
    }
    return {std::get<0>(least), std::get<2>(least)};
  }

  void remove_side(std::size_t side)
  {
    const std::size_t split = arcs[side].lower;
    std::set<std::size_t>* owner = &nodes[split];
    for(std::size_t i = 0; i < arcs.size(); ++i)
      if(i != side && arcs[i].lower == split && above(split) == 2)
        owner = &arcs[i].places;
    owner->insert(arcs[side].places.begin(), arcs[side].places.end());
    arcs.erase(arcs.begin() + static_cast<std::ptrdiff_t>(side));
  }
};

} // namespace simplification_oracle

#endif // CGAL_REEB_GRAPH_TEST_SIMPLIFICATION_ORACLE_H
