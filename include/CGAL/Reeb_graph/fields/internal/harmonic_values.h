// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_HARMONIC_VALUES_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_HARMONIC_VALUES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/Field_report.h>
#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/fields/internal/Weighted_graph.h>
#include <CGAL/Reeb_graph/fields/internal/constraints.h>
#include <CGAL/Reeb_graph/fields/internal/remove_extrema.h>
#include <CGAL/Reeb_graph/fields/internal/solve.h>
#include <CGAL/Reeb_graph/fields/internal/triangle_geometry.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

template <class NamedParameters>
Laplacian_weights choose_weights(const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, internal::laplacian_weights),
                                      Laplacian_weights::MEAN_VALUE);
}

// The fixed values, mapped linearly to those from 0 to 1.
template <class Scalar>
struct Unit_range
{
  double lowest, highest;

  explicit Unit_range(const Constraints<Scalar>& constraints)
  {
    lowest = std::numeric_limits<double>::infinity();
    highest = -lowest;
    for(std::size_t v = 0; v != constraints.values.size(); ++v)
      if(constraints.is_fixed[v])
      {
        lowest = (std::min)(lowest, static_cast<double>(constraints.values[v]));
        highest = (std::max)(highest, static_cast<double>(constraints.values[v]));
      }
    if(highest >= lowest && (std::isinf(lowest) || std::isinf(highest)))
      throw Linear_solver_error();
  }

  double to_unit(Scalar value) const { return lowest < highest ? crossing_fraction(lowest, highest, value) : 0; }
  Scalar from_unit(double t) const { return static_cast<Scalar>(value_at_fraction(lowest, highest, t)); }
};

// The harmonic field with these fixed values, and without extrema at free vertices. The fraction is that of the work
// which is done when the equations are set up.
template <class Scalar, class NamedParameters>
std::vector<Scalar> harmonic_values(const Indexed_surface& surface,
                                    const Weighted_graph& graph,
                                    const Constraints<Scalar>& constraints,
                                    const Progress& progress,
                                    double fraction,
                                    const NamedParameters& np,
                                    Field_report& report)
{
  const Unit_range<Scalar> range(constraints);
  std::vector<double> fixed_values(graph.number_of_vertices(), 0);
  for(Position v = 0; v != graph.number_of_vertices(); ++v)
    if(constraints.is_fixed[v])
      fixed_values[v] = range.to_unit(constraints.values[v]);
  progress.report(fraction);
  const Dirichlet_solution solution =
    solve_dirichlet_problem({surface, graph, choose_weights(np), constraints.is_fixed, fixed_values}, 1, np);
  report.number_of_iterations = solution.number_of_steps;
  std::vector<Scalar> values = constraints.values;
  for(Position v = 0; v != graph.number_of_vertices(); ++v)
    if(!constraints.is_fixed[v])
    {
      values[v] = range.from_unit(solution.values[v]);
      if(!std::isfinite(values[v]))
        throw Non_finite_scalar_error(v);
    }
  progress.report(0.8);
  remove_extrema(graph, constraints.is_fixed, values);
  progress.report(0.9);
  return values;
}

// The harmonic field with the values that fix_vertices(surface, graph, constraints) gives.
template <class FaceListGraph, class FieldMap, class NamedParameters, class FixVertices>
Field_report write_harmonic_field(const FaceListGraph& mesh,
                                  FieldMap field_map,
                                  const NamedParameters& np,
                                  const FixVertices& fix_vertices)
{
  if constexpr(Mesh_with_vertex_map<FaceListGraph, FieldMap>::value)
  {
    const Progress progress(np);
    progress.report(0);
    Indexed_mesh<FaceListGraph> surface(mesh, np);
    const Laplacian_weights weights = choose_weights(np);
    const bool has_geometry = weights != Laplacian_weights::UNIFORM;
    Field_report report = has_geometry ? make_triangles_proper(surface) : Field_report();
    const Weighted_graph graph = laplacian_graph(surface, weights);
    Constraints<typename Scalar_of_field<FieldMap>::type> constraints(surface.number_of_vertices());
    fix_vertices(surface, graph, constraints);
    check_components(graph, constraints.is_fixed);
    const auto solve = [&](const Weighted_graph& weighted_graph, double fraction) {
      return harmonic_values(surface, weighted_graph, constraints, progress, fraction, np, report);
    };
    const auto values = has_geometry ? solve_or_lengthen_edges(surface, report, graph, solve,
                                                               [&] { return laplacian_graph(surface, weights); })
                                     : solve(graph, 0.2);
    write_field(surface, values, field_map, progress);
    return report;
  }
  else
    return Field_report();
}

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_HARMONIC_VALUES_H
