// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_LOOP_GROUP_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_LOOP_GROUP_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

typedef boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off> Integer;
typedef std::map<std::size_t, Integer> Row; // by column, without zeros

// Adds a multiple of another row. Numbers are those modulo `modulus`, where that is not 0.
inline void add_multiple(Row& row, const Row& other, const Integer& factor, const Integer& modulus = 0)
{
  for(const auto& [column, number] : other)
  {
    Integer& sum = row[column];
    sum += factor * number;
    if(modulus != 0)
      sum %= modulus;
    if(sum == 0)
      row.erase(column);
  }
}

// The numbers of a row in some columns.
template <class Columns>
std::vector<Integer> in_columns(const Row& row, const Columns& columns)
{
  std::vector<Integer> result;
  for(const auto& [column, any] : columns)
    result.push_back(row.count(column) != 0 ? row.at(column) : Integer(0));
  return result;
}

// The group that rows generate, in echelon form: each row of the basis has a first column of its own.
class Generated_group
{
public:
  // Numbers are those modulo `modulus`, where that is not 0. Returns which rows depend on those before them.
  std::vector<std::size_t> add_all(const std::vector<Row>& rows, const Integer& modulus = 0)
  {
    std::vector<std::size_t> dependent;
    for(std::size_t i = 0; i != rows.size(); ++i)
    {
      Row row;
      add_multiple(row, rows[i], 1, modulus);
      if(!add(std::move(row), modulus))
        dependent.push_back(i);
    }
    return dependent;
  }

  // A row for each rank, by its first column.
  const std::map<std::size_t, Row>& basis() const { return basis_; }

private:
  // Returns whether the rank has grown.
  bool add(Row row, const Integer& modulus)
  {
    while(!row.empty())
    {
      const std::size_t column = row.begin()->first;
      Row& pivot = basis_[column];
      pivot.swap(row);
      if(row.empty())
        return true;
      while(row.count(column) != 0) // as Euclid
      {
        add_multiple(row, pivot, -(row[column] / pivot[column]), modulus);
        if(row.count(column) != 0)
          row.swap(pivot);
      }
    }
    return false;
  }

  std::map<std::size_t, Row> basis_; // by first column
};

// Takes rows away that have 1 or -1 in a column where no other one is left with a number, and those without numbers, by adding
// multiples: minors change by their signs only. Returns the number of the former.
inline std::size_t eliminate_units(std::vector<Row>& rows)
{
  const auto unit = [](const Row& row) {
    return std::find_if(row.begin(), row.end(), [](const auto& entry) { return abs(entry.second) == 1; });
  };
  for(std::size_t number = 0;; ++number)
  {
    rows.erase(std::remove_if(rows.begin(), rows.end(), [](const Row& row) { return row.empty(); }), rows.end());
    auto shortest = rows.end();
    for(auto row = rows.begin(); row != rows.end(); ++row)
      if((shortest == rows.end() || row->size() < shortest->size()) && unit(*row) != row->end())
        shortest = row;
    if(shortest == rows.end())
      return number;
    const Row pivot = std::move(*shortest);
    rows.erase(shortest);
    const auto [column, sign] = *unit(pivot);
    for(Row& row : rows)
      if(const auto found = row.find(column); found != row.end())
        add_multiple(row, pivot, -found->second * sign);
  }
}

// The rank, and the size of a minor of that rank (E. H. Bareiss 1968): all numbers on the way are minors, too.
inline std::pair<std::size_t, Integer> rank_and_minor(std::vector<std::vector<Integer>> matrix)
{
  const std::size_t width = matrix.empty() ? 0 : matrix.front().size();
  std::size_t rank = 0;
  Integer minor = 1;
  for(std::size_t column = 0; column != width && rank != matrix.size(); ++column)
  {
    std::size_t pivot = rank;
    while(pivot != matrix.size() && matrix[pivot][column] == 0)
      ++pivot;
    if(pivot == matrix.size())
      continue;
    matrix[pivot].swap(matrix[rank]);
    const auto& first = matrix[rank++];
    for(std::size_t i = rank; i != matrix.size(); ++i)
      for(std::size_t k = width; k-- != column;)
        matrix[i][k] = (matrix[i][k] * first[column] - matrix[i][column] * first[k]) / minor;
    minor = first[column];
  }
  return {rank, abs(minor)};
}

// The group that loops generate among those of a solid, by their linking numbers with curves.
struct Loop_group
{
  std::size_t number_of_dependent = 0;
  Integer index = 1; // of the group in that of all loops that have a multiple in it

