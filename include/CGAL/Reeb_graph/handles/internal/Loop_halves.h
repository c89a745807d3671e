// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_INTERNAL_LOOP_HALVES_H
#define CGAL_REEB_GRAPH_HANDLES_INTERNAL_LOOP_HALVES_H

#include <CGAL/Reeb_graph/handles/internal/Handle_homology.h>
#include <CGAL/Reeb_graph/handles/internal/Loop_search.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <CGAL/license/Reeb_graph.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The remainder modulo 2^64.
inline std::uint64_t low_bits(const Integer& a)
{
  const std::uint64_t bits = static_cast<std::uint64_t>(abs(a) & ~std::uint64_t(0));
  return a < 0 ? std::uint64_t(0) - bits : bits;
}

inline long long to_machine_integer(const Integer& a)
{
  const Integer bound = Integer(1) << 62;
  return bound < abs(a) ? throw std::overflow_error("more than 64 bits") : static_cast<long long>(a);
}

inline void add_multiple(std::vector<Integer>& row, const std::vector<Integer>& other, const Integer& factor)
{
  for(std::size_t k = 0; k != row.size(); ++k)
  {
    if(other[k] != 0)
      row[k] += factor * other[k];
  }
}

// The sum of the rows, each as often as the coefficients say.
inline std::vector<Integer> combination(const std::vector<Integer>& coefficients, const Rows& rows)
{
  std::vector<Integer> sum(rows.empty() ? 0 : rows.front().size(), Integer(0));
  for(std::size_t k = 0; k != coefficients.size(); ++k)
  {
    if(coefficients[k] != 0)
      add_multiple(sum, rows[k], coefficients[k]);
  }
  return sum;
}

inline Integer dot_product(const std::vector<Integer>& a, const std::vector<Integer>& b)
{
  Integer sum(0);
  for(std::size_t k = 0; k != a.size(); ++k)
  {
    if(a[k] != 0 && b[k] != 0)
      sum += a[k] * b[k];
  }
  return sum;
}

// The place of the number nearest to 0 among those that are not 0, and how many these are.
template <class NumberAt>
std::pair<std::size_t, std::size_t> find_least(std::size_t begin, std::size_t end, const NumberAt& number_at)
{
  std::size_t least = end, count = 0;
  for(std::size_t i = begin; i != end; ++i)
  {
    const Integer& number = number_at(i);
    if(number == 0)
      continue;
    ++count;
    if(least == end || abs(number) < abs(number_at(least)))
      least = i;
  }
  return {least, count};
}

// A basis of the lattice that some rows span, and what the rows are in that basis: rows[i] is the sum of
// coordinates[j][i] * basis[j].
struct Row_lattice
{
  Rows basis, coordinates;
};

