// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#ifndef CGAL_REEB_GRAPH_SKELETON_FIND_BRANCH_FACES_H
#define CGAL_REEB_GRAPH_SKELETON_FIND_BRANCH_FACES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/interpolation.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/skeleton/Curve_skeleton.h>
#include <CGAL/Reeb_graph/skeleton/internal/Junction_balls.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {
namespace internal::skeleton {

// The beginning of an arc at a junction: a line that goes on beyond the ball there, and the radius of its tube where it leaves it.
struct Junction_arm
{
  typedef CGAL::Simple_cartesian<double>::Point_3 Point;

  std::size_t arc;
  double tube_radius, ball_radius;
  std::vector<Point> line;
  std::vector<Bbox_3> boxes; // of so many segments each

  static constexpr std::size_t segments_in_box = 8;

  void make_boxes()
  {
    for(std::size_t i = 0; i + 1 < line.size(); ++i)
    {
      if(i % segments_in_box == 0)
        boxes.emplace_back();
      boxes.back() += line[i].bbox() + line[i + 1].bbox();
    }
  }

  // How far a point is from the place on the line that is nearest, in radii of the tube, and whether that is in the ball: more
  // than a bound where it is not nearer.
  std::pair<double, bool> distance_to(const Point& p, double bound) const
  {
    std::pair<double, bool> nearest = {std::numeric_limits<double>::infinity(), true};
    for(std::size_t i = 0; i + 1 < line.size(); ++i)
    {
      if(i % segments_in_box == 0 && distance_from_box(p, boxes[i / segments_in_box]) / tube_radius > bound)
      {
        i += segments_in_box - 1;
        continue;
      }
      const auto along = line[i + 1] - line[i];
      const double size = distance_between(line[i], line[i + 1]); // No length is squared, in any unit.
      const double t = size > 0 ? (p - line[i]) / size * (along / size) : 0;
      const Point place = line[i] + std::clamp(t, 0., 1.) * along;
      const double distance = distance_between(p, place) / tube_radius;
      bound = (std::min)(bound, distance);
      if(distance < nearest.first)
        nearest = {distance, distance_between(place, line.front()) <= ball_radius};
    }
    return nearest;
  }

private:
  // A distance along an axis: no more than that of any point of the box.
  static double distance_from_box(const Point& p, const Bbox_3& box)
  {
    double distance = 0;
    for(int i = 0; i != 3; ++i)
      distance = (std::max)({distance, (box.min)(i)-p[i], p[i] - (box.max)(i)});
    return distance;
  }
};

// Pieces of a mesh, one for each arc of its skeleton, which grow from face to face.
template <class FaceListGraph, class PointMap, class FaceArcMap, class FaceJunctionMap>
class Branch_pieces
{
public:
  typedef typename boost::graph_traits<FaceListGraph>::face_descriptor face_descriptor;
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  Branch_pieces(const FaceListGraph& mesh, PointMap point_map, FaceArcMap arc_map, FaceJunctionMap junction_map)
    : mesh_(mesh),
      point_map_(point_map),
      arc_map_(arc_map),
      junction_map_(junction_map),
      vertex_map_(get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh))
  {}

  // Near junctions, a face takes the arm whose tube is nearest, elsewhere the arc of its corners, if that is one but for
  // nodes. The largest part of each piece is kept, and grows.
  template <class CurveSkeleton>
  void find(const CurveSkeleton& skeleton)
  {
    for(const auto v : CGAL::make_range(vertices(skeleton)))
      for(const auto of_mesh : skeleton[v].vertices)
        put(vertex_map_, of_mesh, v);
    add_arms(skeleton);
    sort_faces();
    const auto arcs_of_corners = [&](face_descriptor f) { // those of nodes last
      std::vector<std::size_t> arcs;
      for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh_), mesh_))
        arcs.push_back(skeleton[get(vertex_map_, v)].arc);
      std::sort(arcs.begin(), arcs.end());
      return arcs;
    };
    for(const face_descriptor f : faces_)
    {
      put(arc_map_, f, nearest_arm(f, none).first);
      if(get(arc_map_, f) != none)
        continue;
      const std::vector<std::size_t> arcs = arcs_of_corners(f);
      const auto is_other = [&](std::size_t arc) { return arc != none && arc != arcs.front(); };
      if(std::none_of(arcs.begin(), arcs.end(), is_other))
        put(arc_map_, f, arcs.front());
    }
    keep_largest_parts();
    for(const face_descriptor f : faces_) // the first one of arcs without any
      for(const std::size_t arc : arcs_of_corners(f))
        add(f, arc);
    grow();
    for(const face_descriptor f : faces_) // of components without any
      if(get(arc_map_, f) == none)
      {
        std::size_t arc = none;
        for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh_), mesh_))
          arc = (std::min)(arc, skeleton[*out_edges(get(vertex_map_, v), skeleton).first].arc);
        add(f, arc);
        grow();
      }
    mark_junctions();
  }

