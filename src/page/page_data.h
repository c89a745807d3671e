// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_PAGE_DATA_H
#define CGAL_REEB_GRAPH_SRC_PAGE_DATA_H

#include "base/options.h"
#include "base/report.h"
#include "base/surface.h"
#include "computation/Mesh_graph.h"
#include "computation/simplification.h"
#include "computation/skeleton.h"

#include <CGAL/Reeb_graph/internal/drawing/Value_scale.h>

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace reeb_graph_program {
// The place and the size of the picture.
struct Page_frame
{
  // Throws std::runtime_error if a coordinate is infinite, NaN, or of a size that no picture has.
  explicit Page_frame(const Surface& surface);

  // The coordinates of a point in the page, with digits for a millionth of the size.
  std::array<double, 3> coordinates(const Point& point) const;

  // A coordinate or a length with as many digits.
  double rounded(double number) const;

  // The centre of the surface where the coordinates have too few digits in single precision, else 0.
  std::array<double, 3> origin = {0, 0, 0};
  double digits = 1; // a power of ten: the coordinates are rounded to multiples of its inverse
};

// A surface, its field, and where its vertices are in a graph.
struct Shown_surface
{
  const Surface& surface;
  Scalar_map scalar_map;
  const std::vector<std::size_t>& places; // of the vertices, by their indices: nodes, and then arcs
  std::size_t number_of_nodes;
  std::vector<Surface::Vertex_index> vertices_to_keep;
  std::optional<Patch_map> patch_map;
};

// The surface as the page shows it.
struct Display_surface
{
  std::vector<float> positions;          // three for each vertex
  std::vector<double> values;            // of the field
  std::vector<std::uint32_t> triangles;  // three vertices for each face
  std::vector<std::int32_t> vertex_arcs; // the number of an arc, or -1 - that of a node
  std::optional<std::vector<std::int32_t>> face_patches;
  bool is_decimated = false;
  std::vector<std::uint32_t> new_numbers; // of the vertices by their indices; empty if the surface is decimated
};

// A surface of more than 200000 faces is decimated.
Display_surface display_surface(const Shown_surface& shown, const Page_frame& frame);

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

// The graph, and simplified graphs for thresholds that ascend, loops cancelled: all there are if they are few, else those of ticks,
// those of the largest thresholds, and some of the others.
nlohmann::ordered_json page_levels(const Embedded_graph& given,
                                   const Page_frame& frame,
                                   const Value_scale& value_scale);

// The thresholds that matter, each with the last of these levels that it reaches, and whether it is the suggested one.
nlohmann::ordered_json page_ticks(const Graph& graph, const nlohmann::ordered_json& levels);

// What a page is written of: a graph on its surface, with patches and curves if there are any.
struct Page_request
{
  Scalar_map scalar_map;
  Mesh_graph& graph; // of a surface
  std::string title;
  Field_label field_label;
  Simplification_options simplification = {}; // that of the graph
  std::string up = {};                        // which way is up: x, y, z, -x, -y, -z, or as the page finds it
  std::optional<Patch_map> patch_map = std::nullopt;
  std::vector<Polyline> curves = {};
  std::vector<Loop_row> loops = {}; // what each curve is, if they are handles, tunnels and the like
};

// Two shapes, and which of their arcs are partners, by their numbers.
struct Page_of_shapes
{
  Page_request a, b;
  std::vector<std::pair<std::size_t, std::size_t>> partners;
  double distance;
};

// The data of the page, which its script src/page/data.js reads, with a graph that may be smaller than that of the request.
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
// the place of vertices, and arcs, which have neither chains nor contours, rise and fall in the plane where a loop closes. These
// have the two radii of each point, and, of each segment, whether it lies in a junction.
nlohmann::ordered_json page_data(const Page_request& request, Mesh_graph& shown);

// The data of the one shape, with those of the other one as `other`, and what they have in common. Neither has levels but
// the first.
nlohmann::ordered_json page_data(const Page_of_shapes& page);

// What the data of the page of a skeleton are made of.
struct Page_of_skeleton
{
  Surface& surface; // gets the distances along the lines, which the page has as its field, as a property
  const Skeleton& skeleton;
  std::string title;
  std::string unit; // of lengths
  std::string up = {};
};

// The data of the page, in which the skeleton is the graph: its arcs have neither chains nor contours, and rise and fall in
// the plane where they close a loop. Nodes have the number of their point in the place of a vertex. `skeleton` has counts.
nlohmann::ordered_json page_data(const Page_of_skeleton& page);

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
