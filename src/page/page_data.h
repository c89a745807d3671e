// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_PAGE_DATA_H
#define CGAL_REEB_GRAPH_SRC_PAGE_DATA_H

#include "base/Arc_table.h"
#include "base/Field_label.h"
#include "base/report.h"
#include "base/surface.h"
#include "computation/simplification.h"
#include "page/display_surface.h"
#include "page/page_graph.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace reeb_graph_program {
// What the data of a page are made of: a graph on its surface, with patches and curves if there are any.
struct Page_subject
{
  const Augmentation& augmentation;       // the way from the graph to the surface
  const std::vector<std::size_t>& places; // of the vertices, by their indices
  const Arc_table& arc_table;
  Scalar_map scalar_map;
  std::string title;
  Field_label field_label;
  std::string up = {}; // x, y, z, -x, -y, -z, or empty
  std::optional<Patch_map> patch_map = std::nullopt;
  std::vector<Polyline> curves = {};
  std::vector<Loop_row> loops = {}; // what each curve is, if they are handles, tunnels and the like

  const Surface& surface() const { return augmentation.mesh(); }
  const Graph& graph() const { return augmentation.graph(); }
};

// The data of the page, which its script src/page/data.js reads.
//
// Arrays of numbers that belong to the surface are base64 codes of little-endian numbers. All points are relative to
// surface.origin. A number that JSON does not have is one of the strings "Infinity", "-Infinity" and "NaN", for which
// JavaScript's Number() returns it; field.lowest and field.highest are always finite, with room for infinite values,
// and so are the heights in the plane.
//
// What is measured of arcs, each arc has under the names of `columns`, which say in which unit it is.
//
// The graph is told from the one that was asked for by is_simplified; arcs_of_input counts the arcs of that.
//
// A chain is a sequence of vertices, of which each pair of neighbours is an ascending edge, but where a chain consists
// of several pieces. For any level that an arc crosses, the edge to start its contour at leads from the last vertex of
// the chain that is below the level to the vertex that follows.
//
// `skeleton` has the counts of a skeleton, and is null for a Reeb graph. Nodes of skeletons know their points by number in
// the place of vertices, and arcs, which have neither chains nor contours, rise and fall in the plane where a loop closes.
nlohmann::ordered_json page_data(const Page_subject& subject);

// What all pages have: this, and then the surface.
nlohmann::ordered_json begin_data(const std::string& title,
                                  const std::string& up,
                                  const Field_label& field,
                                  const Value_scale& value_scale);
nlohmann::ordered_json page_surface(std::size_t number_of_faces,
                                    const Display_surface& surface,
                                    const Page_frame& frame);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_PAGE_DATA_H
