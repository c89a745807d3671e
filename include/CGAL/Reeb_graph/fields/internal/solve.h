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
#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/Named_function_parameters.h>

#ifdef CGAL_EIGEN3_ENABLED

#include <CGAL/Eigen_solver_traits.h>

#include <Eigen/SparseCholesky>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Reeb_graph::internal::scalar_fields {

// The equations of a Dirichlet problem, with the factorized matrix as preconditioner, or that with symmetric weights.
template <class Solver>
class Factorized_system
{
public:
  Factorized_system(Solver& solver, const Dirichlet_problem& problem, bool are_weights_symmetric = false)
    : problem_(problem),
      solver_(solver),
      matrix_(problem.number_of_rows())
  {
    problem.for_each_entry(are_weights_symmetric, [&](std::size_t row, std::size_t column, double entry) {
      matrix_.set_coef(row, column, entry, true);
    });
    typename Solver::NT denominator = 1;
    if(!solver_.factor(matrix_, denominator))
      throw Linear_solver_error();
  }

  void compute_residual(const Values& x, Values& residual) const { problem_.compute_residual(x, residual); }
  void multiply(const Values& x, Values& product) const { problem_.multiply(x, product); }
  void precondition(const Values& r, Values& z)
  {
    typename Solver::Vector b(r.size()), x(r.size());
    for(std::size_t i = 0; i != r.size(); ++i)
      b.set(i, r[i]);
    if(!solver_.linear_solver(b, x))
      throw Linear_solver_error();
    z.resize(r.size());
    for(std::size_t i = 0; i != z.size(); ++i)
      z[i] = x[static_cast<int>(i)];
  }

  // The solution with the weights of the matrix.
  Values solve()
  {
    Values solution;
    precondition(problem_.right_side(), solution);
    return solution;
  }

private:
  const Dirichlet_problem& problem_;
  Solver& solver_;
  typename Solver::Matrix matrix_;
};

#ifdef CGAL_EIGEN3_ENABLED
typedef Eigen_sparse_matrix<double>::EigenType Eigen_matrix;
typedef Eigen_solver_traits<Eigen::SimplicialLDLT<Eigen_matrix>> Default_solver;
typedef Eigen_solver_traits<Eigen::SparseLU<Eigen_matrix>> Unsymmetric_solver;
#endif

// Solves equations that are not symmetric. This is a template so that the library can have it.
template <class Problem>
Values solve_unsymmetric([[maybe_unused]] const Problem& problem)
{
#ifdef CGAL_EIGEN3_ENABLED
  Unsymmetric_solver solver;
  return Factorized_system<Unsymmetric_solver>(solver, problem).solve();
#else
  throw Linear_solver_error();
#endif
}

// Factorizes the matrix if it is symmetric; else symmetric weights that are close, and iteration does the rest.
template <class Solver>
Dirichlet_solution solve_directly(const Dirichlet_equations& equations, const Accuracy& accuracy, Solver& solver)
{
  const Dirichlet_problem problem(equations);
  const bool is_unsymmetric = equations.weights == Laplacian_weights::MEAN_VALUE;
  Factorized_system<Solver> system(solver, problem, is_unsymmetric);
  if(!is_unsymmetric)
    return problem.make_solution(system.solve(), 0);
  constexpr std::size_t largest_number_of_steps = 80;
  const Iterative_solution solution =
    solve_iteratively(system, problem.right_side(), accuracy, largest_number_of_steps, equations.progress);
  return problem.make_solution(solution.is_accurate ? solution.values : solve_unsymmetric(problem), 0);
}

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
