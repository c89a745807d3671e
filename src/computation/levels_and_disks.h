// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_LEVELS_AND_DISKS_H
#define CGAL_REEB_GRAPH_SRC_LEVELS_AND_DISKS_H

#include "base/options.h"
#include "base/surface.h"
#include "computation/Mesh_graph.h"
#include "computation/curves.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace reeb_graph_program {
// The values that are chosen. Throws std::runtime_error if they are no numbers, or too many.
std::vector<double> values_of_levels(const Level_choice& choice, Scalar_map scalar_map);

// Cuts the surface along the levels, and finds curves, pieces and bands. The properties are interpolated at vertices
// that are added. The callback is told the number of triangles before, and may refuse it.
Cut_result cut_along_levels(Surface& surface,
                            Scalar_map scalar_map,
                            const std::vector<Any_vertex_property>& properties,
                            const std::vector<double>& levels,
                            bool is_cut_open,
                            const std::function<bool(std::size_t)>& face_count_callback);

// The curves of a surface that has been cut, each with the arc of the contour next to it, on the higher side if there is
// one: of a graph of this surface.
std::vector<Contour> contours_of_levels(const Cut_result& result, Scalar_map scalar_map, Mesh_graph& graph);

// What the user may not expect: levels that have no curve.
std::vector<std::string> notes_on_levels(const std::vector<double>& levels,
                                         const Cut_result& result,
                                         Scalar_map scalar_map);

// Cuts each component of the surface to a disk. The properties are copied to vertices that are doubled.
Cut_result cut_to_disks(Surface& surface, std::vector<Any_vertex_property> properties);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_LEVELS_AND_DISKS_H
