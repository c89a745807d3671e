// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_BENCHMARK_SIMPLIFICATION_TABLE_H
#define CGAL_REEB_GRAPH_BENCHMARK_SIMPLIFICATION_TABLE_H

#include "Table.h"
#include "inputs.h"
#include "measurements.h"
#include "tables.h"
#include "timed_runs.h"

#include <CGAL/Reeb_graph/simplification/persistence_pairs.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

// The time of persistence pairs and of simplification beside that of the graph, all with one thread.
namespace benchmark {
inline double time_pairs(const Graph& graph)
{
  std::vector<CGAL::Reeb_graph::Persistence_pair<std::size_t>> pairs;
  return milliseconds([&] { CGAL::Reeb_graph::persistence_pairs(graph, std::back_inserter(pairs)); });
}

// The time, and the number of nodes that are left.
inline std::pair<double, std::size_t> time_simplification(const Graph& graph, double threshold)
{
  Graph simplified;
  const double time = milliseconds([&] { CGAL::Reeb_graph::simplify(graph, threshold, simplified); });
  return {time, num_vertices(simplified)};
}

inline void print_simplification(const Options& options)
{
  const std::vector<double> fractions = {0.05, 0.5}; // of the range of the field
  std::vector<Column> columns = {{"surface", "", 8}, {"field", "", 6},   {"vertices", "", 8},
                                 {"nodes", "", 7},   {"graph", "ms", 7}, {"pairs", "ms", 7}};
  for(const double fraction : fractions)
    columns.insert(columns.end(), {{cell(100 * fraction, 0) + " %", "ms", 7}, {"", "nodes", 7}});
  const Table table("Persistence pairs, and simplification with thresholds in per cent of the range, one thread",
                    columns);
  for(const std::size_t size : options.sizes)
    for(const std::string& surface : options.surfaces)
    {
      Input input(surface, size);
      for(const std::string& field : options.fields)
      {
        input.set_field(field);
        const Properties properties = find_properties(input);
        const Graph& graph = properties.graph;
        const double range = graph[num_vertices(graph) - 1].value - graph[0].value;
        Engine_times graph_times;
        Sample pairs;
        std::vector<Sample> simplifications(fractions.size());
        std::vector<std::size_t> nodes(fractions.size());
        for(std::size_t repetition = 0; repetition != options.number_of_repetitions; ++repetition)
        {
          run_engine(input, Method::CONTOUR_TREES, 1, graph_times);
          pairs.add(time_pairs(graph));
          for(std::size_t i = 0; i != fractions.size(); ++i)
          {
            const auto [time, number_of_nodes] = time_simplification(graph, fractions[i] * range);
            simplifications[i].add(time);
            nodes[i] = number_of_nodes;
          }
        }
        std::vector<std::string> cells = {surface,
                                          field,
                                          cell(std::size_t(input.mesh().number_of_vertices())),
                                          cell(num_vertices(graph)),
                                          cell(graph_times.total.median(), 1),
                                          cell(pairs.median(), 1)};
        for(std::size_t i = 0; i != fractions.size(); ++i)
          cells.insert(cells.end(), {cell(simplifications[i].median(), 1), cell(nodes[i])});
        table.print_row(cells);
      }
    }
}

} // namespace benchmark

#endif // CGAL_REEB_GRAPH_BENCHMARK_SIMPLIFICATION_TABLE_H
