// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_LOOPS_OUTPUT_H
#define CGAL_REEB_GRAPH_SRC_LOOPS_OUTPUT_H

#include "computation/handles.h"

#include <filesystem>
#include <string>

namespace reeb_graph_program {
// Throws std::runtime_error, which calls loops so, if the file name ends in none of .vtp, .obj, and .polylines.txt.
void check_loops_format(const std::filesystem::path& path, const std::string& contents = "loops");

void write_loops(const std::filesystem::path& path, const Loops_of_surface& loops);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_LOOPS_OUTPUT_H
