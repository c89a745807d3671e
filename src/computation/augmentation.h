// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_AUGMENTATION_H
#define CGAL_REEB_GRAPH_SRC_AUGMENTATION_H

#include "base/options.h"
#include "base/surface.h"

#include <cstddef>
#include <vector>

namespace reeb_graph_program {
// The place of each vertex in the graph that was computed with `options`: the number of a node, or, from the number of
// nodes on, that of an arc. They are numbered as in the graph files.
std::vector<std::size_t> locate_vertices(const Surface& surface,
                                         Scalar_map scalar_map,
                                         const Graph& graph,
                                         const Graph_options& options);

// The contour of the arc number `arc` at the place `t` between 0 and 1. Throws an exception if there is none.
std::vector<Polyline> contour_of_arc(const Surface& surface,
                                     Scalar_map scalar_map,
                                     const Graph_options& options,
                                     std::size_t arc,
                                     double t);

// All contours at a level, none if no arc is alive there.
std::vector<Polyline> contours_at_level(const Surface& surface,
                                        Scalar_map scalar_map,
                                        const Graph_options& options,
                                        double level);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_AUGMENTATION_H
