// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_HANDLES_SELF_INTERSECTIONS_H
#define CGAL_REEB_GRAPH_INTERNAL_HANDLES_SELF_INTERSECTIONS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/handles/Closed_surface.h>
#include <CGAL/Reeb_graph/internal/handles/Tree_and_cotree.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Whether two triangles of a component intersect, by number of the component. Others may pass through it.
inline std::vector<bool> find_self_intersections(const Closed_surface& surface, const Tree_and_cotree& trees)
{
  typedef Exact_predicates_inexact_constructions_kernel Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
  typedef Mesh::Face_index Face;
  Mesh mesh;
  const std::size_t number_of_faces = surface.number_of_given_halfedges / 3 + 1;
  mesh.reserve(surface.number_of_given_vertices, surface.number_of_given_halfedges / 2,
               static_cast<Mesh::size_type>(number_of_faces));
  for(Index v = 0; v != surface.number_of_given_vertices; ++v)
    mesh.add_vertex(Kernel::Point_3(surface.points[v][0], surface.points[v][1], surface.points[v][2]));
  std::vector<Index> components; // by face of the mesh
  for(const Index h : surface.halfedge)
  {
    const Index u = surface.source(h), v = surface.target[h], w = surface.target[surface.next[h]];
    if(surface.is_apex(u) || surface.is_apex(v) || surface.is_apex(w))
      continue;
    const Face f = mesh.add_face(Mesh::Vertex_index(u), Mesh::Vertex_index(v), Mesh::Vertex_index(w));
    if(f != Mesh::null_face()) // as it is if two edges join the same vertices
      components.push_back(trees.component_of(u));
  }
  std::vector<bool> result(trees.components().size(), false);
  Polygon_mesh_processing::self_intersections(
    mesh, boost::make_function_output_iterator([&](const std::pair<Face, Face>& faces) {
      const std::size_t a = faces.first, b = faces.second;
      if(components[a] == components[b])
        result[components[a]] = true;
    }));
  return result;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_HANDLES_SELF_INTERSECTIONS_H
