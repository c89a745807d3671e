// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_INTERNAL_LOOP_CUT_H
#define CGAL_REEB_GRAPH_HANDLES_INTERNAL_LOOP_CUT_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/internal/Curve_opening.h>
#include <CGAL/Reeb_graph/handles/internal/Disc_of_loop.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A triangle that is to be, or a face. A vertex of a loop that is cut has a copy on its left and one on its right.
template <class VertexDescriptor>
struct Placed_triangle
{
  struct Corner
  {
    VertexDescriptor vertex;
    int copy; // 0 if it is not cut, 1 on the left, 2 on the right
    Disc_point point;
  };
  std::array<Corner, 3> corners;

  Disc_kernel::Triangle_3 triangle() const { return {corners[0].point, corners[1].point, corners[2].point}; }
};

// Whether two triangles have more in common than the corners that they share. One without area has nothing.
template <class VertexDescriptor>
bool do_intersect(Placed_triangle<VertexDescriptor> a, Placed_triangle<VertexDescriptor> b)
{
  typedef typename Placed_triangle<VertexDescriptor>::Corner Corner;
  const auto is_same = [](const Corner& p, const Corner& q) { return p.vertex == q.vertex && p.copy == q.copy; };
  std::size_t shared = 0; // the shared ones are put first
  for(std::size_t i = 0; i != 3; ++i)
    for(std::size_t j = shared; j != 3; ++j)
    {
      if(!is_same(a.corners[i], b.corners[j]))
        continue;
      std::swap(a.corners[i], a.corners[shared]);
      std::swap(b.corners[j], b.corners[shared]);
      ++shared;
      break;
    }
  const Disc_kernel::Triangle_3 s = a.triangle(), t = b.triangle();
  if(s.is_degenerate() || t.is_degenerate())
    return false;
  if(shared == 3)
    return true;
  if(shared == 2)
    return CGAL::coplanar(s[0], s[1], s[2], t[2])
        && CGAL::coplanar_orientation(s[0], s[1], s[2], t[2]) == CGAL::POSITIVE;
  if(shared == 1)
    return CGAL::do_intersect(s, Disc_kernel::Segment_3(t[1], t[2]))
        || CGAL::do_intersect(t, Disc_kernel::Segment_3(s[1], s[2]));
  return CGAL::do_intersect(s, t);
}

// A cut along a simple loop that meets no border. Both copies of the loop move a little away from each other, into their
// sides, and both get the same disc.
template <class FaceGraph, class PointMap>
class Loop_cut
{
public:
  typedef FaceGraph Mesh;
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<Mesh>::face_descriptor face_descriptor;
  typedef Placed_triangle<vertex_descriptor> Triangle;

  // Plans the cut, and changes nothing.
  Loop_cut(const Mesh& mesh, const PointMap& point_map, std::vector<halfedge_descriptor> loop)
    : mesh_(mesh),
      point_map_(point_map),
      loop_(std::move(loop))
  {
    std::vector<Disc_point> polyline;
    for(const halfedge_descriptor h : loop_)
    {
      passed_.insert(source(h, mesh));
      polyline.push_back(point(source(h, mesh)));
    }
    disc_triangles_ = triangulate_disc(polyline);
    for(auto& t : disc_triangles_)
      std::sort(t.begin(), t.end());
    if(disc_triangles_.empty())
      return;
    add_disc(disc_, 0, polyline);
    for(const double step : {0.25, 0.05})
    {
      place(step);
      if(fits_itself())
        return;
    }
    placed_.clear();
  }

  const std::vector<halfedge_descriptor>& loop() const { return loop_; }
  bool passes(vertex_descriptor v) const { return passed_.count(v) != 0; }
  const std::vector<Triangle>& disc() const { return disc_; } // that spans the loop; empty if there is none
  // The faces around the loop, and the discs, as they will be. Empty if they would intersect each other.
  const std::vector<Triangle>& placed() const { return placed_; }

