// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_REPORT_VISITOR_H
#define CGAL_REEB_GRAPH_SRC_REPORT_VISITOR_H

#include "base/costs.h"
#include "base/report.h"

#include <CGAL/Reeb_graph/options.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>

namespace reeb_graph_program {
// Notes what each stage of the computation of a graph takes.
class Report_visitor
{
public:
  explicit Report_visitor(Report& report) : report_(report) {}

  void begin_stage(CGAL::Reeb_graph::Stage) { stopwatch_ = Stopwatch(); }
  void end_stage(CGAL::Reeb_graph::Stage stage) { report_.seconds.emplace_back(name(stage), stopwatch_.seconds()); }
  void critical_vertices(const CGAL::Reeb_graph::Critical_vertex_counts& counts) { report_.critical_vertices = counts; }

private:
  static std::string name(CGAL::Reeb_graph::Stage stage)
  {
    using CGAL::Reeb_graph::Stage;
    switch(stage)
    {
    case Stage::FLATTEN: return "flatten";
    case Stage::CLASSIFY: return "classify";
    case Stage::ARCS: return "arcs";
    case Stage::WRITE: return "write";
    }
    return "other";
  }

  Report& report_;
  Stopwatch stopwatch_;
};

template <class AnyGraph>
Graph_counts count_graph(const AnyGraph& graph, std::size_t number_of_components)
{
  Graph_counts counts;
  counts.nodes = num_vertices(graph);
  counts.arcs = num_edges(graph);
  counts.loops = counts.arcs + number_of_components - counts.nodes;
  for(const auto arc : CGAL::make_range(edges(graph)))
    if(graph[source(arc, graph)].value == graph[target(arc, graph)].value)
      ++counts.arcs_of_length_zero;
  return counts;
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_REPORT_VISITOR_H
