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
#include <CGAL/Reeb_graph/fields/internal/iterate.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>
#include <CGAL/Reeb_graph/options.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

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
