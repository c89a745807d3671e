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
#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/fields/internal/Weighted_graph.h>
#include <CGAL/Reeb_graph/fields/internal/solve_iteratively.h>
#include <CGAL/Reeb_graph/options.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

// The equations sum_j w_ij (x_j - x_i) = h_i for the vertices i that are free, while the values of the fixed ones are
// given.
class Dirichlet_problem
{
public:
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

// The equations of a Dirichlet problem, with the factorized matrix that has its own weights or other ones, see
// Dirichlet_problem::fill(), as preconditioner.
template <class Solver>
class Factorized_system
{
public:
  template <class... Weight>
  Factorized_system(Solver& solver, const Dirichlet_problem& problem, const Weight&... weight)
    : problem_(problem),
      solver_(solver),
      matrix_(problem.number_of_rows())
  {
    problem.fill(matrix_, weight...);
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

// Orders the vertices of a surface so that the factor of a matrix with one entry per edge has few entries: first those
// of one half, then those of the other half, then those that separate them, and so on in both halves (A. George, Nested
// Dissection of a Regular Finite Element Mesh, 1973). The halves are those along the longest side of the bounding box.
class Nested_dissection
{
public:
  Nested_dissection(const Indexed_surface& surface, const Weighted_graph& graph)
    : surface_(surface),
      graph_(graph),
      vertices_(graph.number_of_vertices()),
      halves_(graph.number_of_vertices(), 0)
  {
    std::iota(vertices_.begin(), vertices_.end(), Position(0));
    dissect(vertices_.begin(), vertices_.end());
  }

  const std::vector<Position>& vertices() const { return vertices_; }

private:
  typedef std::vector<Position>::iterator Iterator;

  int longest_side(Iterator begin, Iterator end) const
  {
    Vector lowest = surface_.point(*begin), highest = lowest;
    for(Iterator it = begin; it != end; ++it)
      for(int i = 0; i != 3; ++i)
      {
        lowest[i] = (std::min)(lowest[i], surface_.point(*it)[i]);
        highest[i] = (std::max)(highest[i], surface_.point(*it)[i]);
      }
    const Vector sides = highest - lowest;
    return static_cast<int>(std::max_element(sides.begin(), sides.end()) - sides.begin());
  }

  void dissect(Iterator begin, Iterator end)
  {
    constexpr std::ptrdiff_t smallest_size = 16;
    if(end - begin < smallest_size)
      return;
    const int side = longest_side(begin, end);
    const Iterator middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, [&](Position u, Position v) {
      const double a = surface_.point(u)[side], b = surface_.point(v)[side];
      return a < b || (a == b && u < v);
    });
    ++last_half_;
    for(Iterator it = middle; it != end; ++it)
      halves_[*it] = last_half_;
    const Iterator first_separator = std::partition(begin, middle, [&](Position v) {
      const auto neighbors = graph_.neighbors(v);
      return std::none_of(neighbors.begin(), neighbors.end(),
                          [&](const auto& n) { return halves_[n.vertex] == last_half_; });
    });
    const Iterator end_of_upper_half = std::rotate(first_separator, middle, end);
    dissect(begin, first_separator);
    dissect(first_separator, end_of_upper_half);
  }

  const Indexed_surface& surface_;
  const Weighted_graph& graph_;
  std::vector<Position> vertices_;
  std::vector<Position> halves_; // number of the last upper half that a vertex was in, by vertex
  Position last_half_ = 0;
};

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

// The following two are in solve.h. They are templates so that the library can have them.
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
    return equations.make_solution(problem, Factorized_system<Solver>(solver, problem).solve(), 0);
  Factorized_system<Solver> system(solver, problem, equations.symmetric_weights());
  constexpr std::size_t largest_number_of_steps = 80;
  const Iterative_solution solution =
    solve_iteratively(system, problem.right_side(), accuracy, largest_number_of_steps);
  return equations.make_solution(problem, solution.is_accurate ? solution.values : solve_unsymmetric(problem), 0);
}

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_DIRICHLET_PROBLEM_H
