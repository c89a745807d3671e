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
#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// A point that is not outside of a surface, and the vertex that it is, or the face in whose middle it lies, if any.
struct Surface_place
{
  Point point;
  std::optional<Mesh::Vertex_index> vertex = std::nullopt;
  std::optional<Mesh::Face_index> face = std::nullopt;

  bool is_on_surface() const { return vertex || face; }
};

// A ball inside of a surface.
struct Inner_ball
{
  Point center;
  double radius = 0;
};

// A tree over a closed surface: tells what is inside, how far from it, and whether a segment crosses it.
class Surface_tree
{
public:
  // Distances are those from the surface without its openings.
  Surface_tree(const Filled_component& component, bool are_borders_openings) : mesh_(component.mesh)
  {
    std::vector<Mesh::Face_index> all;
    double volume = 0;
    const Point origin = mesh_.point(*mesh_.vertices().begin());
    for(const auto f : mesh_.faces())
    {
      const auto [a, b, c] = corners(f);
      volume += cross_product(a - origin, b - origin) * (c - origin);
      // The edges of a triangle without area belong to others, too.
      if(collinear(a, b, c) || !(cross_product(b - a, c - a).squared_length() > 0))
        continue;
      all.push_back(f);
      const bool is_wall = !(are_borders_openings && is_of_opening(component, f));
      (is_wall ? walls_ : openings_).push_back({to_rounded(a), to_rounded(b), to_rounded(c)});
    }
    is_inward_ = volume < 0;
    tree_.insert(all.begin(), all.end(), mesh_);
    build(tree_, [&](const auto& face) { return corners(face.id())[0]; });
    if(walls_.empty())
      walls_.swap(openings_);
    opening_tree_.insert(openings_.cbegin(), openings_.cend());
    wall_tree_.insert(walls_.cbegin(), walls_.cend());
    build(wall_tree_, [](const auto& wall) { return (*wall.id())[0]; });
    const Bbox_3 box = CGAL::bbox_3(mesh_.points().begin(), mesh_.points().end());
    size_ = distance({box.xmin(), box.ymin(), box.zmin()}, {box.xmax(), box.ymax(), box.zmax()});
    find_axis(all, box);
    is_flat_ = !(std::abs(volume) > 1e-12 * size_ * size_ * size_);
  }

  const Mesh& mesh() const { return mesh_; }

