// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/vtk_cells.h"

#include "input/input_error.h"

#include <array>
#include <initializer_list>
#include <limits>
#include <map>
#include <set>

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

Corner_counts corner_counts(std::size_t type)
{
  constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
  switch(type)
  {
  case VERTEX: return {1, 1};
  case POLY_VERTEX: return {0, any};
  case LINE: return {2, 2};
  case POLY_LINE: return {0, any};
  case TRIANGLE: return {3, 3};
  case TRIANGLE_STRIP:
  case POLYGON: return {0, any};
  case PIXEL:
  case QUAD:
  case TETRA: return {4, 4};
  default: return {0, 0};
  }
}

// Types that files often have.
std::string name_of_type(std::size_t type)
{
  static const std::map<std::size_t, std::string> names = {{0, "empty"},
                                                           {11, "voxel"},
                                                           {12, "hexahedron"},
                                                           {13, "wedge"},
                                                           {14, "pyramid"},
                                                           {15, "prism"},
                                                           {16, "prism"},
                                                           {21, "quadratic edge"},
                                                           {22, "quadratic triangle"},
                                                           {23, "quadratic quadrilateral"},
                                                           {24, "quadratic tetrahedron"},
                                                           {25, "quadratic hexahedron"},
                                                           {42, "polyhedron"}};
  const auto found = names.find(type);
  return std::to_string(type) + (found == names.end() ? "" : " (" + found->second + ")");
}

void add_polygon(std::initializer_list<Corner> vertices, Polygons& polygons)
{
  for(const Corner v : vertices)
    polygons.add_corner(v);
  polygons.end_polygon();
}

void add_cell(const std::string& path,
              std::size_t type,
              Polygons::Polygon vertices,
              std::size_t first_vertex,
              Polygon_soup& soup)
{
  const Corner_counts counts = corner_counts(type);
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
      if(v(i - 1) != v(i))
        soup.edges.push_back({v(i - 1), v(i)});
    break;
  case TRIANGLE_STRIP:
    for(std::size_t i = 2; i < size; ++i)
      add_polygon({v(i - 2 + i % 2), v(i - 1 - i % 2), v(i)}, soup.polygons);
    if(size > 2)
      break;
    [[fallthrough]]; // fewer corners are a face that is left out
  case TRIANGLE:
  case POLYGON:
  case QUAD:
    for(std::size_t i = 0; i < size; ++i)
      soup.polygons.add_corner(v(i));
    soup.polygons.end_polygon();
    break;
  case PIXEL: add_polygon({v(0), v(1), v(3), v(2)}, soup.polygons); break;
  case TETRA: soup.tetrahedra.push_back({v(0), v(1), v(2), v(3)}); break;
  default: break;
  }
}

} // namespace

const char* const vtk_way_out = "VTK's vtkDataSetTriangleFilter, ParaView's filter Tetrahedralize, cuts all cells into "
                                "triangles and tetrahedra";

void add_vtk_vertices(const std::string& path,
                      const std::vector<std::size_t>& ends,
                      const std::vector<std::size_t>& vertices,
                      Polygons& cells)
{
  std::size_t begin = 0;
  for(const std::size_t end : ends)
  {
    if(end < begin || end > vertices.size())
      throw Input_error(path, "the offsets of the cells do not ascend, or are too large");
    for(; begin != end; ++begin)
      cells.add_corner(vertices[begin]);
    cells.end_polygon();
  }
}

void check_vtk_types(const std::string& path, const std::vector<std::size_t>& types)
{
  std::set<std::size_t> others;
  for(const std::size_t type : types)
    if(type < VERTEX || type > TETRA)
      others.insert(type);
  if(others.empty())
    return;
  std::string names;
  std::size_t number = 0;
  for(const std::size_t type : others)
    if(++number <= 8)
      names += (names.empty() ? "" : ", ") + name_of_type(type);
  names += number > 8 ? ", ..." : "";
  throw Input_error(path, "cells of type " + names + " of VTK are not read: the types are 1 to 10; " + vtk_way_out);
}

void add_vtk_cells(const std::string& path, const Vtk_cells& cells, std::size_t first_vertex, Polygon_soup& soup)
{
  if(cells.vertices.size() != cells.types.size())
    throw Input_error(path, "there are " + std::to_string(cells.vertices.size()) + " cells, and types of "
                              + std::to_string(cells.types.size()));
  for(std::size_t i = 0; i < cells.types.size(); ++i)
    add_cell(path, cells.types[i], cells.vertices[i], first_vertex, soup);
}

} // namespace reeb_graph_program
