// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_DIRICHLET_PROBLEM_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_DIRICHLET_PROBLEM_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>
#include <CGAL/Reeb_graph/options.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
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
  double residual = 0, error = 0;
};

// Takes steps of the stabilized bi-conjugate gradients of van der Vorst, preconditioned from the right, until the
// residual or the estimate of the error gets below its limit. `residual` is the one at the start.
template <class System, class Report>
void take_biconjugate_steps(System& system,
                            Values residual,
                            const Step_limits& limits,
                            Iterative_solution& solution,
                            const Report& report)
{
  const Values shadow = residual;
  Values direction(residual.size(), 0), v(residual.size(), 0), t(residual.size()), y, z;
  double rho = 1, alpha = 1, omega = 1;
  for(std::size_t step = 0; step != limits.number; ++step)
  {
    if(!(inner_product(residual, residual) > limits.residual * limits.residual))
      return;
    report(1 - std::pow(0.9, solution.number_of_steps + 1)); // Most solutions take ten to twenty steps.
    const double next_rho = inner_product(shadow, residual);
    const double beta = next_rho / rho * alpha / omega;
    rho = next_rho;
    for(std::size_t i = 0; i != residual.size(); ++i)
      direction[i] = residual[i] + beta * (direction[i] - omega * v[i]);
    system.precondition(direction, y);
    system.multiply(y, v);
    alpha = rho / inner_product(shadow, v);
    if(!std::isfinite(alpha))
      return;
    ++solution.number_of_steps;
    add(solution.values, alpha, y);
    add(residual, -alpha, v);
    system.precondition(residual, z);
    system.multiply(z, t);
    omega = inner_product(t, residual) / inner_product(t, t);
    if(!std::isfinite(omega) || omega == 0)
      return; // a residual of zero after the first half of the step, which is the solution, gives 0 / 0
    add(solution.values, omega, z);
    add(residual, -omega, t);
    if(largest_absolute_value(z) < limits.error)
      return;
  }
}

// Solves the equations of a system. `system.precondition(r, z)` sets z to about the solution for the right side r, and
// is what tells the error; `system.compute_residual(x, r)` is exact to the last digits, and `system.multiply(x,
// product)` need not be so.
template <class System, class Report>
Iterative_solution solve_iteratively(System& system,
                                     const Values& right_side,
                                     const Accuracy& accuracy,
                                     std::size_t largest_number_of_steps,
                                     const Report& report)
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
    take_biconjugate_steps(system, residual, limits, solution, report);
  }
}

// The values of all vertices, and the number of steps of the iteration that has found them, zero if there was none.
struct Dirichlet_solution
{
  std::vector<double> values;
  std::size_t number_of_steps = 0;
};

// The equations sum_j w_ij (x_j - x_i) = h_i for the vertices i that are free. `values` holds x for the fixed ones, and
// h for the free ones.
struct Dirichlet_equations
{
  const Indexed_surface& surface;
  const Weighted_graph& graph;
  Laplacian_weights weights;
  const std::vector<bool>& is_fixed;
  const std::vector<double>& values;
  const Stage_progress& progress;
};

// The rows of the equations, in the order of a breadth-first search. Mean value weights are not symmetric, but their rows are
// scaled so that they come close to symmetric ones: the geometric means of tangents on both ends of an edge.
class Dirichlet_problem
{
public:
  explicit Dirichlet_problem(const Dirichlet_equations& equations)
    : equations_(equations),
      graph_(equations.graph),
      rows_(graph_.number_of_vertices(), no_index)
  {
    for(const Index v : Breadth_first_search(graph_).order)
      if(!equations.is_fixed[v])
      {
        rows_[v] = static_cast<Index>(vertices_.size());
        vertices_.push_back(v);
      }
    factors_.assign(vertices_.size(), 1);
    right_side_.reserve(vertices_.size());
    for(const Index v : vertices_)
    {
      right_side_.push_back(-equations.values[v]);
      for(const auto& n : graph_.neighbors(v))
        if(!is_free(n.vertex))
          right_side_.back() += n.weight * equations.values[n.vertex];
      if(equations.weights != Laplacian_weights::MEAN_VALUE)
        continue;
      double sum = 0, symmetric_sum = 0;
      for(const auto& n : graph_.neighbors(v))
      {
        sum += n.weight;
        symmetric_sum += symmetric_weight(v, n);
      }
      factors_[rows_[v]] = symmetric_sum / sum;
      right_side_.back() *= factors_[rows_[v]];
    }
  }

  std::size_t number_of_rows() const { return vertices_.size(); }
  const Values& right_side() const { return right_side_; }

  // Calls visit(row, column, entry) for the matrix of the equations, or for one with symmetric weights that are close,
  // row by row, and in each row with the diagonal last.
  template <class Visit>
  void for_each_entry(bool are_weights_symmetric, const Visit& visit) const
  {
    for(std::size_t row = 0; row != number_of_rows(); ++row)
    {
      double diagonal = 0;
      for(const auto& n : graph_.neighbors(vertices_[row]))
      {
        const double w = are_weights_symmetric ? symmetric_weight(vertices_[row], n) : factors_[row] * n.weight;
        diagonal += w;
        if(is_free(n.vertex))
          visit(row, std::size_t(rows_[n.vertex]), -w);
      }
      visit(row, row, diagonal);
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
      product[row] = factors_[row] * sum;
    }
  }

  void compute_residual(const Values& x, Values& residual) const
  {
    multiply(x, residual);
    for(std::size_t row = 0; row != number_of_rows(); ++row)
      residual[row] = right_side_[row] - residual[row];
  }

  // The values of all vertices, from those of the rows.
  Dirichlet_solution make_solution(const Values& solution, std::size_t number_of_steps) const
  {
    Dirichlet_solution result = {equations_.values, number_of_steps};
    for(std::size_t row = 0; row != solution.size(); ++row)
      result.values[vertices_[row]] = solution[row];
    return result;
  }

private:
  bool is_free(Index v) const { return rows_[v] != no_index; }

  double symmetric_weight(Index v, const Weighted_graph::Neighbor& n) const
  {
    return std::sqrt(n.weight) * std::sqrt(graph_.weight(n.vertex, v)) * equations_.surface.edge_length(v, n.vertex);
  }

  const Dirichlet_equations& equations_;
  const Weighted_graph& graph_;
  std::vector<Index> rows_;     // row of each vertex, no_index if it is fixed
  std::vector<Index> vertices_; // vertex of each row
  Values right_side_, factors_; // of the rows
};

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_DIRICHLET_PROBLEM_H
