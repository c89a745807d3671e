// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_PERSISTENCE_ORACLE_H
#define CGAL_REEB_GRAPH_TEST_PERSISTENCE_ORACLE_H

#include <CGAL/Reeb_graph/simplification/persistence_pairs.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

// Extended persistence of a graph as in textbooks: the boundary matrix of the graph and of the cone over it, reduced
// column by column.
namespace persistence_oracle {
using CGAL::Reeb_graph::Persistence_pair_kind;
typedef CGAL::Reeb_graph::Persistence_pair<std::size_t> Pair;
typedef std::pair<std::size_t, std::size_t> Arc; // lower and upper node

enum class Cell_kind
{
  APEX,
  NODE,
  ARC,
  CONE_OF_NODE,
  CONE_OF_ARC
};

struct Cell
{
  Cell_kind kind;
  std::size_t node; // at which it comes
  std::set<std::size_t> boundary;
};

// First the apex, then the graph from below to above, then the cone from above to below.
inline std::vector<Cell> filtration(std::size_t number_of_nodes, const std::vector<Arc>& arcs)
{
  std::vector<Cell> cells = {{Cell_kind::APEX, 0, {}}};
  std::map<std::size_t, std::size_t> cell_of_node, cell_of_arc, cone_of_node;
  for(std::size_t node = 0; node < number_of_nodes; ++node)
  {
    cell_of_node[node] = cells.size();
    cells.push_back({Cell_kind::NODE, node, {}});
    for(std::size_t arc = 0; arc < arcs.size(); ++arc)
      if(arcs[arc].second == node)
      {
        cell_of_arc[arc] = cells.size();
        cells.push_back({Cell_kind::ARC, node, {cell_of_node.at(arcs[arc].first), cell_of_node.at(node)}});
      }
  }
  for(std::size_t node = number_of_nodes; node-- > 0;)
  {
    cone_of_node[node] = cells.size();
    cells.push_back({Cell_kind::CONE_OF_NODE, node, {0, cell_of_node.at(node)}});
    for(std::size_t arc = 0; arc < arcs.size(); ++arc)
      if(arcs[arc].first == node)
        cells.push_back({Cell_kind::CONE_OF_ARC,
                         node,
                         {cell_of_arc.at(arc), cone_of_node.at(node), cone_of_node.at(arcs[arc].second)}});
  }
  return cells;
}

// Pairs of cells, birth and death.
inline std::vector<std::pair<std::size_t, std::size_t>> reduce(const std::vector<Cell>& cells)
{
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  std::map<std::size_t, std::set<std::size_t>> columns; // by their last entry
  for(std::size_t cell = 0; cell < cells.size(); ++cell)
  {
    std::set<std::size_t> column = cells[cell].boundary;
    while(!column.empty() && columns.count(*column.rbegin()) != 0)
      for(const std::size_t entry : columns.at(*column.rbegin()))
        if(!column.insert(entry).second)
          column.erase(entry);
    if(column.empty())
      continue;
    pairs.emplace_back(*column.rbegin(), cell);
    columns[*column.rbegin()] = column;
  }
  return pairs;
}

// All pairs, sorted.
inline std::vector<Pair> pairs(std::size_t number_of_nodes, const std::vector<Arc>& arcs)
{
  const std::vector<Cell> cells = filtration(number_of_nodes, arcs);
  std::vector<Pair> result;
  for(const auto& [birth, death] : reduce(cells))
  {
    const Cell &first = cells[birth], &second = cells[death];
    if(first.kind == Cell_kind::NODE && second.kind == Cell_kind::CONE_OF_NODE)
      result.push_back({first.node, second.node, Persistence_pair_kind::MINIMUM_MAXIMUM});
    else if(first.kind == Cell_kind::ARC)
      result.push_back({second.node, first.node, Persistence_pair_kind::LOOP});
    else if(first.kind == Cell_kind::NODE && first.node != second.node)
      result.push_back({first.node, second.node, Persistence_pair_kind::MINIMUM_SADDLE});
    else if(first.kind == Cell_kind::CONE_OF_NODE && first.node != second.node)
      result.push_back({second.node, first.node, Persistence_pair_kind::SADDLE_MAXIMUM});
  }
  std::sort(result.begin(), result.end());
  return result;
}

template <class Graph>
std::vector<Arc> arcs_of(const Graph& graph)
{
  std::vector<Arc> arcs;
  for(auto range = edges(graph); range.first != range.second; ++range.first)
    arcs.emplace_back(source(*range.first, graph), target(*range.first, graph));
  return arcs;
}

template <class Graph>
std::vector<Pair> found_pairs(const Graph& graph)
{
  std::vector<Pair> result;
  CGAL::Reeb_graph::persistence_pairs(graph, std::back_inserter(result));
  return result;
}

} // namespace persistence_oracle

#endif // CGAL_REEB_GRAPH_TEST_PERSISTENCE_ORACLE_H
