// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_DIRICHLET_EQUATIONS_H
#define CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_DIRICHLET_EQUATIONS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/scalar_fields/Dirichlet_problem.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Dirichlet_systems.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Indexed_surface.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Nested_dissection.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Weighted_graph.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/solve_iteratively.h>
#include <CGAL/Reeb_graph/options.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

// The values of all vertices, and the number of steps of the iteration that has found them, zero if there was none.
struct Dirichlet_solution
{
  std::vector<double> values;
  std::size_t number_of_steps = 0;
};

// The equations sum_j w_ij (x_j - x_i) = h_i. `values` holds x for the fixed vertices, and h for the free ones.
struct Dirichlet_equations
{
  const Indexed_surface& surface;
  const Weighted_graph& graph;
  Laplacian_weights weights;
  const std::vector<bool>& is_fixed;
  const std::vector<double>& values;

  Nearly_symmetric_weights symmetric_weights() const { return Nearly_symmetric_weights(surface, graph); }

  // The free vertices are in the order given.
  Dirichlet_problem make_problem(const std::vector<Position>& order) const
  {
    Dirichlet_problem problem(graph, order, is_fixed, values);
    if(weights == Laplacian_weights::MEAN_VALUE)
      symmetric_weights().scale(problem);
    return problem;
  }

  Dirichlet_solution make_solution(const Dirichlet_problem& problem,
                                   const Values& solution,
                                   std::size_t number_of_steps) const
  {
    Dirichlet_solution result = {values, number_of_steps};
    for(std::size_t row = 0; row != solution.size(); ++row)
      result.values[problem.vertex(row)] = solution[row];
    return result;
  }
};

// The following two are in Default_solver.h. They are templates so that the library can have them.
template <class Equations>
Dirichlet_solution solve_by_default(const Equations& equations, const Accuracy& accuracy);
template <class Problem>
Values solve_unsymmetric(const Problem& problem);

// Factorizes the matrix if it is symmetric; else symmetric weights that are close, and iteration does the rest.
template <class Solver>
Dirichlet_solution solve_directly(const Dirichlet_equations& equations, const Accuracy& accuracy, Solver& solver)
{
  const Dirichlet_problem problem =
    equations.make_problem(Nested_dissection(equations.surface, equations.graph).vertices());
  if(equations.weights != Laplacian_weights::MEAN_VALUE)
    return equations.make_solution(problem, Factorized_matrix<Solver>(solver, problem).solve(problem.right_side()), 0);
  Factorized_system<Solver> system(solver, problem, equations.symmetric_weights());
  constexpr std::size_t largest_number_of_steps = 80;
  const Iterative_solution solution =
    solve_iteratively(system, problem.right_side(), accuracy, largest_number_of_steps);
  return equations.make_solution(problem, solution.is_accurate ? solution.values : solve_unsymmetric(problem), 0);
}

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_DIRICHLET_EQUATIONS_H
