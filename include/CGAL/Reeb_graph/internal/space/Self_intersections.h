// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SPACE_SELF_INTERSECTIONS_H
#define CGAL_REEB_GRAPH_INTERNAL_SPACE_SELF_INTERSECTIONS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/space/Surface_ball.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Triangles in space, by whose predicates it is told what intersects.
typedef Exact_predicates_inexact_constructions_kernel Disc_kernel;
typedef Disc_kernel::Point_3 Disc_point;

typedef Box_intersection_d::Box_with_info_d<double, 3, std::size_t> Numbered_box;

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

// Whether two triangles have more in common than the corners that they share, and the edge between two of these, if that
// is one edge and no double one. A triangle without area has nothing.
template <class VertexDescriptor>
bool do_intersect(Placed_triangle<VertexDescriptor> a, Placed_triangle<VertexDescriptor> b, bool is_edge_double = false)
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
  if(shared == 3 || (shared == 2 && is_edge_double))
    return true;
  if(shared == 2)
    return CGAL::coplanar(s[0], s[1], s[2], t[2])
        && CGAL::coplanar_orientation(s[0], s[1], s[2], t[2]) == CGAL::POSITIVE;
  if(shared == 1)
    return CGAL::do_intersect(s, Disc_kernel::Segment_3(t[1], t[2]))
        || CGAL::do_intersect(t, Disc_kernel::Segment_3(s[1], s[2]));
  return CGAL::do_intersect(s, t);
}

// Finds the components that intersect themselves, or have faces without area. Other components may pass through them.
// Faces are in patches, each inside of a ball. Where that is flat, as nearly always, none of its faces intersect. Other
// pairs of faces whose boxes overlap are tested exactly, unless they lie side by side around a vertex, or floating-point
// numbers find a plane between them. Around a vertex with many faces, as in the lid of a cylinder, all boxes overlap: there
// arcs tell which faces come near to each other. The same pairs are found as by
// Polygon_mesh_processing::self_intersections().
class Self_intersections
{
public:
  // Each pair is counted, or else one of a component is enough.
  Self_intersections(const Closed_triangles& surface,
                     std::vector<Index> components, // by vertex, no_index where none is looked for
                     std::size_t number_of_components,
                     bool are_counted)
    : surface_(surface),
      components_(std::move(components)),
      are_counted_(are_counted),
      ball_(surface),
      flatness_(surface.points.size(), Flatness::UNKNOWN),
      numbers_(number_of_components, 0)
  {}

  // The number of pairs, and of faces without area, by number of the component.
  template <class Progress>
  std::vector<std::size_t> operator()(const Progress& progress)
  {
    make_patches(progress);
    std::vector<Numbered_box> boxes;
    for(const Patch& patch : patches_)
    {
      boxes.push_back(Numbered_box(patch.extent.box(), boxes.size()));
      if(!patch.is_flat())
        test_patch(patch);
    }
    std::vector<std::pair<std::size_t, std::size_t>> pairs; // of a flat patch, and one that overlaps it
    box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Numbered_box& a, const Numbered_box& b) {
      const Patch &patch = patches_[a.info()], &other = patches_[b.info()];
      if(component_of(patch) != component_of(other) || is_same_fan(patch, other)
         || !do_overlap(patch.extent, other.extent))
        return;
      if(patch.is_flat())
        pairs.emplace_back(a.info(), b.info());
      else if(other.is_flat())
        pairs.emplace_back(b.info(), a.info());
      else
        test_patches(patch, other);
    });
    std::sort(pairs.begin(), pairs.end());
    std::size_t marked = patches_.size();
    for(std::size_t i = 0; i != pairs.size(); ++i)
    {
      if(i % 10000 == 0)
        progress(0.8 + 0.2 * static_cast<double>(i) / static_cast<double>(pairs.size()));
      const auto& [flat, other] = pairs[i];
      const Patch& patch = patches_[flat];
      if(marked != flat)
        ball_.mark(faces_of_balls_.begin() + patch.ball_begin, faces_of_balls_.begin() + patch.ball_end);
      marked = flat;
      test_patches(patch, patches_[other]);
    }
    test_fans();
    return numbers_;
  }