// By elimination with integers. The inverse of the operations on rows, done to columns, gives the coordinates.
inline Row_lattice find_row_lattice(Rows rows)
{
  const std::size_t size = rows.size(), width = rows.empty() ? 0 : rows.front().size();
  Rows columns(size, std::vector<Integer>(size, Integer(0)));
  for(std::size_t i = 0; i != size; ++i)
    columns[i][i] = Integer(1);
  std::size_t rank = 0;
  for(std::size_t column = 0; column != width && rank != size; ++column)
  {
    for(;;)
    {
      const auto [least, number] =
        find_least(rank, size, [&](std::size_t i) -> const Integer& { return rows[i][column]; });
      if(number == 0)
        break;
      std::swap(rows[rank], rows[least]);
      std::swap(columns[rank], columns[least]);
      for(std::size_t i = rank + 1; i != size; ++i)
      {
        const Integer factor = rows[i][column] / rows[rank][column];
        if(factor == 0)
          continue;
        add_multiple(rows[i], rows[rank], -factor);
        add_multiple(columns[rank], columns[i], factor);
      }
      if(number == 1)
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
      if(!is_chosen_[1 - side][i] || y[i] == 0)
        continue;
      if(place || is_chosen_[side][i] || abs(y[i]) != 1)
        return std::nullopt;
      place = i;
    }
    if(!place)
      place = reduce_free_coordinates(side, y);
    if(!place)
      return std::nullopt;
    const int sign = y[*place] < 0 ? -1 : 1;
    for(std::size_t k = 0; k != size(); ++k)
    {
      if(k != *place && y[k] != 0)
        add(side, *place, k, y[k] * sign);
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
        divisor = gcd(divisor, y[i]);
    if(divisor != 1)
      return std::nullopt;
    for(;;)
    {
      const auto [least, number] = find_least(0, size(), [&](std::size_t i) { return is_free(i) ? y[i] : Integer(0); });
      if(number == 1)
        return least;
      for(std::size_t i = 0; i != size(); ++i)
      {
        if(i == least || !is_free(i) || y[i] == 0)
          continue;
        const Integer factor = y[i] / y[least];
        y[i] -= factor * y[least];
        add(side, least, i, factor);
      }
    }
  }

  // Adds a multiple of a vector to another one on one side, and what this means for the other side.
  void add(int side, std::size_t to, std::size_t other, const Integer& factor)
  {
    add_multiple(bases_[side][to], bases_[side][other], factor);
    add_multiple(bases_[1 - side][other], bases_[1 - side][to], -factor);
  }

  std::array<Rows, 2> bases_;
  std::array<std::vector<bool>, 2> is_chosen_;
};

// The homology of a component as the sum of two halves, of loops that bound behind the surface (half 0) and in front of
// it (half 1), each of which is isotropic: no two of its loops have an intersection number but 0.
// If P is minus the matrix of the linking numbers of the loops b with the loops c in front, a loop x = sum x_i b_i has
// the linking numbers -xP. As the loops c are a basis, it bounds behind if and only if xP = 0. Pushing it to the other
// side changes the linking number with c_k by x_k, so it bounds in front if and only if xP = x. By the theorem of Mayer
// and Vietoris each loop is the sum of one of either kind, which is the same as P being the projection xP, P^2 = P.
// Loops that bound on the same side are isotropic, and the intersection form is unimodular, so both halves have rank g
// and are dual to each other.
class Loop_halves
{
public:
  // Coordinates in two dual bases of the halves: row k of `coordinates(half)` has those of b_k. The intersection
  // number of a loop of half 0 with one of half 1 is the dot product of their coordinates.
  Loop_halves(const Component_loops& loops, const Rows& projection) : size_(loops.size() / 2)
  {
    const auto intersections = loops.intersection_numbers();
    const Row_lattice front = find_row_lattice(projection);
    is_valid_ = front.basis.size() == size_ && is_isotropic(front.basis, intersections[0]);
    if(!is_valid_)
      return;
    basis_[1] = front.basis;
    coordinates_[0].assign(loops.size(), std::vector<Integer>());
    coordinates_[1].assign(loops.size(), std::vector<Integer>());
    const auto& [forms, inverse] = intersections;
    for(std::size_t k = 0; k != loops.size(); ++k)
      for(std::size_t j = 0; j != size_; ++j)
      {
        coordinates_[0][k].push_back(dot_product(forms[k], front.basis[j]));
        coordinates_[1][k].push_back(front.coordinates[j][k]);
      }
    // The loops of half 0 whose intersection numbers with all b are the coordinates of these.
    for(std::size_t j = 0; j != size_; ++j)
    {
      basis_[0].push_back(combination(front.coordinates[j], inverse));
      for(Integer& number : basis_[0].back()) // as columns are rows with the other sign
        number = -number;
    }
    is_valid_ = is_projection();
  }

  // The halves of two given bases, where loop i of the second one crosses loop i of the first one from its right to its left, and no
  // other one.
  Loop_halves(const Component_loops& loops, std::array<Rows, 2> bases)
    : size_(loops.size() / 2),
      is_valid_(true),
      basis_(std::move(bases))
  {
    const Rows forms = loops.intersection_numbers()[0];
    for(const auto& crossed : forms)
      for(int half : {0, 1})
      {
        auto& row = coordinates_[half].emplace_back();
        for(const auto& loop : basis_[1 - half])
          row.push_back(half == 0 ? dot_product(crossed, loop) : -dot_product(crossed, loop));
      }
  }

  bool is_valid() const { return is_valid_; }
  std::size_t size() const { return size_; }

  std::vector<Integer> coordinates(int half, const std::vector<Integer>& loop) const
  {
    return combination(loop, coordinates_[half]);
  }

  // The loop of given coordinates in one half, in the basis b.
  std::vector<Integer> loop(int half, const std::vector<Integer>& coordinates) const
  {
    return combination(coordinates, basis_[half]);
  }

  // A random number for each loop b, by half, linear in the coordinates there.
  std::array<std::uint64_t, 2> code(std::size_t k, const std::vector<std::uint64_t>& random) const
  {
    std::array<std::uint64_t, 2> sums = {0, 0};
    for(int half : {0, 1})
      for(std::size_t j = 0; j != size_; ++j)
        sums[half] += low_bits(coordinates_[half][k][j]) * random[j + half * size_];
    return sums;
  }

private:
  static bool is_isotropic(const Rows& basis, const Rows& forms)
  {
    for(const auto& loop : basis)
    {
      const std::vector<Integer> crossing = combination(loop, forms);
      for(const auto& other : basis)
        if(dot_product(crossing, other) != 0)
          return false;
    }
    return true;
  }

  // Whether P is the projection to half 1: P = sum over j of coordinates times basis by construction, so P^2 = P if and
  // only if the coordinates of the basis are those of unit vectors. Half 0 then has none, and is isotropic, too.
  bool is_projection() const
  {
    for(std::size_t i = 0; i != size_; ++i)
      for(int half : {0, 1})
      {
        const std::vector<Integer> sum = combination(basis_[half][i], coordinates_[1]);
        for(std::size_t j = 0; j != size_; ++j)
          if(sum[j] != (half == 1 && i == j ? 1 : 0))
            return false;
      }
    return true;
  }

  std::size_t size_;
  bool is_valid_ = false;
  std::array<Rows, 2> coordinates_, basis_;
};

// Bases of two isotropic halves for a surface without inside: a symplectic basis is made of the loops b, the shortest first, so
// that few become long sums.
inline std::array<Rows, 2> splitting(const Closed_surface& surface, const Component_loops& loops)
{
  struct Loop
  {
    double length; // no less than that of a walk
    std::vector<Integer> coordinates;

    void add(const Loop& other, const Integer& factor)
    {
      if(factor == 0)
        return;
      add_multiple(coordinates, other.coordinates, factor);
      length += std::abs(static_cast<double>(factor)) * other.length;
    }
  };
  const std::size_t size = loops.size();
  const Rows forms = loops.intersection_numbers()[0];
  std::vector<Loop> rest;
  for(std::size_t k = 0; k != size; ++k)
  {
    Halfedge_walk walk = loops.walk(k);
    reduce(walk);
    rest.push_back({surface.length(walk), std::vector<Integer>(size, Integer(0))});
    rest[k].coordinates[k] = Integer(1);
  }
  std::array<Rows, 2> bases;
  while(!rest.empty())
  {
    std::stable_sort(rest.begin(), rest.end(), [](const Loop& a, const Loop& b) { return a.length < b.length; });
    Loop e = std::move(rest.front());
    rest.erase(rest.begin());
    const std::vector<Integer> crossed = combination(e.coordinates, forms);
    std::vector<Integer> crossings;
    for(const Loop& x : rest)
      crossings.push_back(dot_product(crossed, x.coordinates));
    std::size_t least = 0, number = 0;
    while(number != 1)
    {
      std::tie(least, number) = find_least(0, rest.size(), [&](std::size_t i) { return crossings[i]; });
      for(std::size_t i = 0; i != rest.size(); ++i)
        if(const Integer factor = crossings[i] / crossings[least]; i != least)
        {
          rest[i].add(rest[least], -factor);
          crossings[i] -= factor * crossings[least];
        }
    }
    Loop f = std::move(rest[least]);
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(least));
    if(crossings[least] < 0)
      for(Integer& coordinate : f.coordinates)
        coordinate = -coordinate;
    const std::vector<Integer> crossed_by_f = combination(f.coordinates, forms);
    for(Loop& x : rest)
      x.add(e, dot_product(crossed_by_f, x.coordinates)); // x crosses neither e nor f then
    bases[0].push_back(std::move(e.coordinates));
    bases[1].push_back(std::move(f.coordinates));
  }
  return bases;
}

// Writes the codes of the edges in cotrees, from those that are in no tree: the codes of the edges of a face add up to 0.
inline void complete_codes(const Closed_surface& surface, const Tree_and_cotree& trees, Class_codes& codes)
{
  const auto& faces = trees.face_order();
  for(auto f = faces.rbegin(); f != faces.rend(); ++f)
  {
    const Index h = trees.to_parent(*f);
    if(h == no_index)
      continue;
    for(int half : {0, 1})
    {
      const std::uint64_t sum = code_of(codes, surface.next[h], half) + code_of(codes, surface.previous(h), half);
      codes[h / 2][half] = h % 2 == 0 ? std::uint64_t(0) - sum : sum;
    }
  }
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_LOOP_HALVES_H
