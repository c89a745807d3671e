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

#include <CGAL/Reeb_graph/internal/base/descriptors.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphScalarMaps
///
/// \brief returns a property map from the vertices of a mesh to their positions in `vertices(mesh)`, from 0.
///
/// It serves where a mesh has no indices of its own, such as a plain `Polyhedron_3`, or where its indices have holes.
/// The mesh is only read, so that several threads may call this function for one mesh. The map holds the positions: it
/// is that of the mesh as it is now, and copies of it share them. Several threads may read it; what is not one of the mesh
/// has the greatest number of the type.
template <class FaceListGraph>
auto make_vertex_index_map(const FaceListGraph& mesh)
{
  typedef typename boost::graph_traits<FaceListGraph>::vertex_descriptor vertex_descriptor;
  internal::Descriptor_numbers<vertex_descriptor, std::size_t> map(num_vertices(mesh));
  for(const auto v : CGAL::make_range(vertices(mesh)))
    map.add(v);
  return map;
}

/// \ingroup PkgReebGraphScalarMaps
///
/// \brief returns a property map from the halfedges of a mesh to their positions in `halfedges(mesh)`, from 0; else as
/// `make_vertex_index_map()`.
template <class FaceListGraph>
auto make_halfedge_index_map(const FaceListGraph& mesh)
{
  typedef typename boost::graph_traits<FaceListGraph>::halfedge_descriptor halfedge_descriptor;
  internal::Descriptor_numbers<halfedge_descriptor, std::size_t> map(num_halfedges(mesh));
  for(const auto h : CGAL::make_range(halfedges(mesh)))
    map.add(h);
  return map;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_INDEX_MAPS_H
