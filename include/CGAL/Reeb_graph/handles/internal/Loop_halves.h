// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_INTERNAL_LOOP_HALVES_H
#define CGAL_REEB_GRAPH_HANDLES_INTERNAL_LOOP_HALVES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/handles/internal/Component_loops.h>
#include <CGAL/Reeb_graph/handles/internal/Integer_rows.h>
#include <CGAL/Reeb_graph/handles/internal/Loop_search.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The homology of a component as the sum of two halves, of loops that bound behind the surface (half 0) and in front of
// it (half 1), each of which is isotropic: no two of its loops have an intersection number but 0.
// If P is minus the matrix of the linking numbers of the loops b with the loops c in front, a loop x = sum x_i b_i has
// the linking numbers -xP. As the loops c are a basis, it bounds behind if and only if xP = 0. Pushing it to the other
// side changes the linking number with c_k by x_k, so it bounds in front if and only if xP = x. By the theorem of Mayer
// and Vietoris each loop is the sum of one of either kind, which is the same as P being the projection xP, P^2 = P.
// Loops that bound on the same side are isotropic, and the intersection form is unimodular, so both halves have rank g
// and are dual to each other.
template <class Integer>
class Loop_halves
{
public:
  // Coordinates in two dual bases of the halves: row k of `coordinates(half)` has those of b_k. The intersection
  // number of a loop of half 0 with one of half 1 is the dot product of their coordinates.
  Loop_halves(const Component_loops& loops, const Integer_rows& projection) : size_(loops.size() / 2)
  {
    const auto intersections = loops.intersection_numbers();
    const Row_lattice<Integer> front = find_row_lattice(converted(projection));
    is_valid_ = front.basis.size() == size_ && is_isotropic(front.basis, intersections[0]);
    if(!is_valid_)
      return;
    basis_[1] = front.basis;
    coordinates_[0].assign(loops.size(), std::vector<Integer>());
    coordinates_[1].assign(loops.size(), std::vector<Integer>());
    const Rows<Integer> forms = converted(intersections[0]), inverse = converted(intersections[1]);
    for(std::size_t k = 0; k != loops.size(); ++k)
      for(std::size_t j = 0; j != size_; ++j)
      {
        coordinates_[0][k].push_back(dot_product(forms[k], front.basis[j]));
        coordinates_[1][k].push_back(front.coordinates[j][k]);
      }
    // The loops of half 0 whose intersection numbers with all b are the coordinates of these.
    for(std::size_t j = 0; j != size_; ++j)
    {
      std::vector<Integer> dual(loops.size(), Integer(0));
      for(std::size_t k = 0; k != loops.size(); ++k)
        add_column(dual, inverse, k, front.coordinates[j][k]);
      basis_[0].push_back(dual);
    }
    is_valid_ = is_projection(projection);
  }

  bool is_valid() const { return is_valid_; }
  std::size_t size() const { return size_; }

  std::vector<Integer> coordinates(int half, const std::vector<long long>& loop) const
  {
    std::vector<Integer> sum(size_, Integer(0));
    for(std::size_t k = 0; k != loop.size(); ++k)
    {
      if(loop[k] != 0)
        add_multiple(sum, coordinates_[half][k], Integer(loop[k]));
    }
    return sum;
  }