  // The index is the greatest common divisor of minors of the highest rank. That of two of them is a multiple, and so numbers are
  // those modulo this one: with Euclid alone, they had millions of digits on solids of genus 200.
  explicit Loop_group(std::vector<Row> rows)
  {
    const std::size_t number = rows.size(), number_of_units = eliminate_units(rows);
    Row columns;
    for(const Row& row : rows)
      columns.insert(row.begin(), row.end());
    std::vector<std::vector<Integer>> matrix;
    for(const Row& row : rows)
      matrix.push_back(in_columns(row, columns));
    const auto [rank, first] = rank_and_minor(matrix);
    for(auto& row : matrix)
      std::reverse(row.begin(), row.end());
    const Integer minor = gcd(first, rank_and_minor(matrix).second);
    number_of_dependent = number - number_of_units - rank;
    std::vector<Row> multiples;
    for(const auto& [column, any] : columns)
      multiples.push_back({{column, minor}});
    Generated_group group;
    group.add_all(multiples);
    group.add_all(rows, minor);
    for(const auto& [column, row] : group.basis())
      index *= abs(row.at(column));
    index /= pow(minor, static_cast<unsigned>(columns.size() - rank));
  }

  // The index as a number of the machine, or the greatest one of these.
  std::size_t index_or_most() const
  {
    return static_cast<std::size_t>((std::min)(index, Integer((std::numeric_limits<std::size_t>::max)())));
  }

  bool is_whole() const { return number_of_dependent == 0 && index == 1; }
  bool operator<(const Loop_group& other) const
  {
    return std::tie(number_of_dependent, index) < std::tie(other.number_of_dependent, other.index);
  }
};

// How often loops are to wind around curves, so that they generate as much as can be. Numbers are those modulo a Mersenne
// prime, beyond twice the index unless that has 2,202 bits.
class Winding_choice
{
public:
  // By linking numbers of loops, and by those that one winding of each adds.
  Winding_choice(const std::vector<Row>& loops, const std::vector<Row>& added, const Stage_progress& progress)
    : progress_(progress),
      windings_(loops.size(), 0)
  {
    for(const std::size_t loop : Generated_group().add_all(loops, prime_))
      windings_[loop] = 1;
    std::vector<Row> wound = loops;
    for(std::size_t i = 0; i != loops.size(); ++i)
      add_multiple(wound[i], added[i], windings_[i]);
    const Integer index = Loop_group(wound).index;
    for(const unsigned exponent : {521, 2203})
      if(2 * index > prime_)
        prime_ = (Integer(1) << exponent) - 1;
    Generated_group independent; // in the columns of its basis
    if(!independent.add_all(wound, prime_).empty())
      return;
    Matrix of_added = restricted(added, independent);
    divide(of_added, restricted(wound, independent));
    improve(of_added, index);
  }

  const std::vector<int>& windings() const { return windings_; }

private:
  typedef std::vector<std::vector<Integer>> Matrix;

  // The number of least size.
  Integer reduced(Integer number) const
  {
    number %= prime_;
    if(2 * abs(number) > prime_)
      number += number < 0 ? prime_ : -prime_;
    return number;
  }

  Integer inverse(const Integer& number) const { return powm(Integer((number + prime_) % prime_), prime_ - 2, prime_); }

  static Matrix restricted(const std::vector<Row>& rows, const Generated_group& group)
  {
    Matrix result;
    for(const Row& row : rows)
      result.push_back(in_columns(row, group.basis()));
    return result;
  }

  // Divides by a matrix whose columns are independent, by operations on columns.
  void divide(Matrix& numbers, Matrix by) const
  {
    const std::size_t size = by.size();
    const auto for_each_row = [&](const auto& act) {
      for(Matrix* matrix : {&by, &numbers})
        for(auto& row : *matrix)
          act(row);
    };
    for(std::size_t i = 0; i != size; ++i)
    {
      progress_(0); // so that it can be cancelled
      std::size_t pivot = i;
      while(by[i][pivot] == 0)
        ++pivot;
      for_each_row([&](auto& row) { row[pivot].swap(row[i]); });
      const Integer factor = inverse(by[i][i]);
      for_each_row([&](auto& row) { row[i] = reduced(row[i] * factor); });
      const std::vector<Integer> pivots = by[i];
      for_each_row([&](auto& row) {
        for(std::size_t k = 0; k != size && row[i] != 0; ++k)
          if(k != i && pivots[k] != 0)
            row[k] = reduced(row[k] - pivots[k] * row[i]);
      });
    }
  }

  // A loop that winds some times more, and a second one, if any.
  struct Change
  {
    std::array<std::size_t, 2> loops = {};
    std::array<int, 2> times = {};
    Integer index;
  };

  // Winds loops as long as the index falls. A winding of loop i multiplies it by 1 + shares[i][i].
  void improve(Matrix& shares, const Integer& index)
  {
    Change best = {{}, {}, index};
    for(bool is_better = true; is_better && abs(best.index) != 1;)
    {
      is_better = false;
      const Integer before = best.index;
      const auto offer = [&](const Change& change) {
        if(change.index == 0 || abs(change.index) >= abs(best.index))
          return;
        best = change;
        is_better = true;
      };
      for(std::size_t i = 0; i != shares.size(); ++i)
        for(const int t : {-2, -1, 1, 2})
        {
          progress_(0);
          const Integer next = reduced(before + t * before * shares[i][i]);
          offer({{i, i}, {t, 0}, next});
          for(std::size_t j = 0; j != i && next != 0; ++j)
            for(const int u : {-1, 1})
              offer({{i, j},
                     {t, u},
                     reduced(next + u * before * (shares[j][j] + t * shares[i][i] * shares[j][j])
                             - u * t * before * reduced(shares[i][j] * shares[j][i]))});
        }
      for(const int k : {0, 1})
        if(is_better && best.times[k] != 0)
          wind(best.loops[k], best.times[k], shares);
    }
  }

