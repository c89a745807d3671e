// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_DIRICHLET_SYSTEMS_H
#define CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_DIRICHLET_SYSTEMS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/scalar_fields/Dirichlet_problem.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Weighted_graph.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/solve_iteratively.h>

#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

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

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_DIRICHLET_SYSTEMS_H
