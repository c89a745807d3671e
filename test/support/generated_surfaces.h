// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_GENERATED_SURFACES_H
#define CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_GENERATED_SURFACES_H

#include "Plate_mesher.h"
#include "Rolled_out_plate.h"
#include "generated_surfaces/Triangle_soup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

// Surfaces made from nothing, for the demo, the tests and the benchmark. The same call gives the same surface.
namespace generated_surfaces {
namespace internal {
// A grid of `columns` times `rows` vertices, where the last column is joined to the first one if it is closed so.
template <class PointFunction>
Triangle_soup grid(std::size_t columns,
                   std::size_t rows,
                   bool are_columns_closed,
                   bool are_rows_closed,
                   const PointFunction& point)
{
  Triangle_soup soup;
  for(std::size_t row = 0; row < rows; ++row)
    for(std::size_t column = 0; column < columns; ++column)
      soup.points.push_back(point(column, row));
  for(std::size_t row = 0; row + (are_rows_closed ? 0 : 1) < rows; ++row)
    for(std::size_t column = 0; column + (are_columns_closed ? 0 : 1) < columns; ++column)
    {
      const std::size_t right = (column + 1) % columns, up = (row + 1) % rows;
      const std::size_t a = row * columns + column, b = row * columns + right;
      const std::size_t c = up * columns + column, d = up * columns + right;
      soup.triangles.push_back({a, b, d});
      soup.triangles.push_back({a, d, c});
    }
  return soup;
}

} // namespace internal

// A connected closed surface of exactly that genus with outward faces: a rounded plate in the xy-plane with `genus`
// round holes, in rows of at most eight. Genus 0 is a sphere, genus 1 a torus. The number of vertices is right up to a
// factor of 2, except that each hole takes at least about 100 of them.
inline Triangle_soup closed_surface(unsigned genus, std::size_t number_of_vertices)
{
  const internal::Rolled_out_plate plate(genus);
  const double area_per_vertex = 2 * plate.area() / std::max<std::size_t>(number_of_vertices, 1);
  const double edge_length = std::sqrt(area_per_vertex / std::sqrt(0.75));
  return internal::Plate_mesher(plate, std::min(edge_length, 0.8 * plate.hole_radius)).double_of_plate();
}

// Smooth hills over the unit square, a grid of `columns` times `rows` vertices, at least 2 each.
inline Triangle_soup terrain(std::size_t columns, std::size_t rows)
{
  return internal::grid(columns, rows, false, false, [&](std::size_t column, std::size_t row) {
    const double x = column / (columns - 1.), y = row / (rows - 1.);
    const double z = 0.10 * std::sin(7 * x + 1) * std::cos(6 * y) + 0.05 * std::sin(17 * x - 9 * y)
                   + 0.02 * std::cos(23 * x + 31 * y + 2);
    return std::array<double, 3>{x, y, z};
  });
}

// A torus around the z-axis, with `around` vertices around the tube and `along` vertices along it, at least 3 each.
inline Triangle_soup torus(std::size_t around, std::size_t along)
{
  return internal::grid(along, around, true, true, [&](std::size_t column, std::size_t row) {
    const double u = 2 * internal::pi * column / along, v = 2 * internal::pi * row / around;
    const double radius = 1 + 0.4 * std::cos(v);
    return std::array<double, 3>{radius * std::cos(u), radius * std::sin(u), 0.4 * std::sin(v)};
  });
}

} // namespace generated_surfaces

#endif // CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_GENERATED_SURFACES_H
