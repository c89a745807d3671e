// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_PAGE_GRAPH_H
#define CGAL_REEB_GRAPH_SRC_PAGE_GRAPH_H

#include "base/Arc_table.h"
#include "base/surface.h"
#include "page/display_surface.h"

#include <CGAL/Reeb_graph/internal/drawing/Value_scale.h>

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace reeb_graph_program {
typedef CGAL::Reeb_graph::internal::Value_scale Value_scale;

// A graph in space, with what is told of its arcs.
struct Embedded_graph
{
  const Graph& graph;
  std::vector<Point> node_points = {};
  std::vector<Polyline> arc_polylines = {}; // from the lower node to the upper one
  Arc_table arc_table = {};
};

// A number, or a string where JSON has none.
nlohmann::ordered_json number_or_string(double number);

// What is told of each arc.
nlohmann::ordered_json page_columns(const Arc_table& table);

// Adds the numbers of an arc.
void add_columns(const Arc_table& table, std::size_t arc, nlohmann::ordered_json& json);

// The coordinates of all points.
nlohmann::ordered_json flat_polyline(const Polyline& polyline, const Page_frame& frame);

// The columns and heights of a line in the plane.
nlohmann::ordered_json flat_drawing(const std::vector<std::array<double, 2>>& drawing, const Value_scale& value_scale);

// The nodes and arcs, without what leads from arcs to the surface.
nlohmann::ordered_json page_graph(const Embedded_graph& embedded,
                                  const Page_frame& frame,
                                  const Value_scale& value_scale);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_PAGE_GRAPH_H
