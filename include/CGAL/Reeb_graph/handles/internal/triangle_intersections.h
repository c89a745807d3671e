// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_INTERNAL_TRIANGLE_INTERSECTIONS_H
#define CGAL_REEB_GRAPH_HANDLES_INTERNAL_TRIANGLE_INTERSECTIONS_H

#include <CGAL/Reeb_graph/handles/internal/Closed_surface.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/license/Reeb_graph.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Triangles in space, by whose predicates it is told what intersects.
typedef Exact_predicates_inexact_constructions_kernel Disc_kernel;
typedef Disc_kernel::Point_3 Disc_point;

struct Numbered_box : Box_intersection_d::Box_d<double, 3>
{
  Numbered_box(const Bbox_3& box, std::size_t n) : Box_intersection_d::Box_d<double, 3>(box), number(n) {}
  std::size_t number;
};

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

// Finds the closed components with handles that intersect themselves, or have faces without area. Other components may
// pass through them. Pairs of faces whose boxes overlap, and those of their patches, are tested exactly, but for those
// that floating-point numbers part for certain: neighbors that lie side by side in a picture, and faces with a plane between.
class Self_intersections
{
public:
  Self_intersections(const Closed_surface& surface, const Tree_and_cotree& trees)
    : surface_(surface),
      trees_(trees),
      is_flat_(surface.points.size(), false),
      result_(trees.components().size(), false)
  {}

  // By number of the component.
  std::vector<bool> operator()()
  {
    for(Index v = 0; v != surface_.number_of_given_vertices; ++v)
      is_flat_[v] = surface_.outgoing[v] != no_index && is_tested(v) && is_flat(v);
    make_patches();
    std::vector<Numbered_box> boxes;
    for(std::size_t patch = 0; patch + 1 != begins_.size(); ++patch)
    {
      Bbox_3 box;
      for(std::size_t i = begins_[patch]; i != begins_[patch + 1]; ++i)
      {
        box += faces_[i].box;
        for(std::size_t k = begins_[patch]; k != i; ++k)
          test(faces_[i], faces_[k]);
      }
      boxes.push_back(Numbered_box(box, patch));
    }
    box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Numbered_box& a, const Numbered_box& b) {
      if(component_of(faces_[begins_[a.number]]) == component_of(faces_[begins_[b.number]]))
        test_patches(a, b);
    });
    return result_;
  }

