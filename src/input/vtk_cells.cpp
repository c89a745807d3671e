// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/vtk_cells.h"

#include "input/input_error.h"

#include <array>
#include <initializer_list>
#include <limits>
#include <vector>

namespace reeb_graph_program {
namespace {
// The types by their numbers in VTK's vtkCellType.h.
enum Cell_type : std::size_t
{
  VERTEX = 1,
  POLY_VERTEX = 2,
  LINE = 3,
  POLY_LINE = 4,
  TRIANGLE = 5,
  TRIANGLE_STRIP = 6,
  POLYGON = 7,
  PIXEL = 8,
  QUAD = 9,
  TETRA = 10
};

struct Corner_counts
{
  std::size_t least, most;
};

Corner_counts corner_counts(const std::string& path, std::size_t type)
{
  constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
  switch(type)
  {
  case VERTEX: return {1, 1};
  case POLY_VERTEX: return {0, any};
  case LINE: return {2, 2};
  case POLY_LINE: return {2, any};
  case TRIANGLE: return {3, 3};
  case TRIANGLE_STRIP:
  case POLYGON: return {3, any};
  case PIXEL:
  case QUAD:
  case TETRA: return {4, 4};
  default:
    throw Input_error(path, "cells of type " + std::to_string(type)
                              + " of VTK are not read: the types are 1 to 10, points, lines, triangles, strips of "
                                "triangles, polygons, pixels, quadrilaterals, and tetrahedra");
  }
}

void add_polygon(std::initializer_list<Corner> vertices, Polygons& polygons)
{
  for(const Corner v : vertices)
    polygons.add_corner(v);
  polygons.end_polygon();
}

} // namespace

void add_vtk_cell(const std::string& path,
                  std::size_t type,
                  Polygons::Polygon vertices,
                  std::size_t first_vertex,
                  Polygon_soup& soup)
{
  const Corner_counts counts = corner_counts(path, type);
  const auto size = static_cast<std::size_t>(vertices.end() - vertices.begin());
  if(size < counts.least || size > counts.most)
    throw Input_error(path, "a cell of type " + std::to_string(type) + " of VTK cannot have " + std::to_string(size)
                              + " vertices");
  const auto v = [&](std::size_t i) { return corner(first_vertex + vertices.begin()[i]); };
  switch(type)
  {
  case LINE:
  case POLY_LINE:
    for(std::size_t i = 1; i < size; ++i)
      soup.edges.push_back({v(i - 1), v(i)});
    break;
  case TRIANGLE_STRIP:
  {
    std::vector<Corner> strip;
    for(std::size_t i = 0; i < size; ++i)
      strip.push_back(v(i));
    add_strip(strip, soup.polygons);
    break;
  }
  case PIXEL: add_polygon({v(0), v(1), v(3), v(2)}, soup.polygons); break;
  case TETRA: soup.tetrahedra.push_back({v(0), v(1), v(2), v(3)}); break;
  case TRIANGLE:
  case POLYGON:
  case QUAD:
    for(std::size_t i = 0; i < size; ++i)
      soup.polygons.add_corner(v(i));
    soup.polygons.end_polygon();
    break;
  default: break;
  }
}

} // namespace reeb_graph_program
