// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_CHECK_TRIANGLES_H
#define CGAL_REEB_GRAPH_SRC_CHECK_TRIANGLES_H

#include <array>
#include <cstdint>
#include <string>

namespace reeb_graph_program {
// Throws Input_error, as the sequential program does, if a vertex of the face does not exist or is at two of its
// corners.
void check_triangle(const std::string& path,
                    std::uint64_t face,
                    const std::array<std::uint64_t, 3>& corners,
                    std::uint64_t number_of_vertices);

// Throws Input_error for a face that has not three corners.
[[noreturn]] void throw_for_polygon(const std::string& path, std::uint64_t face, double number_of_corners);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_CHECK_TRIANGLES_H
