// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_CURVES_H
#define CGAL_REEB_GRAPH_SRC_CURVES_H

#include "base/options.h"
#include "base/surface.h"
#include "computation/Mesh_graph.h"

#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/fields/make_borders_level.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace reeb_graph_program {
// A curve of a level.
struct Level_curve
{
  double value = 0;
  bool is_closed = false;
  // An edge beside it that the contour crosses which is next to it, from its lower to its higher vertex. A curve inside
  // of a plateau has none.
  std::optional<std::array<std::size_t, 2>> crossed_edge;
  bool is_above = true; // whether this contour is above the level
};

struct Cut_result
{
  std::vector<Polyline> polylines; // of the curves
  Patch_map patch_map;
  std::size_t number_of_patches = 0;
  CGAL::Reeb_graph::Border_level_changes border_changes; // of the field
  // Of levels.
  std::vector<Level_curve> level_curves; // in the order of the polylines
  std::optional<Patch_map> band_map;
  std::optional<CGAL::Reeb_graph::Level_cut_report> level_report;
  // Of disks: the vertex that each vertex was.
  std::optional<Vertex_property<std::int32_t>> original_map;
};

// Makes the borders levels of the field if that is asked for, refines the surface, and finds the curves and the patches
// between them. The properties are interpolated at vertices that are added. The callback is told the number of triangles
// of the cut surface before it is cut, and may refuse it.
Cut_result cut_along_curves(Surface& surface,
                            Scalar_map scalar_map,
                            const std::vector<Any_vertex_property>& properties,
                            const Cut_options& options,
                            const std::function<bool(std::size_t)>& face_count_callback);

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

#endif // CGAL_REEB_GRAPH_SRC_CURVES_H
