// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_INTERNAL_DISC_OF_LOOP_H
#define CGAL_REEB_GRAPH_HANDLES_INTERNAL_DISC_OF_LOOP_H

#include <CGAL/license/Reeb_graph.h>

// Algorithms of Boost.Graph that look up get() for pointers as they are defined: they come first, as triangulate_hole.h of
// CGAL 6 includes compressed_sparse_row_graph.hpp, whose boost::detail::get() would hide that function from them.
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>

#include <CGAL/Reeb_graph/handles/internal/Placed_triangle.h>

#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/number_utils.h>
#include <CGAL/utility.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

template <class VertexDescriptor, class PointMap>
Disc_point disc_point(VertexDescriptor v, const PointMap& point_map)
{
  const auto& p = get(point_map, v);
  return Disc_point(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

template <class Mesh>
std::array<typename boost::graph_traits<Mesh>::vertex_descriptor, 3> face_corners(
  typename boost::graph_traits<Mesh>::face_descriptor f,
  const Mesh& mesh)
{
  const auto h = halfedge(f, mesh);
  return {source(h, mesh), target(h, mesh), target(next(h, mesh), mesh)};
}

template <class Mesh, class PointMap>
Disc_kernel::Triangle_3 face_triangle(typename boost::graph_traits<Mesh>::face_descriptor f,
                                      const Mesh& mesh,
                                      const PointMap& point_map)
{
  const auto [u, v, w] = face_corners(f, mesh);
  return {disc_point(u, point_map), disc_point(v, point_map), disc_point(w, point_map)};
}

// Triangulating a loop of more edges takes too long, as it takes more than linear time.
inline constexpr std::size_t largest_loop_of_disc = 1000;

// A disc of triangles with little area that spans a closed polyline, by positions of its points. Empty if there
// is none, or if the polyline has less than 3 or more than 1000 points. `third_points`, if there are any, are those of the
// triangles that its segments have on one side: the disc avoids to fold back on these.
inline std::vector<std::array<std::size_t, 3>> triangulate_disc(const std::vector<Disc_point>& polyline,
                                                                const std::vector<Disc_point>& third_points = {})
{
  std::vector<std::array<std::size_t, 3>> result;
  if(polyline.size() < 3 || polyline.size() > largest_loop_of_disc)
    return result;
  std::vector<CGAL::Triple<int, int, int>> triangles;
  if(third_points.empty())
    Polygon_mesh_processing::triangulate_hole_polyline(polyline, std::back_inserter(triangles));
  else
    Polygon_mesh_processing::triangulate_hole_polyline(polyline, third_points, std::back_inserter(triangles));
  for(const auto& t : triangles)
    result.push_back(
      {static_cast<std::size_t>(t.first), static_cast<std::size_t>(t.second), static_cast<std::size_t>(t.third)});
  return result;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_DISC_OF_LOOP_H
