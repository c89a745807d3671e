// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_DIRICHLET_PROBLEM_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_DIRICHLET_PROBLEM_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/fields/internal/Weighted_graph.h>
#include <CGAL/Reeb_graph/fields/internal/solve_iteratively.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

// The equations sum_j w_ij (x_j - x_i) = h_i for the vertices i that are free, while the values of the fixed ones are
// given.
class Dirichlet_problem
{
public:
  typedef std::vector<double> Values;

  // The rows are in the order `order`; `values` holds the values of the fixed vertices, and h for the free ones.
  Dirichlet_problem(const Weighted_graph& graph,
                    const std::vector<Position>& order,
                    const std::vector<bool>& is_fixed,
                    const Values& values)
    : graph_(graph),
      rows_(graph.number_of_vertices(), no_position)
  {
    for(const Position v : order)
      if(!is_fixed[v])
      {
        rows_[v] = static_cast<Position>(vertices_.size());
        vertices_.push_back(v);
      }
    right_side_.reserve(vertices_.size());
    for(const Position v : vertices_)
    {
      right_side_.push_back(-values[v]);
      for(const auto& n : graph.neighbors(v))
        if(!is_free(n.vertex))
          right_side_.back() += n.weight * values[n.vertex];
    }
  }

  // Multiplies each equation by a factor.
  void scale(Values factors)
  {
    factors_ = std::move(factors);
    for(std::size_t row = 0; row != number_of_rows(); ++row)
      right_side_[row] *= factors_[row];
  }

  std::size_t number_of_rows() const { return vertices_.size(); }
  Position vertex(std::size_t row) const { return vertices_[row]; }
  const Values& right_side() const { return right_side_; }

  // Fills the matrix of the equations.
  template <class Matrix>
  void fill(Matrix& matrix) const
  {
    fill(matrix, [this](Position v, const auto& n) { return factor(rows_[v]) * n.weight; });
  }

  // Fills the matrix that has -`weight(i, n)` for the neighbor n of i beside the diagonal, and their sums on it, row by
  // row.
  template <class Matrix, class Weight>
  void fill(Matrix& matrix, const Weight& weight) const
  {
    for(std::size_t row = 0; row != number_of_rows(); ++row)
    {
      double diagonal = 0;
      for(const auto& n : graph_.neighbors(vertices_[row]))
      {
        const double w = weight(vertices_[row], n);
        diagonal += w;
        if(is_free(n.vertex))
          matrix.set_coef(row, rows_[n.vertex], -w, true);
      }
      matrix.set_coef(row, row, diagonal, true);
    }
  }

  // The product of the matrix and x. Differences come first, so that their digits count where values are nearly equal.
  void multiply(const Values& x, Values& product) const
  {
    for(std::size_t row = 0; row != number_of_rows(); ++row)
    {
      double sum = 0;
      for(const auto& n : graph_.neighbors(vertices_[row]))
        sum += n.weight * (x[row] - (is_free(n.vertex) ? x[rows_[n.vertex]] : 0));
      product[row] = factor(row) * sum;
    }
  }

  void compute_residual(const Values& x, Values& residual) const
  {
    multiply(x, residual);
    for(std::size_t row = 0; row != number_of_rows(); ++row)
      residual[row] = right_side_[row] - residual[row];
  }

private:
  double factor(std::size_t row) const { return factors_.empty() ? 1 : factors_[row]; }
  bool is_free(Position v) const { return rows_[v] != no_position; }

  const Weighted_graph& graph_;
  std::vector<Position> rows_;     // row of each vertex, no_position if it is fixed
  std::vector<Position> vertices_; // vertex of each row
  Values right_side_;
  Values factors_; // of the rows, none if they are all 1
};

// The factorized matrix of a Dirichlet problem, with its own weights or other ones, see Dirichlet_problem::fill().
template <class Solver>
class Factorized_matrix
{
public:
  template <class... Weight>
  Factorized_matrix(Solver& solver, const Dirichlet_problem& problem, const Weight&... weight)
    : solver_(solver),
      matrix_(problem.number_of_rows())
  {
    problem.fill(matrix_, weight...);
    typename Solver::NT denominator = 1;
    if(!solver_.factor(matrix_, denominator))
      throw Linear_solver_error();
  }

  std::vector<double> solve(const std::vector<double>& right_side)
  {
    typename Solver::Vector b(right_side.size()), x(right_side.size());
    for(std::size_t i = 0; i != right_side.size(); ++i)
      b.set(i, right_side[i]);
    if(!solver_.linear_solver(b, x))
      throw Linear_solver_error();
    std::vector<double> solution(right_side.size());
    for(std::size_t i = 0; i != solution.size(); ++i)
      solution[i] = x[static_cast<int>(i)];
    return solution;
  }

private:
  Solver& solver_;
  typename Solver::Matrix matrix_;
};

// The equations of a Dirichlet problem, with a factorized matrix as preconditioner.
template <class Solver>
class Factorized_system
{
public:
  template <class Weight>
  Factorized_system(Solver& solver, const Dirichlet_problem& problem, const Weight& weight)
    : problem_(problem),
      matrix_(solver, problem, weight)
  {}

  void compute_residual(const Values& x, Values& residual) const { problem_.compute_residual(x, residual); }
  void multiply(const Values& x, Values& product) const { problem_.multiply(x, product); }
  void precondition(const Values& r, Values& z) { z = matrix_.solve(r); }

private:
  const Dirichlet_problem& problem_;
  Factorized_matrix<Solver> matrix_;
};

// Mean value weights are not symmetric, but the equations can be scaled so that they come close to symmetric ones: the
// geometric means of tangents on both ends of an edge.
class Nearly_symmetric_weights
{
public:
  Nearly_symmetric_weights(const Indexed_surface& surface, const Weighted_graph& graph)
    : surface_(surface),
      graph_(graph)
  {}

  double operator()(Position v, const Weighted_graph::Neighbor& n) const
  {
    return std::sqrt(n.weight) * std::sqrt(graph_.weight(n.vertex, v)) * surface_.edge_length(v, n.vertex);
  }

  void scale(Dirichlet_problem& problem) const
  {
    Values factors;
    factors.reserve(problem.number_of_rows());
    for(std::size_t row = 0; row != problem.number_of_rows(); ++row)
    {
      const Position v = problem.vertex(row);
      double sum = 0;
      for(const auto& n : graph_.neighbors(v))
        sum += (*this)(v, n);
      factors.push_back(sum / graph_.sum_of_weights(v));
    }
    problem.scale(std::move(factors));
  }

private:
  const Indexed_surface& surface_;
  const Weighted_graph& graph_;
};

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_DIRICHLET_PROBLEM_H
