// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_GENERATED_COMPLEXES_H
#define CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_GENERATED_COMPLEXES_H

#include "generated_surfaces/Triangle_soup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

// Complexes made from nothing that are no surfaces, for the tests and the benchmark. The same call gives the same one.
namespace generated_surfaces {
struct Tetrahedron_soup
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 4>> tetrahedra;
};

namespace internal {
constexpr std::size_t no_vertex = static_cast<std::size_t>(-1);

// The corners of a grid of cubes. Those that are used become vertices, in the order in which they are asked for.
template <class Soup>
class Grid_corners
{
public:
  Grid_corners(Soup& soup, const std::array<std::size_t, 3>& cubes)
    : soup_(soup),
      cubes_(cubes),
      vertices_((cubes[0] + 1) * (cubes[1] + 1) * (cubes[2] + 1), no_vertex)
  {}

  std::size_t vertex(const std::array<std::size_t, 3>& corner)
  {
    std::size_t& v = vertices_[(corner[2] * (cubes_[1] + 1) + corner[1]) * (cubes_[0] + 1) + corner[0]];
    if(v != no_vertex)
      return v;
    const double size = static_cast<double>(*std::max_element(cubes_.begin(), cubes_.end()));
    std::array<double, 3> point;
    for(std::size_t i = 0; i < 3; ++i)
      point[i] = static_cast<double>(corner[i]) / size;
    soup_.points.push_back(bent(point));
    return v = soup_.points.size() - 1;
  }

private:
  // Planes of the grid become smooth surfaces whose heights have no ties.
  static std::array<double, 3> bent(const std::array<double, 3>& p)
  {
    const double x = p[0], y = p[1], z = p[2];
    return {x + 0.031 * std::sin(3.1 * y + 1.7 * z), y + 0.029 * std::sin(2.3 * z + 1.9 * x + 1),
            z + 0.083 * x - 0.061 * y + 0.027 * std::sin(2.9 * x + 2.1 * y + 2)};
  }

  Soup& soup_;
  std::array<std::size_t, 3> cubes_;
  std::vector<std::size_t> vertices_;
};

// The number of the brick that a cube is in, in a wall of bricks each of which is 4 `quarter` cubes long. Layers, and
// rows in a layer, are shifted so that no more than three bricks meet at an edge.
inline std::size_t brick(const std::array<std::size_t, 3>& cube,
                         const std::array<std::size_t, 3>& bricks,
                         std::size_t quarter)
{
  const auto number = [&](std::size_t place, std::size_t shift, std::size_t number_of_bricks) {
    const std::size_t i = place < shift * quarter ? 0 : (place - shift * quarter) / (4 * quarter);
    return std::min(i, number_of_bricks - 1);
  };
  const std::size_t layer = number(cube[2], 0, bricks[2]);
  const std::size_t row = number(cube[1], 2 * (layer % 2), bricks[1]);
  const std::size_t column = number(cube[0], layer % 2 + 2 * (row % 2), bricks[0]);
  return (layer * bricks[1] + row) * bricks[0] + column;
}

// the square between a cube and the one before it along an axis
template <class Corners>
void add_square(Triangle_soup& soup, Corners& corners, const std::array<std::size_t, 3>& corner, std::size_t axis)
{
  std::array<std::size_t, 3> right = corner, up = corner, opposite = corner;
  const std::size_t second = (axis + 1) % 3, third = (axis + 2) % 3;
  ++right[second];
  ++up[third];
  ++opposite[second];
  ++opposite[third];
  const std::size_t a = corners.vertex(corner), b = corners.vertex(right), c = corners.vertex(opposite),
                    d = corners.vertex(up);
  soup.triangles.push_back({a, b, c});
  soup.triangles.push_back({a, c, d});
}

} // namespace internal

// The walls of columns * rows * layers cells, which fill a box: three of them meet at each inner edge. A cell is
// 4 * quarter cubes of a grid long, and has about 192 quarter^2 triangles on its six sides, most of them shared by two.
inline Triangle_soup foam(std::size_t columns, std::size_t rows, std::size_t layers, std::size_t quarter)
{
  const std::array<std::size_t, 3> bricks = {columns, rows, layers};
  const std::array<std::size_t, 3> cubes = {4 * quarter * columns, 4 * quarter * rows, 4 * quarter * layers};
  Triangle_soup soup;
  internal::Grid_corners<Triangle_soup> corners(soup, cubes);
  std::array<std::size_t, 3> cube;
  for(cube[2] = 0; cube[2] <= cubes[2]; ++cube[2])
    for(cube[1] = 0; cube[1] <= cubes[1]; ++cube[1])
      for(cube[0] = 0; cube[0] <= cubes[0]; ++cube[0])
        for(std::size_t axis = 0; axis < 3; ++axis)
        {
          const std::size_t second = (axis + 1) % 3, third = (axis + 2) % 3;
          if(cube[second] == cubes[second] || cube[third] == cubes[third])
            continue;
          std::array<std::size_t, 3> previous = cube;
          --previous[axis];
          const bool is_outer = cube[axis] == 0 || cube[axis] == cubes[axis];
          if(is_outer || internal::brick(cube, bricks, quarter) != internal::brick(previous, bricks, quarter))
            internal::add_square(soup, corners, cube, axis);
        }
  return soup;
}

