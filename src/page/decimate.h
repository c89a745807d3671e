// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_DECIMATE_H
#define CGAL_REEB_GRAPH_SRC_DECIMATE_H

#include "base/surface.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace reeb_graph_program {
typedef Surface::Property_map<Surface::Vertex_index, Surface::Vertex_index> Origin_map;

// A surface whose vertices are some of those of another one.
struct Decimated_surface
{
  Surface surface; // without garbage; faces have the patches of the map that has been given
  Origin_map origin_map;
  std::optional<Patch_map> patch_map;
};

// Collapses edges into one of their ends, those first that change the shape least, until few enough faces are left. The
// vertices that are named, and those on borders and between patches, stay.
Decimated_surface decimate(const Surface& surface,
                           std::size_t number_of_faces,
                           const std::vector<Surface::Vertex_index>& vertices_to_keep,
                           const std::optional<Patch_map>& patch_map);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_DECIMATE_H
