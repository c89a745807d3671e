// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_AGGREGATION_H
#define CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_AGGREGATION_H

#include <CGAL/license/Reeb_graph.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

typedef Eigen::SparseMatrix<double, Eigen::RowMajor> Row_matrix;

// Partitions the rows of a matrix into aggregates, each of a row and those that depend strongly on it (P. Vanek, J.
// Mandel, M. Brezina, Algebraic Multigrid by Smoothed Aggregation for Second and Fourth Order Elliptic Problems, 1996).
class Aggregation
{
public:
  Aggregation(const Row_matrix& matrix, double threshold)
    : matrix_(matrix),
      diagonal_(matrix.diagonal()),
      squared_threshold_(threshold * threshold),
      aggregates_(matrix.rows(), none)
  {
    found_aggregates();
    join_neighbors();
  }

  int number_of_aggregates() const { return size_; }

  // The aggregate of a row, `none` for rows that depend strongly on no other one: smoothing solves them.
  int operator[](int row) const { return aggregates_[row]; }

  static constexpr int none = -1;

  // Whether the row depends strongly on that of an entry beside the diagonal.
  bool is_strong(const Row_matrix::InnerIterator& entry) const
  {
    const double value = entry.value();
    return value < 0 && value * value > squared_threshold_ * diagonal_[entry.row()] * diagonal_[entry.col()];
  }

private:
  template <class Visit>
  void for_each_strong_neighbor(int row, const Visit& visit) const
  {
    for(Row_matrix::InnerIterator entry(matrix_, row); entry; ++entry)
      if(entry.col() != row && is_strong(entry))
        visit(entry);
  }

  // Each row none of whose neighbors is in an aggregate founds one with them.
  void found_aggregates()
  {
    for(int row = 0; row != matrix_.rows(); ++row)
    {
      bool is_free = aggregates_[row] == none, has_neighbors = false;
      for_each_strong_neighbor(row, [&](const auto& entry) {
        has_neighbors = true;
        is_free = is_free && aggregates_[entry.col()] == none;
      });
      if(!is_free || !has_neighbors)
        continue;
      aggregates_[row] = size_;
      for_each_strong_neighbor(row, [&](const auto& entry) { aggregates_[entry.col()] = size_; });
      ++size_;
    }
  }

  // The other rows join the aggregate on which they depend most; where there is none, they found one.
  void join_neighbors()
  {
    const std::vector<int> founded = aggregates_;
    for(int row = 0; row != matrix_.rows(); ++row)
    {
      if(aggregates_[row] != none)
        continue;
      double strongest = 0;
      bool has_neighbors = false;
      for_each_strong_neighbor(row, [&](const auto& entry) {
        has_neighbors = true;
        if(founded[entry.col()] == none || !(-entry.value() > strongest))
          return;
        strongest = -entry.value();
        aggregates_[row] = founded[entry.col()];
      });
      if(aggregates_[row] != none || !has_neighbors)
        continue;
      aggregates_[row] = size_;
      for_each_strong_neighbor(row, [&](const auto& entry) {
        if(aggregates_[entry.col()] == none)
          aggregates_[entry.col()] = size_;
      });
      ++size_;
    }
  }

  const Row_matrix& matrix_;
  const Eigen::VectorXd diagonal_;
  const double squared_threshold_;
  std::vector<int> aggregates_;
  int size_ = 0;
};

// The interpolation from aggregates to rows: constant on each aggregate, then smoothed by a step of Jacobi's iteration
// with the strong entries of the matrix, while the weak ones are added to its diagonal.
inline Row_matrix smoothed_interpolation(const Row_matrix& matrix, const Aggregation& aggregates)
{
  constexpr double damping = 2. / 3;
  Row_matrix interpolation(matrix.rows(), aggregates.number_of_aggregates());
  interpolation.reserve(3 * matrix.rows());
  std::vector<std::pair<int, double>> entries;
  for(int row = 0; row != matrix.rows(); ++row)
  {
    double diagonal = 0;
    entries.clear();
    for(Row_matrix::InnerIterator entry(matrix, row); entry; ++entry)
      if(entry.col() == row || !aggregates.is_strong(entry))
        diagonal += entry.value();
      else
        entries.emplace_back(aggregates[entry.index()], -damping * entry.value());
    for(auto& entry : entries)
      entry.second /= diagonal;
    if(!(diagonal > 0))
      entries.clear();
    if(aggregates[row] != Aggregation::none)
      entries.emplace_back(aggregates[row], entries.empty() ? 1 : 1 - damping);
    std::sort(entries.begin(), entries.end());
    interpolation.startVec(row);
    int last = Aggregation::none;
    for(const auto& [aggregate, value] : entries)
    {
      if(aggregate == Aggregation::none)
        continue;
      if(aggregate != last)
        interpolation.insertBack(row, aggregate) = 0;
      last = aggregate;
      interpolation.valuePtr()[interpolation.data().size() - 1] += value;
    }
  }
  interpolation.finalize();
  return interpolation;
}

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_AGGREGATION_H