  // Cuts the mesh. The visitor is told of vertices, halfedges and faces that are added. Calls act(face) for each face that
  // is new or has changed.
  template <class Visitor, class Act>
  void operator()(Mesh& mesh, Visitor& visitor, const Act& act) const
  {
    Opened_mesh<Visitor> opened = {mesh, point_map_, visitor};
    Curve<halfedge_descriptor> curve;
    curve.halfedges = loop_;
    curve.is_closed = true;
    curve.lower_halfedges.resize(loop_.size());
    Curve_opening<Opened_mesh<Visitor>> open(opened);
    open(curve);
    const std::size_t size = loop_.size();
    std::array<std::vector<halfedge_descriptor>, 2> cycles; // of the borders
    for(std::size_t k = 0; k != size; ++k)
    {
      put(point_map_, source(loop_[k], mesh), moved_[0][k]);
      put(point_map_, target(curve.lower_halfedges[k], mesh), moved_[1][k]);
      cycles[0].push_back(opposite(loop_[size - 1 - k], mesh));
      cycles[1].push_back(opposite(curve.lower_halfedges[k], mesh));
    }
    for(const std::size_t side : {0, 1})
    {
      fill(mesh, cycles[side], side == 0, visitor);
      for(const halfedge_descriptor border : cycles[side])
        for(const face_descriptor f : faces_around_target(border, mesh))
          act(f);
    }
  }

private:
  typedef typename boost::property_traits<PointMap>::value_type Point;

  // What Curve_opening asks for.
  template <class Visitor>
  struct Opened_mesh
  {
    typedef FaceGraph Mesh;
    typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
    typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
    Mesh& mesh() const { return mesh_; }
    Visitor& visitor() const { return visitor_; }
    const PointMap& vertex_point_map() const { return point_map_; }
    Mesh& mesh_;
    const PointMap& point_map_;
    Visitor& visitor_;
  };

  Disc_point point(vertex_descriptor v) const { return disc_point(v, point_map_); }

  // The disc between copies of the vertices of the loop.
  void add_disc(std::vector<Triangle>& triangles, int copy, const std::vector<Disc_point>& points) const
  {
    for(const auto& t : disc_triangles_)
    {
      triangles.emplace_back();
      for(std::size_t i = 0; i != 3; ++i)
        triangles.back().corners[i] = {source(loop_[t[i]], mesh_), copy, points[t[i]]};
    }
  }

  // Moves the copies by this part of the way to the mean of their neighbors.
  void place(double step)
  {
    placed_.clear();
    const std::size_t size = loop_.size();
    std::map<halfedge_descriptor, std::pair<int, Disc_point>> copies; // by the halfedge that leads to a vertex in a face
    std::array<std::vector<Disc_point>, 2> points;
    for(std::size_t side : {0, 1})
    {
      moved_[side].clear();
      for(std::size_t k = 0; k != size; ++k)
      {
        const halfedge_descriptor back = opposite(loop_[(k + size - 1) % size], mesh_);
        const halfedge_descriptor begin = side == 0 ? loop_[k] : back, end = side == 0 ? back : loop_[k];
        moved_[side].push_back(moved(begin, end, step));
        points[side].push_back(to_disc_point(moved_[side].back()));
        for(halfedge_descriptor h = begin; h != end; h = turned(h))
          copies.emplace(prev(h, mesh_), std::make_pair(static_cast<int>(side) + 1, points[side].back()));
      }
    }
    std::set<face_descriptor> placed;
    for(const auto& copy : copies)
    {
      if(placed.insert(face(copy.first, mesh_)).second)
        place_face(copy.first, copies);
    }
    add_disc(placed_, 1, points[0]);
    add_disc(placed_, 2, points[1]);
  }

  void place_face(halfedge_descriptor h,
                  const std::map<halfedge_descriptor, std::pair<int, Disc_point>>& copies)
  {
    placed_.emplace_back();
    for(auto& corner : placed_.back().corners)
    {
      const vertex_descriptor v = target(h, mesh_);
      const auto copy = copies.find(h);
      if(copy == copies.end())
        corner = {v, 0, point(v)};
      else
        corner = {v, copy->second.first, copy->second.second};
      h = next(h, mesh_);
    }
  }

