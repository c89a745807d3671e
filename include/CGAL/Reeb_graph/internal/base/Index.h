// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_INDEX_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_INDEX_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Vertices, edges and halfedges are numbered by 32-bit integers: half the memory traffic of the sweeps.
typedef std::uint32_t Index;
inline constexpr Index no_index = (std::numeric_limits<Index>::max)();

inline Index checked_index(std::size_t i)
{
  if(i >= no_index)
    throw Mesh_size_error();
  return static_cast<Index>(i);
}

// The two halfedges of edge e are 2 e and 2 e + 1.
constexpr Index edge_of(Index halfedge) { return halfedge / 2; }
constexpr Index opposite_of(Index halfedge) { return halfedge ^ 1; }

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_INDEX_H
