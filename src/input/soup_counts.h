// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_SOUP_COUNTS_H
#define CGAL_REEB_GRAPH_SRC_SOUP_COUNTS_H

#include "base/input_findings.h"
#include "input/Polygon_soup.h"

#include <cstddef>
#include <vector>

namespace reeb_graph_program {
Soup_counts count_soup(const Polygons& polygons, std::size_t number_of_vertices);

// The component of each polygon; polygons that share a vertex are in one.
std::vector<std::size_t> components_of_polygons(const Polygons& polygons, std::size_t number_of_vertices);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_SOUP_COUNTS_H
