// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_BUILD_MESH_H
#define CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_BUILD_MESH_H

#include "generated_surfaces/Triangle_soup.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/properties.h>

#include <array>
#include <vector>

namespace generated_surfaces {
template <class Mesh>
typename boost::graph_traits<Mesh>::vertex_descriptor add_point(Mesh& mesh, const std::array<double, 3>& p)
{
  const auto v = add_vertex(mesh);
  typedef
    typename boost::property_traits<typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type Point;
  put(get(CGAL::vertex_point, mesh), v, Point(p[0], p[1], p[2]));
  return v;
}

// Appends the vertices in the order of the points, and the faces in the order of the triangles.
template <class Mesh>
void build(Mesh& mesh, const Triangle_soup& soup)
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  reserve(mesh, soup.points.size(), soup.points.size() + soup.triangles.size(), soup.triangles.size());
  std::vector<vertex_descriptor> vertices;
  vertices.reserve(soup.points.size());
  for(const auto& p : soup.points)
    vertices.push_back(add_point(mesh, p));
  for(const auto& t : soup.triangles)
    CGAL::Euler::add_face(std::array<vertex_descriptor, 3>{vertices[t[0]], vertices[t[1]], vertices[t[2]]}, mesh);
}

template <class Mesh>
Mesh make_mesh(const Triangle_soup& soup)
{
  Mesh mesh;
  build(mesh, soup);
  return mesh;
}

} // namespace generated_surfaces

#endif // CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_BUILD_MESH_H
