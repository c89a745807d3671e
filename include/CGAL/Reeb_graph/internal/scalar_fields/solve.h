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
#include <CGAL/Reeb_graph/internal/scalar_fields/Weighted_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

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

// Solves A x = b by the stabilized bi-conjugate gradients of van der Vorst, preconditioned from the right by a
// factorized matrix M that is close to A. Returns whether M^-1 (b - A x), about the error of x, became small.
template <class Multiply, class Precondition>
bool solve_iteratively(const Multiply& multiply, const Precondition& precondition, const Values& b, Values& x)
{
  constexpr int number_of_starts = 2, number_of_steps = 40;
  constexpr double largest_error = 1e-12, smallest_residual = 1e-15;
  Values residual(b.size()), v(b.size()), t(b.size()), y, z;
  const auto compute_residual = [&] {
    multiply(x, residual);
    for(std::size_t i = 0; i != b.size(); ++i)
      residual[i] = b[i] - residual[i];
  };
  const double goal = smallest_residual * smallest_residual * inner_product(b, b);
  x = precondition(b);
  for(int start = 0; start != number_of_starts; ++start)
  {
    compute_residual();
    const Values shadow = residual;
    Values direction(b.size(), 0);
    double rho = 1, alpha = 1, omega = 1;
    std::fill(v.begin(), v.end(), 0);
    for(int step = 0; step != number_of_steps && inner_product(residual, residual) > goal; ++step)
    {
      const double next_rho = inner_product(shadow, residual);
      const double beta = next_rho / rho * alpha / omega;
      rho = next_rho;
      for(std::size_t i = 0; i != b.size(); ++i)
        direction[i] = residual[i] + beta * (direction[i] - omega * v[i]);
      y = precondition(direction);
      multiply(y, v);
      alpha = rho / inner_product(shadow, v);
      add(residual, -alpha, v);
      z = precondition(residual);
      multiply(z, t);
      omega = inner_product(t, residual) / inner_product(t, t);
      if(!std::isfinite(alpha) || !std::isfinite(omega) || omega == 0)
        break;
      add(x, alpha, y);
      add(x, omega, z);
      add(residual, -omega, t);
      if(std::abs(alpha) * largest_absolute_value(y) + std::abs(omega) * largest_absolute_value(z)
         < 0.1 * largest_error)
        break;
    }
    compute_residual();
    const Values correction = precondition(residual);
    const double error = largest_absolute_value(correction);
    if(error <= largest_error)
      return true;
    if(!std::isfinite(error))
      return false;
  }
  return false;
}

// The matrix of the problem is symmetric.
template <class Solver>
Values solve_symmetric(const Dirichlet_problem& problem, Solver& solver)
{
  if(problem.number_of_rows() == 0)
    return Values();
  Factorized_matrix<Solver> matrix(solver, problem, [](Position, const auto& n) { return n.weight; });
  return matrix.solve(problem.right_side());
}

// The weights are mean values, which are not symmetric. The rows can be scaled so that they come close to symmetric
// weights, the geometric means of tangents on both ends of an edge; these are factorized, and iteration does the rest.
template <class Surface, class Solver>
Values solve_mean_value(const Surface& surface,
                        const Weighted_graph& graph,
                        const Dirichlet_problem& problem,
                        Solver& solver)
{
  if(problem.number_of_rows() == 0)
    return Values();
  const auto symmetric_weight = [&](Position v, const Weighted_graph::Neighbor& n) {
    return std::sqrt(n.weight) * std::sqrt(graph.weight(n.vertex, v)) * surface.edge_length(v, n.vertex);
  };
  Values scales, b, x;
  for(std::size_t row = 0; row != problem.number_of_rows(); ++row)
  {
    const Position v = problem.vertex(row);
    double sum = 0;
    for(const auto& n : graph.neighbors(v))
      sum += symmetric_weight(v, n);
    scales.push_back(sum / graph.sum_of_weights(v));
    b.push_back(scales.back() * problem.right_side()[row]);
  }
  const auto multiply = [&](const Values& factor, Values& product) {
    problem.multiply(factor, product);
    for(std::size_t row = 0; row != product.size(); ++row)
      product[row] *= scales[row];
  };
  Factorized_matrix<Solver> matrix(solver, problem, symmetric_weight);
  if(solve_iteratively(
       multiply, [&](const Values& r) { return matrix.solve(r); }, b, x))
    return x;
#ifdef CGAL_EIGEN3_ENABLED
  std::vector<double> scale_of_vertex(graph.number_of_vertices());
  for(std::size_t row = 0; row != problem.number_of_rows(); ++row)
    scale_of_vertex[problem.vertex(row)] = scales[row];
  Unsymmetric_solver unsymmetric_solver;
  Factorized_matrix<Unsymmetric_solver> unsymmetric_matrix(
    unsymmetric_solver, problem, [&](Position v, const auto& n) { return scale_of_vertex[v] * n.weight; });
  return unsymmetric_matrix.solve(b);
#else
  throw Linear_solver_error();
#endif
}

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_SOLVE_H
