// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/analysis.h"

#include "computation/Report_visitor.h"
#include "computation/complex_counts.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Reeb_graph/graph_topology.h>

#include <cstddef>

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

void count_all(const Mesh& mesh, const Graph& graph, Report& report)
{
  if(!mesh.complex)
    return count_all(mesh.surface, graph, report);
  report.complex = count_complex(*mesh.complex);
  report.complex->vertices = mesh.surface.number_of_vertices();
  report.complex->components = CGAL::Reeb_graph::number_of_components(graph); // as many as the complex has
  report.graph = count_graph(graph, report.complex->components);
}

void count_simplified(const Graph& simplified, double threshold, Report& report)
{
  const std::size_t number_of_components = report.complex ? report.complex->components : report.surface.components;
  report.simplification = Simplification_counts{threshold, count_graph(simplified, number_of_components), {}};
}

} // namespace reeb_graph_program
