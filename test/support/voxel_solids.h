// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_VOXEL_SOLIDS_H
#define CGAL_REEB_GRAPH_TEST_VOXEL_SOLIDS_H

#include "generated_surfaces.h"
#include "random_meshes.h"

#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

// Random solids made of unit cubes, whose surfaces have hardly any edges, and which loops bound on which side: counted
// with squares of cubes, modulo 2.
class Voxel_solid
{
public:
  typedef std::array<int, 3> Cell;

  // Cubes are changed until the surface is a manifold.
  Voxel_solid(int size, std::size_t seed) : size_(size)
  {
    random_meshes::Random random(seed);
    const std::size_t percentage = 35 + random.below(35);
    for_each_cell(0, size, [&](const Cell& cell) {
      if(random.below(100) < percentage)
        cubes_.insert(cell);
    });
    for(bool is_any_wrong = true; is_any_wrong;)
    {
      is_any_wrong = false;
      for_each_cell(0, size + 1, [&](const Cell& corner) {
        if(is_manifold_at(corner))
          return;
        is_any_wrong = true;
        const Cell cell = cell_around(corner, random.below(8));
        if(is_in_grid(cell) && cubes_.erase(cell) == 0)
          cubes_.insert(cell);
      });
    }
  }

  // The cells of a grid for which a function is true, which make a manifold.
  static Voxel_solid of_cells(int size, const std::function<bool(const Cell&)>& is_solid)
  {
    Voxel_solid solid(size);
    for_each_cell(0, size, [&](const Cell& cell) {
      if(is_solid(cell))
        solid.cubes_.insert(cell);
    });
    return solid;
  }

  // Two triangles for each square, seen from outside counterclockwise.
  generated_surfaces::Triangle_soup surface() const
  {
    generated_surfaces::Triangle_soup soup;
    std::map<Cell, std::size_t> numbers;
    const auto number = [&](const Cell& corner) {
      const auto entry = numbers.emplace(corner, soup.points.size());
      if(entry.second)
        soup.points.push_back({double(corner[0]), double(corner[1]), double(corner[2])});
      return entry.first->second;
    };
    for(const Cell& cube : cubes_)
      for(std::size_t axis = 0; axis != 3; ++axis)
        for(const int side : {0, 1})
        {
          if(cubes_.count(moved(cube, axis, 2 * side - 1)) != 0)
            continue;
          const Cell a = moved(cube, axis, side), b = moved(a, (axis + 1) % 3, 1), d = moved(a, (axis + 2) % 3, 1);
          const std::size_t p = number(a), r = number(moved(b, (axis + 2) % 3, 1));
          const std::size_t q = number(side == 1 ? b : d), s = number(side == 1 ? d : b);
          soup.triangles.push_back({p, q, r});
          soup.triangles.push_back({p, r, s});
        }
    return soup;
  }

  // Whether a closed polygon of edges and diagonals of squares bounds inside, or outside.
  bool is_bounding(const std::vector<Cell>& polygon, bool is_inside)
  {
    std::map<Chain::value_type, Chain>& boundaries = boundaries_[is_inside ? 1 : 0];
    if(boundaries.empty())
      reduce_boundaries(is_inside, boundaries);
    Chain chain;
    for(std::size_t i = 0; i != polygon.size(); ++i)
    {
      Cell corner = polygon[i];
      for(std::size_t axis = 0; axis != 3; ++axis)
        while(const int step = polygon[(i + 1) % polygon.size()][axis] - corner[axis])
        {
          flip(chain, {step > 0 ? corner : moved(corner, axis, -1), axis});
          corner = moved(corner, axis, step > 0 ? 1 : -1);
        }
    }
    reduce(chain, boundaries);
    return chain.empty();
  }

private:
  explicit Voxel_solid(int size) : size_(size) {}

  typedef std::set<std::pair<Cell, std::size_t>> Chain; // edges, by their lower end and axis

  static Cell moved(Cell cell, std::size_t axis, int step)
  {
    cell[axis] += step;
    return cell;
  }
  static Cell cell_around(const Cell& corner, std::size_t number)
  {
    return {corner[0] - int(number & 1), corner[1] - int(number >> 1 & 1), corner[2] - int(number >> 2)};
  }
  bool is_in_grid(const Cell& cell) const
  {
    for(const int coordinate : cell)
      if(coordinate < 0 || coordinate >= size_)
        return false;
    return true;
  }
  template <class Visit>
  static void for_each_cell(int begin, int end, const Visit& visit)
  {
    for(int x = begin; x != end; ++x)
      for(int y = begin; y != end; ++y)
        for(int z = begin; z != end; ++z)
          visit(Cell{x, y, z});
  }

  // Whether the cubes around a corner are connected by squares, and what is between them as well.
  bool is_manifold_at(const Cell& corner) const
  {
    int number_of_parts[2] = {0, 0};
    std::array<bool, 8> is_seen = {};
    for(std::size_t first = 0; first != 8; ++first)
    {
      if(is_seen[first])
        continue;
      const bool is_solid = cubes_.count(cell_around(corner, first)) != 0;
      ++number_of_parts[is_solid ? 1 : 0];
      std::vector<std::size_t> stack(1, first);
      while(!stack.empty())
      {
        const std::size_t number = stack.back();
        stack.pop_back();
        is_seen[number] = true;
        for(const std::size_t bit : {1, 2, 4})
          if(!is_seen[number ^ bit] && (cubes_.count(cell_around(corner, number ^ bit)) != 0) == is_solid)
            stack.push_back(number ^ bit);
      }
    }
    return number_of_parts[0] <= 1 && number_of_parts[1] <= 1;
  }

  static void flip(Chain& chain, const Chain::value_type& edge)
  {
    const auto entry = chain.insert(edge);
    if(!entry.second)
      chain.erase(entry.first);
  }

  // The boundaries of all squares of one side, each with a last edge that is its own.
  void reduce_boundaries(bool is_inside, std::map<Chain::value_type, Chain>& boundaries) const
  {
    for_each_cell(-1, size_ + 2, [&](const Cell& cell) {
      for(std::size_t axis = 0; axis != 3; ++axis)
      {
        if((cubes_.count(cell) != 0) != is_inside && (cubes_.count(moved(cell, axis, -1)) != 0) != is_inside)
          continue;
        const std::size_t i = (axis + 1) % 3, k = (axis + 2) % 3;
        Chain chain = {{cell, i}, {cell, k}, {moved(cell, k, 1), i}, {moved(cell, i, 1), k}};
        reduce(chain, boundaries);
        if(!chain.empty())
          boundaries.emplace(*chain.rbegin(), chain);
      }
    });
  }

  static void reduce(Chain& chain, const std::map<Chain::value_type, Chain>& boundaries)
  {
    for(auto edge = chain.rbegin(); edge != chain.rend();)
    {
      const auto boundary = boundaries.find(*edge);
      if(boundary == boundaries.end())
      {
        ++edge;
        continue;
      }
      const Chain::value_type last = *edge;
      for(const auto& other : boundary->second)
        flip(chain, other);
      edge = std::make_reverse_iterator(chain.lower_bound(last));
    }
  }

  int size_;
  std::set<Cell> cubes_;
  std::array<std::map<Chain::value_type, Chain>, 2> boundaries_; // outside and inside
};

#endif // CGAL_REEB_GRAPH_TEST_VOXEL_SOLIDS_H
