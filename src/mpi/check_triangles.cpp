// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "mpi/check_triangles.h"

#include "input/input_error.h"

#include <algorithm>

namespace reeb_graph_program {
namespace {
// Ranks look nothing over, as faces keep their numbers in the file.
constexpr const char* way_out = "; reeb_graph repair writes a file without such faces";

[[noreturn]] void fail(const std::string& path, std::uint64_t face, const std::string& message)
{
  throw Input_error(path, "face " + std::to_string(face) + message);
}

} // namespace

void check_triangle(const std::string& path,
                    std::uint64_t face,
                    const std::array<std::uint64_t, 3>& corners,
                    std::uint64_t number_of_vertices)
{
  const auto [a, b, c] = corners;
  if(std::max({a, b, c}) >= number_of_vertices)
    fail(path, face, " has a vertex that does not exist");
  if(a == b || b == c || c == a)
    fail(path, face, " has vertex " + std::to_string(b == c ? b : a) + " at two of its corners" + way_out);
}

void throw_for_polygon(const std::string& path, std::uint64_t face, double number_of_corners)
{
  if(number_of_corners < 3)
    fail(path, face, std::string(" has fewer than three vertices") + way_out);
  fail(path, face,
       " has " + std::to_string(static_cast<std::uint64_t>(number_of_corners))
         + " vertices and is not a triangle; reeb_graph repair --triangulate writes a file of triangles");
}

} // namespace reeb_graph_program