private:
  // The points of the corners, in an order that only they decide.
  std::array<Coordinates, 3> corners(face_descriptor f) const
  {
    std::array<Coordinates, 3> result;
    auto next = result.begin();
    for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh_), mesh_))
      *next++ = coordinates_of(get(point_map_, v));
    std::sort(result.begin(), result.end());
    return result;
  }

  // Where faces are equal otherwise, the one with the least corners is the first one, in any order of the mesh.
  void sort_faces()
  {
    std::vector<std::pair<std::array<Coordinates, 3>, face_descriptor>> sorted;
    for(const face_descriptor f : faces(mesh_))
      sorted.emplace_back(corners(f), f);
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for(const auto& [points, f] : sorted)
      faces_.push_back(f);
  }

  // Finds the arms of each junction, and which of them are near each point of the skeleton.
  template <class CurveSkeleton>
  void add_arms(const CurveSkeleton& skeleton)
  {
    const Junction_balls<CurveSkeleton> balls(skeleton);
    has_faces_.assign(balls.arcs().size(), false);
    arms_of_points_.resize(num_vertices(skeleton));
    std::vector<std::vector<std::size_t>> arms_of_nodes(num_vertices(skeleton));
    const auto visit = [&](const auto& visitor) {
      for(std::size_t arc = 0; arc != balls.arcs().size(); ++arc)
        for(const bool is_last : {false, true})
          if(const std::size_t inside = balls.number_inside(arc, is_last); inside > 0)
          {
            std::vector<std::size_t> points = balls.arcs()[arc];
            if(is_last)
              std::reverse(points.begin(), points.end());
            const std::size_t outside = (std::min)(inside, points.size() - 1);
            points.resize((std::min)(balls.number_near(arc, is_last) + 2, points.size()));
            visitor(arc, points, outside);
          }
    };
    visit([&](std::size_t arc, const std::vector<std::size_t>& points, std::size_t outside) {
      arms_of_nodes[points.front()].push_back(arms_.size());
      arms_.push_back({arc, skeleton[points[outside]].radius, balls.radius(points.front()), {}, {}});
      for(const std::size_t point : points)
      {
        const Coordinates c = coordinates_of(skeleton[point].point);
        arms_.back().line.emplace_back(c[0], c[1], c[2]);
      }
      arms_.back().make_boxes();
    });
    visit([&](std::size_t, const std::vector<std::size_t>& points, std::size_t outside) {
      const auto& arms = arms_of_nodes[points.front()];
      for(std::size_t i = 0; i <= outside; ++i)
        if(auto& near = arms_of_points_[points[i]]; i > 0 || near.empty())
          near.insert(near.end(), arms.begin(), arms.end());
    });
  }

  // Of the arms near the corners of a face, or those of an arc only, the arc of the one whose tube is nearest, or none, and whether
  // that is in the junction.
  std::pair<std::size_t, bool> nearest_arm(face_descriptor f, std::size_t arc) const
  {
    Coordinates center = {0, 0, 0};
    for(const Coordinates& corner : corners(f))
      for(std::size_t i = 0; i != 3; ++i)
        center[i] += corner[i] / 3;
    std::pair<std::size_t, bool> nearest = {none, false};
    std::pair<double, std::size_t> least = {std::numeric_limits<double>::infinity(), 0};
    std::vector<std::size_t> numbers;
    for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh_), mesh_))
      for(const std::size_t number : arms_of_points_[get(vertex_map_, v)])
        if(arc == none || arms_[number].arc == arc)
          numbers.push_back(number);
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    for(const std::size_t number : numbers)
    {
      const auto [distance, is_in_ball] = arms_[number].distance_to({center[0], center[1], center[2]}, least.first);
      if(!(std::make_pair(distance, number) < least))
        continue;
      least = {distance, number};
      nearest = {arms_[number].arc, is_in_ball};
    }
    return nearest;
  }

  // Faces of two pieces that share an edge are in junctions, too.
  void mark_junctions()
  {
    for(const face_descriptor f : faces_)
    {
      bool is_in_junction = nearest_arm(f, get(arc_map_, f)).second;
      visit_neighbors(f, [&](face_descriptor neighbor) {
        is_in_junction = is_in_junction || get(arc_map_, neighbor) != get(arc_map_, f);
      });
      put(junction_map_, f, is_in_junction);
    }
  }

  // Makes the face the first one of an arc that has none.
  void add(face_descriptor f, std::size_t arc)
  {
    if(arc == none || has_faces_[arc] || get(arc_map_, f) != none)
      return;
    put(arc_map_, f, arc);
    has_faces_[arc] = true;
    queue_.push_back(f);
  }

  template <class Visitor>
  void visit_neighbors(face_descriptor f, const Visitor& visit) const
  {
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, mesh_), mesh_))
      if(!is_border(opposite(h, mesh_), mesh_))
        visit(face(opposite(h, mesh_), mesh_));
  }

  void keep_largest_parts()
  {
    const auto part_map = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh_);
    for(const face_descriptor f : faces_)
      put(part_map, f, none);
    std::vector<std::vector<face_descriptor>> parts(
      has_faces_.size()); // the largest one of each arc, the first of such
    for(const face_descriptor first : faces_)
    {
      const std::size_t arc = get(arc_map_, first);
      if(arc == none || get(part_map, first) != none)
        continue;
      std::vector<face_descriptor> part = {first};
      put(part_map, first, arc);
      for(std::size_t i = 0; i != part.size(); ++i)
        visit_neighbors(part[i], [&](face_descriptor f) {
          if(get(arc_map_, f) != arc || get(part_map, f) != none)
            return;
          put(part_map, f, arc);
          part.push_back(f);
        });
      if(part.size() > parts[arc].size())
        parts[arc].swap(part);
    }
    for(const face_descriptor f : faces_)
      put(arc_map_, f, none);
    for(std::size_t arc = 0; arc != has_faces_.size(); ++arc)
      for(const face_descriptor f : parts[arc])
      {
        put(arc_map_, f, arc);
        has_faces_[arc] = true;
        queue_.push_back(f);
      }
  }

  // Gives faces without an arc that of the nearest face with one; of several that are as near, the first arc.
  void grow()
  {
    while(!queue_.empty())
    {
      std::vector<std::pair<face_descriptor, std::size_t>> offers;
      for(const face_descriptor f : queue_)
        visit_neighbors(f, [&](face_descriptor neighbor) {
          if(get(arc_map_, neighbor) == none)
            offers.emplace_back(neighbor, get(arc_map_, f));
        });
      queue_.clear();
      for(const auto& [f, arc] : offers)
      {
        if(get(arc_map_, f) == none)
          queue_.push_back(f);
        put(arc_map_, f, (std::min)(std::size_t(get(arc_map_, f)), arc));
      }
    }
  }

  const FaceListGraph& mesh_;
  PointMap point_map_;
  FaceArcMap arc_map_;
  FaceJunctionMap junction_map_;
  typename boost::property_map<FaceListGraph, CGAL::dynamic_vertex_property_t<std::size_t>>::const_type vertex_map_;
  std::vector<Junction_arm> arms_;
  std::vector<std::vector<std::size_t>> arms_of_points_; // of the skeleton
  std::vector<bool> has_faces_;                          // of arcs
  std::vector<face_descriptor> faces_;                   // in an order that only the points decide
  std::vector<face_descriptor> queue_;
};

} // namespace internal::skeleton

