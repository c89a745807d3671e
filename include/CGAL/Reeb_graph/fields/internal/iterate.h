// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_ITERATE_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_ITERATE_H

#include <CGAL/license/Reeb_graph.h>

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

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_ITERATE_H
