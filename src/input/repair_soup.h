// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_REPAIR_SOUP_H
#define CGAL_REEB_GRAPH_SRC_REPAIR_SOUP_H

#include "base/input_findings.h"
#include "input/Polygon_soup.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace reeb_graph_program {
// What is done besides leaving faces out.
struct Repair_options
{
  bool are_coinciding_points_merged = false;
  std::optional<double> distance; // within which points are merged
  bool are_faces_oriented = false;
  bool is_split = false;        // where an edge has more than two faces, a vertex several fans, or no orientation fits
  bool is_largest_kept = false; // the component with the most faces, of several the first one, alone
};

constexpr std::size_t no_vertex = std::numeric_limits<std::size_t>::max();

// Which vertex of the repaired soup each given one is, no_vertex if none; and which given one each repaired one was.
// Of those that have been merged, that is the one with the lowest number.
struct Repair_result
{
  std::vector<std::size_t> new_vertices, old_vertices;
  Repair_counts counts;
};

// Leaves out the faces with a vertex at two corners or fewer than three corners, and then those that repeat an earlier
// one in the same orientation. The numbers of findings are those before.
void leave_out_degenerate_faces(Polygons& polygons, Input_findings& findings);
void leave_out_repeated_faces(Polygons& polygons, Input_findings& findings);

// The number in the file of a face that has not been left out.
std::size_t number_in_file(std::size_t face, const Input_findings& findings);

// Repairs the points and polygons of a soup, whose vertices exist and whose faces have no vertex at two corners. Points
// are merged in their order, and only those of border edges: each joins the nearest kept one. Throws
// std::runtime_error if the distance is not positive and finite.
Repair_result repair_soup(Polygon_soup& soup, const Repair_options& options);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_REPAIR_SOUP_H
