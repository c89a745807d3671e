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
#include "base/options.h"
#include "input/Polygon_soup.h"

#include <CGAL/Reeb_graph/internal/base/arrays.h>

#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <vector>

namespace reeb_graph_program {
class Union_find_of_indices
{
public:
  explicit Union_find_of_indices(std::size_t size) : parents_(size)
  {
    std::iota(parents_.begin(), parents_.end(), std::size_t(0));
  }
  std::size_t find(std::size_t i)
  {
    return CGAL::Reeb_graph::internal::find_root(i, [&](std::size_t j) -> std::size_t& { return parents_[j]; });
  }
  void unite(std::size_t i, std::size_t j) { parents_[find(i)] = find(j); }
  bool is_root(std::size_t i) const { return parents_[i] == i; }

private:
  std::vector<std::size_t> parents_;
};

// A side of a polygon, by its vertices in ascending order, and which corners of all polygons it has there. The order is
// that of edges.
struct Polygon_side
{
  Corner u, v;
  std::size_t corner_of_u, corner_of_v, face;
  bool is_descending; // along the polygon

  bool operator<(const Polygon_side& other) const { return std::tie(u, v) < std::tie(other.u, other.v); }
};

// Those of all polygons, edge by edge; within one, in the order of the polygons.
std::vector<Polygon_side> sides_of(const Polygons& polygons);

// Visits the sides of one edge after the other, as the numbers of the first one and of that behind the last one.
template <class Visit>
void for_each_edge(const std::vector<Polygon_side>& sides, const Visit& visit)
{
  for(std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    while(end < sides.size() && !(sides[begin] < sides[end]))
      ++end;
    visit(begin, end);
  }
}

Mesh_counts count_soup(const Polygons& polygons, std::size_t number_of_vertices);

// How many fans the faces at each vertex form.
std::vector<std::size_t> count_fans(const Polygons& polygons,
                                    const std::vector<Polygon_side>& sides,
                                    std::size_t number_of_vertices);

// The component of each polygon, by a vertex of it. Polygons with a common vertex are in one.
std::vector<std::size_t> components_of_polygons(const Polygons& polygons, std::size_t number_of_vertices);

// The faces of components with less than a share of the area, and of those that are closed and have no volume. In ascending
// order.
std::vector<std::size_t> faces_of_lesser_pieces(const Polygon_soup& soup, double least_share, Repair_counts& counts);

// Solids are closed pieces with a volume, whose faces agree, together with those that lie in them.
struct Inside_out
{
  std::size_t solids = 0;
  std::vector<char> is_inside_out; // of the faces
};

// Which solids are inside out: those whose outermost piece is. What lies in them is so, too, whichever way round: a cavity
// stays one if all is turned. An open piece is in none.
Inside_out find_inside_out(const Polygon_soup& soup);
std::size_t count_inside_out_solids(const Surface& surface);

// Which faces go on in each other at the edges.
struct Face_pairs
{
  std::vector<Polygon_side> sides;
  std::vector<std::size_t> mates; // of the sides, by their numbers; a side without another one is its own
  std::vector<char> is_turned;    // of the faces: which ones are to be reversed so that pairs agree, if that can be
};

// Pairs both faces of an edge of two, unless no orientation agrees there with the other ones.
Face_pairs pair_two_faces(const Polygons& polygons);

// Pairs those, and where there are more, each face that runs along the edge goes on in one that runs against it: in the order of their angles, across gaps outside,
// so that what two solids share does not part them. Each decision is exact.
Face_pairs pair_faces(const Polygon_soup& soup);

// Cuts the mesh open where faces are not paired: each fan of pairs gets a vertex of its own, the first one the given one.
// Where edges at one place then have both ends in common, each gets a midpoint. Returns two given vertices for each vertex
// that is added behind the others: a copy has the same one twice, a midpoint the ends of its edge.
std::vector<std::array<Corner, 2>> split_at_pairs(Polygon_soup& soup, const Face_pairs& pairs, Repair_counts& counts);

// Cuts sides of borders at points of borders that are at most so far from their inside: where those are corners of other
// faces already, nothing moves. What is a triangle becomes triangles. Returns the number of cuts.
std::size_t cut_at_junctions(Polygon_soup& soup, double distance);

// Besides leaving faces out, in this order.
struct Repair_options
{
  bool are_coinciding_points_merged = false;
  std::optional<double> distance;     // within which points of borders are merged
  std::optional<Threshold> stitching; // the distance within which borders are joined: points, and points with edges
  bool are_opposite_faces_cancelled = false; // one by one, those with the same corners
  bool are_faces_triangulated = false;       // after that, as both sides of a polygon can be cut in different ways
  bool is_split = false; // where an edge has more than two faces, a vertex several fans, or no orientation fits
  bool are_faces_oriented = false; // so that neighbors agree, and no solid is inside out
  double least_share = 0; // of the area: smaller components go, and closed ones without volume, if it is positive
  std::size_t most_filled_edges = 0; // of a border that is filled
  bool is_largest_kept = false;      // the component with the most faces, of several the first one, alone
  bool are_unused_points_left_out = false;
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
// which repeats another one in the same orientation. Throws std::runtime_error if a distance is not positive and finite,
// or the share is none.
Repair_result repair_soup(Polygon_soup& soup, const Repair_options& options);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_REPAIR_SOUP_H
