// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_POISSON_VALUES_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_POISSON_VALUES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/Field_report.h>
#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/fields/internal/Weighted_graph.h>
#include <CGAL/Reeb_graph/fields/internal/constraints.h>
#include <CGAL/Reeb_graph/fields/internal/solve.h>
#include <CGAL/Reeb_graph/fields/internal/triangle_geometry.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/options.h>

#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

// Solves sum_j w_ij (f_j - f_i) = h_i at the free vertices, where `right_side` is h. The fraction is that of the work
// which is done when the equations are set up.
template <class NamedParameters>
std::vector<double> poisson_values(const Indexed_surface& surface,
                                   const Weighted_graph& graph,
                                   const Constraints<double>& constraints,
                                   std::vector<double> right_side,
                                   const Progress& progress,
                                   double fraction,
                                   const NamedParameters& np,
                                   Field_report& report)
{
  for(Position v = 0; v != graph.number_of_vertices(); ++v)
    if(constraints.is_fixed[v])
      right_side[v] = constraints.values[v];
  progress.report(fraction);
  Dirichlet_solution solution =
    solve_dirichlet_problem({surface, graph, Laplacian_weights::COTANGENT, constraints.is_fixed, right_side}, 0, np);
  report.number_of_iterations = solution.number_of_steps;
  check_finite(solution.values);
  progress.report(0.9);
  return std::move(solution.values);
}

// Solves with the constraints that fix_vertices(surface, graph, constraints) gives, and the right side that
// integrated_right_side(surface, graph) gives, in the scale of the indexed surface.
template <class FaceListGraph, class FieldMap, class NamedParameters, class FixVertices, class RightSide>
Field_report solve_poisson_equation(const FaceListGraph& mesh,
                                    FieldMap field_map,
                                    const NamedParameters& np,
                                    const FixVertices& fix_vertices,
                                    const RightSide& integrated_right_side)
{
  if constexpr(Mesh_with_vertex_map<FaceListGraph, FieldMap>::value)
  {
    const Progress progress(np);
    progress.report(0);
    Indexed_mesh<FaceListGraph> surface(mesh, np);
    Field_report report = make_triangles_proper(surface);
    const Weighted_graph graph = cotangent_graph(surface);
    Constraints<double> fixed(surface.number_of_vertices());
    fix_vertices(surface, graph, fixed);
    check_components(graph, fixed.is_fixed);
    const auto values = solve_or_lengthen_edges(
      surface, report, graph,
      [&](const Weighted_graph& cotangents, double fraction) {
        return poisson_values(surface, cotangents, fixed, integrated_right_side(surface, cotangents), progress,
                              fraction, np, report);
      },
      [&] { return cotangent_graph(surface); });
    write_field(surface, values, field_map, progress);
    return report;
  }
  else
    return Field_report();
}

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_POISSON_VALUES_H