private:
  typedef Closed_triangles::Point Vector;
  enum class Flatness : unsigned char
  {
    UNKNOWN,
    FLAT,
    FOLDED
  };
  // Where points lie along the axes and their diagonals: rounding a sum of two keeps the order of exact ones. Spikes lean, and
  // boxes of many overlap that come nowhere near to each other.
  struct Extent
  {
    std::array<double, 9> least, greatest;

    Extent()
    {
      least.fill(std::numeric_limits<double>::infinity());
      greatest.fill(-std::numeric_limits<double>::infinity());
    }
    void add(const Vector& p)
    {
      const std::array<double, 9> places = {p[0],        p[1],        p[2],        p[0] + p[1], p[0] - p[1],
                                            p[0] + p[2], p[0] - p[2], p[1] + p[2], p[1] - p[2]};
      for(std::size_t i = 0; i != places.size(); ++i)
      {
        least[i] = (std::min)(least[i], places[i]);
        greatest[i] = (std::max)(greatest[i], places[i]);
      }
    }
    Bbox_3 box() const { return {least[0], least[1], least[2], greatest[0], greatest[1], greatest[2]}; }
    friend bool do_overlap(const Extent& a, const Extent& b)
    {
      for(std::size_t i = 0; i != a.least.size(); ++i)
        if(a.least[i] > b.greatest[i] || b.least[i] > a.greatest[i])
          return false;
      return true;
    }
  };
  struct Face
  {
    Index number;
    Extent extent;
  };
  struct Patch
  {
    std::size_t begin, end;              // of its faces
    std::ptrdiff_t ball_begin, ball_end; // of the faces of its ball, which are kept if that is flat
    Extent extent;
    Index hub = no_index; // the vertex that all of its faces are around, where that has many
    bool is_flat() const { return ball_begin != ball_end; }
  };

  static constexpr std::size_t most_steps = 2000; // A ball of seven layers takes 762 where vertices have six neighbors.
  static constexpr std::size_t largest_patch = 48; // of those that are not flat

  Index component_of(Index face) const { return components_[surface_.corners(face)[0]]; }
  Index component_of(const Patch& patch) const { return component_of(faces_[patch.begin]); }
  static bool is_same_fan(const Patch& a, const Patch& b) { return a.hub != no_index && a.hub == b.hub; }

  template <class Progress>
  void make_patches(const Progress& progress)
  {
    std::vector<bool> is_placed(surface_.halfedge.size(), false);
    faces_.reserve(surface_.halfedge.size());
    for(Index seed = 0; seed != surface_.halfedge.size(); ++seed)
    {
      if(seed % 100000 == 0)
        progress(0.7 * seed / static_cast<double>(surface_.halfedge.size()));
      while(!is_placed[seed] && component_of(seed) != no_index)
        make_patch(seed, is_placed);
    }
  }

  // A patch has the faces of a flat ball that are in none yet, but for those of the last layer: so what is around it is in
  // the ball too. The center is a few steps away from the seed, where many faces are in no patch. Larger balls would be
  // flat more seldom, and smaller ones have more faces in the last layer.
  void make_patch(Index seed, std::vector<bool>& is_placed)
  {
    const auto is_new = [&](Index face) { return !is_placed[face]; };
    ball_.grow(surface_.corners(seed)[0], 4, most_steps, is_new);
    const Index center = ball_.last_vertex();
    patches_.push_back({faces_.size(), 0, static_cast<std::ptrdiff_t>(faces_of_balls_.size()), 0, {}});
    for(const int number_of_layers : {7, 3})
    {
      if(!ball_.grow(center, number_of_layers, most_steps, [](Index) { return true; }) || !ball_.is_flat())
        continue;
      for(std::size_t i = 0; i != ball_.number_of_inner_faces(); ++i)
        if(is_new(ball_.faces()[i]))
          add_face(ball_.faces()[i], is_placed);
      break;
    }
    Patch& patch = patches_.back();
    if(faces_.size() != patch.begin)
      faces_of_balls_.insert(faces_of_balls_.end(), ball_.faces().begin(), ball_.faces().end());
    else
      add_connected_faces(seed, is_placed);
    patch.end = faces_.size();
    patch.ball_end = static_cast<std::ptrdiff_t>(faces_of_balls_.size());
  }

  // Faces that are not flat are compared one by one, so that the patch is small. Those around a vertex with many faces
  // are in patches of their own.
  void add_connected_faces(Index seed, std::vector<bool>& is_placed)
  {
    const std::size_t begin = faces_.size();
    const Index hub = patches_.back().hub = hub_of(seed);
    add_face(seed, is_placed);
    for(std::size_t i = begin; i != faces_.size(); ++i)
    {
      Index h = surface_.halfedge[faces_[i]];
      for(int k = 0; k != 3; ++k, h = surface_.next[h])
      {
        const Index neighbor = surface_.face[surface_.opposite(h)];
        if(!is_placed[neighbor] && faces_.size() != begin + largest_patch && hub_of(neighbor) == hub)
          add_face(neighbor, is_placed);
      }
    }
  }

  // The corner of a face that has many faces around it; no_index if there is none.
  Index hub_of(Index face)
  {
    for(const Index v : surface_.corners(face))
    {
      std::size_t number = 0;
      for(Index h = surface_.outgoing[v]; number <= largest_patch && (number == 0 || h != surface_.outgoing[v]);
          ++number)
        h = surface_.turned(h);
      if(number > largest_patch)
        return v;
    }
    return no_index;
  }

  void add_face(Index face, std::vector<bool>& is_placed)
  {
    is_placed[face] = true;
    faces_.push_back(face);
    for(const Index v : surface_.corners(face))
      patches_.back().extent.add(surface_.points[v]);
  }

  Extent extent(Index face) const
  {
    Extent result;
    for(const Index v : surface_.corners(face))
      result.add(surface_.points[v]);
    return result;
  }

  Placed_triangle<Index> triangle(const Face& face) const
  {
    Placed_triangle<Index> result;
    const std::array<Index, 3> corners = surface_.corners(face.number);
    for(std::size_t i = 0; i != 3; ++i)
    {
      const Closed_triangles::Point& p = surface_.points[corners[i]];
      result.corners[i] = {corners[i], 0, Disc_point(p[0], p[1], p[2])};
    }
    return result;
  }

  // Whether the faces around a vertex lie side by side.
  bool is_flat(Index v)
  {
    if(flatness_[v] == Flatness::UNKNOWN)
    {
      ball_.grow(v, 1, surface_.next.size(), [](Index) { return true; });
      flatness_[v] = ball_.is_flat() ? Flatness::FLAT : Flatness::FOLDED;
    }
    return flatness_[v] == Flatness::FLAT;
  }

  bool is_done(const Patch& patch) const { return !are_counted_ && numbers_[component_of(patch)] != 0; }

  void test_patch(const Patch& patch)
  {
    near_.clear();
    for(std::size_t i = patch.begin; i != patch.end && !is_done(patch); ++i)
    {
      const Face face = {faces_[i], extent(faces_[i])};
      const auto [u, v, w] = surface_.corners(face.number);
      if(!is_flat(u) && !is_flat(v) && !is_flat(w) && triangle(face).triangle().is_degenerate())
        ++numbers_[component_of(patch)];
      if(patch.hub == no_index)
        test_near(face, false);
      near_.push_back(face);
    }
  }

  // Tests the faces of patches around one vertex. Two that meet elsewhere, too, meet in the same direction seen from there.
  void test_fans()
  {
    std::map<Index, std::vector<std::size_t>> fans; // patches by vertex
    for(std::size_t i = 0; i != patches_.size(); ++i)
      if(patches_[i].hub != no_index && !is_flat(patches_[i].hub))
        fans[patches_[i].hub].push_back(i);
    for(const auto& [hub, patches] : fans)
    {
      std::vector<Numbered_box> arcs;
      for(const std::size_t i : patches)
        for(std::size_t k = patches_[i].begin; k != patches_[i].end; ++k)
          if(const Face face = {faces_[k], {}}; !triangle(face).triangle().is_degenerate())
            arcs.push_back(Numbered_box(arc_seen_from(hub, faces_[k]), faces_[k]));
      box_self_intersection_d(arcs.begin(), arcs.end(), [&](const Numbered_box& a, const Numbered_box& b) {
        const Index f = static_cast<Index>(a.info()), g = static_cast<Index>(b.info());
        if(!are_counted_ && numbers_[component_of(f)] != 0)
          return;
        const Face face = {f, extent(f)}, other = {g, extent(g)};
        if(do_overlap(face.extent, other.extent) && !are_around_flat_vertex(face, other))
          test(face, other);
      });
    }
  }

  // A box around the directions in which a face is seen from one of its corners. They bulge beyond those of the other two.
  Bbox_3 arc_seen_from(Index corner, Index face) const
  {
    Bbox_3 result;
    Vector sum = {0, 0, 0};
    for(const Index v : surface_.corners(face))
    {
      if(v == corner)
        continue;
      Vector way = surface_.way(corner, v);
      const double size = (std::max)({std::abs(way[0]), std::abs(way[1]), std::abs(way[2])});
      way = {way[0] / size, way[1] / size, way[2] / size};
      const double length = std::sqrt(dot(way, way));
      for(std::size_t k = 0; k != 3; ++k)
        sum[k] += way[k] /= length;
      result += Bbox_3(way[0], way[1], way[2], way[0], way[1], way[2]);
    }
    const double bulge = 1 - std::sqrt(dot(sum, sum)) / 2 + 1e-12;
    return {result.xmin() - bulge, result.ymin() - bulge, result.zmin() - bulge,
            result.xmax() + bulge, result.ymax() + bulge, result.zmax() + bulge};
  }

  // Tests those faces of two patches that overlap the other patch. If the ball of the first one is flat, it is marked, and
  // each face that shares a corner with the first patch is in it.
  void test_patches(const Patch& a, const Patch& b)
  {
    near_.clear();
    for(std::size_t i = b.begin; i != b.end && !is_done(a); ++i)
      if(!(a.is_flat() && ball_.contains(faces_[i])))
        if(const Face face = {faces_[i], extent(faces_[i])}; does_reach(face, a.extent))
          near_.push_back(face);
    for(std::size_t i = a.begin; i != a.end && !near_.empty(); ++i)
      if(const Face face = {faces_[i], extent(faces_[i])}; does_reach(face, b.extent))
        test_near(face, a.is_flat());
  }

  // Whether a face may come into a box: no plane across it through an edge has the box beyond, as for most of a long lean face.
  bool does_reach(const Face& face, const Extent& extent) const
  {
    if(!do_overlap(face.extent, extent))
      return false;
    const auto corners = surface_.corners(face.number);
    const Vector normal = cross(surface_.way(corners[0], corners[1]), surface_.way(corners[1], corners[2]));
    for(std::size_t i = 0; i != 3; ++i)
    {
      const Vector &from = surface_.points[corners[i]],
                   axis = cross(surface_.way(corners[i], corners[(i + 1) % 3]), normal);
      double lowest = 0, size = 0; // of the box, along what leads out of the face
      for(std::size_t k = 0; k != 3; ++k)
      {
        const double a = axis[k] * (extent.least[k] - from[k]), b = axis[k] * (extent.greatest[k] - from[k]);
        lowest += (std::min)(a, b);
        size += std::abs(a) + std::abs(b);
      }
      if(size > 1e-250 && lowest > 1e-12 * size)
        return false;
    }
    return true;
  }

  void test_near(const Face& face, bool is_apart)
  {
    for(const Face& other : near_)
      if(do_overlap(face.extent, other.extent) && (is_apart || !are_around_flat_vertex(face, other)))
        test(face, other);
  }

  bool are_around_flat_vertex(const Face& a, const Face& b)
  {
    for(const Index u : surface_.corners(a.number))
      for(const Index v : surface_.corners(b.number))
        if(u == v && is_flat(u))
          return true;
    return false;
  }

  void test(const Face& a, const Face& b)
  {
    const bool is_edge_double = have_double_edge(a.number, b.number);
    if((is_edge_double || (!is_plane_between(a, b) && !is_plane_between(b, a)))
       && do_intersect(triangle(a), triangle(b), is_edge_double))
      ++numbers_[component_of(a.number)];
  }

  // Whether an edge of one face joins the same vertices as another one of the other face.
  bool have_double_edge(Index a, Index b) const
  {
    Index h = surface_.halfedge[a], g = surface_.halfedge[b];
    for(int i = 0; i != 9; ++i, g = surface_.next[g], h = i % 3 == 0 ? surface_.next[h] : h)
      if(h / 2 != g / 2
         && std::minmax(surface_.target[h], surface_.source(h)) == std::minmax(surface_.target[g], surface_.source(g)))
        return true;
    return false;
  }

  // Whether the plane of `a`, or one across it through an edge, has `b` on its other side. The margin is as above.
  bool is_plane_between(const Face& a, const Face& b) const
  {
    const std::array<Index, 3> of_a = surface_.corners(a.number), of_b = surface_.corners(b.number);
    const std::array<Vector, 3> edges = {surface_.way(of_a[0], of_a[1]), surface_.way(of_a[1], of_a[2]),
                                         surface_.way(of_a[2], of_a[0])};
    const Vector normal = cross(edges[0], edges[1]);
    const Bbox_3 box = a.extent.box() + b.extent.box();
    std::array<std::size_t, 3> shared; // by corner of b, that of a
    for(std::size_t k = 0; k != 3; ++k)
      shared[k] = static_cast<std::size_t>(std::find(of_a.begin(), of_a.end(), of_b[k]) - of_a.begin());
    const double size = (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
    double margin = 1e-12 * size * size * size;
    if(!(margin * size > 1e-250 && margin * size < 1e250))
      return false;
    for(std::size_t i = 0; i != 4; ++i)
    {
      const Vector axis = i == 0 ? normal : cross(edges[i - 1], normal);
      double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
      for(std::size_t k = 0; k != 3; ++k)
      {
        if(shared[k] != 3 && (i == 0 || shared[k] != (i + 1) % 3)) // It is on the plane.
          continue;
        const double height = dot(axis, surface_.way(of_a[i == 0 ? 0 : i - 1], of_b[k]));
        lowest = (std::min)(lowest, height);
        highest = (std::max)(highest, height);
      }
      if(lowest <= highest && (lowest > margin || (i == 0 && highest < -margin)))
        return true;
      if(i == 0)
        margin *= size;
    }
    return false;
  }

  const Closed_triangles& surface_;
  const std::vector<Index> components_;
  const bool are_counted_;
  Surface_ball ball_;
  std::vector<Index> faces_, faces_of_balls_; // patch by patch
  std::vector<Patch> patches_;
  std::vector<Flatness> flatness_; // by vertex
  std::vector<Face> near_;
  std::vector<std::size_t> numbers_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_SPACE_SELF_INTERSECTIONS_H
