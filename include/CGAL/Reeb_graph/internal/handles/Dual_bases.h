// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_HANDLES_DUAL_BASES_H
#define CGAL_REEB_GRAPH_INTERNAL_HANDLES_DUAL_BASES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/handles/Integer_rows.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

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

#endif // CGAL_REEB_GRAPH_INTERNAL_HANDLES_DUAL_BASES_H
