// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_INPUT_FINDINGS_H
#define CGAL_REEB_GRAPH_SRC_INPUT_FINDINGS_H

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace reeb_graph_program {
// Points of border edges that may be meant to be one.
struct Close_points
{
  std::size_t coinciding = 0;            // with another one
  std::size_t close = 0;                 // to another one elsewhere
  double largest_distance = 0;           // that counts as close: a millionth of the diagonal of the box of all points
  std::size_t on_edges = 0;              // on the inside of a border edge, or as close to it: T-junctions
  double needed_distance = 0;            // at which repair joins these, a power of ten; 0 if all coincide
  bool have_edges_of_many_faces = false; // if those that coincide are one: bodies touch

  bool is_any() const { return coinciding + close + on_edges > 0; }
};

// What was seen when a mesh was read. Faces with a repeated corner or fewer than three, and those that repeat an earlier
// one in the same orientation, are left out; they have their numbers in the file.
struct Input_findings
{
  std::size_t faces = 0;                     // of the file
  std::vector<std::size_t> degenerate_faces; // those with a repeated corner, or fewer than three
  std::vector<std::size_t> repeated_faces;
  std::size_t faces_of_few_corners = 0;        // of the degenerate ones, those with fewer than three
  std::size_t points = 0, isolated_points = 0; // of no face, edge, or tetrahedron
  Close_points close_points;
  std::optional<std::size_t> inside_out_solids; // if they have been looked for

  bool is_point_cloud() const { return points > 0 && isolated_points == points; }
  std::size_t kept_faces() const { return faces - degenerate_faces.size() - repeated_faces.size(); }
};

// The command that merges the points, empty if there are none.
std::string suggested_repair(const Close_points& points);

// How much a field of the vertices differs at points that have been merged.
struct Merged_field
{
  std::string name;
  std::size_t differing_points = 0;
  double largest_difference = 0;
};

// What a mesh has, be it a surface or not. Components, borders and fans are those of a complex: the faces of an edge are
// joined, however many they are.
struct Mesh_counts
{
  std::size_t vertices = 0, edges = 0, faces = 0;
  std::size_t components = 0; // isolated vertices included
  std::size_t border_edges = 0;
  std::size_t border_loops = 0; // components of the border edges
  std::size_t edges_of_many_faces = 0, vertices_of_several_fans = 0;
  std::size_t edges_without_orientation = 0; // of two faces that run along it in the same direction

  long euler_characteristic() const { return static_cast<long>(vertices + faces) - static_cast<long>(edges); }
  bool is_surface() const { return edges_of_many_faces + vertices_of_several_fans + edges_without_orientation == 0; }
  // Of an oriented connected surface. A vertex alone has none.
  std::optional<long> genus() const
  {
    const long twice = 2 - euler_characteristic() - static_cast<long>(border_loops);
    return is_surface() && components == 1 && twice % 2 == 0 ? std::make_optional(twice / 2) : std::nullopt;
  }
};

// What a repair has done.
struct Repair_counts
{
  std::size_t merged_points = 0, unmerged_points = 0; // the latter coincide with others
  std::size_t stitched_points = 0;                    // that cut an edge
  std::size_t collapsed_faces = 0;                    // that a merged point is at two corners of
  std::size_t faces_repeated_by_merging = 0;
  std::size_t cancelled_faces = 0, sheets = 0;       // components that are both sides of a sheet, of which one stays
  std::size_t paired_edges = 0, unpaired_sides = 0;  // of more than two faces: with pairs, and sides that are cut open
  std::size_t added_points = 0, added_midpoints = 0; // by splitting: the latter are no copies
  std::size_t reversed_faces = 0;                    // so that neighbors agree
  std::size_t turned_solids = 0;                     // that were inside out, with all that lies in them
  std::size_t small_pieces = 0, pieces_without_volume = 0, faces_of_pieces = 0;
  std::size_t filled_borders = 0, filling_faces = 0;
  std::size_t other_faces = 0;       // than of the largest component
  std::size_t unused_points = 0;     // of no face, that are left out
  Mesh_counts given, merged, result; // given: but for the faces that are left out
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_INPUT_FINDINGS_H
