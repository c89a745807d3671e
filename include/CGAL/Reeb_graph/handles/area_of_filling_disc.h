// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_AREA_OF_FILLING_DISC_H
#define CGAL_REEB_GRAPH_HANDLES_AREA_OF_FILLING_DISC_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/handles/internal/triangulate_disc.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/internal/space/Self_intersections.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {
namespace internal {

template <class Point>
Disc_point disc_point(const Point& p)
{
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
  return {disc_point(get(point_map, u)), disc_point(get(point_map, v)), disc_point(get(point_map, w))};
}

// The boxes of those faces that meet some of the given boxes, with their places in a list of faces. That is looked at in
// blocks, as faces that follow each other are mostly near.
template <class Face, class Mesh, class PointMap>
std::vector<Numbered_box> boxes_of_faces_near(const std::vector<Face>& faces,
                                              const Mesh& mesh,
                                              const PointMap& point_map,
                                              const std::vector<Bbox_3>& given)
{
  constexpr std::size_t size_of_block = 64;
  std::vector<Numbered_box> result;
  for(std::size_t begin = 0; begin < faces.size(); begin += size_of_block)
  {
    std::vector<Bbox_3> boxes, near;
    Bbox_3 block;
    for(std::size_t i = begin; i != (std::min)(begin + size_of_block, faces.size()); ++i)
    {
      boxes.push_back(face_triangle(faces[i], mesh, point_map).bbox());
      block += boxes.back();
    }
    for(const Bbox_3& box : given)
      if(do_overlap(box, block))
        near.push_back(box);
    for(std::size_t i = 0; i != boxes.size(); ++i)
      if(std::any_of(near.begin(), near.end(), [&](const Bbox_3& box) { return do_overlap(box, boxes[i]); }))
        result.push_back(Numbered_box(boxes[i], begin + i));
  }
  return result;
}

// The areas of the discs that fill loops, and do not meet a face but those at vertices of their loops.
template <class Mesh, class LoopRange, class PointMap>
std::vector<std::optional<double>> areas_of_discs(const Mesh& mesh, const LoopRange& loops, const PointMap& point_map)
{
  typedef typename boost::graph_traits<Mesh>::face_descriptor face_descriptor;
  std::vector<std::optional<double>> areas;
  std::vector<std::set<typename boost::graph_traits<Mesh>::vertex_descriptor>> passed; // by the loop of a disc
  std::vector<std::pair<Disc_kernel::Triangle_3, std::size_t>> triangles;              // with the number of the disc
  std::vector<Numbered_box> triangle_boxes;
  std::vector<Bbox_3> disc_boxes;
  for(const auto& loop : loops)
  {
    areas.emplace_back();
    passed.emplace_back();
    disc_boxes.emplace_back();
    std::vector<Disc_point> polyline;
    for(const auto h : loop)
    {
      passed.back().insert(source(h, mesh));
      polyline.push_back(disc_point(get(point_map, source(h, mesh))));
    }
    for(const auto& t : triangulate_disc(polyline, {}, [](std::size_t, std::size_t) { return false; }))
    {
      const Disc_kernel::Triangle_3 triangle(polyline[t[0]], polyline[t[1]], polyline[t[2]]);
      triangle_boxes.push_back(Numbered_box(triangle.bbox(), triangles.size()));
      disc_boxes.back() += triangle.bbox();
      triangles.emplace_back(triangle, areas.size() - 1);
      areas.back() = areas.back().value_or(0) + area_of(triangle[0], triangle[1], triangle[2]);
    }
  }
  if(triangles.empty())
    return areas;
  const std::vector<face_descriptor> all_faces(faces(mesh).begin(), faces(mesh).end());
  std::vector<Numbered_box> face_boxes = boxes_of_faces_near(all_faces, mesh, point_map, disc_boxes);
  box_intersection_d(triangle_boxes.begin(), triangle_boxes.end(), face_boxes.begin(), face_boxes.end(),
                     [&](const Numbered_box& a, const Numbered_box& b) {
                       const auto& [triangle, disc] = triangles[a.info()];
                       const face_descriptor f = all_faces[b.info()];
                       const auto [u, v, w] = face_corners(f, mesh);
                       const bool is_beside =
                         passed[disc].count(u) + passed[disc].count(v) + passed[disc].count(w) != 0;
                       if(areas[disc] && !is_beside && CGAL::do_intersect(triangle, face_triangle(f, mesh, point_map)))
                         areas[disc].reset();
                     });
  return areas;
}

} // namespace internal

/// \ingroup PkgReebGraphHandles
///
/// \brief returns the areas of discs that fill loops, where they do.
///
/// A loop that bounds on one side of a surface need not bound a disc there: the tunnel of a knotted torus does not. For
/// each loop, a disc of triangles with little area is spanned, by `CGAL::Polygon_mesh_processing::triangulate_hole_polyline()`,
/// long and rough loops in parts. If it meets a face of the mesh, but for those with a vertex on the loop, there is no area.
/// Neither is there for a loop of less than 3 halfedges. Among discs that are as good as each other, another one can be spanned
/// in another run over a loop of more than 50 halfedges; its area differs by rounding.
///
/// \tparam FaceListGraph a model of `FaceListGraph`
/// \tparam LoopRange a range of ranges of halfedge descriptors
///
/// \param mesh the mesh
/// \param loops the loops, closed walks that pass no vertex twice
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", of which `vertex_point_map` counts
///
/// \pre Each loop is closed.
///
/// \reebGraphComplexity
///
/// \returns an area, or nothing, for each loop.
template <class FaceListGraph, class LoopRange, class NamedParameters = parameters::Default_named_parameters>
std::vector<std::optional<double>> areas_of_filling_discs(const FaceListGraph& mesh,
                                                          const LoopRange& loops,
                                                          const NamedParameters& np = parameters::default_values())
{
  return internal::areas_of_discs(mesh, loops, internal::choose_point_map(mesh, np));
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_HANDLES_AREA_OF_FILLING_DISC_H
