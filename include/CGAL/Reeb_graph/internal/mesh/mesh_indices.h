// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_MESH_MESH_INDICES_H
#define CGAL_REEB_GRAPH_INTERNAL_MESH_MESH_INDICES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <cstddef>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Names of the elements of a mesh. The stages know nothing else of them.
struct Vertex_tag;
struct Halfedge_tag;
struct Edge_tag;
struct Face_tag;
struct Triangle_tag;
typedef Index_of<Vertex_tag> Vertex_index;
typedef Index_of<Halfedge_tag> Halfedge_index;
typedef Index_of<Edge_tag> Edge_index;
typedef Index_of<Face_tag> Face_index;
typedef Index_of<Triangle_tag> Triangle_index; // of a complex that may be no surface

// The two halfedges of edge e are 2 e and 2 e + 1.
constexpr Edge_index edge_of(Halfedge_index halfedge) { return Edge_index(halfedge.number() / 2); }
constexpr Halfedge_index opposite_of(Halfedge_index halfedge) { return Halfedge_index(halfedge.number() ^ 1); }
constexpr Halfedge_index even_halfedge(Edge_index edge) { return Halfedge_index(std::size_t(2) * edge.number()); }

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_MESH_MESH_INDICES_H
