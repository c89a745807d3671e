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
#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/fields/internal/Weighted_graph.h>
#include <CGAL/Reeb_graph/fields/internal/solve_iteratively.h>
#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Origin.h>

#ifdef CGAL_EIGEN3_ENABLED

#include <CGAL/Eigen_solver_traits.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
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
};

// The rows of the equations, in an order of the vertices. Mean value weights are not symmetric, but their rows are
// scaled so that they come close to symmetric ones: the geometric means of tangents on both ends of an edge.
class Dirichlet_problem
{
public:
  Dirichlet_problem(const Dirichlet_equations& equations, const std::vector<Position>& order)
    : equations_(equations),
      graph_(equations.graph),
      rows_(graph_.number_of_vertices(), no_position)
  {
    for(const Position v : order)
      if(!equations.is_fixed[v])
      {
        rows_[v] = static_cast<Position>(vertices_.size());
        vertices_.push_back(v);
      }
    factors_.assign(vertices_.size(), 1);
    right_side_.reserve(vertices_.size());
    for(const Position v : vertices_)
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
  bool is_free(Position v) const { return rows_[v] != no_position; }

  double symmetric_weight(Position v, const Weighted_graph::Neighbor& n) const
  {
    return std::sqrt(n.weight) * std::sqrt(graph_.weight(n.vertex, v)) * equations_.surface.edge_length(v, n.vertex);
  }

  const Dirichlet_equations& equations_;
  const Weighted_graph& graph_;
  std::vector<Position> rows_;     // row of each vertex, no_position if it is fixed
  std::vector<Position> vertices_; // vertex of each row
  Values right_side_, factors_;    // of the rows
};

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
    Bbox_3 box;
    for(Iterator it = begin; it != end; ++it)
      box += (ORIGIN + surface_.point(*it)).bbox();
    const std::array<double, 3> sides = {box.x_span(), box.y_span(), box.z_span()};
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

// What needs Eigen. These are templates so that the library can have them.
template <class Equations>
Dirichlet_solution solve_by_default(const Equations& equations, const Accuracy& accuracy);
template <class Problem>
Values solve_unsymmetric(const Problem& problem);

// Factorizes the matrix if it is symmetric; else symmetric weights that are close, and iteration does the rest.
template <class Solver>
Dirichlet_solution solve_directly(const Dirichlet_equations& equations, const Accuracy& accuracy, Solver& solver)
{
  const Dirichlet_problem problem(equations, Nested_dissection(equations.surface, equations.graph).vertices());
  const bool is_unsymmetric = equations.weights == Laplacian_weights::MEAN_VALUE;
  Factorized_system<Solver> system(solver, problem, is_unsymmetric);
  if(!is_unsymmetric)
    return problem.make_solution(system.solve(), 0);
  constexpr std::size_t largest_number_of_steps = 80;
  const Iterative_solution solution =
    solve_iteratively(system, problem.right_side(), accuracy, largest_number_of_steps);
  return problem.make_solution(solution.is_accurate ? solution.values : solve_unsymmetric(problem), 0);
}

#ifdef CGAL_EIGEN3_ENABLED

// An ordering method of Eigen: keeps the order of the rows, as they come from a nested dissection. Where this fills the
// factor more than it should on a surface, because sheets of it are entangled in space, the minimum degrees decide.
class Given_or_minimum_degree_ordering
{
public:
  typedef Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> PermutationType;

  template <class Matrix>
  void operator()(const Matrix& matrix, PermutationType& permutation) const
  {
    if(is_fill_low(matrix))
      permutation.setIdentity(matrix.cols());
    else
      Eigen::AMDOrdering<int>()(matrix, permutation);
  }

private:
  // Counts the entries of the factor along the elimination tree, and stops when there are too many.
  template <class Matrix>
  static bool is_fill_low(const Matrix& matrix)
  {
    const auto size = static_cast<std::size_t>(matrix.cols());
    const double largest_fill = 6. * static_cast<double>(size) * (std::log2(static_cast<double>(size)) + 1);
    std::vector<std::size_t> parents(size, size), last_visits(size, size);
    double fill = 0;
    for(std::size_t column = 0; column != size && fill <= largest_fill; ++column)
    {
      last_visits[column] = column;
      for(typename Matrix::InnerIterator entry(matrix, static_cast<Eigen::Index>(column)); entry; ++entry)
        for(auto row = static_cast<std::size_t>(entry.index()); row < column && last_visits[row] != column;
            row = parents[row])
        {
          if(parents[row] == size)
            parents[row] = column;
          last_visits[row] = column;
          ++fill;
        }
    }
    return fill <= largest_fill;
  }
};

typedef Eigen_sparse_matrix<double>::EigenType Eigen_matrix;
typedef Eigen_solver_traits<Eigen::SimplicialLDLT<Eigen_matrix, Eigen::Lower, Given_or_minimum_degree_ordering>>
  Default_solver;
typedef Eigen_solver_traits<Eigen::SparseLU<Eigen_matrix>> Unsymmetric_solver;

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

// Below this number of vertices a factorization is faster than multigrid.
inline constexpr Position smallest_size_for_multigrid = 5000;

#endif // CGAL_EIGEN3_ENABLED

// Solves large problems by multigrid, which need not get as accurate as asked for: after too many steps, the estimate of
// the error could not be trusted. Then, and else, a matrix is factorized.
template <class Equations>
Dirichlet_solution solve_by_default([[maybe_unused]] const Equations& equations,
                                    [[maybe_unused]] const Accuracy& accuracy)
{
#ifdef CGAL_EIGEN3_ENABLED
  if(equations.graph.number_of_vertices() >= smallest_size_for_multigrid)
  {
    const Dirichlet_problem problem(equations, Breadth_first_search(equations.graph).order);
    constexpr std::size_t largest_number_of_steps = 40;
    Multigrid_system system(problem);
    const Iterative_solution solution =
      system.is_usable() ? solve_iteratively(system, problem.right_side(), accuracy, largest_number_of_steps)
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

// Solves the equations by the solver that is given, or else by the default one.
template <class NamedParameters>
Dirichlet_solution solve_dirichlet_problem(const Dirichlet_equations& equations,
                                           double least_range,
                                           const NamedParameters& np)
{
  const double tolerance =
    parameters::choose_parameter(parameters::get_parameter(np, internal::solver_tolerance), 1e-12);
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
