// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_TRIANGLE_SOUP_H
#define CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_TRIANGLE_SOUP_H

#include <array>
#include <cstddef>
#include <vector>

namespace generated_surfaces {
struct Triangle_soup
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

} // namespace generated_surfaces

#endif // CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_TRIANGLE_SOUP_H
