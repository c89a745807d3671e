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
#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/Named_function_parameters.h>

#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Eigen_solver_traits.h>

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

#ifdef CGAL_EIGEN3_ENABLED

typedef Eigen::SparseMatrix<double, Eigen::RowMajor> Row_matrix;

// Partitions the rows of a matrix into aggregates, each of a row and those that depend strongly on it (P. Vanek, J.
// Mandel, M. Brezina, Algebraic Multigrid by Smoothed Aggregation for Second and Fourth Order Elliptic Problems, 1996).
class Aggregation
{
public:
  Aggregation(const Row_matrix& matrix, double threshold)
    : matrix_(matrix),
      diagonal_(matrix.diagonal()),
      squared_threshold_(threshold * threshold),
      aggregates_(matrix.rows(), none)
  {
    found_aggregates();
    join_neighbors();
  }

  int number_of_aggregates() const { return size_; }

  // The aggregate of a row, `none` for rows that depend strongly on no other one: smoothing solves them.
  int operator[](int row) const { return aggregates_[row]; }

  static constexpr int none = -1;

  // Whether the row depends strongly on that of an entry beside the diagonal.
  bool is_strong(const Row_matrix::InnerIterator& entry) const
  {
    const double value = entry.value();
    return value < 0 && value * value > squared_threshold_ * diagonal_[entry.row()] * diagonal_[entry.col()];
  }

private:
  template <class Visit>
  void for_each_strong_neighbor(int row, const Visit& visit) const
  {
    for(Row_matrix::InnerIterator entry(matrix_, row); entry; ++entry)
      if(entry.col() != row && is_strong(entry))
        visit(entry);
  }

  // Each row none of whose neighbors is in an aggregate founds one with them.
  void found_aggregates()
  {
    for(int row = 0; row != matrix_.rows(); ++row)
    {
      bool is_free = aggregates_[row] == none, has_neighbors = false;
      for_each_strong_neighbor(row, [&](const auto& entry) {
        has_neighbors = true;
        is_free = is_free && aggregates_[entry.col()] == none;
      });
      if(!is_free || !has_neighbors)
        continue;
      aggregates_[row] = size_;
      for_each_strong_neighbor(row, [&](const auto& entry) { aggregates_[entry.col()] = size_; });
      ++size_;
    }
  }

  // The other rows join the aggregate on which they depend most; where there is none, they found one.
  void join_neighbors()
  {
    const std::vector<int> founded = aggregates_;
    for(int row = 0; row != matrix_.rows(); ++row)
    {
      if(aggregates_[row] != none)
        continue;
      double strongest = 0;
      bool has_neighbors = false;
      for_each_strong_neighbor(row, [&](const auto& entry) {
        has_neighbors = true;
        if(founded[entry.col()] == none || !(-entry.value() > strongest))
          return;
        strongest = -entry.value();
        aggregates_[row] = founded[entry.col()];
      });
      if(aggregates_[row] != none || !has_neighbors)
        continue;
      aggregates_[row] = size_;
      for_each_strong_neighbor(row, [&](const auto& entry) {
        if(aggregates_[entry.col()] == none)
          aggregates_[entry.col()] = size_;
      });
      ++size_;
    }
  }

  const Row_matrix& matrix_;
  const Eigen::VectorXd diagonal_;
  const double squared_threshold_;
  std::vector<int> aggregates_;
  int size_ = 0;
};

// The interpolation from aggregates to rows: constant on each aggregate, then smoothed by a step of Jacobi's iteration
// with the strong entries of the matrix, while the weak ones are added to its diagonal.
inline Row_matrix smoothed_interpolation(const Row_matrix& matrix, const Aggregation& aggregates)
{
  constexpr double damping = 0.8;
  Row_matrix interpolation(matrix.rows(), aggregates.number_of_aggregates());
  interpolation.reserve(3 * matrix.rows());
  std::vector<std::pair<int, double>> entries;
  for(int row = 0; row != matrix.rows(); ++row)
  {
    double diagonal = 0;
    entries.clear();
    for(Row_matrix::InnerIterator entry(matrix, row); entry; ++entry)
      if(entry.col() == row || !aggregates.is_strong(entry))
        diagonal += entry.value();
      else
        entries.emplace_back(aggregates[entry.index()], -damping * entry.value());
    for(auto& entry : entries)
      entry.second /= diagonal;
    if(!(diagonal > 0))
      entries.clear();
    if(aggregates[row] != Aggregation::none)
      entries.emplace_back(aggregates[row], entries.empty() ? 1 : 1 - damping);
    std::sort(entries.begin(), entries.end());
    interpolation.startVec(row);
    int last = Aggregation::none;
    for(const auto& [aggregate, value] : entries)
    {
      if(aggregate == Aggregation::none)
        continue;
      if(aggregate != last)
        interpolation.insertBack(row, aggregate) = 0;
      last = aggregate;
      interpolation.valuePtr()[interpolation.data().size() - 1] += value;
    }
  }
  interpolation.finalize();
  return interpolation;
}

