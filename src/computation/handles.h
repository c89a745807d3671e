// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_HANDLES_H
#define CGAL_REEB_GRAPH_SRC_HANDLES_H

#include "base/options.h"
#include "base/report.h"
#include "base/surface.h"
#include "computation/Mesh_graph.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace reeb_graph_program {
struct Loops_of_surface
{
  std::vector<Loop_row> rows;
  std::vector<Polyline> polylines;    // in the same order
  std::size_t self_intersections = 0; // pairs of faces
};

// The place of a closed polyline, without vertices.
Loop_place place_of(const Polyline& polyline);

// Removes the handles that are smaller than a size, if one is given, at most so many, the smallest ones. Properties are
// carried over. Percents are those of the diagonal of the box of the faces.
std::vector<Removal_row> remove_handles(Surface& surface,
                                        Scalar_map scalar_map,
                                        const std::vector<Any_vertex_property>& properties,
                                        const std::optional<Threshold>& size,
                                        std::size_t number,
                                        bool are_self_intersections_ignored);

// Handles, tunnels, holes, and loops of what has no inside.
Loops_of_surface find_loops(const Surface& surface,
                            Scalar_map scalar_map,
                            bool are_shortened,
                            bool are_self_intersections_ignored);

// Writes the coordinate, of the three, whose extrema have the least persistence in all, and returns its name.
std::string write_least_rough_height(const Surface& surface, Scalar_map scalar_map);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_HANDLES_H