  halfedge_descriptor turned(halfedge_descriptor h) const { return opposite(prev(h, mesh_), mesh_); }

  // The place of the source of two halfedges, moved to the mean of the neighbors between them, counterclockwise.
  Point moved(halfedge_descriptor begin, halfedge_descriptor end, double step) const
  {
    const Disc_point p = point(source(begin, mesh_));
    double x = 0, y = 0, z = 0;
    int number = 0;
    for(halfedge_descriptor h = turned(begin); h != end; h = turned(h), ++number)
    {
      const Disc_point q = point(target(h, mesh_));
      x += q.x() - p.x();
      y += q.y() - p.y();
      z += q.z() - p.z();
    }
    if(number == 0)
      return get(point_map_, source(begin, mesh_));
    step /= number;
    return Point(p.x() + step * x, p.y() + step * y, p.z() + step * z);
  }

  static Disc_point to_disc_point(const Point& p)
  {
    return Disc_point(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }

  bool fits_itself() const
  {
    std::vector<Numbered_box> boxes;
    for(const Triangle& t : placed_)
    {
      if(t.triangle().is_degenerate())
        return false;
      boxes.push_back(Numbered_box(t.triangle().bbox(), boxes.size()));
    }
    bool result = true;
    box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Numbered_box& a, const Numbered_box& b) {
      result = result && !internal::do_intersect(placed_[a.number], placed_[b.number]);
    });
    return result;
  }

  // Fills a border cycle by the triangles of the disc. Its vertices are those of the loop, backwards from the first one or
  // in their order.
  template <class Visitor>
  void fill(Mesh& mesh, const std::vector<halfedge_descriptor>& cycle, bool is_backwards, Visitor& visitor) const
  {
    const std::size_t size = cycle.size();
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> apexes; // of triangles, by the first and the last vertex
    for(auto t : disc_triangles_)
    {
      for(std::size_t& position : t)
        position = is_backwards ? (size - position) % size : position;
      std::sort(t.begin(), t.end());
      apexes[{t[0], t[2]}] = t[1];
    }
    const face_descriptor beside = face(opposite(cycle.front(), mesh), mesh);
    Euler::fill_hole(cycle.front(), mesh);
    visitor.face_split(beside, face(cycle.front(), mesh));
    struct Polygon
    {
      std::size_t first, last;
      halfedge_descriptor closing; // from the last vertex to the first one
    };
    std::vector<Polygon> polygons = {{0, size - 1, cycle.back()}};
    const auto split = [&](halfedge_descriptor from, halfedge_descriptor to) {
      const halfedge_descriptor h = Euler::split_face(from, to, mesh);
      visitor.face_split(beside, face(opposite(h, mesh), mesh));
      return h;
    };
    while(!polygons.empty())
    {
      const auto [first, last, closing] = polygons.back();
      polygons.pop_back();
      if(last - first < 2)
        continue;
      const std::size_t apex = apexes.at({first, last});
      halfedge_descriptor to_apex = cycle[apex - 1];
      if(apex - first > 1)
      {
        const halfedge_descriptor h = split(to_apex, closing);
        polygons.push_back({first, apex, h});
        to_apex = opposite(h, mesh);
      }
      if(last - apex > 1)
        polygons.push_back({apex, last, split(cycle[last - 1], to_apex)});
    }
  }

  const Mesh& mesh_;
  const PointMap& point_map_;
  std::vector<halfedge_descriptor> loop_;
  std::set<vertex_descriptor> passed_;
  std::vector<std::array<std::size_t, 3>> disc_triangles_; // by positions in the loop
  std::vector<Triangle> disc_, placed_;
  std::array<std::vector<Point>, 2> moved_; // the vertices of the loop, on its left and on its right
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_LOOP_CUT_H
