// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_HANDLES_INTEGER_ROWS_H
#define CGAL_REEB_GRAPH_INTERNAL_HANDLES_INTEGER_ROWS_H

#include <CGAL/license/Reeb_graph.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

// Rows of integers that are added exactly: in 64 bits, and if they do not fit, in as many as it takes.

namespace CGAL {
namespace Reeb_graph {
namespace internal {

struct Integer_overflow
{
};

// An integer of 64 bits that throws Integer_overflow rather than be wrong.
class Checked_integer
{
public:
  Checked_integer(long long value = 0) : value_(value) {}
  explicit operator long long() const { return value_; }

  friend Checked_integer operator*(Checked_integer a, Checked_integer b)
  {
    long long result = 0;
    return __builtin_mul_overflow(a.value_, b.value_, &result) ? throw Integer_overflow() : Checked_integer(result);
  }
  Checked_integer& operator+=(Checked_integer b)
  {
    return __builtin_add_overflow(value_, b.value_, &value_) ? throw Integer_overflow() : *this;
  }
  Checked_integer& operator-=(Checked_integer b)
  {
    return __builtin_sub_overflow(value_, b.value_, &value_) ? throw Integer_overflow() : *this;
  }
  Checked_integer operator-() const { return *this * Checked_integer(-1); }
  friend Checked_integer operator/(Checked_integer a, Checked_integer b)
  {
    return b.value_ == -1 ? -a : Checked_integer(a.value_ / b.value_);
  }
  friend bool operator==(Checked_integer a, Checked_integer b) { return a.value_ == b.value_; }
  friend bool operator!=(Checked_integer a, Checked_integer b) { return a.value_ != b.value_; }
  friend bool operator<(Checked_integer a, Checked_integer b) { return a.value_ < b.value_; }

private:
  long long value_;
};

typedef boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>
  Large_integer;

// The remainder modulo 2^64.
inline std::uint64_t low_bits(Checked_integer a) { return static_cast<std::uint64_t>(static_cast<long long>(a)); }
inline std::uint64_t low_bits(const Large_integer& a)
{
  const Large_integer magnitude = a < 0 ? Large_integer(-a) : a;
  const std::uint64_t bits = static_cast<std::uint64_t>(magnitude & Large_integer(~std::uint64_t(0)));
  return a < 0 ? std::uint64_t(0) - bits : bits;
}

inline long long to_machine_integer(Checked_integer a) { return static_cast<long long>(a); }
inline long long to_machine_integer(const Large_integer& a)
{
  const Large_integer bound = Large_integer(1) << 62;
  return a < -bound || bound < a ? throw Integer_overflow() : static_cast<long long>(a);
}

template <class Integer>
Integer magnitude(const Integer& a)
{
  return a < Integer(0) ? Integer(-a) : a;
}

template <class Integer>
using Rows = std::vector<std::vector<Integer>>;

template <class Integer>
void add_multiple(std::vector<Integer>& row, const std::vector<Integer>& other, const Integer& factor)
{
  for(std::size_t k = 0; k != row.size(); ++k)
  {
    if(other[k] != Integer(0))
      row[k] += factor * other[k];
  }
}

template <class Integer>
Integer dot_product(const std::vector<Integer>& a, const std::vector<Integer>& b)
{
  Integer sum(0);
  for(std::size_t k = 0; k != a.size(); ++k)
  {
    if(a[k] != Integer(0) && b[k] != Integer(0))
      sum += a[k] * b[k];
  }
  return sum;
}

// A basis of the lattice that some rows span, and what the rows are in that basis: rows[i] is the sum of
// coordinates[j][i] * basis[j].
template <class Integer>
struct Row_lattice
{
  Rows<Integer> basis, coordinates;
};

// By elimination with integers. The inverse of the operations on rows, done to columns, gives the coordinates.
template <class Integer>
Row_lattice<Integer> find_row_lattice(Rows<Integer> rows)
{
  const std::size_t size = rows.size(), width = rows.empty() ? 0 : rows.front().size();
  Rows<Integer> columns(size, std::vector<Integer>(size, Integer(0)));
  for(std::size_t i = 0; i != size; ++i)
    columns[i][i] = Integer(1);
  std::size_t rank = 0;
  for(std::size_t column = 0; column != width && rank != size; ++column)
  {
    for(;;)
    {
      std::size_t least = size, number_of_others = 0;
      for(std::size_t i = rank; i != size; ++i)
      {
        if(rows[i][column] == Integer(0))
          continue;
        ++number_of_others;
        if(least == size || magnitude(rows[i][column]) < magnitude(rows[least][column]))
          least = i;
      }
      if(number_of_others == 0)
        break;
      std::swap(rows[rank], rows[least]);
      std::swap(columns[rank], columns[least]);
      for(std::size_t i = rank + 1; i != size; ++i)
      {
        const Integer factor = rows[i][column] / rows[rank][column];
        if(factor == Integer(0))
          continue;
        add_multiple(rows[i], rows[rank], Integer(-factor));
        add_multiple(columns[rank], columns[i], factor);
      }
      if(number_of_others == 1)
      {
        ++rank;
        break;
      }
    }
  }
  rows.resize(rank);
  columns.resize(rank);
  return {std::move(rows), std::move(columns)};
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_HANDLES_INTEGER_ROWS_H
