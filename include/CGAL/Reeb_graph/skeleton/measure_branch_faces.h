// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#ifndef CGAL_REEB_GRAPH_SKELETON_MEASURE_BRANCH_FACES_H
#define CGAL_REEB_GRAPH_SKELETON_MEASURE_BRANCH_FACES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/interpolation.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/internal/space/volumes_of_parts.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/skeleton/internal/Component_filling.h>
#include <CGAL/Reeb_graph/skeleton/measure_branches.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {
namespace internal::skeleton {

// The volume of each part of the solid of a mesh, whose borders are filled by triangles around their centers, each of the part of its
// edge. The part of a face is a number.
template <class FaceListGraph, class PointMap, class PartOf>
std::vector<double> volumes_of_face_parts(const FaceListGraph& mesh,
                                          PointMap point_map,
                                          const PartOf& part_of,
                                          std::size_t number_of_parts)
{
  typedef typename boost::graph_traits<FaceListGraph>::halfedge_descriptor halfedge_descriptor;
  const auto index_map = get(CGAL::dynamic_vertex_property_t<Index>(), mesh);
  std::vector<Point> points;
  for(const auto v : vertices(mesh))
  {
    const Coordinates c = coordinates_of(get(point_map, v));
    put(index_map, v, static_cast<Index>(points.size()));
    points.emplace_back(c[0], c[1], c[2]);
  }
  const int exponent = scale_to_one(points);
  const auto corner = [&](halfedge_descriptor h) { return Index(get(index_map, target(h, mesh))); };
  std::vector<Part_triangle> triangles;
  for(const auto f : faces(mesh))
  {
    const auto h = halfedge(f, mesh);
    triangles.push_back({{corner(h), corner(next(h, mesh)), corner(prev(h, mesh))}, part_of(f)});
  }
  std::set<halfedge_descriptor> passed;
  for(const auto first : halfedges(mesh))
  {
    if(!is_border(first, mesh) || passed.count(first) != 0)
      continue;
    std::vector<Point> polygon;
    const Index center = static_cast<Index>(points.size());
    for(const auto h : CGAL::halfedges_around_face(first, mesh))
    {
      passed.insert(h);
      polygon.push_back(points[corner(h)]);
      triangles.push_back({{corner(opposite(h, mesh)), corner(h), center}, part_of(face(opposite(h, mesh), mesh))});
    }
    points.push_back(measure(polygon).centroid);
  }
  std::vector<double> volumes = volumes_of_parts(std::move(points), std::move(triangles), number_of_parts);
  for(double& volume : volumes)
    volume = std::scalbn(volume, -3 * exponent);
  return volumes;
}

} // namespace internal::skeleton

/// \ingroup PkgReebGraphSkeleton
///
/// \brief measures the area and the volume of each branch of a curve skeleton, and how much of them lies in junctions.
///
/// The volume of a branch is that of the solid between its faces and cones over their borders. In each junction, these cones
/// have one tip, the middle of all edges between branches there. Borders of the mesh are filled, each by triangles around its
/// center. So the branches make the whole: their areas add up to that of the mesh, and their volumes to that of the solid, up to
/// rounding. What lies in junctions is cut off from the rest of its branch in the same way. Volumes of components that are
/// inside out are those of the solid, too. No volume is negative. Some faces look at what belongs to another branch, as those of one that
/// is hardly more than a side of a junction. Their volume is 0, and the branch with which their border is longest has the less. It takes
/// \f$ O(n \log n) \f$ time for \f$ n \f$ faces.
///
/// \tparam FaceListGraph a model of `FaceListGraph`, with triangles as faces
/// \tparam FaceArcMap a model of `ReadablePropertyMap` with the face descriptors of the mesh as key type and `std::size_t`
///         as value type
/// \tparam FaceJunctionMap a model of `ReadablePropertyMap` with the face descriptors of the mesh as key type and `bool`
///         as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the mesh
/// \param face_arc_map the number of an arc for each face, as `find_branch_faces()` sets it
/// \param face_junction_map whether each face lies in a junction, as `find_branch_faces()` sets it
/// \param branches the branches, as `measure_branches()` returns them; their areas and volumes are set
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those below
///
/// \cgalNamedParamsBegin
///   \reebGraphPoints{ReadablePropertyMap}
/// \cgalNamedParamsEnd
///
/// \returns how many components are inside out: those whose faces are oriented towards the inside, by the sign of the volume.
template <class FaceListGraph,
          class FaceArcMap,
          class FaceJunctionMap,
          class NamedParameters = parameters::Default_named_parameters>
std::size_t measure_branch_faces(const FaceListGraph& mesh,
                                 FaceArcMap face_arc_map,
                                 FaceJunctionMap face_junction_map,
                                 std::vector<Skeleton_branch>& branches,
                                 const NamedParameters& np = parameters::default_values())
{
  const auto point_map = internal::choose_point_map(mesh, np);
  const auto part_of = [&](auto f) { // twice the branch, and one more in junctions
    return 2 * std::size_t(get(face_arc_map, f)) + (get(face_junction_map, f) ? 1 : 0);
  };
  const std::vector<double> volumes =
    internal::skeleton::volumes_of_face_parts(mesh, point_map, part_of, 2 * branches.size());
  for(Skeleton_branch& branch : branches)
    branch.area = branch.junction_area = 0;
  for(const auto f : faces(mesh))
  {
    const auto h = halfedge(f, mesh);
    const double area = internal::area_of(get(point_map, source(h, mesh)), get(point_map, target(h, mesh)),
                                          get(point_map, target(next(h, mesh), mesh)));
    Skeleton_branch& branch = branches[get(face_arc_map, f)];
    branch.area += area;
    branch.junction_area += get(face_junction_map, f) ? area : 0;
  }
  std::map<std::size_t, std::array<double, 2>> wholes; // the volume and area of components
  for(std::size_t i = 0; i != branches.size(); ++i)
  {
    wholes[branches[i].component][0] += volumes[2 * i] + volumes[2 * i + 1];
    wholes[branches[i].component][1] += branches[i].area;
  }
  for(std::size_t i = 0; i != branches.size(); ++i)
  {
    const double sign = wholes[branches[i].component][0] < 0 ? -1 : 1;
    branches[i].volume = sign * (volumes[2 * i] + volumes[2 * i + 1]);
    branches[i].junction_volume = sign * volumes[2 * i + 1];
  }
  const auto is_inside_out = [](const auto& whole) { // not by rounding, as sheets on each other
    return std::cbrt(-whole.second[0]) > 1e-4 * std::sqrt(whole.second[1]);
  };
  return static_cast<std::size_t>(std::count_if(wholes.begin(), wholes.end(), is_inside_out));
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SKELETON_MEASURE_BRANCH_FACES_H
