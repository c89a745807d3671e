// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_SOLVE_H
#define CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_SOLVE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Dirichlet_equations.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Dirichlet_problem.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/solve_iteratively.h>
#include <CGAL/Reeb_graph/named_parameters.h>
// Who links the library with the solvers need not read Eigen.
#ifndef CGAL_REEB_GRAPH_ARE_SOLVERS_COMPILED
#include <CGAL/Reeb_graph/internal/scalar_fields/Default_solver.h>
#endif

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

// Whether there is a named parameter `sparse_linear_solver`.
template <class NamedParameters>
inline constexpr bool is_solver_given =
  is_given<decltype(parameters::get_parameter(std::declval<const NamedParameters&>(),
                                              internal_np::sparse_linear_solver))>;

template <class NamedParameters>
double choose_tolerance(const NamedParameters& np)
{
  const double tolerance =
    parameters::choose_parameter(parameters::get_parameter(np, internal::solver_tolerance), 1e-12);
  if(!(tolerance > 0) || !std::isfinite(tolerance))
    throw Solver_tolerance_error(tolerance);
  return tolerance;
}

// Solves the equations by the solver that is given, or else by the default one.
template <class NamedParameters>
Dirichlet_solution solve_dirichlet_problem(const Dirichlet_equations& equations,
                                           double least_range,
                                           const NamedParameters& np)
{
  const Accuracy accuracy = {choose_tolerance(np), least_range};
  if(std::find(equations.is_fixed.begin(), equations.is_fixed.end(), false) == equations.is_fixed.end())
    return {equations.values, 0};
  if constexpr(is_solver_given<NamedParameters>)
  {
    auto solver = parameters::get_parameter(np, internal_np::sparse_linear_solver);
    return solve_directly(equations, accuracy, solver);
  }
  else
    return solve_by_default(equations, accuracy);
}

#define CGAL_REEB_GRAPH_SOLVE_BY_DEFAULT(PREFIX)                                                                       \
  PREFIX template Dirichlet_solution solve_by_default<Dirichlet_equations>(const Dirichlet_equations&,                 \
                                                                           const Accuracy&);                           \
  PREFIX template Values solve_unsymmetric<Dirichlet_problem>(const Dirichlet_problem&);
CGAL_REEB_GRAPH_FOR_SOLVERS(CGAL_REEB_GRAPH_SOLVE_BY_DEFAULT)

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_SOLVE_H
