// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_VTK_INPUT_H
#define CGAL_REEB_GRAPH_SRC_VTK_INPUT_H

#include "input/Polygon_soup.h"
#include "input/mesh_formats.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace reeb_graph_program {
// Which numbers of the points are read.
struct Vtk_field_choice
{
  bool are_all_wanted = false;
  std::string name;             // of those that become scalars of the soup, or empty
  Field_names* names = nullptr; // what the file has is added here

  bool is_wanted(const std::string& field) const { return are_all_wanted || (!name.empty() && field == name); }
  // Adds the numbers of one more piece of the file, if they are wanted.
  void add(const Vertex_field& field, Polygon_soup& soup) const;
};

// Parts of read_vtk().
Polygon_soup read_vtk_legacy(const std::string& path, std::string_view text, const Vtk_field_choice& choice);
Polygon_soup read_vtk_xml(const std::string& path, std::string_view text, const Vtk_field_choice& choice);

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

#endif // CGAL_REEB_GRAPH_SRC_VTK_INPUT_H
