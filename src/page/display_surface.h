// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_DISPLAY_SURFACE_H
#define CGAL_REEB_GRAPH_SRC_DISPLAY_SURFACE_H

#include "base/surface.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace reeb_graph_program {
// The place and the size of the picture.
struct Page_frame
{
  // Throws std::runtime_error if a coordinate is infinite, NaN, or of a size that no picture has.
  explicit Page_frame(const Surface& surface);

  // The coordinates of a point in the page, with digits for a millionth of the size.
  std::array<double, 3> coordinates(const Point& point) const;

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

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_DISPLAY_SURFACE_H