/// \ingroup PkgReebGraphSkeleton
///
/// \brief finds the faces around each arc of a curve skeleton, and those in junctions.
///
/// The faces of an arc are connected, and each face has an arc. Near a junction, that is the arc whose tube is nearest. Arcs
/// without a vertex of the mesh, as short ones between nodes, may have no face. A face lies in a junction where the place of the
/// arc that is nearest does, and where a face beside it has another arc. The order of vertices and faces does not matter if no two faces have the same points.
/// It takes \f$ O(n \log n) \f$ time for \f$ n \f$ faces, if few arcs meet in each junction.
///
/// \tparam FaceListGraph a model of `FaceListGraph`, with triangles as faces
/// \tparam CurveSkeleton a `Curve_skeleton` of that mesh
/// \tparam FaceArcMap a model of `ReadWritePropertyMap` with the face descriptors of the mesh as key type and `std::size_t`
///         as value type
/// \tparam FaceJunctionMap a model of `WritablePropertyMap` with the face descriptors of the mesh as key type and `bool`
///         as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the mesh
/// \param skeleton its skeleton, as it has been extracted
/// \param face_arc_map the result: the number of an arc for each face
/// \param face_junction_map the result: whether each face lies in a junction
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those below
///
/// \cgalNamedParamsBegin
///   \reebGraphPoints{ReadablePropertyMap}
/// \cgalNamedParamsEnd
template <class FaceListGraph,
          class CurveSkeleton,
          class FaceArcMap,
          class FaceJunctionMap,
          class NamedParameters = parameters::Default_named_parameters>
void find_branch_faces(const FaceListGraph& mesh,
                       const CurveSkeleton& skeleton,
                       FaceArcMap face_arc_map,
                       FaceJunctionMap face_junction_map,
                       const NamedParameters& np = parameters::default_values())
{
  const auto point_map = internal::choose_point_map(mesh, np);
  typedef std::decay_t<decltype(point_map)> PointMap;
  internal::skeleton::Branch_pieces<FaceListGraph, PointMap, FaceArcMap, FaceJunctionMap>(mesh, point_map, face_arc_map,
                                                                                          face_junction_map)
    .find(skeleton);
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SKELETON_FIND_BRANCH_FACES_H
