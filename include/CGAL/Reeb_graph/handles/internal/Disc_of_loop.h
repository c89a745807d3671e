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

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/box_intersection_d.h>
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

// Triangles in space, by whose predicates it is told what intersects.
typedef Exact_predicates_inexact_constructions_kernel Disc_kernel;
typedef Disc_kernel::Point_3 Disc_point;

struct Numbered_box : Box_intersection_d::Box_d<double, 3>
{
  Numbered_box(const Bbox_3& box, std::size_t n) : Box_intersection_d::Box_d<double, 3>(box), number(n) {}
  std::size_t number;
};

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
// is none, or if the polyline has less than 3 or more than 1000 points.
inline std::vector<std::array<std::size_t, 3>> triangulate_disc(const std::vector<Disc_point>& polyline)
{
  std::vector<std::array<std::size_t, 3>> result;
  if(polyline.size() < 3 || polyline.size() > largest_loop_of_disc)
    return result;
  std::vector<CGAL::Triple<int, int, int>> triangles;
  Polygon_mesh_processing::triangulate_hole_polyline(polyline, std::back_inserter(triangles));
  for(const auto& t : triangles)
    result.push_back({static_cast<std::size_t>(t.first), static_cast<std::size_t>(t.second),
                      static_cast<std::size_t>(t.third)});
  return result;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_DISC_OF_LOOP_H