private:
  typedef std::array<double, 3> Vector;
  struct Face
  {
    std::array<Index, 3> corners;
    Bbox_3 box;
  };
  static constexpr std::size_t patch_size = 48; // 16 or 64 take a tenth longer

  bool is_tested(Index v) const
  {
    const Tree_and_cotree::Component& component = trees_.components()[trees_.component_of(v)];
    return component.genus() != 0 && !component.has_border;
  }

  Index component_of(const Face& face) const { return trees_.component_of(face.corners[0]); }

  Vector way(Index u, Index v) const
  {
    const Closed_surface::Point &p = surface_.points[u], &q = surface_.points[v];
    return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  }
  static Vector unit(const Vector& a)
  {
    const double length = std::sqrt(dot(a, a));
    return {a[0] / length, a[1] / length, a[2] / length};
  }

  // Whether the halfedges that leave a vertex turn once, and each to the left of the one before, as they are seen against
  // the mean normal. So the faces lie side by side. The margin is large beside all errors of rounding.
  bool is_flat(Index v) const
  {
    const Index first = surface_.outgoing[v];
    Vector normal = {0, 0, 0}, before = way(v, surface_.target[first]);
    Index h = first;
    do
    {
      h = surface_.turned(h);
      const Vector after = way(v, surface_.target[h]), product = cross(before, after);
      for(std::size_t k = 0; k != 3; ++k)
        normal[k] += product[k];
      before = after;
    } while(h != first);
    const bool is_steep = std::abs(normal[0]) < std::abs(normal[1]);
    const Vector x_axis = unit(is_steep ? Vector{0, -normal[2], normal[1]} : Vector{normal[2], 0, -normal[0]});
    const Vector y_axis = unit(cross(normal, x_axis));
    int number_of_turns = 0;
    do
    {
      h = surface_.turned(h);
      const Vector after = way(v, surface_.target[h]);
      const double y = dot(before, y_axis), next_y = dot(after, y_axis);
      const double area = dot(before, x_axis) * next_y - y * dot(after, x_axis);
      if(!(area > 0 && area * area > 1e-12 * dot(before, before) * dot(after, after)))
        return false;
      number_of_turns += y < 0 && next_y >= 0 ? 1 : 0;
      before = after;
    } while(h != first);
    return number_of_turns == 1;
  }

  // Patches are connected sets of faces.
  void make_patches()
  {
    std::vector<bool> is_placed(surface_.halfedge.size(), false);
    std::vector<Index> patch;
    faces_.reserve(surface_.halfedge.size());
    for(Index seed = 0; seed != surface_.halfedge.size(); ++seed)
    {
      if(is_placed[seed] || !is_tested(surface_.target[surface_.halfedge[seed]]))
        continue;
      is_placed[seed] = true;
      patch.assign(1, seed);
      begins_.push_back(faces_.size());
      for(std::size_t i = 0; i != patch.size(); ++i)
      {
        Index h = surface_.halfedge[patch[i]];
        add_face(h);
        for(int k = 0; k != 3; ++k, h = surface_.next[h])
        {
          const Index neighbor = surface_.face[surface_.opposite(h)];
          if(is_placed[neighbor] || patch.size() == patch_size)
            continue;
          is_placed[neighbor] = true;
          patch.push_back(neighbor);
        }
      }
    }
    begins_.push_back(faces_.size());
  }

  void add_face(Index h)
  {
    const std::array<Index, 3> corners = {surface_.source(h), surface_.target[h], surface_.target[surface_.next[h]]};
    Face face = {corners, {}};
    for(const Index v : corners)
    {
      const Closed_surface::Point& p = surface_.points[v];
      face.box += Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2]);
    }
    faces_.push_back(face);
    const bool is_any_flat = is_flat_[corners[0]] || is_flat_[corners[1]] || is_flat_[corners[2]];
    if(!is_any_flat && triangle(face).triangle().is_degenerate())
      result_[component_of(face)] = true;
  }

  Placed_triangle<Index> triangle(const Face& face) const
  {
    Placed_triangle<Index> result;
    for(std::size_t i = 0; i != 3; ++i)
    {
      const Closed_surface::Point& p = surface_.points[face.corners[i]];
      result.corners[i] = {face.corners[i], 0, Disc_point(p[0], p[1], p[2])};
    }
    return result;
  }

  // Tests those faces of two patches that overlap the other patch.
  void test_patches(const Numbered_box& a, const Numbered_box& b)
  {
    const auto find_near = [&](const Numbered_box& patch, const Bbox_3& other, std::vector<const Face*>& near) {
      near.clear();
      for(std::size_t i = begins_[patch.number]; i != begins_[patch.number + 1]; ++i)
        if(do_overlap(faces_[i].box, other))
          near.push_back(&faces_[i]);
    };
    find_near(a, b.bbox(), near_a_);
    find_near(b, a.bbox(), near_b_);
    for(const Face* face : near_a_)
      for(const Face* other : near_b_)
        test(*face, *other);
  }

  void test(const Face& a, const Face& b)
  {
    if(do_overlap(a.box, b.box) && !are_around_flat_vertex(a, b))
      test_exactly(a, b);
  }

  bool are_around_flat_vertex(const Face& a, const Face& b) const
  {
    for(const Index u : a.corners)
      for(const Index v : b.corners)
        if(u == v && is_flat_[u])
          return true;
    return false;
  }

  void test_exactly(const Face& a, const Face& b)
  {
    if(is_plane_between(a, b) || is_plane_between(b, a) || result_[component_of(a)])
      return;
    if(do_intersect(triangle(a), triangle(b)))
      result_[component_of(a)] = true;
  }

  // Whether the plane of `a`, or one across it through an edge, has `b` on its other side. The margin is as above.
  bool is_plane_between(const Face& a, const Face& b) const
  {
    const std::array<Vector, 3> edges = {way(a.corners[0], a.corners[1]), way(a.corners[1], a.corners[2]),
                                         way(a.corners[2], a.corners[0])};
    const Vector normal = cross(edges[0], edges[1]);
    const Bbox_3 box = a.box + b.box;
    const double size = (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
    double margin = 1e-12 * size * size * size;
    if(!(margin * size > 1e-250))
      return false;
    for(std::size_t i = 0; i != 4; ++i)
    {
      const Vector axis = i == 0 ? normal : cross(edges[i - 1], normal);
      std::array<double, 3> heights;
      for(std::size_t k = 0; k != 3; ++k)
        heights[k] = dot(axis, way(a.corners[i == 0 ? 0 : i - 1], b.corners[k]));
      if((std::min)({heights[0], heights[1], heights[2]}) > margin
         || (i == 0 && (std::max)({heights[0], heights[1], heights[2]}) < -margin))
        return true;
      if(i == 0)
        margin *= size;
    }
    return false;
  }

  const Closed_surface& surface_;
  const Tree_and_cotree& trees_;
  std::vector<bool> is_flat_; // by vertex
  std::vector<bool> result_;
  std::vector<Face> faces_;         // patch by patch
  std::vector<std::size_t> begins_; // of the patches, and the end of the last one
  std::vector<const Face*> near_a_, near_b_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_TRIANGLE_INTERSECTIONS_H
