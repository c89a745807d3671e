// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_SKELETON_H
#define CGAL_REEB_GRAPH_SRC_SKELETON_H

#include "base/surface.h"

#include <CGAL/Reeb_graph/skeleton/Curve_skeleton.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace reeb_graph_program {
struct Skeleton_settings
{
  double pruning_ratio = 0.5;
  double sampling_ratio = 0.5;
  bool are_borders_ends = true;
};

// A curve skeleton by numbers.
struct Skeleton
{
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  std::vector<Point> points;
  std::vector<double> radii, inscribed_radii;
  std::vector<std::vector<std::size_t>> arcs; // points from node to node
  std::vector<std::size_t> vertex_map;        // the point of each vertex of the surface, or none
  CGAL::Reeb_graph::Skeleton_certificate certificate = {};
};

// By contours of a field, or, without any, by distances.
Skeleton extract_skeleton(const Surface& surface,
                          const std::optional<Scalar_map>& scalar_map,
                          const Skeleton_settings& settings);

// The component of each arc, in the order of their first arcs, and how many arcs lead there from the first node of that.
struct Arc_place
{
  std::size_t component = 0, depth = 0;
};
std::vector<Arc_place> places_of_arcs(const Skeleton& skeleton);

// What tables say of an arc. Radii are means by length, but for the least and the greatest one.
struct Skeleton_arc_row
{
  std::size_t from, to, component;
  double length = 0, radius = 0, least_radius = 0, greatest_radius = 0, inscribed_radius = 0;
};
std::vector<Skeleton_arc_row> rows_of_arcs(const Skeleton& skeleton);

// The distance of each point along the lines from a root of its component, an end if there is one.
std::vector<double> distances_along_lines(const Skeleton& skeleton);

// The points of each arc.
std::vector<Polyline> polylines_of(const Skeleton& skeleton);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_SKELETON_H
