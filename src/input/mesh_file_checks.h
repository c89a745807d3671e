// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_MESH_FILE_CHECKS_H
#define CGAL_REEB_GRAPH_SRC_MESH_FILE_CHECKS_H

#include "input/mesh_input.h"

#include <string>

namespace reeb_graph_program {
// Finds what the readers of CGAL take for a smaller or another mesh: an STL file that breaks off, or is none at all;
// an OFF file with more faces than its header says; a face of an OBJ file that ends in something else than a number, or
// has a vertex that does not exist. `extension` is in lower case.
bool is_stl_file_complete(const std::string& path);
void check_mesh_file(const std::string& path, const std::string& extension, const Polygon_soup& soup);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_MESH_FILE_CHECKS_H
