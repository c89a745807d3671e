// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_SOLVE_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_SOLVE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/fields/internal/Dirichlet_problem.h>
#include <CGAL/Reeb_graph/fields/internal/Multigrid.h>
#include <CGAL/Reeb_graph/fields/internal/iterate.h>
#include <CGAL/Reeb_graph/fields/internal/solve_directly.h>
#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Reeb_graph::internal::scalar_fields {

// Below this number of vertices a factorization is faster than multigrid.
inline constexpr std::size_t smallest_size_for_multigrid = 5000;

// Solves large problems by multigrid, which need not get as accurate as asked for: after too many steps, the estimate of
// the error could not be trusted. Then, and else, a matrix is factorized.
template <class Equations>
Dirichlet_solution solve_by_default([[maybe_unused]] const Equations& equations,
                                    [[maybe_unused]] const Accuracy& accuracy)
{
#ifdef CGAL_EIGEN3_ENABLED
  if(equations.graph.number_of_vertices() >= smallest_size_for_multigrid)
  {
    const Dirichlet_problem problem(equations);
    constexpr std::size_t largest_number_of_steps = 40;
    Multigrid_system system(problem);
    const Iterative_solution solution =
      system.is_usable()
        ? solve_iteratively(system, problem.right_side(), accuracy, largest_number_of_steps, equations.progress)
        : Iterative_solution();
    if(solution.is_accurate)
      return problem.make_solution(solution.values, solution.number_of_steps);
  }
  Default_solver solver;
  return solve_directly(equations, accuracy, solver);
#else
  static_assert(sizeof(Equations) == 0,
                "Eigen is needed, or the named parameter sparse_linear_solver: link CGAL::Eigen3_support");
  return {};
#endif
}

// Solves the equations by the solver that is given, or else by the default one.
template <class NamedParameters>
Dirichlet_solution solve_dirichlet_problem(const Dirichlet_equations& equations,
                                           double least_range,
                                           const NamedParameters& np)
{
  const double tolerance =
    parameters::choose_parameter(parameters::get_parameter(np, internal::solver_tolerance), 1e-12);
  if(!(tolerance > 0) || !std::isfinite(tolerance))
    throw Solver_tolerance_error(tolerance);
  const Accuracy accuracy = {tolerance, least_range};
  if(std::find(equations.is_fixed.begin(), equations.is_fixed.end(), false) == equations.is_fixed.end())
    return {equations.values, 0};
  auto solver = parameters::get_parameter(np, internal_np::sparse_linear_solver);
  if constexpr(is_given<decltype(solver)>)
    return solve_directly(equations, accuracy, solver);
  else
    return solve_by_default(equations, accuracy);
}

#define CGAL_REEB_GRAPH_SOLVE_BY_DEFAULT(PREFIX)                                                                       \
  PREFIX template Dirichlet_solution solve_by_default<Dirichlet_equations>(const Dirichlet_equations&,                 \
                                                                           const Accuracy&);                           \
  PREFIX template Values solve_unsymmetric<Dirichlet_problem>(const Dirichlet_problem&);
CGAL_REEB_GRAPH_FOR_SOLVERS(CGAL_REEB_GRAPH_SOLVE_BY_DEFAULT)

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_SOLVE_H
