// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_DEFAULT_SOLVER_H
#define CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_DEFAULT_SOLVER_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Eigen_solver_traits.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#endif

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

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

#else

typedef void Default_solver;

#endif

// Whether there is a named parameter `sparse_linear_solver`.
template <class NamedParameters>
inline constexpr bool is_solver_given =
  is_given<decltype(parameters::get_parameter(std::declval<const NamedParameters&>(),
                                              internal_np::sparse_linear_solver))>;

template <class NamedParameters>
auto choose_solver(const NamedParameters& np)
{
  if constexpr(is_solver_given<NamedParameters>)
    return parameters::get_parameter(np, internal_np::sparse_linear_solver);
  else
  {
    static_assert(!std::is_void_v<Default_solver>,
                  "Eigen is needed, or the named parameter sparse_linear_solver: link CGAL::Eigen3_support");
    return Default_solver();
  }
}

template <class NamedParameters>
double choose_tolerance(const NamedParameters& np)
{
  const double tolerance =
    parameters::choose_parameter(parameters::get_parameter(np, internal::solver_tolerance), 1e-12);
  if(!(tolerance > 0) || !std::isfinite(tolerance))
    throw Solver_tolerance_error(tolerance);
  return tolerance;
}

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_DEFAULT_SOLVER_H
