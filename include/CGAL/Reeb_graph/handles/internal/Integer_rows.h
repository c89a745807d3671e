// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_INTERNAL_INTEGER_ROWS_H
#define CGAL_REEB_GRAPH_HANDLES_INTERNAL_INTEGER_ROWS_H

#include <CGAL/license/Reeb_graph.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
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

// Two bases of Z^n that are dual to one another under the dot product, members of which are chosen one by one. Any set
// of chosen ones is part of such a pair of bases.
template <class Integer>
class Dual_bases
{
public:
  typedef std::vector<Integer> Vector;

  struct Choice
  {
    std::size_t place;
    int sign; // the vector is this times the one of the basis
  };

  explicit Dual_bases(std::size_t size)
  {
    for(int side : {0, 1})
    {
      bases_[side].assign(size, Vector(size, Integer(0)));
      for(std::size_t i = 0; i != size; ++i)
        bases_[side][i][i] = Integer(1);
      is_chosen_[side].assign(size, false);
    }
  }

  std::size_t size() const { return bases_[0].size(); }
  const Vector& vector(int side, std::size_t place) const { return bases_[side][place]; }
  bool is_chosen(int side, std::size_t place) const { return is_chosen_[side][place]; }

  // Makes a vector, or its negative, one of the basis of a side, if the chosen vectors of both sides can stay.
  // Proof that this is so if and only if it is found: the dot products with the vectors chosen on the other side have
  // to be those of a dual basis, so at most one is not 0, and that one is 1 or -1 and has no partner yet. Then the
  // vector takes the place of the partner. If all are 0, the vector is to be primitive modulo those chosen on its side.
  std::optional<Choice> choose(int side, const Vector& v)
  {
    Vector y;
    for(const Vector& other : bases_[1 - side])
      y.push_back(dot_product(v, other)); // the coordinates in the basis of this side
    std::optional<std::size_t> place;
    for(std::size_t i = 0; i != size(); ++i)
    {
      if(!is_chosen_[1 - side][i] || y[i] == Integer(0))
        continue;
      if(place || is_chosen_[side][i] || magnitude(y[i]) != Integer(1))
        return std::nullopt;
      place = i;
    }
    if(!place)
      place = reduce_free_coordinates(side, y);
    if(!place)
      return std::nullopt;
    const int sign = y[*place] < Integer(0) ? -1 : 1;
    for(std::size_t k = 0; k != size(); ++k)
    {
      if(k != *place && y[k] != Integer(0))
        add(side, *place, k, Integer(y[k] * Integer(sign)));
    }
    is_chosen_[side][*place] = true;
    return Choice{*place, sign};
  }

private:
  bool is_free(std::size_t i) const { return !is_chosen_[0][i] && !is_chosen_[1][i]; }

  // Changes the vectors that are chosen on neither side until only one coordinate of them is not 0. Returns its place,
  // or nothing, and changes nothing, if it would not be 1 or -1.
  std::optional<std::size_t> reduce_free_coordinates(int side, Vector& y)
  {
    Integer divisor(0);
    for(std::size_t i = 0; i != size(); ++i)
      if(is_free(i))
        divisor = greatest_common_divisor(divisor, magnitude(y[i]));
    if(divisor != Integer(1))
      return std::nullopt;
    for(;;)
    {
      std::size_t least = size(), number = 0;
      for(std::size_t i = 0; i != size(); ++i)
      {
        if(!is_free(i) || y[i] == Integer(0))
          continue;
        ++number;
        if(least == size() || magnitude(y[i]) < magnitude(y[least]))
          least = i;
      }
      if(number == 1)
        return least;
      for(std::size_t i = 0; i != size(); ++i)
      {
        if(i == least || !is_free(i) || y[i] == Integer(0))
          continue;
        const Integer factor = y[i] / y[least];
        y[i] -= factor * y[least];
        add(side, least, i, factor);
      }
    }
  }

  static Integer greatest_common_divisor(Integer a, Integer b)
  {
    while(b != Integer(0))
    {
      const Integer quotient = a / b;
      a -= quotient * b;
      std::swap(a, b);
    }
    return a;
  }

  // Adds a multiple of a vector to another one on one side, and what this means for the other side.
  void add(int side, std::size_t to, std::size_t other, const Integer& factor)
  {
    add_multiple(bases_[side][to], bases_[side][other], factor);
    add_multiple(bases_[1 - side][other], bases_[1 - side][to], Integer(-factor));
  }

  std::array<Rows<Integer>, 2> bases_;
  std::array<std::vector<bool>, 2> is_chosen_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_INTEGER_ROWS_H
