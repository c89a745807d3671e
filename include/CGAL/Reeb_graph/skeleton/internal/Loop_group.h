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

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cstddef>
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
  // Numbers are those modulo `modulus`, where that is not 0.
  void add_all(const std::vector<Row>& rows, const Integer& modulus = 0)
  {
    for(const Row& other : rows)
    {
      Row row;
      add_multiple(row, other, 1, modulus);
      add(std::move(row), modulus);
    }
  }

  // A row for each rank, by its first column.
  const std::map<std::size_t, Row>& basis() const { return basis_; }

private:
  void add(Row row, const Integer& modulus)
  {
    while(!row.empty())
    {
      const std::size_t column = row.begin()->first;
      Row& pivot = basis_[column];
      pivot.swap(row);
      while(row.count(column) != 0) // as Euclid
      {
        add_multiple(row, pivot, -(row[column] / pivot[column]), modulus);
        if(row.count(column) != 0)
          row.swap(pivot);
      }
    }
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

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_LOOP_GROUP_H
