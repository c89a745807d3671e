// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_SOLVE_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_SOLVE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/fields/internal/Dirichlet_problem.h>
#include <CGAL/Reeb_graph/fields/internal/solve_iteratively.h>
#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#ifdef CGAL_EIGEN3_ENABLED

#include <CGAL/Eigen_solver_traits.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#endif

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

#ifdef CGAL_EIGEN3_ENABLED

// An ordering method of Eigen: keeps the order of the rows, as they come from a nested dissection. Where this fills the
// factor more than it should on a surface, because sheets of it are entangled in space, the minimum degrees decide.
class Given_or_minimum_degree_ordering
{
public:
  typedef Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> PermutationType;

  template <class Matrix>
  void operator()(const Matrix& matrix, PermutationType& permutation) const
  {
    if(is_fill_low(matrix))
      permutation.setIdentity(matrix.cols());
    else
      Eigen::AMDOrdering<int>()(matrix, permutation);
  }

private:
  // Counts the entries of the factor along the elimination tree, and stops when there are too many.
  template <class Matrix>
  static bool is_fill_low(const Matrix& matrix)
  {
    const auto size = static_cast<std::size_t>(matrix.cols());
    const double largest_fill = 6. * static_cast<double>(size) * (std::log2(static_cast<double>(size)) + 1);
    std::vector<std::size_t> parents(size, size), last_visits(size, size);
    double fill = 0;
    for(std::size_t column = 0; column != size && fill <= largest_fill; ++column)
    {
      last_visits[column] = column;
      for(typename Matrix::InnerIterator entry(matrix, static_cast<Eigen::Index>(column)); entry; ++entry)
        for(auto row = static_cast<std::size_t>(entry.index()); row < column && last_visits[row] != column;
            row = parents[row])
        {
          if(parents[row] == size)
            parents[row] = column;
          last_visits[row] = column;
          ++fill;
        }
    }
    return fill <= largest_fill;
  }
};

typedef Eigen_sparse_matrix<double>::EigenType Eigen_matrix;
typedef Eigen_solver_traits<Eigen::SimplicialLDLT<Eigen_matrix, Eigen::Lower, Given_or_minimum_degree_ordering>>
  Default_solver;
typedef Eigen_solver_traits<Eigen::SparseLU<Eigen_matrix>> Unsymmetric_solver;

// The equations of a Dirichlet problem, with multigrid as preconditioner.
class Multigrid_system
{
public:
  explicit Multigrid_system(const Dirichlet_problem& problem) : problem_(problem), multigrid_(make_row_matrix(problem))
  {}

  bool is_usable() const { return multigrid_.is_usable(); }

  void compute_residual(const Values& x, Values& residual) const { problem_.compute_residual(x, residual); }

  void multiply(const Values& x, Values& product) const { view(product).noalias() = multigrid_.matrix() * view(x); }

  void precondition(const Values& r, Values& z)
  {
    z.resize(r.size());
    view(z) = multigrid_(view(r));
  }

private:
  typedef Multigrid::Vector Vector;
  static Eigen::Map<const Vector> view(const Values& values) { return {values.data(), Eigen::Index(values.size())}; }
  static Eigen::Map<Vector> view(Values& values) { return {values.data(), Eigen::Index(values.size())}; }

  const Dirichlet_problem& problem_;
  Multigrid multigrid_;
};

// Below this number of vertices a factorization is faster than multigrid.
inline constexpr Position smallest_size_for_multigrid = 5000;

#endif // CGAL_EIGEN3_ENABLED

// Solves large problems by multigrid, which need not get as accurate as asked for: after too many steps, the estimate of
// the error could not be trusted. Then, and else, a matrix is factorized.
template <class Equations>
Dirichlet_solution solve_by_default([[maybe_unused]] const Equations& equations,
                                    [[maybe_unused]] const Accuracy& accuracy)
{
#ifdef CGAL_EIGEN3_ENABLED
  if(equations.graph.number_of_vertices() >= smallest_size_for_multigrid)
  {
    const Dirichlet_problem problem = equations.make_problem(breadth_first_order(equations.graph));
    constexpr std::size_t largest_number_of_steps = 40;
    Multigrid_system system(problem);
    const Iterative_solution solution =
      system.is_usable() ? solve_iteratively(system, problem.right_side(), accuracy, largest_number_of_steps)
                         : Iterative_solution();
    if(solution.is_accurate)
      return equations.make_solution(problem, solution.values, solution.number_of_steps);
  }
  Default_solver solver;
  return solve_directly(equations, accuracy, solver);
#else
  static_assert(sizeof(Equations) == 0,
                "Eigen is needed, or the named parameter sparse_linear_solver: link CGAL::Eigen3_support");
  return {};
#endif
}

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

} // namespace CGAL::Reeb_graph::internal::scalar_fields

// Who links the library with the solvers need not read Eigen.
#ifndef CGAL_REEB_GRAPH_ARE_SOLVERS_COMPILED
#endif

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <utility>

namespace CGAL::Reeb_graph::internal::scalar_fields {

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

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_SOLVE_H
