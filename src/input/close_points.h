// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_CLOSE_POINTS_H
#define CGAL_REEB_GRAPH_SRC_CLOSE_POINTS_H

#include "base/input_findings.h"
#include "input/Polygon_soup.h"

#include <vector>

namespace reeb_graph_program {
// The points of edges that one polygon has, in ascending order.
std::vector<Corner> border_points(const Polygons& polygons);

// Counts those of the points that coincide with another one of them, or lie close to one.
Close_points count_close_points(const std::vector<Point>& points, const std::vector<Corner>& candidates);

// For all points the one that each joins: itself, or for a candidate the nearest one of those before it that have joined
// none themselves, if that is within the distance; of several, the first one. A distance of 0 joins points that coincide,
// for which the signs of zeros do not matter.
std::vector<Corner> join_close_points(const std::vector<Point>& points,
                                      const std::vector<Corner>& candidates,
                                      double distance);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_CLOSE_POINTS_H
