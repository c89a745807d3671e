// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_OUTPUT_VTP_GRAPH_H
#define CGAL_REEB_GRAPH_INTERNAL_OUTPUT_VTP_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/output/Vtp_document.h>

#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The points of a graph: those of its nodes, and behind them the inner ones of its arcs.
template <class Graph, class Embedding>
struct Vtp_graph
{
  Vtp_graph(const Graph& graph, const Embedding& embedding) : values(embedding.node_values)
  {
    for(const auto node : CGAL::make_range(vertices(graph)))
    {
      add_coordinates(embedding.node_points[node], coordinates);
      nodes.add_point(node);
      nodes.end_cell();
    }
    for(const auto arc : CGAL::make_range(edges(graph)))
    {
      const std::size_t i = arcs.ends.size();
      arcs.add_point(source(arc, graph));
      for(std::size_t j = 1; j + 1 < embedding.arc_polylines[i].size(); ++j)
      {
        arcs.add_point(values.size());
        add_coordinates(embedding.arc_polylines[i][j], coordinates);
        values.push_back(embedding.arc_values[i][j]);
        arc_of_point.push_back(static_cast<std::int64_t>(i));
      }
      arcs.add_point(target(arc, graph));
      arcs.end_cell();
    }
  }

  std::vector<double> coordinates, values;
  std::vector<std::int64_t> arc_of_point; // of inner points
  Vtp_document::Cells nodes, arcs;
};

// The numbers of nodes, and -1 or NaN for the rest; or the other way round.
template <class Number>
std::vector<Number> padded(std::size_t number_before, std::vector<Number> numbers, std::size_t number_behind)
{
  constexpr Number nothing = std::is_floating_point_v<Number> ? std::numeric_limits<Number>::quiet_NaN() : Number(-1);
  numbers.insert(numbers.begin(), number_before, nothing);
  numbers.insert(numbers.end(), number_behind, nothing);
  return numbers;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_OUTPUT_VTP_GRAPH_H