  void wind(std::size_t loop, int times, Matrix& shares)
  {
    windings_[loop] += times;
    const Integer factor = reduced(times * inverse(reduced(1 + times * shares[loop][loop])));
    const std::vector<Integer> row = shares[loop];
    for(auto& other : shares)
      if(const Integer share = reduced(other[loop] * factor); share != 0)
        for(std::size_t k = 0; k != row.size(); ++k)
          other[k] = reduced(other[k] - share * row[k]);
  }

  const Stage_progress progress_;
  std::vector<int> windings_;
  Integer prime_ = (Integer(1) << 127) - 1;
};

// Which chains can keep lines of their own in place of ways that are led: as many as are found one after the other, so that the
// loops generate as much as with all ways. Numbers are those modulo a prime number.
class Kept_lines
{
public:
  struct Candidate
  {
    std::vector<std::pair<Index, int>> cycles; // that pass the chain, with 1 or -1 for a direction
    Row change;                                // what its line adds more than its way
  };

  // By linking numbers of loops with ways, and the chains in the order in which they are tried.
  Kept_lines(const std::vector<Row>& loops, const std::vector<Candidate>& candidates, const Stage_progress& progress)
    : is_kept_(candidates.size(), false)
  {
    const std::vector<Numbers> sums = as_sums_of_loops(loops, candidates, progress);
    if(sums.empty())
      return;
    // A line that is kept multiplies the index by 1 + shares[i][i].
    std::vector<Numbers> shares(candidates.size(), Numbers(candidates.size(), 0));
    for(std::size_t i = 0; i != shares.size(); ++i)
      for(std::size_t j = 0; j != shares.size(); ++j)
        for(const auto& [cycle, direction] : candidates[j].cycles)
          shares[i][j] = (shares[i][j] + (direction > 0 ? 1 : prime - 1) * sums[cycle][loops.size() + i]) % prime;
    for(bool is_any_new = true; is_any_new;)
    {
      is_any_new = false;
      for(std::size_t i = 0; i != shares.size(); ++i)
        if(const Number factor = (1 + shares[i][i]) % prime; !is_kept_[i] && (factor == 1 || factor == prime - 1))
        {
          progress(0);
          const Numbers row = shares[i];
          for(Numbers& other : shares)
            add(other, (prime - other[i]) * factor % prime, row);
          is_kept_[i] = is_any_new = true;
        }
    }
  }

  bool is_kept(std::size_t candidate) const { return is_kept_[candidate]; }

private:
  typedef std::uint64_t Number;
  typedef std::vector<Number> Numbers;
  static constexpr Number prime = 2147483647;

  static void add(Numbers& row, Number factor, const Numbers& other)
  {
    for(std::size_t k = 0; factor != 0 && k != row.size(); ++k)
      row[k] = (row[k] + factor * other[k]) % prime;
  }

  static Number inverse(Number number)
  {
    Number result = 1;
    for(Number exponent = prime - 2; exponent != 0; exponent /= 2, number = number * number % prime)
      result = exponent % 2 == 1 ? result * number % prime : result;
    return result;
  }

  // A row for each loop: after a part of the unit matrix, how often each change has the loop. None if loops are dependent.
  static std::vector<Numbers> as_sums_of_loops(const std::vector<Row>& loops,
                                               const std::vector<Candidate>& candidates,
                                               const Stage_progress& progress)
  {
    std::map<std::size_t, Numbers> by_curve;
    for(std::size_t i = 0; i != loops.size() + candidates.size(); ++i)
      for(const auto& [curve, number] : i < loops.size() ? loops[i] : candidates[i - loops.size()].change)
      {
        Numbers& row = by_curve[curve];
        row.resize(loops.size() + candidates.size());
        row[i] = static_cast<Number>((number % prime + prime) % prime);
      }
    std::vector<Numbers> rows;
    for(auto& [curve, row] : by_curve)
      rows.push_back(std::move(row));
    for(std::size_t i = 0; i != loops.size(); ++i)
    {
      progress(0); // so that it can be cancelled
      std::size_t pivot = i;
      while(pivot < rows.size() && rows[pivot][i] == 0)
        ++pivot;
      if(pivot >= rows.size())
        return {};
      rows[i].swap(rows[pivot]);
      const Number factor = inverse(rows[i][i]);
      for(Number& number : rows[i])
        number = number * factor % prime;
      for(Numbers& row : rows)
        if(&row != &rows[i])
          add(row, (prime - row[i]) % prime, rows[i]);
    }
    rows.resize(loops.size());
    return rows;
  }

  std::vector<bool> is_kept_;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_LOOP_GROUP_H
