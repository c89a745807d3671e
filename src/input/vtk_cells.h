// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_VTK_CELLS_H
#define CGAL_REEB_GRAPH_SRC_VTK_CELLS_H

#include "input/Polygon_soup.h"

#include <cstddef>
#include <string>
#include <vector>

namespace reeb_graph_program {
// The types of cells that both formats of VTK's polygonal data have by sections.
constexpr std::size_t vtk_vertices = 2, vtk_lines = 4, vtk_strips = 6, vtk_polygons = 7;

// What makes a file that is read of one with other cells: the end of messages.
extern const char* const vtk_way_out;

// Cells of VTK, in the order of a file.
struct Vtk_cells
{
  std::vector<std::size_t> types;
  Polygons vertices;
};

// Adds the vertices of cells, by the ends of the cells among them. Throws Input_error if those do not ascend.
void add_vtk_vertices(const std::string& path,
                      const std::vector<std::size_t>& ends,
                      const std::vector<std::size_t>& vertices,
                      Polygons& cells);

// Throws Input_error, which names the types, if some are none that are read.
void check_vtk_types(const std::string& path, const std::vector<std::size_t>& types);

// Adds cells of these types to a soup: points, which say nothing of the complex, lines, triangles, strips of them,
// polygons, and tetrahedra. Throws Input_error for a cell that has another number of vertices than its type.
// `first_vertex` is added to the numbers of vertices. In a line, a point that follows itself makes no edge.
void add_vtk_cells(const std::string& path, const Vtk_cells& cells, std::size_t first_vertex, Polygon_soup& soup);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_VTK_CELLS_H
