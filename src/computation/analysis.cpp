// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/analysis.h"

#include "base/progress_bar.h"
#include "computation/Report_visitor.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Reeb_graph/graph_topology.h>
#include <CGAL/compute_reeb_graph.h>

#include <cstddef>
#include <functional>

namespace PMP = CGAL::Polygon_mesh_processing;

namespace reeb_graph_program {
namespace {
Surface_counts count_surface(const Surface& surface, const Graph& graph, std::size_t number_of_isolated_vertices)
{
  Surface_counts counts;
  counts.vertices = surface.number_of_vertices();
  counts.edges = surface.number_of_edges();
  counts.faces = surface.number_of_faces();
  counts.components = CGAL::Reeb_graph::number_of_components(graph); // as many as the surface has
  counts.border_loops = PMP::number_of_borders(surface);
  count_handles(counts, number_of_isolated_vertices);
  return counts;
}

} // namespace

Graph compute_and_time(const Surface& surface, Scalar_map scalar_map, const Graph_options& options, Report& report)
{
  Graph graph;
  Report_visitor visitor(report);
  Progress_bar progress_bar("graph");
  const Timed_computation timed(report);
  CGAL::compute_reeb_graph<CGAL::Parallel_if_available_tag>(
    surface, scalar_map, graph, named_parameters(options).visitor(std::ref(visitor)).callback(std::ref(progress_bar)));
  return graph;
}

void count_handles(Surface_counts& counts, std::size_t number_of_isolated_vertices)
{
  counts.euler_characteristic = static_cast<long>(counts.vertices + counts.faces) - static_cast<long>(counts.edges);
  if(counts.components == 1 && number_of_isolated_vertices == 0)
    counts.genus = (2 - counts.euler_characteristic - static_cast<long>(counts.border_loops)) / 2;
}

void count_graph_of_surface(const Graph& graph, Report& report)
{
  report.graph = count_graph(graph, report.surface.components);
  if(report.surface.genus && report.surface.border_loops == 0)
    report.graph.hidden_handles = *report.surface.genus - static_cast<long>(report.graph.loops);
}

void count_all(const Surface& surface, const Graph& graph, Report& report)
{
  report.surface = count_surface(surface, graph, report.critical_vertices.isolated);
  count_graph_of_surface(graph, report);
}

void count_simplified(const Graph& simplified, double threshold, Report& report)
{
  const std::size_t number_of_components = report.complex ? report.complex->components : report.surface.components;
  report.simplification = Simplification_counts{threshold, count_graph(simplified, number_of_components), {}};
}

} // namespace reeb_graph_program
