// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_DECIMATE_H
#define CGAL_REEB_GRAPH_SRC_DECIMATE_H

#include "base/surface.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace reeb_graph_program {
// The faces that a page shows.
struct Shown_faces
{
  std::vector<std::uint32_t> corners; // three indices of vertices of the surface for each face
  std::optional<std::vector<std::int32_t>> patches;
};

Shown_faces all_faces(const Surface& surface, const std::optional<Patch_map>& patch_map);

// Collapses edges into one of their ends, those first that change the shape least, until few enough faces are left. The
// vertices that are named, and those on borders and between patches, stay. Patches come one after the other.
Shown_faces decimate(const Surface& surface,
                     std::size_t number_of_faces,
                     const std::vector<Surface::Vertex_index>& vertices_to_keep,
                     const std::optional<Patch_map>& patch_map);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_DECIMATE_H
