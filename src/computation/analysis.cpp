// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/analysis.h"

#include "base/progress_bar.h"
#include "base/stopwatch.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Reeb_graph/graph_topology.h>
#include <CGAL/compute_reeb_graph.h>

#include <cstddef>
#include <functional>
#include <string>
#include <utility>

namespace PMP = CGAL::Polygon_mesh_processing;

namespace reeb_graph_program {
namespace {
typedef CGAL::Reeb_graph::Stage Stage;

std::string name(Stage stage)
{
  switch(stage)
  {
  case Stage::FLATTEN: return "flatten";
  case Stage::CLASSIFY: return "classify";
  case Stage::ARCS: return "arcs";
  case Stage::WRITE: return "write";
  }
  return "other";
}

class Report_visitor
{
public:
  explicit Report_visitor(Report& report) : report_(report) {}

  void begin_stage(Stage) { stopwatch_ = Stopwatch(); }
  void end_stage(Stage stage) { report_.seconds.emplace_back(name(stage), stopwatch_.seconds()); }
  void critical_vertices(const CGAL::Reeb_graph::Critical_vertex_counts& counts) { report_.critical_vertices = counts; }

private:
  Report& report_;
  Stopwatch stopwatch_;
};

Surface_counts count_surface(const Surface& surface, const Graph& graph, std::size_t number_of_isolated_vertices)
{
  Surface_counts counts;
  counts.vertices = surface.number_of_vertices();
  counts.edges = surface.number_of_edges();
  counts.faces = surface.number_of_faces();
  counts.components = CGAL::Reeb_graph::number_of_components(graph); // as many as the surface has
  counts.border_loops = PMP::number_of_borders(surface);
  counts.euler_characteristic = static_cast<long>(counts.vertices + counts.faces) - static_cast<long>(counts.edges);
  if(counts.components == 1 && number_of_isolated_vertices == 0)
    counts.genus = (2 - counts.euler_characteristic - static_cast<long>(counts.border_loops)) / 2;
  return counts;
}

Graph_counts count_graph(const Graph& graph, std::size_t number_of_components)
{
  Graph_counts counts;
  counts.nodes = num_vertices(graph);
  counts.arcs = num_edges(graph);
  counts.loops = counts.arcs + number_of_components - counts.nodes;
  return counts;
}

} // namespace

Graph compute_and_time(const Surface& surface, Scalar_map scalar_map, const Graph_options& options, Report& report)
{
  Graph graph;
  Report_visitor visitor(report);
  Progress_bar progress_bar("graph");
  const Stopwatch stopwatch;
  const std::size_t place_of_total = report.seconds.size();
  CGAL::compute_reeb_graph<CGAL::Parallel_if_available_tag>(
    surface, scalar_map, graph, named_parameters(options).visitor(std::ref(visitor)).callback(std::ref(progress_bar)));
  const auto total = std::make_pair(std::string("compute"), stopwatch.seconds());
  report.seconds.insert(report.seconds.begin() + static_cast<std::ptrdiff_t>(place_of_total), total);
  return graph;
}

void count_all(const Surface& surface, const Graph& graph, Report& report)
{
  report.surface = count_surface(surface, graph, report.critical_vertices.isolated);
  report.graph = count_graph(graph, report.surface.components);
  if(report.surface.genus && report.surface.border_loops == 0)
    report.graph.hidden_handles = *report.surface.genus - static_cast<long>(report.graph.loops);
}

void count_simplified(const Graph& simplified, double threshold, Report& report)
{
  report.simplification = Simplification_counts{threshold, count_graph(simplified, report.surface.components), {}};
}

} // namespace reeb_graph_program