// The matrix of equations that have an entry for each edge.
template <class Problem>
Row_matrix make_row_matrix(const Problem& problem)
{
  const auto size = static_cast<Eigen::Index>(problem.number_of_rows());
  Row_matrix matrix(size, size);
  matrix.reserve(7 * size);
  std::vector<std::pair<int, double>> entries; // of a row
  problem.for_each_entry(false, [&](std::size_t row, std::size_t column, double entry) {
    entries.emplace_back(static_cast<int>(column), entry);
    if(column != row)
      return;
    std::sort(entries.begin(), entries.end());
    matrix.startVec(static_cast<Eigen::Index>(row));
    for(const auto& [j, value] : entries)
      matrix.insertBack(static_cast<Eigen::Index>(row), j) = value;
    entries.clear();
  });
  matrix.finalize();
  return matrix;
}

// A preconditioner for matrices with a positive diagonal and mostly negative entries beside it, which come from a graph
// and are symmetric or nearly so: one V-cycle of algebraic multigrid by smoothed aggregation. It usually takes time and
// memory in proportion to the entries of the matrix; rows of many entries can make the coarser ones dense.
class Multigrid
{
public:
  typedef Eigen::VectorXd Vector;

  explicit Multigrid(Row_matrix matrix)
  {
    constexpr Eigen::Index size_to_reach = 300, largest_direct_size = 1000;
    double threshold = 0.08; // of strong entries; Vanek halves it from level to level
    for(add_level(matrix); levels_.back().matrix.rows() > size_to_reach; threshold /= 2)
      if(!coarsen(threshold))
        break;
    is_usable_ = levels_.back().matrix.rows() <= largest_direct_size;
    if(is_usable_)
      coarsest_.compute(Eigen::MatrixXd(levels_.back().matrix));
  }

  // Whether the matrix became small enough to be solved. Otherwise there is no preconditioner.
  bool is_usable() const { return is_usable_; }

  const Row_matrix& matrix() const { return levels_.front().matrix; }

  // Solves for the right side about.
  const Vector& operator()(const Eigen::Ref<const Vector>& right_side)
  {
    levels_.front().right_side = right_side;
    cycle(0);
    return levels_.front().solution;
  }

private:
  struct Level
  {
    Row_matrix matrix, interpolation;
    Vector right_side, solution, residual;
  };

  // Takes the matrix over.
  void add_level(Row_matrix& matrix)
  {
    const Eigen::Index size = matrix.rows();
    levels_.push_back({Row_matrix(), Row_matrix(), Vector(size), Vector(size), Vector(size)});
    levels_.back().matrix.swap(matrix);
  }

  bool coarsen(double threshold)
  {
    Level& level = levels_.back();
    const Aggregation aggregates(level.matrix, threshold);
    if(aggregates.number_of_aggregates() == 0 || aggregates.number_of_aggregates() > level.matrix.rows() / 2)
      return false;
    level.interpolation = smoothed_interpolation(level.matrix, aggregates);
    const Row_matrix product = level.matrix * level.interpolation, restriction = level.interpolation.transpose();
    Row_matrix coarse_matrix = restriction * product;
    add_level(coarse_matrix);
    return true;
  }

  // A sweep of Gauss and Seidel forwards, from zero; a correction from the next level; and a sweep backwards.
  void cycle(std::size_t i)
  {
    auto& [matrix, interpolation, right_side, solution, residual] = levels_[i];
    if(i + 1 == levels_.size())
    {
      solution = coarsest_.solve(right_side);
      return;
    }
    solution = right_side;
    matrix.triangularView<Eigen::Lower>().solveInPlace(solution);
    // After the sweep, this is what the left side is too large by; so is the correction.
    residual.noalias() = matrix.triangularView<Eigen::StrictlyUpper>() * solution;
    levels_[i + 1].right_side.noalias() = interpolation.transpose() * residual;
    cycle(i + 1);
    solution.noalias() -= interpolation * levels_[i + 1].solution;
    for(Eigen::Index row = matrix.rows(); row-- > 0;)
    {
      double sum = right_side[row], diagonal = 0;
      for(Row_matrix::InnerIterator entry(matrix, row); entry; ++entry)
        if(entry.col() == row)
          diagonal = entry.value();
        else
          sum -= entry.value() * solution[entry.col()];
      solution[row] = sum / diagonal;
    }
  }

  std::deque<Level> levels_; // from the finest to the coarsest
  Eigen::PartialPivLU<Eigen::MatrixXd> coarsest_;
  bool is_usable_ = false;
};

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

#endif // CGAL_EIGEN3_ENABLED

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
  const double tolerance = internal::parameter_or(np, internal::solver_tolerance, 1e-12);
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
