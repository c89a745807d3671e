// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_INTERNAL_HANDLE_REMOVER_H
#define CGAL_REEB_GRAPH_HANDLES_INTERNAL_HANDLE_REMOVER_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/handles/Handle_loop.h>
#include <CGAL/Reeb_graph/handles/area_of_filling_disc.h>
#include <CGAL/Reeb_graph/handles/internal/Closed_surface.h>
#include <CGAL/Reeb_graph/handles/internal/make_loops.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/Threads.h>
#include <CGAL/Reeb_graph/internal/complex/Curve_opening.h>
#include <CGAL/Reeb_graph/internal/space/Self_intersections.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/box_intersection_d.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

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
    std::vector<Disc_point> polyline, left, right;
    for(const halfedge_descriptor h : loop_)
    {
      passed_.insert(source(h, mesh));
      polyline.push_back(point(source(h, mesh)));
      left.push_back(point(target(next(h, mesh), mesh)));
      right.push_back(point(target(next(opposite(h, mesh), mesh), mesh)));
    }
    find_joined_vertices();
    for(const auto& third_points : {std::vector<Disc_point>(), left, right})
    {
      span_disc(polyline, third_points);
      if(find_place())
        return;
    }
  }

  const std::vector<halfedge_descriptor>& loop() const { return loop_; }
  bool passes(vertex_descriptor v) const { return passed_.count(v) != 0; }
  const std::vector<Triangle>& disc() const { return disc_; } // that spans the loop; empty if there is none
  // The faces around the loop, and the discs, as they will be. Empty if they would intersect each other.
  const std::vector<Triangle>& placed() const { return placed_; }

  // Cuts the mesh. The visitor is told of what is added. Calls act(face) for each face that is new or has changed.
  template <class Visitor, class Act>
  void operator()(Mesh& mesh, Visitor& visitor, const Act& act) const
  {
    Curve<halfedge_descriptor> curve;
    curve.halfedges = loop_;
    curve.is_closed = true;
    curve.lower_halfedges.resize(loop_.size());
    Curve_opening(mesh, point_map_, visitor)(curve);
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

  Disc_point point(vertex_descriptor v) const { return disc_point(get(point_map_, v)); }

  void span_disc(const std::vector<Disc_point>& polyline, const std::vector<Disc_point>& third_points)
  {
    disc_.clear();
    disc_triangles_ = triangulate_disc(
      polyline, third_points, [&](std::size_t i, std::size_t j) { return joined_.count(std::minmax(i, j)) != 0; });
    for(auto& t : disc_triangles_)
      std::sort(t.begin(), t.end());
    add_disc(disc_, 0, polyline);
    find_normals(polyline);
  }

  // Finds the vertices of the loop that an edge joins which leaves both on the same side of the loop. An inner edge of the
  // disc between them would be there twice.
  void find_joined_vertices()
  {
    const std::size_t size = loop_.size();
    std::array<std::map<halfedge_descriptor, std::size_t>, 2> leaving; // positions of their sources, by the side
    for(std::size_t k = 0; k != size; ++k)
    {
      const halfedge_descriptor back = opposite(loop_[(k + size - 1) % size], mesh_);
      for(halfedge_descriptor h = turned(loop_[k]); h != back; h = turned(h))
        leaving[0].emplace(h, k);
      for(halfedge_descriptor h = turned(back); h != loop_[k]; h = turned(h))
        leaving[1].emplace(h, k);
    }
    for(const auto& side : leaving)
      for(const auto& [h, position] : side)
      {
        const auto other = side.find(opposite(h, mesh_));
        if(other != side.end())
          joined_.insert(std::minmax(position, other->second));
      }
  }

  // Moves the copies until nothing intersects; false if nothing helps, or if there is no disc.
  bool find_place()
  {
    if(disc_.empty())
      return false;
    for(const bool is_along_normals : {false, true})
      for(const double step : {0.25, 0.05, 0.01})
      {
        place(step, is_along_normals);
        if(fits_itself())
          return true;
      }
    placed_.clear();
    return false;
  }

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

  // For each vertex of the loop, the sum of the normals of the disc around it, divided by that of their lengths, and times
  // the length of the halfedge that leaves the vertex. They point to the left of the loop, if it is seen as a ring around
  // a tube.
  void find_normals(const std::vector<Disc_point>& polyline)
  {
    normals_.assign(loop_.size(), CGAL::NULL_VECTOR);
    std::vector<double> lengths(loop_.size(), 0);
    for(const auto& t : disc_triangles_)
    {
      const auto normal = CGAL::cross_product(polyline[t[1]] - polyline[t[0]], polyline[t[2]] - polyline[t[0]]);
      for(const std::size_t k : t)
      {
        normals_[k] = normals_[k] + normal;
        lengths[k] += std::sqrt(normal.squared_length());
      }
    }
    const double sign = points_left() ? 1 : -1;
    for(std::size_t k = 0; k != loop_.size(); ++k)
    {
      const double edge = std::sqrt(CGAL::squared_distance(polyline[k], polyline[(k + 1) % loop_.size()]));
      normals_[k] = normals_[k] * (lengths[k] > 0 ? sign * edge / lengths[k] : 0);
    }
  }

  // Whether the normals of the disc point to the left of most of the loop.
  bool points_left() const
  {
    double sum = 0;
    for(std::size_t k = 0; k != loop_.size(); ++k)
    {
      const Disc_point left = point(target(next(loop_[k], mesh_), mesh_));
      const Disc_point right = point(target(next(opposite(loop_[k], mesh_), mesh_), mesh_));
      sum += normals_[k] * (left - right) > 0 ? 1 : -1;
    }
    return sum > 0;
  }

  // Moves the copies by this part of the way to the mean of their neighbors, or of a normal.
  void place(double step, bool is_along_normals)
  {
    placed_.clear();
    const std::size_t size = loop_.size();
    std::map<halfedge_descriptor, std::pair<int, Disc_point>>
      copies; // by the halfedge that leads to a vertex in a face
    std::array<std::vector<Disc_point>, 2> points;
    for(std::size_t side : {0, 1})
    {
      moved_[side].clear();
      for(std::size_t k = 0; k != size; ++k)
      {
        const halfedge_descriptor back = opposite(loop_[(k + size - 1) % size], mesh_);
        const halfedge_descriptor begin = side == 0 ? loop_[k] : back, end = side == 0 ? back : loop_[k];
        moved_[side].push_back(is_along_normals ? moved(begin, (side == 0 ? step : -step) * normals_[k])
                                                : moved(begin, step * way_to_neighbors(begin, end)));
        points[side].push_back(disc_point(moved_[side].back()));
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

  void place_face(halfedge_descriptor h, const std::map<halfedge_descriptor, std::pair<int, Disc_point>>& copies)
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

  // From the source of two halfedges to the mean of the neighbors between them, counterclockwise.
  Disc_kernel::Vector_3 way_to_neighbors(halfedge_descriptor begin, halfedge_descriptor end) const
  {
    Disc_kernel::Vector_3 sum = CGAL::NULL_VECTOR;
    int number = 0;
    for(halfedge_descriptor h = turned(begin); h != end; h = turned(h), ++number)
      sum = sum + (point(target(h, mesh_)) - point(source(begin, mesh_)));
    return number == 0 ? sum : sum / number;
  }

  Point moved(halfedge_descriptor h, const Disc_kernel::Vector_3& way) const
  {
    const Disc_point p = point(source(h, mesh_)) + way;
    return Point(p.x(), p.y(), p.z());
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
      result = result && !internal::do_intersect(placed_[a.info()], placed_[b.info()]);
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
  std::set<std::pair<std::size_t, std::size_t>>
    joined_;                                   // positions in the loop, which no inner edge of the disc may join
  Disc_triangles disc_triangles_;              // by positions in the loop
  std::vector<Disc_kernel::Vector_3> normals_; // of the disc
  std::vector<Triangle> disc_, placed_;
  std::array<std::vector<Point>, 2> moved_; // the vertices of the loop, on its left and on its right
};

// Removes handles in rounds. All loops of a round are found at once: cuts along some of them leave the others a basis of
// what is left, as they do not cross, if they do not touch. Those that touch are left to the next round.
template <class Mesh, class PointMap, class Visitor>
class Handle_remover
{
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<Mesh>::face_descriptor face_descriptor;
  typedef Loop_cut<Mesh, PointMap> Cut;
  typedef typename Cut::Triangle Triangle;
  typedef Handle_removal<typename boost::graph_traits<Mesh>::vertex_descriptor> Row;

  struct Plan
  {
    Cut cut;
    Row row;
    std::vector<std::size_t> rivals; // plans of smaller handles that the cut would intersect
  };

public:
  Handle_remover(Mesh& mesh, const PointMap& point_map, Visitor& visitor, const Threads& threads)
    : mesh_(mesh),
      point_map_(point_map),
      visitor_(visitor),
      threads_(threads)
  {}

  // Removes handles that are smaller than `size`, at most `number` of them. The last ones of the list are refused.
  std::vector<Row> operator()(double size, std::size_t number, bool are_checked, const Progress& progress)
  {
    std::vector<Row> removed;
    double begin = 0;
    while(removed.size() < number)
    {
      const double end = 0.5 + begin / 2; // as the number of rounds is not known
      plan(size, number - removed.size(), are_checked, Stage_progress(progress, begin, begin + 0.8 * (end - begin)));
      find_conflicts();
      const std::size_t number_before = removed.size();
      const std::vector<Row> refused = cut(removed, number, Stage_progress(progress, begin + 0.8 * (end - begin), end));
      if(removed.size() == number_before || removed.size() == number)
      {
        removed.insert(removed.end(), refused.begin(), refused.end());
        break;
      }
      begin = end;
    }
    return removed;
  }

private:
  // Finds the loops, and plans the cuts, the smallest first.
  void plan(double size, std::size_t number, bool are_checked, const Stage_progress& progress)
  {
    plans_.clear();
    Surface_closing<Mesh> closing(mesh_, make_flat_mesh(mesh_), point_map_);
    const auto found = make_loop_finder(std::move(closing.surface()), progress.part(0, 0.2));
    const std::vector<std::size_t> components = number_components(closing, *found);
    const auto find_crossed = [&] {
      if(!are_checked)
        return;
      if(is_crossed_.empty()) // A cut makes none, so they are looked for once.
        is_crossed_ = found->self_intersections(false);
      std::vector<std::size_t> is_crossed;
      for(const std::size_t component : components)
        is_crossed.push_back(is_crossed_[component]);
      found->refuse_self_intersections(is_crossed);
    };
    const std::vector<Surface_loop> loops =
      found->make_loops(size, number, find_crossed, threads_, progress.part(0.2, 1));
    std::vector<const Surface_loop*> shorter;
    for(std::size_t i = 0; i != loops.size(); ++i)
    {
      if(loops[i].kind == Loop_kind::HOLE || loops[i].partner < i)
        continue;
      const Surface_loop& partner = loops[loops[i].partner];
      shorter.push_back(partner.length < loops[i].length ? &partner : &loops[i]);
    }
    std::stable_sort(shorter.begin(), shorter.end(),
                     [](const Surface_loop* a, const Surface_loop* b) { return a->length < b->length; });
    for(const Surface_loop* loop : shorter)
    {
      if(!(loop->length < size))
        break;
      std::vector<halfedge_descriptor> halfedges;
      for(const Index h : loop->halfedges)
        halfedges.push_back(closing.halfedge_of(h));
      add_plan(*loop, components[loop->component], std::move(halfedges));
    }
    components_.clear();
    for(const face_descriptor f : faces(mesh_))
      components_.push_back(components[component_of(closing.number(halfedge(f, mesh_)), *found)]);
  }

  static std::size_t component_of(Index h, const Loop_finder& found)
  {
    return found.component_of(found.surface().target[h]);
  }

  // The number that each component had before the first cut. It may come in another order, as a mesh may put new vertices
  // where removed ones have been.
  std::vector<std::size_t> number_components(const Surface_closing<Mesh>& closing, const Loop_finder& found)
  {
    const std::size_t size = found.number_of_components();
    if(representatives_.empty())
    {
      representatives_.resize(size);
      for(std::size_t h = closing.number_of_halfedges(); h != 0; --h)
        representatives_[component_of(static_cast<Index>(h - 1), found)] =
          closing.halfedge_of(static_cast<Index>(h - 1));
    }
    std::vector<std::size_t> result(size, 0);
    for(std::size_t i = 0; i != size; ++i)
      result[component_of(closing.number(representatives_[i]), found)] = i;
    return result;
  }

  void add_plan(const Surface_loop& loop, std::size_t component, std::vector<halfedge_descriptor> halfedges)
  {
    Row row;
    row.kind = loop.kind;
    row.length = loop.length;
    row.component = component;
    bool is_at_border = false;
    for(const halfedge_descriptor h : halfedges)
    {
      is_at_border = is_at_border || CGAL::is_border(target(h, mesh_), mesh_).has_value();
      row.vertices.push_back(source(h, mesh_));
      const auto point = get(point_map_, source(h, mesh_));
      row.points.push_back({to_double(point.x()), to_double(point.y()), to_double(point.z())});
    }
    if(!loop.is_simple || is_at_border)
    {
      row.result = loop.is_simple ? Removal_result::PASSES_HOLE : Removal_result::CROSSES_ITSELF;
      halfedges.clear();
    }
    plans_.push_back({plan_cut(std::move(halfedges)), row, {}});
    Plan& plan = plans_.back();
    if(row.result == Removal_result::REMOVED && plan.cut.disc().empty())
      plan.row.result = Removal_result::NO_DISC;
    else if(row.result == Removal_result::REMOVED && plan.cut.placed().empty())
      plan.row.result = Removal_result::INTERSECTS;
  }

  // Plans the cut along a loop, or along one near by, if the faces around the loop are in the way of its disc.
  Cut plan_cut(std::vector<halfedge_descriptor> loop) const
  {
    Cut cut(mesh_, point_map_, loop);
    if(!cut.placed().empty())
      return cut;
    std::array<std::vector<halfedge_descriptor>, 2> beside = {loop, reversed(loop)};
    for(int step = 0; step != 3; ++step)
      for(auto& side : beside)
      {
        side = reversed(loop_beside(side));
        Cut other(mesh_, point_map_, side);
        if(!other.placed().empty())
          return other;
      }
    return cut;
  }

  std::vector<halfedge_descriptor> reversed(const std::vector<halfedge_descriptor>& loop) const
  {
    std::vector<halfedge_descriptor> result;
    for(auto h = loop.rbegin(); h != loop.rend(); ++h)
      result.push_back(opposite(*h, mesh_));
    return result;
  }

  // The loop that bounds the faces on the left of a loop on their other side; empty if it passes a vertex twice, one of
  // the loop, or one of a border.
  std::vector<halfedge_descriptor> loop_beside(const std::vector<halfedge_descriptor>& loop) const
  {
    std::vector<halfedge_descriptor> result;
    std::set<typename boost::graph_traits<Mesh>::vertex_descriptor> passed;
    const auto turned = [&](halfedge_descriptor h) { return opposite(prev(h, mesh_), mesh_); };
    bool is_simple = true;
    for(const halfedge_descriptor h : loop)
      is_simple = passed.insert(source(h, mesh_)).second && is_simple;
    for(std::size_t k = loop.size(); k != 0; --k)
    {
      const halfedge_descriptor back = opposite(loop[k == 1 ? loop.size() - 1 : k - 2], mesh_);
      for(halfedge_descriptor h = turned(loop[k - 1]); h != back && turned(h) != back; h = turned(h))
      {
        result.push_back(next(h, mesh_));
        is_simple =
          is_simple && passed.insert(target(h, mesh_)).second && !CGAL::is_border(target(h, mesh_), mesh_).has_value();
      }
    }
    return is_simple ? result : std::vector<halfedge_descriptor>();
  }

  // Finds what the discs, and the faces as they will be, intersect: faces of the mesh that do not change, and each other.
  void find_conflicts()
  {
    struct Planned
    {
      const Triangle* triangle;
      std::size_t plan;
      bool is_disc;
    };
    std::vector<Planned> planned;
    std::vector<Numbered_box> boxes;
    std::vector<Bbox_3> plan_boxes(plans_.size());
    for(std::size_t i = 0; i != plans_.size(); ++i)
      for(const bool is_disc : {true, false})
        for(const Triangle& t : is_disc ? plans_[i].cut.disc() : plans_[i].cut.placed())
        {
          boxes.push_back(Numbered_box(t.triangle().bbox(), planned.size()));
          plan_boxes[i] += t.triangle().bbox();
          planned.push_back({&t, i, is_disc});
        }
    if(boxes.empty())
      return;
    const std::vector<face_descriptor> all_faces(faces(mesh_).begin(), faces(mesh_).end());
    std::vector<Numbered_box> face_boxes = boxes_of_faces_near(all_faces, mesh_, point_map_, plan_boxes);
    box_intersection_d(boxes.begin(), boxes.end(), face_boxes.begin(), face_boxes.end(),
                       [&](const Numbered_box& a, const Numbered_box& b) {
                         const Planned& t = planned[a.info()];
                         const auto vertices = face_corners(all_faces[b.info()], mesh_);
                         Plan& plan = plans_[t.plan];
                         if(std::any_of(vertices.begin(), vertices.end(), [&](auto v) { return plan.cut.passes(v); }))
                           return;
                         Triangle face;
                         for(std::size_t k = 0; k != 3; ++k)
                           face.corners[k] = {vertices[k], 0, disc_point(get(point_map_, vertices[k]))};
                         if(do_intersect(*t.triangle, face))
                           refuse(plan, components_[b.info()] != plan.row.component, t.is_disc);
                       });
    box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Numbered_box& a, const Numbered_box& b) {
      const Planned &s = planned[a.info()], &t = planned[b.info()];
      if(s.plan != t.plan && !s.is_disc && !t.is_disc && do_intersect(*s.triangle, *t.triangle))
        plans_[(std::max)(s.plan, t.plan)].rivals.push_back((std::min)(s.plan, t.plan));
    });
  }

  // The reason that tells most stays.
  static void refuse(Plan& plan, bool is_other_component, bool is_disc)
  {
    Removal_result& result = plan.row.result;
    if(is_other_component)
      result = Removal_result::OTHER_COMPONENT;
    else if(is_disc && result != Removal_result::OTHER_COMPONENT)
      result = Removal_result::NO_DISC;
    else if(result == Removal_result::REMOVED)
      result = Removal_result::INTERSECTS;
  }

  // Makes the cuts. Returns what is refused.
  std::vector<Row> cut(std::vector<Row>& removed, std::size_t number, const Stage_progress& progress)
  {
    std::vector<Row> refused;
    std::vector<bool> is_cut(plans_.size(), false);
    std::set<face_descriptor> changed;
    for(std::size_t i = 0; i != plans_.size() && removed.size() != number; ++i)
    {
      progress.report_step(i, plans_.size());
      const Plan& plan = plans_[i];
      if(plan.row.result != Removal_result::REMOVED)
        refused.push_back(plan.row);
      else if(!is_touched(plan, is_cut, changed))
      {
        plan.cut(mesh_, visitor_, [&](face_descriptor f) { changed.insert(f); });
        is_cut[i] = true;
        removed.push_back(plan.row);
      }
    }
    return refused;
  }

  // Whether a cut that has been made has changed what the plan is for.
  bool is_touched(const Plan& plan, const std::vector<bool>& is_cut, const std::set<face_descriptor>& changed) const
  {
    if(std::any_of(plan.rivals.begin(), plan.rivals.end(), [&](std::size_t rival) { return is_cut[rival]; }))
      return true;
    for(const halfedge_descriptor h : plan.cut.loop())
      for(const face_descriptor f : faces_around_target(h, mesh_))
        if(changed.count(f) != 0)
          return true;
    return false;
  }

  Mesh& mesh_;
  const PointMap& point_map_;
  Visitor& visitor_;
  const Threads threads_;
  std::vector<std::size_t> is_crossed_;              // by component
  std::vector<halfedge_descriptor> representatives_; // of the components
  std::deque<Plan> plans_;
  std::vector<std::size_t> components_; // of the faces
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_HANDLE_REMOVER_H
