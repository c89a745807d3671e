// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_AREA_OF_FILLING_DISC_H
#define CGAL_REEB_GRAPH_HANDLES_AREA_OF_FILLING_DISC_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/handles/internal/triangle_intersections.h>
#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>

// With the library, there is no need to read how holes are filled.
#ifndef CGAL_REEB_GRAPH_ARE_LOOPS_COMPILED
// Algorithms of Boost.Graph that look up get() for pointers as they are defined: they come first, as triangulate_hole.h of
// CGAL 6 includes compressed_sparse_row_graph.hpp, whose boost::detail::get() would hide that function from them.
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>

#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>
#endif

#include <CGAL/box_intersection_d.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <set>
#include <vector>

namespace CGAL::Reeb_graph {
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
// triangles that its segments have on one side: the disc avoids to fold back on these. A template, so that the library can
// have it.
typedef std::vector<std::array<std::size_t, 3>> Disc_triangles;
template <class Polyline>
Disc_triangles triangulate_disc(const Polyline& polyline, const Polyline& third_points);

#ifndef CGAL_REEB_GRAPH_ARE_LOOPS_COMPILED
template <class Polyline>
Disc_triangles triangulate_disc(const Polyline& polyline, const Polyline& third_points)
{
  Disc_triangles result;
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
#endif

#define CGAL_REEB_GRAPH_TRIANGULATE_DISC(PREFIX)                                                                       \
  PREFIX template Disc_triangles triangulate_disc(const std::vector<Disc_point>&, const std::vector<Disc_point>&);
CGAL_REEB_GRAPH_FOR_LOOPS(CGAL_REEB_GRAPH_TRIANGULATE_DISC)

// Discs that span loops of a mesh, and the test which of them meet the mesh elsewhere.
template <class Mesh>
class Filling_discs
{
  typedef Disc_kernel::Triangle_3 Triangle;
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Mesh>::face_descriptor face_descriptor;

  struct Disc_triangle
  {
    Triangle triangle;
    std::size_t disc;
  };

public:
  explicit Filling_discs(const Mesh& mesh) : mesh_(mesh) {}

  template <class HalfedgeRange, class PointMap>
  void add(const HalfedgeRange& loop, const PointMap& point_map)
  {
    const std::size_t disc = areas_.size();
    areas_.emplace_back();
    passed_.emplace_back();
    std::vector<Disc_point> polyline;
    for(const auto h : loop)
    {
      passed_.back().insert(source(h, mesh_));
      polyline.push_back(disc_point(source(h, mesh_), point_map));
    }
    const Disc_triangles triangles = triangulate_disc(polyline, {});
    if(triangles.empty())
      return;
    double area = 0;
    for(const auto& t : triangles)
    {
      triangles_.push_back({Triangle(polyline[t[0]], polyline[t[1]], polyline[t[2]]), disc});
      area += std::sqrt(CGAL::to_double(triangles_.back().triangle.squared_area()));
    }
    areas_.back() = area;
  }

  // The areas of the discs that do not meet a face but those at vertices of their loops.
  template <class PointMap>
  std::vector<std::optional<double>> areas(const PointMap& point_map)
  {
    std::vector<Numbered_box> disc_boxes, face_boxes;
    for(const Disc_triangle& t : triangles_)
      disc_boxes.push_back(Numbered_box(t.triangle.bbox(), disc_boxes.size()));
    if(disc_boxes.empty())
      return areas_;
    const std::vector<face_descriptor> all_faces(faces(mesh_).begin(), faces(mesh_).end());
    for(const face_descriptor f : all_faces)
      face_boxes.push_back(Numbered_box(face_triangle(f, mesh_, point_map).bbox(), face_boxes.size()));
    box_intersection_d(disc_boxes.begin(), disc_boxes.end(), face_boxes.begin(), face_boxes.end(),
                       [&](const Numbered_box& a, const Numbered_box& b) {
                         const Disc_triangle& t = triangles_[a.number];
                         const face_descriptor f = all_faces[b.number];
                         if(areas_[t.disc] && !is_beside(t.disc, f)
                            && CGAL::do_intersect(t.triangle, face_triangle(f, mesh_, point_map)))
                           areas_[t.disc].reset();
                       });
    return areas_;
  }

private:
  // Whether a face has a vertex of the loop of a disc.
  bool is_beside(std::size_t disc, face_descriptor f) const
  {
    for(const auto v : face_corners(f, mesh_))
      if(passed_[disc].count(v) != 0)
        return true;
    return false;
  }

  const Mesh& mesh_;
  std::vector<std::optional<double>> areas_;
  std::vector<std::set<vertex_descriptor>> passed_; // by the loop of a disc
  std::vector<Disc_triangle> triangles_;
};

} // namespace internal

/// \ingroup PkgReebGraphHandles
///
/// \brief returns the areas of discs that fill loops, where they do.
///
/// A loop that bounds on one side of a surface need not bound a disc there: the tunnel of a knotted torus does not. For
/// each loop, a disc of triangles with little area is spanned, by `CGAL::Polygon_mesh_processing::triangulate_hole_polyline()`.
/// If it meets a face of the mesh, but for those with a vertex on the loop, there is no area. Neither is there for a
/// loop of less than 3 or more than 1000 halfedges.
///
/// \tparam FaceListGraph a model of `FaceListGraph`
/// \tparam LoopRange a range of ranges of halfedge descriptors
///
/// \param mesh the mesh
/// \param loops the loops, closed walks that pass no vertex twice
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", of which `vertex_point_map` counts
///
/// \returns an area, or nothing, for each loop.
template <class FaceListGraph, class LoopRange, class NamedParameters = parameters::Default_named_parameters>
std::vector<std::optional<double>> areas_of_filling_discs(const FaceListGraph& mesh,
                                                          const LoopRange& loops,
                                                          const NamedParameters& np = parameters::default_values())
{
  const auto point_map = internal::choose_point_map(mesh, np);
  internal::Filling_discs<FaceListGraph> discs(mesh);
  for(const auto& loop : loops)
    discs.add(loop, point_map);
  return discs.areas(point_map);
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_HANDLES_AREA_OF_FILLING_DISC_H
