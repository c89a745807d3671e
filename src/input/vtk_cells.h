// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_VTK_CELLS_H
#define CGAL_REEB_GRAPH_SRC_VTK_CELLS_H

#include "input/Polygon_soup.h"

#include <cstddef>
#include <string>

namespace reeb_graph_program {
// Adds a cell of one of VTK's types: points, which say nothing of the complex, lines, triangles, strips of them,
// polygons, and tetrahedra. Throws Input_error for any other one, and for one that has another number of vertices.
// `first_vertex` is added to the numbers of its vertices.
void add_vtk_cell(const std::string& path,
                  std::size_t type,
                  Polygons::Polygon vertices,
                  std::size_t first_vertex,
                  Polygon_soup& soup);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_VTK_CELLS_H
