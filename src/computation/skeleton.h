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
#include <CGAL/Reeb_graph/skeleton/measure_branches.h>
#include <CGAL/Reeb_graph/skeleton/skeleton_trees.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace reeb_graph_program {
// A place of a skeleton: a vertex of the surface, a point, the thickest point, or all tips.
struct Skeleton_place
{
  enum Kind
  {
    VERTEX,
    POINT,
    THICKEST,
    TIPS
  };
  Kind kind = TIPS;
  std::size_t vertex = 0;
  Point point = CGAL::ORIGIN;
};

// Where a given point is: the point of the skeleton that is nearest to it, and how far it is from the lines.
struct Place_of_point
{
  Point given;
  std::size_t point = 0;
  double distance = 0;
};

struct Skeleton_settings
{
  double pruning_ratio = 0.5;
  double sampling_ratio = 0.5;
  bool are_borders_ends = true;
  double smooth = 1;
  double spacing = 0;                                // of points, if they are to be at equal steps
  std::optional<Skeleton_place> root = std::nullopt; // of trees
};

// What can be chosen of SWC: its radii, and the type of what is no soma. Programs refuse the type 0, and 1 is that of a soma.
struct Swc_options
{
  static constexpr std::size_t least_type = 2, largest_type = (std::numeric_limits<std::int32_t>::max)();

  bool are_radii_inscribed = false;
  std::size_t type = 3;
};

// A curve skeleton by numbers.
struct Skeleton
{
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  CGAL::Reeb_graph::Curve_skeleton<Surface> graph;
  std::vector<std::vector<std::size_t>> arcs; // points from node to node
  std::vector<CGAL::Reeb_graph::Skeleton_record> trees;
  std::vector<CGAL::Reeb_graph::Skeleton_branch> branches; // what is measured of each arc
  std::vector<std::size_t> vertex_map;                     // the point of each vertex of the surface, or none
  std::vector<std::size_t> face_arcs;                      // of each face
  std::vector<char> are_faces_in_junctions;
  std::size_t soma = none; // the record of the thickest point, if it is the root of the largest tree
  std::vector<std::vector<std::size_t>> paths; // that are asked for
  std::vector<Place_of_point> places;          // of the points that they lead from, or to
  CGAL::Reeb_graph::Skeleton_certificate certificate = {};
  std::size_t number_inside_out = 0; // components
};

// By contours of a field, or, without any, by distances.
Skeleton extract_skeleton(const Surface& surface,
                          const std::optional<Scalar_map>& scalar_map,
                          const Skeleton_settings& settings);

// Finds the arcs, the trees, and what is measured of them but for areas and volumes.
void complete(Skeleton& skeleton, const std::optional<Skeleton_place>& root = std::nullopt);

// The points of the skeleton at a place: for a point, the nearest one. If some are of no use, the first ones come first. Throws
// std::runtime_error if the surface has no such vertex, or no face at it.
std::vector<std::size_t> points_at(const Skeleton& skeleton, const Skeleton_place& place);

// Finds the shortest ways along the skeleton from some places to others, and where the points among these are.
void find_paths(Skeleton& skeleton, const std::vector<Skeleton_place>& from, const std::vector<Skeleton_place>& to);

double length_of_path(const Skeleton& skeleton, const std::vector<std::size_t>& path);

// What is said of all branches.
struct Skeleton_numbers
{
  double cable_length = 0;
  double area = 0, volume = 0, junction_area = 0, junction_volume = 0;
  std::optional<double> mean_tortuosity; // of arcs that are not closed, if there are any
  std::size_t order = 0;                 // the highest Strahler number
};
Skeleton_numbers numbers_of(const Skeleton& skeleton);

// The distance of each point along the lines from a root of its component, an end if there is one.
std::vector<double> distances_along_lines(const Skeleton& skeleton);

// The points of each arc, or of the paths, if there are any.
std::vector<Polyline> polylines_of(const Skeleton& skeleton);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_SKELETON_H