// The soup without every `step`-th triangle, so that a foam has loops.
inline Triangle_soup with_holes(Triangle_soup soup, std::size_t step)
{
  std::vector<std::array<std::size_t, 3>> triangles;
  for(std::size_t i = 0; i < soup.triangles.size(); ++i)
    if(i % step != 0)
      triangles.push_back(soup.triangles[i]);
  soup.triangles = triangles;
  return soup;
}

// A box of cubes, of six tetrahedra each around a diagonal, through which tunnels * tunnels tunnels lead upwards. Its
// first Betti number is that of the tunnels. `cubes` is the number along each side, at least 2 * tunnels + 1.
inline Tetrahedron_soup solid(std::size_t cubes, std::size_t tunnels = 0)
{
  const auto is_in_odd_band = [&](std::size_t place) { return place * (2 * tunnels + 1) / cubes % 2 == 1; };
  Tetrahedron_soup soup;
  internal::Grid_corners<Tetrahedron_soup> corners(soup, {cubes, cubes, cubes});
  std::array<std::size_t, 3> cube;
  for(cube[2] = 0; cube[2] < cubes; ++cube[2])
    for(cube[1] = 0; cube[1] < cubes; ++cube[1])
      for(cube[0] = 0; cube[0] < cubes; ++cube[0])
      {
        if(is_in_odd_band(cube[0]) && is_in_odd_band(cube[1]))
          continue;
        std::array<std::size_t, 3> axes = {0, 1, 2};
        do
        {
          std::array<std::size_t, 3> corner = cube;
          std::array<std::size_t, 4> tetrahedron = {corners.vertex(corner), 0, 0, 0};
          for(std::size_t i = 0; i < 3; ++i)
          {
            ++corner[axes[i]];
            tetrahedron[i + 1] = corners.vertex(corner);
          }
          soup.tetrahedra.push_back(tetrahedron);
        } while(std::next_permutation(axes.begin(), axes.end()));
      }
  return soup;
}

// Half disks of 2 * side^2 triangles each, whose straight sides are one path of side + 1 vertices.
inline Triangle_soup book(std::size_t pages, std::size_t side)
{
  Triangle_soup soup;
  const auto point = [&](std::size_t page, std::size_t row, std::size_t column) {
    const double radius = static_cast<double>(column) / static_cast<double>(side);
    const double z = static_cast<double>(row) / static_cast<double>(side);
    const double angle = 6.28318530717958648 * static_cast<double>(page) / static_cast<double>(pages);
    const double turn = angle + 0.3 * radius * std::sin(4 * z);
    return std::array<double, 3>{radius * std::cos(turn), radius * std::sin(turn),
                                 z + 0.2 * radius * std::sin(5 * radius + angle)};
  };
  for(std::size_t row = 0; row <= side; ++row)
    soup.points.push_back(point(0, row, 0));
  for(std::size_t page = 0; page < pages; ++page)
  {
    const std::size_t first = soup.points.size();
    for(std::size_t row = 0; row <= side; ++row)
      for(std::size_t column = 1; column <= side; ++column)
        soup.points.push_back(point(page, row, column));
    const auto vertex = [&](std::size_t row, std::size_t column) {
      return column == 0 ? row : first + row * side + column - 1;
    };
    for(std::size_t row = 0; row < side; ++row)
      for(std::size_t column = 0; column < side; ++column)
      {
        soup.triangles.push_back({vertex(row, column), vertex(row, column + 1), vertex(row + 1, column + 1)});
        soup.triangles.push_back({vertex(row, column), vertex(row + 1, column + 1), vertex(row + 1, column)});
      }
  }
  return soup;
}

// A field with few critical vertices.
inline std::vector<double> smooth_field(const std::vector<std::array<double, 3>>& points)
{
  std::vector<double> values;
  values.reserve(points.size());
  for(const auto& p : points)
    values.push_back(std::sin(4 * p[0]) + 0.5 * std::sin(6 * p[1] + p[0]) + 0.7 * std::sin(5 * p[2] + 1));
  return values;
}

// White noise.
inline std::vector<double> noise_field(const std::vector<std::array<double, 3>>& points)
{
  std::mt19937 random(1);
  std::vector<double> values;
  values.reserve(points.size());
  for(std::size_t i = 0; i < points.size(); ++i)
    values.push_back(static_cast<double>(random()));
  return values;
}

} // namespace generated_surfaces

#endif // CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_GENERATED_COMPLEXES_H
