// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_DIRICHLET_EQUATIONS_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_DIRICHLET_EQUATIONS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/internal/Dirichlet_problem.h>
#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/fields/internal/Weighted_graph.h>
#include <CGAL/Reeb_graph/fields/internal/solve_iteratively.h>
#include <CGAL/Reeb_graph/options.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

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

// The following two are in Default_solver.h. They are templates so that the library can have them.
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
    return equations.make_solution(problem, Factorized_matrix<Solver>(solver, problem).solve(problem.right_side()), 0);
  Factorized_system<Solver> system(solver, problem, equations.symmetric_weights());
  constexpr std::size_t largest_number_of_steps = 80;
  const Iterative_solution solution =
    solve_iteratively(system, problem.right_side(), accuracy, largest_number_of_steps);
  return equations.make_solution(problem, solution.is_accurate ? solution.values : solve_unsymmetric(problem), 0);
}

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_DIRICHLET_EQUATIONS_H