  std::array<Point, 3> corners(Mesh::Face_index f) const
  {
    const auto h = mesh_.halfedge(f);
    return {mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h)), mesh_.point(mesh_.target(mesh_.next(h)))};
  }

  double size() const { return size_; } // of the bounding box

  bool is_inward() const { return is_inward_; } // whether the normals of faces point inwards

  bool is_flat() const { return is_flat_; } // whether the volume is 0 but for rounding

  // Of length 1, or the null vector if the face has no area.
  Vector inward_normal(Mesh::Face_index f) const
  {
    const auto [a, b, c] = corners(f);
    const Vector normal = cross_product(b - a, c - a);
    const double size = length(normal);
    return size > 0 ? (is_inward_ ? 1 : -1) / size * normal : Vector(NULL_VECTOR);
  }

  // Whether the surface has any area.
  bool has_area() const { return !tree_.empty(); }

  // Whether distances are those from less than the whole surface.
  bool has_openings() const { return !openings_.empty(); }

  // Whether a line from a point in the direction of an axis crosses the surface an odd number of times. The line is moved by
  // less than any number, so that it passes no edge: exact signs decide for every surface and every point.
  bool is_inside(const Point& p) const
  {
    Crossings_of_line crossings(*this);
    tree_.traversal(p, crossings);
    return crossings.is_odd() && !crossings.is_on_surface();
  }

  // Whether the surface meets a cube around a point, whose sides are so far away.
  bool is_near(const Point& p, double distance) const
  {
    const Vector corner(distance, distance, distance);
    return tree_.do_intersect(Kernel::Iso_cuboid_3(p - corner, p + corner));
  }

  // Whether an opening meets such a cube.
  bool is_near_opening(const Point& p, double distance) const
  {
    const Rounded_kernel::Vector_3 corner(distance, distance, distance);
    const auto q = to_rounded(p);
    return has_openings() && opening_tree_.do_intersect(Rounded_kernel::Iso_cuboid_3(q - corner, q + corner));
  }

  // The distance from the surface without openings.
  double distance_from_wall(const Point& p, const Point& hint) const
  {
    return has_area() ? distance(p, closest_on_wall(p, hint)) : 0;
  }

  // The point of the surface without openings that is closest to a point, by rounded numbers: centering asks hundreds of
  // times for each point. The surface has area.
  Point closest_on_wall(const Point& p, const Point& hint) const
  {
    const auto q = to_rounded(p);
    const bool is_of_wall = !is_near_opening(hint, 1e-9 * size_);
    const auto found = is_of_wall ? wall_tree_.closest_point(q, to_rounded(hint)) : wall_tree_.closest_point(q);
    return {found.x(), found.y(), found.z()};
  }

  // The point of the surface that is closest to a point, and its face. The surface has area.
  std::pair<Point, Mesh::Face_index> closest_place(const Point& p) const
  {
    const Mesh::Vertex_index any = *mesh_.vertices().begin();
    return tree_.closest_point_and_primitive(p, {mesh_.point(any), mesh_.face(mesh_.halfedge(any))});
  }

  // Whether a segment meets the surface, other than in an end that is on it, by exact predicates.
  bool is_crossed(const Surface_place& from, const Surface_place& to) const
  {
    if(from.point == to.point)
      return false;
    const Kernel::Segment_3 segment(from.point, to.point);
    if(!from.is_on_surface() && !to.is_on_surface())
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

  // A large ball near a vertex: one that touches the surface there, and is grown away from where it touches.
  Inner_ball ball_beneath(Mesh::Vertex_index v) const
  {
    const Point& p = mesh_.point(v);
    const Vector inwards = inward_direction(v);
    Inner_ball ball = {p + depth_beneath(v, inwards) / 2 * inwards, 0};
    if(!is_inside(ball.center))
      return ball;
    Point touched = tree_.closest_point(ball.center);
    double radius = distance(p, ball.center);
    // The surface can cross itself at the vertex.
    while(distance(ball.center, touched) < 0.9 * radius && !is_beside(touched, v) && radius > 1e-9 * size_)
    {
      const Vector way = touched - p; // The ball becomes one through both (J. Ma and others 2012).
      const double next = way.squared_length() / (2 * (way * inwards));
      if(!(next < radius)) // by rounding, far from the origin
        break;
      radius = next;
      ball.center = p + radius * inwards;
      touched = tree_.closest_point(ball.center, touched);
    }
    ball.radius = distance(ball.center, touched);
    for(double growth = 1; growth > 0.1;)
    {
      const Point center = ball.center + growth * (ball.center - touched);
      const Point next = tree_.closest_point(center, touched);
      if(distance(center, next) > (1 + growth / 4) * ball.radius && is_inside(center))
      {
        ball = {center, distance(center, next)};
        touched = next;
      }
      else
        growth /= 2;
    }
    return ball;
  }

  // Whether a point is inside, and farther from the surface than by rounding.
  bool is_well_inside(const Point& p) const { return is_inside(p) && !is_near(p, 1e-9 * size_); }

  // A point inside near one that is not, or hardly: in the middle between the closest point of the surface and what is seen
  // from there, away from the point or straight into the surface; or else right beneath a face.
  std::optional<Point> pulled_inside(const Point& p, const Point& hint) const
  {
    if(!has_area())
      return std::nullopt;
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

  Point center(Mesh::Face_index f) const
  {
    const auto [a, b, c] = corners(f);
    return CGAL::centroid(a, b, c);
  }

  // The place where a ray from inside meets the surface first, and the face there; none at an edge. It is looked for near, as
  // far as four times the length that is given, before a ray meets the boxes of all that is behind.
  std::optional<std::pair<Point, Mesh::Face_index>> first_seen(const Point& origin, const Vector& ray) const
  {
    const double size = length(ray);
    if(!(size > 0))
      return std::nullopt;
    const Vector direction = ray / size;
    std::vector<std::pair<double, Mesh::Face_index>> met;
    const auto add = [&](Mesh::Face_index f) { met.push_back({depth_of(f, origin, direction), f}); };
    const auto found = boost::make_function_output_iterator(std::cref(add));
    if(const Kernel::Segment_3 near(origin, origin + 4 * ray); !near.is_degenerate()) // by rounding
      tree_.all_intersected_primitives(near, found);
    if(met.empty())
      tree_.all_intersected_primitives(Kernel::Ray_3(origin, direction), found);
    std::sort(met.begin(), met.end());
    if(met.empty() || !std::isfinite(met.back().first) || !(met.front().first > 0)
       || (met.size() > 1 && !(met[1].first - met[0].first > 1e-9 * size)))
      return std::nullopt;
    return std::make_pair(origin + met.front().first * direction, met.front().second);
  }

  // Whether the surface meets a triangle.
  bool is_met_by_triangle(const Point& a, const Point& b, const Point& c) const
  {
    if(!collinear(a, b, c))
      return tree_.do_intersect(Kernel::Triangle_3(a, b, c));
    const auto is_met = [&](const Point& p, const Point& q) {
      return p != q && tree_.do_intersect(Kernel::Segment_3(p, q));
    };
    return is_met(a, b) || is_met(b, c) || is_met(c, a);
  }

  // Whether a face other than these meets a triangle. One that is a segment is met by none.
  bool is_met_by_triangle(const Point& a,
                          const Point& b,
                          const Point& c,
                          const std::array<Mesh::Face_index, 4>& own) const
  {
    Meeting_of_others others(*this, own);
    if(!collinear(a, b, c))
      tree_.traversal(Kernel::Triangle_3(a, b, c), others);
    return others.is_met();
  }

  // How far the surface without two faces is from a point in a direction, at most `reach`.
  double clearance(const Point& p,
                   const Vector& direction,
                   const std::array<Mesh::Face_index, 2>& own,
                   double reach) const
  {
    const auto add = [&](Mesh::Face_index f) {
      if(const double depth = depth_of(f, p, direction); f != own[0] && f != own[1] && depth > 0)
        reach = (std::min)(reach, depth);
    };
    if(const Kernel::Segment_3 segment(p, p + reach * direction); !segment.is_degenerate()) // by rounding
      tree_.all_intersected_primitives(segment, boost::make_function_output_iterator(std::cref(add)));
    return reach;
  }

private:
  typedef AABB_face_graph_triangle_primitive<Mesh> Primitive;
  typedef Simple_cartesian<double> Rounded_kernel;
  typedef std::vector<Rounded_kernel::Triangle_3> Walls;
#if CGAL_VERSION_NR >= 1060000000
  typedef AABB_traits_3<Kernel, Primitive> Traits;
  typedef AABB_traits_3<Rounded_kernel, AABB_triangle_primitive_3<Rounded_kernel, Walls::const_iterator>> Any_traits;
#else
  typedef AABB_traits<Kernel, Primitive> Traits;
  typedef AABB_traits<Rounded_kernel, AABB_triangle_primitive<Rounded_kernel, Walls::const_iterator>> Any_traits;
#endif
  // In the middle of a tube, all that is around is about as far: of two triangles in three, the plane tells that it is farther.
  // That of a sliver is rounded to anything.
  struct Wall_traits : Any_traits
  {
    auto closest_point_object() const
    {
      return [this](const auto& p, const auto& wall, const auto& bound) {
        const Rounded_kernel::Triangle_3& triangle = *wall.id();
        const auto u = triangle[1] - triangle[0], v = triangle[2] - triangle[0], normal = cross_product(u, v);
        const double height = normal * (p - triangle[0]), square = normal.squared_length();
        const bool is_sliver = square < 1e-12 * u.squared_length() * v.squared_length();
        return !is_sliver && height * height > (1 + 1e-6) * square * squared_distance(p, bound)
               ? bound
               : Any_traits::closest_point_object()(p, wall, bound);
      };
    }

    auto compare_distance_object() const
    {
      return [](const auto& p, const Bbox_3& box, const auto& bound) {
        const auto square = [](double low, double x, double high) {
          const double outside = (std::max)((std::max)(low - x, x - high), 0.);
          return outside * outside;
        };
        const double sum = square(box.xmin(), p.x(), box.xmax()) + square(box.ymin(), p.y(), box.ymax())
                         + square(box.zmin(), p.z(), box.zmax());
        return sum <= squared_distance(p, bound) ? SMALLER : LARGER;
      };
    }
  };
  typedef AABB_tree<Traits> Tree;

  static double extent(const Bbox_3& box, int axis) { return box.max(axis) - box.min(axis); }

  // Splits at the median of corners along the axis on which they are spread most. That of the box would be the same one again and
  // again where triangles are long, as in spikes of noise: then each search meets a share of all.
  template <class Any_tree, class Corner_of>
  static void build(Any_tree& tree, const Corner_of& corner_of)
  {
    tree.custom_build(tree.traits().compute_bbox_object(), [&](auto first, auto beyond, const Bbox_3&) {
      Bbox_3 box;
      for(auto primitive = first; primitive != beyond; ++primitive)
        box += corner_of(*primitive).bbox();
      const std::array<double, 3> extents = {extent(box, 0), extent(box, 1), extent(box, 2)};
      const auto axis = static_cast<int>(std::max_element(extents.begin(), extents.end()) - extents.begin());
      std::nth_element(first, first + (beyond - first) / 2, beyond,
                       [&](const auto& a, const auto& b) { return corner_of(a)[axis] < corner_of(b)[axis]; });
    });
  }

  // Finds the axis along which a line meets the boxes of fewest faces on average.
  void find_axis(const std::vector<Mesh::Face_index>& faces, const Bbox_3& box)
  {
    std::array<double, 3> numbers = {}; // of boxes, times the volume of all
    for(const auto f : faces)
    {
      const auto [a, b, c] = corners(f);
      const Bbox_3 of_face = a.bbox() + b.bbox() + c.bbox();
      for(const int axis : {0, 1, 2})
        numbers[axis] += extent(of_face, (axis + 1) % 3) * extent(of_face, (axis + 2) % 3) * extent(box, axis);
    }
    axis_ = static_cast<int>(std::min_element(numbers.begin(), numbers.end()) - numbers.begin());
  }

  static Rounded_kernel::Point_3 to_rounded(const Point& p) { return {p.x(), p.y(), p.z()}; }

  // Counts the faces that a line crosses, as it descends a tree.
  class Crossings_of_line
  {
  public:
    explicit Crossings_of_line(const Surface_tree& surface) : surface_(surface) {}

    bool is_odd() const { return is_odd_; }
    bool is_on_surface() const { return is_on_surface_; }

    bool go_further() const { return !is_on_surface_; }

    template <class Node>
    bool do_intersect(const Point& p, const Node& node) const
    {
      return is_beneath(p, node.bbox());
    }

    void intersection(const Point& p, const Primitive& primitive)
    {
      const auto corners = surface_.corners(primitive.id());
      const auto& [a, b, c] = corners;
      if(!is_beneath(p, a.bbox() + b.bbox() + c.bbox()))
        return;
      const Orientation side = orientation(a, b, c, p);
      if(side == ZERO && Kernel::Triangle_3(a, b, c).has_on(p))
        is_on_surface_ = true;
      if(is_on_surface_ || side == ZERO || !is_met(corners, p))
        return;
      const Orientation turn = orientation(seen(a), seen(b), seen(c));
      is_odd_ ^= side != turn; // The face is before the point where this is on the side to which the axis leads.
    }

  private:
    Kernel::Point_2 seen(const Point& p) const { return {p[(surface_.axis_ + 1) % 3], p[(surface_.axis_ + 2) % 3]}; }

    bool is_beneath(const Point& p, const Bbox_3& box) const
    {
      const int u = (surface_.axis_ + 1) % 3, v = (surface_.axis_ + 2) % 3;
      return p[surface_.axis_] <= box.max(surface_.axis_) && box.min(u) <= p[u] && p[u] <= box.max(u)
          && box.min(v) <= p[v] && p[v] <= box.max(v);
    }

    // Whether the line meets a face: each edge that it passes is on the same side of it for both of its faces.
    bool is_met(const std::array<Point, 3>& corners, const Point& p) const
    {
      const int v = (surface_.axis_ + 2) % 3;
      bool result = false;
      for(std::size_t i = 0; i != 3; ++i)
      {
        const Point *low = &corners[i], *high = &corners[(i + 1) % 3];
        if((low->cartesian(v) > p[v]) == (high->cartesian(v) > p[v]))
          continue;
        if(low->cartesian(v) > p[v])
          std::swap(low, high);
        result ^= orientation(seen(*low), seen(*high), seen(p)) == LEFT_TURN;
      }
      return result;
    }

    const Surface_tree& surface_;
    bool is_odd_ = false, is_on_surface_ = false;
  };

  // Whether a face other than some meets a triangle, found as a tree is descended.
  class Meeting_of_others
  {
  public:
    Meeting_of_others(const Surface_tree& surface, const std::array<Mesh::Face_index, 4>& own)
      : surface_(surface),
        own_(own)
    {}

    bool is_met() const { return is_met_; }
    bool go_further() const { return !is_met_; }

    template <class Node>
    bool do_intersect(const Kernel::Triangle_3& triangle, const Node& node) const
    {
      return do_overlap(triangle.bbox(), node.bbox());
    }

    void intersection(const Kernel::Triangle_3& triangle, const Primitive& primitive)
    {
      if(std::find(own_.begin(), own_.end(), primitive.id()) != own_.end())
        return;
      const auto [a, b, c] = surface_.corners(primitive.id());
      is_met_ = is_met_ || CGAL::do_intersect(triangle, Kernel::Triangle_3(a, b, c));
    }

  private:
    const Surface_tree& surface_;
    const std::array<Mesh::Face_index, 4> own_;
    bool is_met_ = false;
  };

  bool has_corner(Mesh::Face_index f, Mesh::Vertex_index v) const
  {
    const auto h = mesh_.halfedge(f);
    return mesh_.source(h) == v || mesh_.target(h) == v || mesh_.target(mesh_.next(h)) == v;
  }

  // Whether a point of the surface is on a face of a vertex, or on the edge of one, where it can be found as one of others.
  bool is_beside(const Point& p, Mesh::Vertex_index v) const
  {
    const auto faces = CGAL::faces_around_target(mesh_.halfedge(v), mesh_);
    return std::any_of(faces.begin(), faces.end(), [&](Mesh::Face_index f) {
      const auto [a, b, c] = corners(f);
      return squared_distance(Kernel::Triangle_3(a, b, c), p) <= 1e-24 * size_ * size_;
    });
  }

  bool is_met_in_end(Mesh::Face_index f, const Surface_place& from, const Surface_place& to) const
  {
    const auto has = [&](const Surface_place& place) {
      return place.face == f || (place.vertex && has_corner(f, *place.vertex));
    };
    if(has(from) == has(to))
      return false;
    const auto [a, b, c] = corners(f);
    return !coplanar(a, b, c, has(from) ? to.point : from.point);
  }

  bool is_of_opening(const Filled_component& component, Mesh::Face_index f) const
  {
    const auto h = mesh_.halfedge(f);
    return component.is_apex(mesh_.source(h)) || component.is_apex(mesh_.target(h))
        || component.is_apex(mesh_.target(mesh_.next(h)));
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

  const Mesh& mesh_;
  Tree tree_;
  Walls walls_, openings_; // the surface without its openings, and these
  AABB_tree<Wall_traits> wall_tree_, opening_tree_;
  bool is_inward_ = false, is_flat_ = false;
  double size_ = 0; // of the bounding box
  int axis_ = 0;    // of the lines that tell what is inside
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_SURFACE_TREE_H
