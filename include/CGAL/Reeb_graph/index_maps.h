// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INDEX_MAPS_H
#define CGAL_REEB_GRAPH_INDEX_MAPS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>

namespace CGAL {
namespace Reeb_graph {

/// \ingroup PkgReebGraphScalarMaps
///
/// \brief returns a property map from the vertices of a mesh to their positions in `vertices(mesh)`, from 0.
///
/// It serves where a mesh has no indices of its own, such as a plain `Polyhedron_3`, or where its indices have holes.
/// The mesh is only read, so that several threads may call this function for one mesh. The map holds the positions: it
/// is that of the mesh as it is now, and copies of it share them.
template <class FaceListGraph>
auto make_vertex_index_map(const FaceListGraph& mesh)
{
  auto map = get(dynamic_vertex_property_t<std::size_t>(), mesh);
  std::size_t number = 0;
  for(const auto v : CGAL::make_range(vertices(mesh)))
    put(map, v, number++);
  return map;
}

/// \ingroup PkgReebGraphScalarMaps
///
/// \brief returns a property map from the halfedges of a mesh to their positions in `halfedges(mesh)`, from 0; else as
/// `make_vertex_index_map()`.
template <class FaceListGraph>
auto make_halfedge_index_map(const FaceListGraph& mesh)
{
  auto map = get(dynamic_halfedge_property_t<std::size_t>(), mesh);
  std::size_t number = 0;
  for(const auto h : CGAL::make_range(halfedges(mesh)))
    put(map, h, number++);
  return map;
}

} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INDEX_MAPS_H
