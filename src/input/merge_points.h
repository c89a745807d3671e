// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_MERGE_POINTS_H
#define CGAL_REEB_GRAPH_SRC_MERGE_POINTS_H

#include "base/input_findings.h"
#include "input/Polygon_soup.h"

#include <algorithm>
#include <cmath>
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

// The points of edges that one polygon has, in ascending order.
std::vector<Corner> border_points(const Polygons& polygons);

bool has_edge_of_many_faces(const Polygons& polygons);

// The diagonal of the box of all points.
long double diagonal_of(const std::vector<Point>& points);

// Counts those of the points that coincide with another one of them, or lie close to one.
Close_points count_close_points(const std::vector<Point>& points, const std::vector<Corner>& candidates);

// Counts those of borders, too, that lie on an edge of a border that they are no ends of.
void count_points_on_edges(const Polygon_soup& soup, const std::vector<Corner>& border_points, Close_points& result);

// A distance that is said to users: a little larger than this one.
inline double power_of_ten_above(long double distance)
{
  return std::pow(10., std::ceil(static_cast<double>(std::log10(1.01L * distance))));
}

// For all points the one that each joins: itself, or for a candidate the nearest one of those before it that have joined
// none themselves, if that is within the distance; of several, the first one. A distance of 0 joins points that coincide,
// for which the signs of zeros do not matter.
std::vector<Corner> join_close_points(const std::vector<Point>& points,
                                      const std::vector<Corner>& candidates,
                                      double distance);

// The first vertex at two corners, none if there is none. `sorted` is room that calls share.
inline std::optional<Corner> find_repeated_vertex(Polygons::Polygon polygon, std::vector<Corner>& sorted)
{
  if(polygon.size() == 3)
  {
    const Corner* const v = polygon.begin();
    return v[0] == v[1] || v[0] == v[2] ? std::make_optional(v[0])
         : v[1] == v[2]                 ? std::make_optional(v[1])
                                        : std::nullopt;
  }
  sorted.assign(polygon.begin(), polygon.end());
  std::sort(sorted.begin(), sorted.end());
  const auto repeated = std::adjacent_find(sorted.begin(), sorted.end());
  return repeated == sorted.end() ? std::nullopt : std::make_optional(*repeated);
}

// The vertex that each one becomes if coinciding points are merged wherever that makes neither a new edge with more than two
// faces nor a new point with several fans. Of those that become one, it is the first one. They are merged along whole
// edges: faces that touch in a point stay apart. So do faces that no orientation fits, if what is cut there is to stay so.
std::vector<Corner> merge_coinciding_points(const Polygon_soup& soup, bool is_cut_kept);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_MERGE_POINTS_H
