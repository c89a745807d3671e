// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_SIMPLIFICATION_ORACLE_H
#define CGAL_REEB_GRAPH_TEST_SIMPLIFICATION_ORACLE_H

#include "persistence_oracle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <tuple>
#include <vector>

// Simplification word by word: look at all leaf arcs, remove the least one, begin anew.
namespace simplification_oracle {
using persistence_oracle::Arc;

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
  {
    for(std::size_t node = 0; node < num_vertices(graph); ++node)
    {
      nodes[node] = {node};
      values_.push_back(graph[node].value);
    }
    for(const Arc& arc : persistence_oracle::arcs_of(graph))
      arcs.push_back({arc.first, arc.second, {arcs.size()}, {values_.size() + arcs.size()}});
    join_passed_nodes();
    while(leaves() > number_of_leaves && remove_least(threshold))
      join_passed_nodes();
    std::sort(arcs.begin(), arcs.end(), [](const Joined_arc& a, const Joined_arc& b) {
      return std::tie(a.lower, a.upper, a.pieces) < std::tie(b.lower, b.upper, b.pieces);
    });
  }

  std::map<std::size_t, std::set<std::size_t>> nodes; // with the places that they have taken up, and their own
  std::vector<Joined_arc> arcs;

private:
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

  bool remove_least(double threshold)
  {
    std::vector<std::tuple<double, std::size_t, std::size_t>> leaf_arcs; // measure, leaf, number
    for(std::size_t i = 0; i < arcs.size(); ++i)
      for(const bool is_minimum : {true, false})
      {
        const std::size_t leaf = is_minimum ? arcs[i].lower : arcs[i].upper;
        const std::size_t saddle = is_minimum ? arcs[i].upper : arcs[i].lower;
        if(!is_leaf(leaf) || (is_minimum ? below(saddle) : above(saddle)) < 2)
          continue;
        const double size = (std::max)(measure(saddle, arcs[i].places), measure(saddle, nodes[leaf]));
        if(size < threshold)
          leaf_arcs.emplace_back(size, leaf, i);
      }
    if(leaf_arcs.empty())
      return false;
    const auto [size, leaf, i] = *std::min_element(leaf_arcs.begin(), leaf_arcs.end());
    static_cast<void>(size);
    const std::size_t saddle = arcs[i].lower == leaf ? arcs[i].upper : arcs[i].lower;
    nodes[saddle].insert(arcs[i].places.begin(), arcs[i].places.end());
    nodes[saddle].insert(nodes[leaf].begin(), nodes[leaf].end());
    nodes.erase(leaf);
    arcs.erase(arcs.begin() + static_cast<std::ptrdiff_t>(i));
    return true;
  }

  std::vector<double> values_;
};

} // namespace simplification_oracle

#endif // CGAL_REEB_GRAPH_TEST_SIMPLIFICATION_ORACLE_H
