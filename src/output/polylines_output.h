// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_POLYLINES_OUTPUT_H
#define CGAL_REEB_GRAPH_SRC_POLYLINES_OUTPUT_H

#include "base/surface.h"
#include "computation/Mesh_graph.h"
#include "computation/handles.h"

#include <filesystem>
#include <string>
#include <vector>

namespace reeb_graph_program {
// Throws std::runtime_error if the file name does not end in .polylines.txt or .csv.
void check_polylines_format(const std::string& path);

// The polylines format of CGAL: for each on a line, the number of points, and their coordinates. In .csv, each point is a
// row, with the number of its curve.
void write_polylines(const std::string& path, const std::vector<Polyline>& polylines);

// Throws std::runtime_error if the file name has none of the endings .polylines.txt, .vtp, .obj, .json, .csv and, for
// contours in tetrahedra, .off.
void check_contour_format(const std::string& path);

// Throws std::runtime_error if contours, which are surfaces in tetrahedra, and curves elsewhere, have another format.
void check_contour_format(const std::string& path, bool are_contours_surfaces);

// Lines with their arcs, values and lengths, and whether they are closed, for which .polylines.txt has no room; or
// triangles, .off.
void write_contours(const std::string& path, const std::vector<Contour>& contours, bool are_contours_surfaces);

// Throws std::runtime_error, which calls loops so, if the file name ends in none of .vtp, .obj, and .polylines.txt.
void check_loops_format(const std::filesystem::path& path, const std::string& contents = "loops");

void write_loops(const std::filesystem::path& path, const Loops_of_surface& loops);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_POLYLINES_OUTPUT_H
