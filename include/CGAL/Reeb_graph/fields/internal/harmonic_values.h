// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
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
#include <CGAL/Reeb_graph/fields/internal/constraints.h>
#include <CGAL/Reeb_graph/fields/internal/remove_extrema.h>
#include <CGAL/Reeb_graph/fields/internal/solve.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

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

// The harmonic field with the values that fix_vertices(surface, graph, constraints) gives, and without extrema at free
// vertices.
template <class FaceListGraph, class FieldMap, class NamedParameters, class FixVertices>
Field_report write_harmonic_field(const FaceListGraph& mesh,
                                  FieldMap field_map,
                                  const NamedParameters& np,
                                  const FixVertices& fix_vertices)
{
  typedef Scalar_of_field<FieldMap> Scalar;
  const auto weights = parameters::choose_parameter(parameters::get_parameter(np, internal::laplacian_weights),
                                                    Laplacian_weights::MEAN_VALUE);
  const auto solve = [&](const Indexed_surface& surface, const Weighted_graph& graph,
                         const Constraints<Scalar>& constraints, const Stage_progress& progress, Field_report& report) {
    const Unit_range<Scalar> range(constraints);
    std::vector<double> fixed_values(graph.number_of_vertices(), 0);
    for(Index v = 0; v != graph.number_of_vertices(); ++v)
      if(constraints.is_fixed[v])
        fixed_values[v] = range.to_unit(constraints.values[v]);
    progress(0);
    const Stage_progress solution_progress = progress.part(0, 0.9);
    const Dirichlet_solution solution =
      solve_dirichlet_problem({surface, graph, weights, constraints.is_fixed, fixed_values, solution_progress}, 1, np);
    report.number_of_iterations = solution.number_of_steps;
    std::vector<Scalar> values = constraints.values;
    for(Index v = 0; v != graph.number_of_vertices(); ++v)
      if(!constraints.is_fixed[v])
        values[v] = range.from_unit(solution.values[v]);
    check_finite(values);
    progress(0.9);
    remove_extrema(graph, constraints.is_fixed, values);
    progress(1);
    return values;
  };
  return write_solution<Scalar>(mesh, field_map, weights, np, fix_vertices, solve);
}

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_HARMONIC_VALUES_H
