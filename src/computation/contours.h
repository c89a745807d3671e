// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_CONTOURS_H
#define CGAL_REEB_GRAPH_SRC_CONTOURS_H

#include "base/options.h"
#include "base/surface.h"

#include <CGAL/squared_distance_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace reeb_graph_program {
// Which contours of which graph: those at the place `t`, those at the levels, or the one closest to a point.
struct Contour_choice
{
  Graph_options graph;
  Simplification_options simplification;
  std::optional<double> t;                     // between 0 and 1 on each arc
  std::optional<std::size_t> arc;              // with t: the only arc
  std::vector<double> levels;                  // each has to have a contour
  std::optional<std::size_t> number_of_levels; // that cut the range of the field into equal steps
  std::optional<Point> point;
};

// A line of a contour.
struct Contour_line
{
  Polyline points;
  std::size_t arc = 0; // by its number
  double value = 0;    // of the level
  double length = 0;
  bool is_closed = false;
};

inline double length_of(const Polyline& points)
{
  double length = 0;
  for(std::size_t i = 1; i < points.size(); ++i)
    length += std::sqrt(CGAL::squared_distance(points[i - 1], points[i]));
  return length;
}

// Parts of level sets: curves in triangles, or triangles in tetrahedra.
struct Contours
{
  std::size_t number = 0;
  std::vector<Contour_line> lines; // on surfaces one for each contour
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_CONTOURS_H
