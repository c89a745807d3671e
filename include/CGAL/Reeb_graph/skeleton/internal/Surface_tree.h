// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_SURFACE_TREE_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_SURFACE_TREE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/skeleton/internal/Component_filling.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// A tree over a closed surface: tells what is inside, how far from it, and whether a segment crosses it.
class Surface_tree
{
public:
  explicit Surface_tree(const Mesh& mesh) : mesh_(mesh), tree_(faces(mesh).first, faces(mesh).second, mesh)
  {
    tree_.build();
    side_.emplace(tree_);
    double volume = 0;
    const Point origin = mesh.point(*mesh.vertices().begin());
    for(const auto f : mesh.faces())
    {
      const auto [a, b, c] = corners(f);
      volume += cross_product(a - origin, b - origin) * (c - origin);
    }
    is_inward_ = volume < 0;
  }

  bool is_inside(const Point& p) const { return (*side_)(p) == ON_BOUNDED_SIDE; }

  // The distance from the surface, which has a point near `p`.
  double distance_from(const Point& p, const Point& hint) const { return distance(p, tree_.closest_point(p, hint)); }

  bool is_crossed(const Point& p, const Point& q) const
  {
    return p != q && tree_.do_intersect(Kernel::Segment_3(p, q));
  }

  // The mean direction into the surface at a vertex.
  Vector inward_direction(Mesh::Vertex_index v) const
  {
    Vector sum = NULL_VECTOR;
    const auto first = mesh_.halfedge(v);
    auto h = first;
    do
    {
      const auto [a, b, c] = corners(mesh_.face(h));
      sum = sum + (is_inward_ ? 1 : -1) * cross_product(b - a, c - a);
      h = mesh_.opposite(mesh_.next(h));
    } while(h != first);
    const double size = length(sum);
    return size > 0 ? sum / size : sum;
  }

  // How far the other side is, from a point of the surface in a direction of length 1; 0 if it is not found.
  double depth_beneath(const Point& p, const Vector& direction) const
  {
    const auto middle = middle_of_chord(p, direction);
    return middle ? 2 * distance(p, *middle) : 0;
  }

  // A point inside near one that is not: in the middle between the closest point of the surface and what is seen from
  // there, away from the point or straight into the surface; or else right beneath a face.
  std::optional<Point> pulled_inside(const Point& p, const Point& hint) const
  {
    const auto closest = tree_.closest_point_and_primitive(p, {hint, *mesh_.faces().begin()});
    const Vector normal = inward_normal(closest.second);
    for(const Vector& direction : {closest.first - p, normal})
      if(const auto middle = middle_of_chord(closest.first, direction))
        return middle;
    const auto [a, b, c] = corners(closest.second);
    const double size = (std::max)({distance(a, b), distance(b, c), distance(c, a)});
    for(double depth = size; normal != NULL_VECTOR && depth > 1e-9 * size; depth /= 4)
      if(const Point sunk = sunk_center(closest.second, depth); is_inside(sunk))
        return sunk;
    return std::nullopt;
  }

  // A way from a point to another one that does not cross the surface: beneath its faces, as close as need be, with
  // shortcuts. An end can be a vertex of the surface. It is empty if there is none.
  std::vector<Point> way_beneath(const Point& from,
                                 const Point& to,
                                 std::optional<Mesh::Vertex_index> first_vertex,
                                 std::optional<Mesh::Vertex_index> last_vertex) const
  {
    const auto begin = foot(from, first_vertex), end = foot(to, last_vertex);
    const std::vector<Mesh::Halfedge_index> crossed = path_of_faces(begin.second, end.second);
    for(double depth = distance(from, to); depth > 1e-9 * distance(from, to); depth /= 4)
    {
      std::vector<Point> way = {from};
      if(!first_vertex)
        way.push_back(beneath(begin.first, from, depth));
      way.push_back(sunk_center(begin.second, depth));
      for(const auto h : crossed)
      {
        const Vector normal = inward_normal(mesh_.face(h)) + inward_normal(mesh_.face(mesh_.opposite(h)));
        const double size = length(normal);
        const Point middle = CGAL::midpoint(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h)));
        way.push_back(size > 0 ? middle + depth / size * normal : middle);
        way.push_back(sunk_center(mesh_.face(mesh_.opposite(h)), depth));
      }
      if(!last_vertex)
        way.push_back(beneath(end.first, to, depth));
      way.push_back(to);
      if(is_free(way, first_vertex.has_value(), last_vertex.has_value()))
        return shortened(way, first_vertex.has_value(), last_vertex.has_value());
    }
    return {};
  }