  // The loop of given coordinates in one half, in the basis b.
  std::vector<Integer> loop(int half, const std::vector<Integer>& coordinates) const
  {
    std::vector<Integer> sum(2 * size_, Integer(0));
    for(std::size_t j = 0; j != size_; ++j)
    {
      if(coordinates[j] != Integer(0))
        add_multiple(sum, basis_[half][j], coordinates[j]);
    }
    return sum;
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
  static Rows<Integer> converted(const Integer_rows& rows)
  {
    Rows<Integer> result;
    for(const auto& row : rows)
      result.emplace_back(row.begin(), row.end());
    return result;
  }

  static void add_column(std::vector<Integer>& sum, const Rows<Integer>& rows, std::size_t k, const Integer& factor)
  {
    if(factor == Integer(0))
      return;
    for(std::size_t i = 0; i != sum.size(); ++i)
    {
      if(rows[i][k] != Integer(0))
        sum[i] += factor * rows[i][k];
    }
  }

  static bool is_isotropic(const Rows<Integer>& basis, const Integer_rows& intersections)
  {
    const Rows<Integer> forms = converted(intersections);
    for(const auto& loop : basis)
    {
      std::vector<Integer> crossing(loop.size(), Integer(0));
      for(std::size_t k = 0; k != loop.size(); ++k)
      {
        if(loop[k] != Integer(0))
          add_multiple(crossing, forms[k], loop[k]);
      }
      for(const auto& other : basis)
        if(dot_product(crossing, other) != Integer(0))
          return false;
    }
    return true;
  }

  // Whether P is the projection to half 1: P = sum over j of coordinates times basis by construction, so P^2 = P if and
  // only if the coordinates of the basis are those of unit vectors. Half 0 then has none, and is isotropic, too.
  bool is_projection(const Integer_rows& projection) const
  {
    for(std::size_t i = 0; i != size_; ++i)
      for(int half : {0, 1})
      {
        std::vector<Integer> sum(size_, Integer(0));
        for(std::size_t k = 0; k != projection.size(); ++k)
        {
          if(basis_[half][i][k] != Integer(0))
            add_multiple(sum, coordinates_[1][k], basis_[half][i][k]);
        }
        for(std::size_t j = 0; j != size_; ++j)
          if(sum[j] != Integer(half == 1 && i == j ? 1 : 0))
            return false;
      }
    return true;
  }

  std::size_t size_;
  bool is_valid_ = false;
  std::array<Rows<Integer>, 2> coordinates_, basis_;
};

// Some projection to an isotropic half along another one, for a surface without inside: a symplectic basis e_j, f_j is
// made of the loops b, and each f_j stays.
template <class Integer>
Integer_rows splitting(const Component_loops& loops)
{
  const std::size_t size = loops.size();
  const Integer_rows forms = loops.intersection_numbers()[0];
  const auto dual = [&](const std::vector<Integer>& x) { // the intersection numbers with all b
    std::vector<Integer> result(size, Integer(0));
    for(std::size_t k = 0; k != size; ++k)
      for(std::size_t i = 0; i != size; ++i)
        if(forms[k][i] != 0)
          result[i] += x[k] * Integer(forms[k][i]);
    return result;
  };
  Rows<Integer> rest(size, std::vector<Integer>(size, Integer(0)));
  for(std::size_t k = 0; k != size; ++k)
    rest[k][k] = Integer(1);
  Integer_rows projection(size, std::vector<long long>(size, 0));
  while(!rest.empty())
  {
    const std::vector<Integer> e = rest.front(), crossed = dual(e);
    rest.erase(rest.begin());
    std::size_t least = 0;
    for(std::size_t number = 0; number != 1;)
    {
      number = 0;
      for(std::size_t i = 0; i != rest.size(); ++i)
      {
        const Integer crossing = dot_product(crossed, rest[i]);
        if(crossing == Integer(0))
          continue;
        if(number++ == 0 || magnitude(crossing) < magnitude(dot_product(crossed, rest[least])))
          least = i;
      }
      const Integer divisor = dot_product(crossed, rest[least]);
      for(std::size_t i = 0; i != rest.size(); ++i)
        if(i != least)
          add_multiple(rest[i], rest[least], Integer(-(dot_product(crossed, rest[i]) / divisor)));
    }
    const Integer sign = dot_product(crossed, rest[least]);
    std::vector<Integer> f(size, Integer(0));
    add_multiple(f, rest[least], sign);
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(least));
    const std::vector<Integer> crossed_by_f = dual(f);
    for(auto& x : rest)
      add_multiple(x, e, dot_product(crossed_by_f, x)); // x crosses neither e nor f then
    for(std::size_t k = 0; k != size; ++k)
      for(std::size_t i = 0; i != size; ++i)
        projection[k][i] += to_machine_integer(Integer(crossed[k] * f[i]));
  }
  return projection;
}

// Random numbers for the coordinates of both halves, for codes.
inline std::vector<std::uint64_t> random_numbers(std::size_t size)
{
  std::uint64_t state = 88172645463325252u;
  std::vector<std::uint64_t> random;
  for(std::size_t i = 0; i != size; ++i)
  {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    random.push_back(state * 2685821657736338717u);
  }
  return random;
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

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_LOOP_HALVES_H
