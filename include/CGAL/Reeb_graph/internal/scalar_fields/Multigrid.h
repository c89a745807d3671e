// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_MULTIGRID_H
#define CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_MULTIGRID_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/scalar_fields/Aggregation.h>

#include <Eigen/LU>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

// The matrix of equations that fill it row by row.
template <class Problem>
Row_matrix make_row_matrix(const Problem& problem)
{
  struct Filler
  {
    Row_matrix& matrix;
    std::size_t row = 0;
    std::vector<std::pair<int, double>> entries;

    void set_coef(std::size_t i, std::size_t j, double value, bool)
    {
      if(i != row)
        finish_row();
      row = i;
      entries.emplace_back(static_cast<int>(j), value);
    }

    void finish_row()
    {
      std::sort(entries.begin(), entries.end());
      const auto i = static_cast<Eigen::Index>(row);
      matrix.startVec(i);
      for(const auto& [j, value] : entries)
        matrix.insertBack(i, j) = value;
      entries.clear();
    }
  };

  const auto size = static_cast<Eigen::Index>(problem.number_of_rows());
  Row_matrix matrix(size, size);
  matrix.reserve(7 * size);
  Filler filler = {matrix, 0, {}};
  problem.fill(filler);
  if(size > 0)
    filler.finish_row();
  matrix.finalize();
  return matrix;
}

// A preconditioner for matrices with a positive diagonal and mostly negative entries beside it, which come from a graph
// and are symmetric or nearly so: one V-cycle of algebraic multigrid by smoothed aggregation. It usually takes time and
// memory in proportion to the entries of the matrix; rows of many entries can make the coarser ones dense.
class Multigrid
{
public:
  typedef Eigen::VectorXd Vector;

  explicit Multigrid(Row_matrix matrix)
  {
    constexpr Eigen::Index size_to_reach = 300, largest_direct_size = 1000;
    double threshold = 0.08; // of strong entries; Vanek halves it from level to level
    for(add_level(matrix); levels_.back().matrix.rows() > size_to_reach; threshold /= 2)
      if(!coarsen(threshold))
        break;
    is_usable_ = levels_.back().matrix.rows() <= largest_direct_size;
    if(is_usable_)
      coarsest_.compute(Eigen::MatrixXd(levels_.back().matrix));
  }

  // Whether the matrix became small enough to be solved. Otherwise there is no preconditioner.
  bool is_usable() const { return is_usable_; }

  const Row_matrix& matrix() const { return levels_.front().matrix; }

  // Solves for the right side about.
  const Vector& operator()(const Eigen::Ref<const Vector>& right_side)
  {
    levels_.front().right_side = right_side;
    cycle(0);
    return levels_.front().solution;
  }

private:
  struct Level
  {
    Row_matrix matrix, interpolation;
    Vector right_side, solution, residual;
  };

  // Takes the matrix over.
  void add_level(Row_matrix& matrix)
  {
    const Eigen::Index size = matrix.rows();
    levels_.push_back({Row_matrix(), Row_matrix(), Vector(size), Vector(size), Vector(size)});
    levels_.back().matrix.swap(matrix);
  }

  bool coarsen(double threshold)
  {
    Level& level = levels_.back();
    const Aggregation aggregates(level.matrix, threshold);
    if(aggregates.number_of_aggregates() == 0 || aggregates.number_of_aggregates() > level.matrix.rows() / 2)
      return false;
    level.interpolation = smoothed_interpolation(level.matrix, aggregates);
    const Row_matrix product = level.matrix * level.interpolation, restriction = level.interpolation.transpose();
    Row_matrix coarse_matrix = restriction * product;
    add_level(coarse_matrix);
    return true;
  }

  // A sweep of Gauss and Seidel forwards, from zero; a correction from the next level; and a sweep backwards.
  void cycle(std::size_t i)
  {
    auto& [matrix, interpolation, right_side, solution, residual] = levels_[i];
    if(i + 1 == levels_.size())
    {
      solution = coarsest_.solve(right_side);
      return;
    }
    solution = right_side;
    matrix.triangularView<Eigen::Lower>().solveInPlace(solution);
    // After the sweep, this is what the left side is too large by; so is the correction.
    residual.noalias() = matrix.triangularView<Eigen::StrictlyUpper>() * solution;
    levels_[i + 1].right_side.noalias() = interpolation.transpose() * residual;
    cycle(i + 1);
    solution.noalias() -= interpolation * levels_[i + 1].solution;
    for(Eigen::Index row = matrix.rows(); row-- > 0;)
    {
      double sum = right_side[row], diagonal = 0;
      for(Row_matrix::InnerIterator entry(matrix, row); entry; ++entry)
        if(entry.col() == row)
          diagonal = entry.value();
        else
          sum -= entry.value() * solution[entry.col()];
      solution[row] = sum / diagonal;
    }
  }

  std::deque<Level> levels_; // from the finest to the coarsest
  Eigen::PartialPivLU<Eigen::MatrixXd> coarsest_;
  bool is_usable_ = false;
};

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_MULTIGRID_H
