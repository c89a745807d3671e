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

// A point that is not outside of a surface, and the vertex that it is, if any.
struct Surface_place
{
  Point point;
  std::optional<Mesh::Vertex_index> vertex;
};

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
    const auto box = tree_.bbox();
    size_ = distance({box.xmin(), box.ymin(), box.zmin()}, {box.xmax(), box.ymax(), box.zmax()});
  }

  bool is_inside(const Point& p) const { return (*side_)(p) == ON_BOUNDED_SIDE; }

  // The distance from the surface, which has a point near `p`.
  double distance_from(const Point& p, const Point& hint) const { return distance(p, tree_.closest_point(p, hint)); }

  // Whether a segment meets the surface, other than in a vertex that is its end, by exact predicates.
  bool is_crossed(const Surface_place& from, const Surface_place& to) const
  {
    if(from.point == to.point)
      return false;
    const Kernel::Segment_3 segment(from.point, to.point);
    if(!from.vertex && !to.vertex)
      return tree_.do_intersect(segment);
    bool result = false;
    const auto add = [&](Mesh::Face_index f) { result = result || !is_met_in_end(f, from, to); };
    tree_.all_intersected_primitives(segment, boost::make_function_output_iterator(std::cref(add)));
    return result;
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

  // How far the other side is, from a vertex in a direction of length 1; 0 if it is not found.
  double depth_beneath(Mesh::Vertex_index v, const Vector& direction) const
  {
    const Point& p = mesh_.point(v);
    const auto middle = middle_of_chord(p, direction, [&](auto f) { return has_corner(f, v); });
    return middle ? 2 * distance(p, *middle) : 0;
  }

  // Whether a point is inside, and farther from the surface than by rounding.
  bool is_well_inside(const Point& p, const Point& hint) const
  {
    return is_inside(p) && distance_from(p, hint) > 1e-9 * size_;
  }

  // A point inside near one that is not, or hardly: in the middle between the closest point of the surface and what is seen
  // from there, away from the point or straight into the surface; or else right beneath a face.
  std::optional<Point> pulled_inside(const Point& p, const Point& hint) const
  {
    const auto closest = tree_.closest_point_and_primitive(p, {hint, *mesh_.faces().begin()});
    const Vector normal = inward_normal(closest.second);
    for(const Vector& direction : {is_inside(p) ? normal : closest.first - p, normal})
      if(const auto middle = middle_of_chord(closest.first, direction, [&](auto f) { return f == closest.second; }))
        return middle;
    const auto [a, b, c] = corners(closest.second);
    const double size = (std::max)({distance(a, b), distance(b, c), distance(c, a)});
    for(double depth = size; normal != NULL_VECTOR && depth > 1e-9 * size; depth /= 4)
      if(const Point beneath = center(closest.second) + depth * normal; is_inside(beneath))
        return beneath;
    return std::nullopt;
  }

  // A way from a place to another one that does not cross the surface: beneath its faces, as close as need be, with
  // shortcuts. It is empty if there is none.
  std::vector<Point> way_beneath(const Surface_place& from, const Surface_place& to) const
  {
    std::vector<Sunk_place> way = {{from, NULL_VECTOR, 0}};
    const Mesh::Face_index begin = add_foot(from, way);
    std::vector<Sunk_place> end = {{to, NULL_VECTOR, 0}};
    const Mesh::Face_index last = add_foot(to, end);
    way.push_back(sunk_center(begin));
    for(const auto h : path_of_faces(begin, last))
    {
      const Mesh::Face_index f = mesh_.face(h), g = mesh_.face(mesh_.opposite(h));
      const Point middle = CGAL::midpoint(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h)));
      const Vector normal = inward_normal(f) + inward_normal(g);
      if(const double size = length(normal); size > 0)
        way.push_back(sunk(middle, normal / size, f, g));
      way.push_back(sunk_center(g));
    }
    way.insert(way.end(), end.rbegin(), end.rend());
    return raise_until_free(way) ? shortened(way) : std::vector<Point>();
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

  // A place of a way, which can be brought nearer to the surface.
  struct Sunk_place
  {
    Surface_place place;
    Vector inwards; // of length 1, or null if the place is to stay
    double depth;
  };

  bool has_corner(Mesh::Face_index f, Mesh::Vertex_index v) const
  {
    const auto h = mesh_.halfedge(f);
    return mesh_.source(h) == v || mesh_.target(h) == v || mesh_.target(mesh_.next(h)) == v;
  }

  bool is_met_in_end(Mesh::Face_index f, const Surface_place& from, const Surface_place& to) const
  {
    const auto has = [&](const Surface_place& place) { return place.vertex && has_corner(f, *place.vertex); };
    if(has(from) == has(to))
      return false;
    const auto [a, b, c] = corners(f);
    return !coplanar(a, b, c, has(from) ? to.point : from.point);
  }

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

  // The middle of the first part of a ray from the surface that is inside. The faces that the ray begins on are left out, as the
  // depth of these is rounded to anything near 0.
  template <class IsOwn>
  std::optional<Point> middle_of_chord(const Point& origin, const Vector& ray, const IsOwn& is_own) const
  {
    const double size = length(ray);
    if(!(size > 0))
      return std::nullopt;
    const Vector direction = ray / size;
    std::vector<double> depths = {0};
    const auto add = [&](Mesh::Face_index f) {
      if(!is_own(f))
        depths.push_back(depth_of(f, origin, direction));
    };
    tree_.all_intersected_primitives(Kernel::Ray_3(origin, direction),
                                     boost::make_function_output_iterator(std::cref(add)));
    std::sort(depths.begin(), depths.end());
    for(std::size_t i = 1; i != depths.size() && std::isfinite(depths[i]); ++i)
    {
      const Point middle = origin + (depths[i - 1] + depths[i]) / 2 * direction;
      if(depths[i - 1] >= 0 && depths[i] - depths[i - 1] > 1e-9 * size_ && is_inside(middle))
        return middle;
    }
    return std::nullopt;
  }

  // In the middle between a point of the surface and what is seen from there.
  Sunk_place sunk(const Point& p, const Vector& inwards, Mesh::Face_index f, Mesh::Face_index g) const
  {
    const auto middle = middle_of_chord(p, inwards, [&](auto face) { return face == f || face == g; });
    const double depth = middle ? distance(p, *middle) : 1e-6 * size_;
    return {{p + depth * inwards, std::nullopt}, inwards, depth};
  }

  Sunk_place sunk_center(Mesh::Face_index f) const { return sunk(center(f), inward_normal(f), f, f); }

  // A face at a place, and, if that is inside, on a way to it a point on a ray to the face.
  Mesh::Face_index add_foot(const Surface_place& from, std::vector<Sunk_place>& way) const
  {
    if(from.vertex)
      return mesh_.face(mesh_.halfedge(*from.vertex));
    const auto [foot, f] = seen_foot(from.point);
    const double height = distance(foot, from.point);
    if(height > 0)
      way.push_back({from, (from.point - foot) / height, height});
    return f;
  }

  // A place on the surface that is seen from a point, and its face. That of the closest point can be hidden if this is at
  // a corner, behind other faces there: then another one that is near, or any one.
  std::pair<Point, Mesh::Face_index> seen_foot(const Point& p) const
  {
    const Mesh::Vertex_index any = *mesh_.vertices().begin();
    const auto closest = tree_.closest_point_and_primitive(p, {mesh_.point(any), mesh_.face(mesh_.halfedge(any))});
    std::vector<Vector> rays;
    for(double t = 0.5; t > 1e-3; t /= 2)
      rays.push_back(closest.first + t * (center(closest.second) - closest.first) - p);
    for(int i = 0; i != 27; ++i)
      rays.push_back(Vector(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1));
    for(const Vector& ray : rays)
      if(const auto seen = first_seen(p, ray))
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

  // Brings the ends of segments that cross the surface nearer to it until none does: faces that share an edge hide nothing
  // from each other right beneath them.
  bool raise_until_free(std::vector<Sunk_place>& way) const
  {
    const int number_of_turns = 24;
    for(int turn = 0; turn != number_of_turns; ++turn)
    {
      std::vector<bool> is_bad(way.size(), false);
      for(std::size_t i = 0; i + 1 < way.size(); ++i)
        if(is_crossed(way[i].place, way[i + 1].place))
          is_bad[i] = is_bad[i + 1] = true;
      if(std::find(is_bad.begin(), is_bad.end(), true) == is_bad.end())
        return true;
      for(std::size_t i = 0; i != way.size(); ++i)
        if(is_bad[i])
        {
          const double rise = 0.75 * way[i].depth;
          way[i].place.point = way[i].place.point - rise * way[i].inwards;
          way[i].depth -= rise;
        }
    }
    return false;
  }

  // Leaves points out as long as nothing is crossed.
  std::vector<Point> shortened(const std::vector<Sunk_place>& way) const
  {
    const auto is_free = [&](std::size_t i, std::size_t j) { return !is_crossed(way[i].place, way[j].place); };
    std::vector<Point> result = {way.front().place.point};
    for(std::size_t i = 0; i + 1 < way.size();)
    {
      std::size_t j = i + 1;
      for(std::size_t step = 2; i + step < way.size() && is_free(i, i + step);
          step = (std::min)(2 * step, way.size() - 1 - i))
      {
        j = i + step;
        if(j + 1 == way.size())
          break;
      }
      while(j + 1 < way.size() && is_free(i, j + 1))
        ++j;
      result.push_back(way[j].place.point);
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
  double size_ = 0; // of the bounding box
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_SURFACE_TREE_H
