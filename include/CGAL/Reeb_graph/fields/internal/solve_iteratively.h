// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_SOLVE_ITERATIVELY_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_SOLVE_ITERATIVELY_H

#include <CGAL/license/Reeb_graph.h>

#ifdef CGAL_EIGEN3_ENABLED
#include <Eigen/LU>
#include <Eigen/SparseCore>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

typedef std::vector<double> Values;

inline double inner_product(const Values& a, const Values& b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
}

// Adds s b to a.
inline void add(Values& a, double s, const Values& b)
{
  for(std::size_t i = 0; i != a.size(); ++i)
    a[i] += s * b[i];
}

inline double largest_absolute_value(const Values& values)
{
  double largest = 0;
  for(const double value : values)
    largest = std::isnan(value) ? value : (std::max)(largest, std::abs(value));
  return largest;
}

// The largest error that a solution may have, as a part of its range, which is at least `least_range`.
struct Accuracy
{
  double tolerance, least_range;

  double largest_error(const Values& solution) const
  {
    constexpr double digits = 16 * std::numeric_limits<double>::epsilon();
    if(solution.empty())
      return 0;
    const auto [lowest, highest] = std::minmax_element(solution.begin(), solution.end());
    return (std::max)(tolerance * (std::max)(*highest - *lowest, least_range),
                      digits * (std::max)(std::abs(*lowest), std::abs(*highest)));
  }
};

struct Iterative_solution
{
  std::vector<double> values;
  std::size_t number_of_steps = 0;
  bool is_accurate = false; // whether the error is about as small as asked for
};

// When steps of an iteration end.
struct Step_limits
{
  std::size_t number = 0;
  double residual = 0, change = 0;
};

// Takes steps of the stabilized bi-conjugate gradients of van der Vorst, preconditioned from the right, until the
// residual or the change of the solution gets below its limit, and returns their number. `residual` is the one at the
// start.
template <class System>
std::size_t take_biconjugate_steps(System& system, Values residual, const Step_limits& limits, Values& solution)
{
  const Values shadow = residual;
  Values direction(residual.size(), 0), v(residual.size(), 0), t(residual.size()), y, z;
  double rho = 1, alpha = 1, omega = 1;
  for(std::size_t step = 0; step != limits.number; ++step)
  {
    if(!(inner_product(residual, residual) > limits.residual * limits.residual))
      return step;
    const double next_rho = inner_product(shadow, residual);
    const double beta = next_rho / rho * alpha / omega;
    rho = next_rho;
    for(std::size_t i = 0; i != residual.size(); ++i)
      direction[i] = residual[i] + beta * (direction[i] - omega * v[i]);
    system.precondition(direction, y);
    system.multiply(y, v);
    alpha = rho / inner_product(shadow, v);
    if(!std::isfinite(alpha))
      return step;
    add(solution, alpha, y);
    add(residual, -alpha, v);
    system.precondition(residual, z);
    system.multiply(z, t);
    omega = inner_product(t, residual) / inner_product(t, t);
    if(!std::isfinite(omega) || omega == 0)
      return step + 1; // a residual of zero after the first half of the step, which is the solution, gives 0 / 0
    add(solution, omega, z);
    add(residual, -omega, t);
    if(std::abs(alpha) * largest_absolute_value(y) + std::abs(omega) * largest_absolute_value(z) < limits.change)
      return step + 1;
  }
  return limits.number;
}

// Solves the equations of a system. `system.precondition(r, z)` sets z to about the solution for the right side r, and
// is what tells the error; `system.compute_residual(x, r)` is exact to the last digits, and `system.multiply(x,
// product)` need not be so.
template <class System>
Iterative_solution solve_iteratively(System& system,
                                     const Values& right_side,
                                     const Accuracy& accuracy,
                                     std::size_t largest_number_of_steps)
{
  constexpr int number_of_starts = 2;
  constexpr double smallest_residual = 1e-15;
  Iterative_solution solution;
  Values residual(right_side.size()), correction;
  system.precondition(right_side, solution.values);
  for(int start = 0;; ++start)
  {
    system.compute_residual(solution.values, residual);
    system.precondition(residual, correction);
    const double error = largest_absolute_value(correction), largest_error = accuracy.largest_error(solution.values);
    solution.is_accurate = error <= largest_error;
    if(solution.is_accurate || !std::isfinite(error) || start == number_of_starts)
      return solution;
    const Step_limits limits = {(std::min)(std::size_t(40), largest_number_of_steps - solution.number_of_steps),
                                smallest_residual * std::sqrt(inner_product(right_side, right_side)),
                                0.1 * largest_error};
    solution.number_of_steps += take_biconjugate_steps(system, residual, limits, solution.values);
  }
}

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
  constexpr double damping = 2. / 3;
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

#endif // CGAL_EIGEN3_ENABLED

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_SOLVE_ITERATIVELY_H
