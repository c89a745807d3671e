// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/arc_columns.h"

#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/simplification/simplification_thresholds.h>
#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

namespace reeb_graph_program {
namespace {
typedef CGAL::Reeb_graph::internal::Weighted_mean Weighted_mean;

std::vector<double> persistences(const Graph& graph) { return CGAL::Reeb_graph::arc_persistences(graph); }

std::vector<Arc_ends> ends_of_arcs(const Graph& graph)
{
  std::vector<Arc_ends> ends;
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    const std::size_t lower = source(arc, graph), upper = target(arc, graph);
    ends.push_back({lower, upper, graph[lower].value, graph[upper].value});
  }
  return ends;
}

// What the arcs of a simplified graph consist of.
struct Joined_arcs
{
  const std::vector<Arc_ends>& ends;
  const CGAL::Reeb_graph::Simplification<Graph>& simplification;
  const std::vector<std::vector<std::size_t>>& parts;
  std::size_t number_of_nodes, number_of_given_arcs;

  // Calls function(given arc, the arc that has taken it up).
  template <class Function>
  void for_each_absorbed(const Function& function) const
  {
    for(std::size_t i = 0; i != number_of_given_arcs; ++i)
      if(const std::size_t place = simplification.index_of_arc(i); place >= number_of_nodes)
        function(i, place - number_of_nodes);
  }

  template <class Number>
  std::vector<Number> sums(const Arc_column& column, const std::vector<Number>& given) const
  {
    std::vector<Number> result(ends.size(), 0);
    if(column.joining == Arc_joining::ALONG_CHAIN)
    {
      for(std::size_t arc = 0; arc != parts.size(); ++arc)
        for(const std::size_t part : parts[arc])
          result[arc] += given[part];
      return result;
    }
    for(std::size_t node = 0; node != column.of_nodes.size(); ++node)
      if(const std::size_t place = simplification.index_of_node(node); place >= number_of_nodes)
        result[place - number_of_nodes] += static_cast<Number>(column.of_nodes[node]);
    for_each_absorbed([&](std::size_t i, std::size_t arc) { result[arc] += given[i]; });
    return result;
  }

  // An arc without area has the middle of its values.
  std::vector<double> means(const std::vector<double>& given, const std::vector<double>& weights) const
  {
    std::vector<Weighted_mean> means(ends.size());
    for_each_absorbed([&](std::size_t i, std::size_t arc) { means[arc].add(given[i], weights[i]); });
    std::vector<double> result;
    for(std::size_t arc = 0; arc != ends.size(); ++arc)
      result.push_back(means[arc].mean_or_middle(ends[arc].lower_value, ends[arc].upper_value));
    return result;
  }
};

const std::vector<double>& sizes_of_arcs(const Arc_table& table)
{
  for(const Arc_column& column : table.columns)
    if(column.attribute.name == "area" || column.attribute.name == "volume")
      return std::get<std::vector<double>>(column.attribute.numbers);
  throw std::logic_error("a mean of arcs needs their areas");
}

} // namespace

Arc_table table_of_graph(const Graph& graph)
{
  return {
    ends_of_arcs(graph),
    {{{"persistence", persistences(graph)}, Arc_joining::RECOMPUTED, Arc_unit::DIFFERENCE, true, {}, &persistences}}};
}

Arc_column length_column(std::vector<double> lengths)
{
  return {{"length", std::move(lengths)}, Arc_joining::ALONG_CHAIN, Arc_unit::PLAIN};
}

Arc_column size_column(const std::string& name, std::vector<double> sizes)
{
  return {{name, std::move(sizes)}, Arc_joining::WITH_ABSORBED, Arc_unit::PLAIN};
}

Arc_column mean_value_column(std::vector<double> means)
{
  return {{"mean_value", std::move(means)}, Arc_joining::MEAN_BY_AREA, Arc_unit::VALUE, false};
}

Arc_table join_arcs(const Arc_table& given,
                    const Graph& simplified,
                    const CGAL::Reeb_graph::Simplification<Graph>& simplification,
                    const std::vector<std::vector<std::size_t>>& parts)
{
  Arc_table result = {ends_of_arcs(simplified), {}};
  const Joined_arcs arcs = {result.ends, simplification, parts, num_vertices(simplified), given.ends.size()};
  for(const Arc_column& column : given.columns)
  {
    Arc_column& joined = result.columns.emplace_back(column);
    joined.of_nodes.clear();
    if(column.joining == Arc_joining::RECOMPUTED)
      joined.attribute.numbers = column.recompute(simplified);
    else if(column.joining == Arc_joining::MEAN_BY_AREA)
      joined.attribute.numbers =
        arcs.means(std::get<std::vector<double>>(column.attribute.numbers), sizes_of_arcs(given));
    else
      std::visit([&](const auto& numbers) { joined.attribute.numbers = arcs.sums(column, numbers); },
                 column.attribute.numbers);
  }
  return result;
}

} // namespace reeb_graph_program
