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
#include <CGAL/Reeb_graph/internal/scalar_fields/Default_solver.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Dirichlet_problem.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Dirichlet_systems.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Nested_dissection.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Weighted_graph.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/solve_iteratively.h>
#include <CGAL/Reeb_graph/options.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

// Solves the equations by iteration with multigrid. The solution need not be accurate; after too many steps, the
// estimate of the error could not be trusted.
inline Iterative_solution solve_by_multigrid([[maybe_unused]] const Dirichlet_problem& problem,
                                             [[maybe_unused]] const Accuracy& accuracy)
{
#ifdef CGAL_EIGEN3_ENABLED
  constexpr std::size_t largest_number_of_steps = 40;
  Multigrid_system system(problem);
  if(system.is_usable())
    return solve_iteratively(system, problem.right_side(), accuracy, largest_number_of_steps);
#endif
  return Iterative_solution();
}

// The matrix of the problem is symmetric.
template <class Solver>
Values solve_symmetric_directly(const Dirichlet_problem& problem, Solver& solver)
{
  return Factorized_matrix<Solver>(solver, problem).solve(problem.right_side());
}

// The symmetric weights that are close are factorized, and iteration does the rest.
template <class Weights, class Solver>
Values solve_nearly_symmetric_directly(const Dirichlet_problem& problem,
                                       const Weights& weights,
                                       const Accuracy& accuracy,
                                       Solver& solver)
{
  Factorized_system<Solver> system(solver, problem, weights);
  constexpr std::size_t largest_number_of_steps = 80;
  Iterative_solution solution = solve_iteratively(system, problem.right_side(), accuracy, largest_number_of_steps);
  if(solution.is_accurate)
    return std::move(solution.values);
#ifdef CGAL_EIGEN3_ENABLED
  Unsymmetric_solver unsymmetric_solver;
  return Factorized_matrix<Unsymmetric_solver>(unsymmetric_solver, problem).solve(problem.right_side());
#else
  throw Linear_solver_error();
#endif
}

// The values of all vertices, and the number of steps of the iteration that has found them, zero if there was none.
struct Dirichlet_solution
{
  std::vector<double> values;
  std::size_t number_of_steps = 0;
};

// Below this number of vertices a factorization is faster than multigrid.
inline constexpr Position smallest_size_for_multigrid = 5000;

// Solves the equations sum_j w_ij (x_j - x_i) = h_i. `values` holds x for the fixed vertices, and h for the free ones.
// Large problems are solved by multigrid, unless a solver is given. Where that does not get as accurate as asked for,
// and else, a matrix is factorized.
template <class Surface, class NamedParameters>
Dirichlet_solution solve_dirichlet_problem(const Surface& surface,
                                           const Weighted_graph& graph,
                                           Laplacian_weights weights,
                                           const std::vector<bool>& is_fixed,
                                           const std::vector<double>& values,
                                           double least_range,
                                           const NamedParameters& np)
{
  const Nearly_symmetric_weights<Surface> symmetric_weights(surface, graph);
  const Accuracy accuracy = {choose_tolerance(np), least_range};
  if(std::find(is_fixed.begin(), is_fixed.end(), false) == is_fixed.end())
    return {values, 0};
  const auto make_problem = [&](const std::vector<Position>& order) {
    Dirichlet_problem problem(graph, order, is_fixed, values);
    if(weights == Laplacian_weights::MEAN_VALUE)
      symmetric_weights.scale(problem);
    return problem;
  };
  const auto values_of_vertices = [&](const Dirichlet_problem& problem, const Values& solution) {
    std::vector<double> result = values;
    for(std::size_t row = 0; row != solution.size(); ++row)
      result[problem.vertex(row)] = solution[row];
    return result;
  };
  if constexpr(!is_solver_given<NamedParameters>)
    if(graph.number_of_vertices() >= smallest_size_for_multigrid)
    {
      const Dirichlet_problem problem = make_problem(breadth_first_order(graph));
      const Iterative_solution solution = solve_by_multigrid(problem, accuracy);
      if(solution.is_accurate)
        return {values_of_vertices(problem, solution.values), solution.number_of_steps};
    }
  const Dirichlet_problem problem = make_problem(Nested_dissection<Surface>(surface, graph).vertices());
  auto solver = choose_solver(np);
  return {values_of_vertices(problem, weights == Laplacian_weights::MEAN_VALUE
                                        ? solve_nearly_symmetric_directly(problem, symmetric_weights, accuracy, solver)
                                        : solve_symmetric_directly(problem, solver)),
          0};
}

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_SOLVE_H
