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

#include <string>
#include <vector>

namespace reeb_graph_program {
// Throws std::runtime_error if the file name does not end in .polylines.txt or .csv.
void check_polylines_format(const std::string& path);

// The polylines format of CGAL: for each on a line, the number of points, and their coordinates. In .csv, each point is a
// row, with the number of its curve.
void write_polylines(const std::string& path, const std::vector<Polyline>& polylines);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_POLYLINES_OUTPUT_H