private:
  typedef AABB_face_graph_triangle_primitive<Mesh> Primitive;
#if CGAL_VERSION_NR >= 1060000000
  typedef AABB_traits_3<Kernel, Primitive> Traits;
#else
  typedef AABB_traits<Kernel, Primitive> Traits;
#endif
  typedef AABB_tree<Traits> Tree;
  typedef boost::property_map<Mesh, vertex_point_t>::const_type Point_map;
  typedef Side_of_triangle_mesh<Mesh, Kernel, Point_map, Tree> Side;

  std::array<Point, 3> corners(Mesh::Face_index f) const
  {
    const auto h = mesh_.halfedge(f);
    return {mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h)), mesh_.point(mesh_.target(mesh_.next(h)))};
  }

  Point center(Mesh::Face_index f) const
  {
    const auto [a, b, c] = corners(f);
    return CGAL::centroid(a, b, c);
  }

  // Of length 1, or the null vector if the face has no area.
  Vector inward_normal(Mesh::Face_index f) const
  {
    const auto [a, b, c] = corners(f);
    const Vector normal = cross_product(b - a, c - a);
    const double size = length(normal);
    return size > 0 ? (is_inward_ ? 1 : -1) / size * normal : Vector(NULL_VECTOR);
  }

  // How far along a line of unit direction the plane of a face is.
  double depth_of(Mesh::Face_index f, const Point& origin, const Vector& direction) const
  {
    const auto [a, b, c] = corners(f);
    const Vector normal = cross_product(b - a, c - a);
    const double slope = normal * direction;
    return slope != 0 ? normal * (a - origin) / slope : std::numeric_limits<double>::infinity();
  }

  // The middle of the first part of a ray from the surface that is inside.
  std::optional<Point> middle_of_chord(const Point& origin, const Vector& ray) const
  {
    const double size = length(ray);
    if(!(size > 0))
      return std::nullopt;
    const Vector direction = ray / size;
    std::vector<double> depths = {0};
    const auto add = [&](Mesh::Face_index f) { depths.push_back(depth_of(f, origin, direction)); };
    tree_.all_intersected_primitives(Kernel::Ray_3(origin, direction),
                                     boost::make_function_output_iterator(std::cref(add)));
    std::sort(depths.begin(), depths.end());
    for(std::size_t i = 1; i != depths.size() && std::isfinite(depths[i]); ++i)
    {
      const Point middle = origin + (depths[i - 1] + depths[i]) / 2 * direction;
      if(depths[i - 1] >= 0 && depths[i] - depths[i - 1] > 1e-6 * depths[i] && is_inside(middle))
        return middle;
    }
    return std::nullopt;
  }

  Point sunk_center(Mesh::Face_index f, double depth) const { return center(f) + depth * inward_normal(f); }

  static Point beneath(const Point& foot, const Point& p, double depth)
  {
    const double height = distance(foot, p);
    return height > depth ? foot + depth / height * (p - foot) : p;
  }

  // A place on the surface that is seen from a point, and its face. That of the closest point can be hidden if this is at
  // a corner, behind other faces there.
  std::pair<Point, Mesh::Face_index> foot(const Point& p, std::optional<Mesh::Vertex_index> v) const
  {
    if(v)
      return {p, mesh_.face(mesh_.halfedge(*v))};
    const auto closest = tree_.closest_point_and_primitive(p);
    for(double t = 0.5; t > 1e-6; t /= 2)
      if(const auto seen = first_seen(p, closest.first + t * (center(closest.second) - closest.first) - p))
        return *seen;
    return closest;
  }

  // The place where a ray from inside meets the surface first, and the face there; none at an edge.
  std::optional<std::pair<Point, Mesh::Face_index>> first_seen(const Point& origin, const Vector& ray) const
  {
    const double size = length(ray);
    if(!(size > 0))
      return std::nullopt;
    const Vector direction = ray / size;
    std::vector<std::pair<double, Mesh::Face_index>> met;
    const auto add = [&](Mesh::Face_index f) { met.push_back({depth_of(f, origin, direction), f}); };
    tree_.all_intersected_primitives(Kernel::Ray_3(origin, direction),
                                     boost::make_function_output_iterator(std::cref(add)));
    std::sort(met.begin(), met.end());
    if(met.empty() || !std::isfinite(met.back().first) || !(met.front().first > 0)
       || (met.size() > 1 && !(met[1].first - met[0].first > 1e-9 * size)))
      return std::nullopt;
    return std::make_pair(origin + met.front().first * direction, met.front().second);
  }

  bool is_crossed(const std::vector<Point>& way, std::size_t i, std::size_t j, bool is_first_on, bool is_last_on) const
  {
    const Vector step = 1e-6 * (way[j] - way[i]);
    const Point p = i == 0 && is_first_on ? way[i] + step : way[i];
    const Point q = j + 1 == way.size() && is_last_on ? way[j] - step : way[j];
    return is_crossed(p, q);
  }

  bool is_free(const std::vector<Point>& way, bool is_first_on, bool is_last_on) const
  {
    for(std::size_t i = 0; i + 1 < way.size(); ++i)
      if(is_crossed(way, i, i + 1, is_first_on, is_last_on))
        return false;
    return true;
  }

  // Leaves points out as long as nothing is crossed.
  std::vector<Point> shortened(const std::vector<Point>& way, bool is_first_on, bool is_last_on) const
  {
    std::vector<Point> result = {way.front()};
    for(std::size_t i = 0; i + 1 < way.size();)
    {
      std::size_t j = i + 1;
      for(std::size_t step = 2; i + step < way.size() && !is_crossed(way, i, i + step, is_first_on, is_last_on);
          step = (std::min)(2 * step, way.size() - 1 - i))
      {
        j = i + step;
        if(j + 1 == way.size())
          break;
      }
      while(j + 1 < way.size() && !is_crossed(way, i, j + 1, is_first_on, is_last_on))
        ++j;
      result.push_back(way[j]);
      i = j;
    }
    return result;
  }

  // The halfedges through which a short path of faces leads, along the centers: each of the face that it leaves.
  std::vector<Mesh::Halfedge_index> path_of_faces(Mesh::Face_index from, Mesh::Face_index to) const
  {
    struct Reached
    {
      double distance;
      Mesh::Halfedge_index through;
    };
    typedef std::pair<double, Mesh::Face_index> Entry;
    std::unordered_map<std::size_t, Reached> reached = {{from.idx(), {0, Mesh::null_halfedge()}}};
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    queue.push({distance(center(from), center(to)), from});
    while(!queue.empty() && queue.top().second != to)
    {
      const auto f = queue.top().second;
      queue.pop();
      const double so_far = reached.at(f.idx()).distance;
      auto h = mesh_.halfedge(f);
      for(int i = 0; i != 3; ++i, h = mesh_.next(h))
      {
        const auto g = mesh_.face(mesh_.opposite(h));
        const double next = so_far + distance(center(f), center(g));
        const auto found = reached.find(g.idx());
        if(found != reached.end() && !(next < found->second.distance))
          continue;
        reached[g.idx()] = {next, h};
        queue.push({next + distance(center(g), center(to)), g});
      }
    }
    std::vector<Mesh::Halfedge_index> path;
    for(auto f = to; f != from; f = mesh_.face(path.back()))
      path.push_back(reached.at(f.idx()).through);
    std::reverse(path.begin(), path.end());
    return path;
  }

  const Mesh& mesh_;
  Tree tree_;
  std::optional<Side> side_;
  bool is_inward_ = false;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_SURFACE_TREE_H
