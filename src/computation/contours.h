// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_CONTOURS_H
#define CGAL_REEB_GRAPH_SRC_CONTOURS_H

#include "base/options.h"
#include "base/surface.h"

#include <array>
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
  std::vector<double> levels;                  // of which some may have no contour
  std::optional<std::size_t> number_of_levels; // that cut the range of the field into equal steps
  std::optional<Point> point;
  bool may_be_none = false; // else it is an error if there is no contour
};

// A contour of a surface or of a complex. Each point is on the edge of the same number, and that leads from its lower to
// its higher vertex.
struct Contour
{
  static constexpr std::size_t no_arc = static_cast<std::size_t>(-1);

  std::size_t arc = 0;    // by its number; no_arc for a curve in a plateau
  double value = 0;       // of the level
  bool is_closed = false; // whether it is one closed line
  std::vector<std::array<std::size_t, 2>> edges;
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polylines;   // of points; if one is closed, its first point is its last one too
  std::vector<std::array<std::size_t, 3>> triangles; // of points: in tetrahedra, instead of polylines
};

// What a node stands for.
struct Critical_set
{
  std::vector<Contour> lower_contours, upper_contours; // one for each arc
  std::vector<std::size_t> star;                       // the faces or tetrahedra at the vertex
  std::vector<std::size_t> border_loop;                // the vertices of the border that is in the level of the node
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_CONTOURS_H
