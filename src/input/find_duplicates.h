// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_FIND_DUPLICATES_H
#define CGAL_REEB_GRAPH_SRC_FIND_DUPLICATES_H

#include "input/Polygon_soup.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace reeb_graph_program {
// Polygons that repeat an earlier one.
struct Duplicates
{
  std::size_t number = 0;
  std::vector<std::size_t> numbers; // of all of them, in ascending order
  std::optional<std::size_t> first;
  std::vector<std::size_t> firsts; // of each polygon, the first one that it repeats, or itself
};

// Polygons are the same if their vertices are, in the same cyclic order, or, unless that is asked for, the opposite
// one.
Duplicates find_duplicates(const Polygons& polygons, bool have_same_orientation);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_FIND_DUPLICATES_H
