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
// Besides leaving faces out, in this order.
struct Repair_options
{
  bool are_coinciding_points_merged = false;
  std::optional<double> distance;            // within which points of borders are merged
  bool are_opposite_faces_cancelled = false; // one by one, those with the same corners
  bool are_faces_triangulated = false;       // after that, as both sides of a polygon can be cut in different ways
  bool is_split = false; // where an edge has more than two faces, a vertex several fans, or no orientation fits
  bool are_faces_oriented = false;
  double least_share = 0;            // of the area: smaller components go, and those without volume, if it is positive
  std::size_t most_filled_edges = 0; // of a border that is filled
  bool is_largest_kept = false;      // the component with the most faces, of several the first one, alone
};

// Those that make a surface of any faces, and take nothing away but what is there twice.
inline Repair_options all_repairs(double least_share)
{
  Repair_options options;
  options.are_coinciding_points_merged = options.are_opposite_faces_cancelled = true;
  options.is_split = options.are_faces_oriented = true;
  options.least_share = least_share;
  return options;
}

constexpr std::size_t no_vertex = std::numeric_limits<std::size_t>::max();

// Which vertex of the repaired soup each given one is, no_vertex if none; and which given one each repaired one was, or is
// a copy of. Of those that have been merged, that is the one with the lowest number. An added one can be between two.
struct Repair_result
{
  std::vector<std::size_t> new_vertices, old_vertices, other_ends;
  Repair_counts counts;
};

// Leaves out the faces with a vertex at two corners or fewer than three corners, and then those that repeat an earlier
// one in the same orientation; the soup keeps how many there were. The numbers of findings are those before.
void leave_out_degenerate_faces(Polygons& polygons, Input_findings& findings);
void leave_out_repeated_faces(Polygon_soup& soup, Input_findings& findings);

// The number in the file of a face that has not been left out.
std::size_t number_in_file(std::size_t face, const Input_findings& findings);

// Repairs the points and polygons of a soup, whose vertices exist, whose faces have no vertex at two corners, and none of
// which repeats another one in the same orientation. Throws std::runtime_error if the distance is not positive and finite,
// or the share is none.
Repair_result repair_soup(Polygon_soup& soup, const Repair_options& options);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_REPAIR_SOUP_H
