// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#include "page/surface_follower.h"

#include "computation/nearest_place.h"

#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
typedef CGAL::Simple_cartesian<double> Kernel;
typedef std::vector<Kernel::Triangle_3> Triangles;
#if CGAL_VERSION_NR >= 1060000000
typedef CGAL::AABB_triangle_primitive_3<Kernel, Triangles::const_iterator> Primitive;
typedef CGAL::AABB_traits_3<Kernel, Primitive> Tree_traits;
#else
typedef CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator> Primitive;
typedef CGAL::AABB_traits<Kernel, Primitive> Tree_traits;
#endif
typedef CGAL::AABB_tree<Tree_traits> Tree;

double distance(const Point& p, const Point& q) { return std::sqrt((p - q).squared_length()); }

} // namespace

// On which side of the surface a point is: that of the sum of the normals around the nearest place, by their angles
// there (J. A. Baerentzen, H. Aanaes, Signed Distance Computation Using the Angle Weighted Pseudonormal, 2005).
class Surface_follower::Sides
{
public:
  explicit Sides(const Surface& surface) : surface_(surface)
  {
    if(surface.number_of_faces() == 0)
      return;
    const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(surface);
    const Point middle((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, (box.zmin() + box.zmax()) / 2);
    size_ = 2 * distance(middle, Point(box.xmax(), box.ymax(), box.zmax()));
    std::vector<std::size_t> degrees(surface.num_vertices(), 0);
    for(const Surface::Halfedge_index h : surface.halfedges())
      ++degrees[surface.target(h)];
    double volume = 0;
    for(const Surface::Face_index f : surface.faces())
    {
      const auto [a, b, c] = corners(f);
      const Vector normal = CGAL::cross_product(b - a, c - a);
      volume += (a - middle) * normal;
      if(!(normal.squared_length() > 0))
        continue;
      triangles_.emplace_back(a, b, c);
      faces_.push_back(f);
      numbers_of_neighbors_.push_back(0);
      for(const Surface::Halfedge_index h : sides(surface, f))
        numbers_of_neighbors_.back() += degrees[surface.target(h)];
    }
    orientation_ = volume < 0 ? -1 : 1;
    tree_.insert(triangles_.begin(), triangles_.end());
    if(triangles_.empty())
      return;
    tree_.custom_build(tree_.traits().compute_bbox_object(),
                       [](auto begin, auto end, const CGAL::Bbox_3& part) { halve(begin, end, part); });
    // The search begins at the last place: to find a place to begin at, the tree would sort the corners, and calls itself
    // once for each of thousands of triangles with one corner.
    tree_.do_not_accelerate_distance_queries();
    nearest_ = {triangles_.front().vertex(0), triangles_.cbegin()};
  }

  bool are_known() const { return !triangles_.empty(); }
  double size() const { return size_; } // of the surface

  // The nearest place if the point is outside.
  std::optional<Point> place_on_surface(const Point& point)
  {
    if(number_of_steps_ > most_steps)
      return std::nullopt;
    nearest_ = tree_.closest_point_and_primitive(point, nearest_);
    const auto& [place, triangle] = nearest_;
    number_of_steps_ += numbers_of_neighbors_[triangle - triangles_.begin()];
    const Vector way = point - place;
    const double least_distance = 1e-4 * size_;
    if(!(way.squared_length() > least_distance * least_distance))
      return std::nullopt;
    if(!(orientation_ * (way * normal(point, faces_[triangle - triangles_.begin()])) > 0))
      return std::nullopt;
    return place;
  }

private:
  typedef std::array<Surface::Halfedge_index, 3> Sides_of_face;

  // As the tree does, but triangles with equal coordinates by number: std::nth_element() puts those in another order in
  // each standard library, and the order of the tree decides among places that are equally near.
  template <class Iterator>
  static void halve(Iterator begin, Iterator end, const CGAL::Bbox_3& box)
  {
    int axis = 0;
    for(int i = 1; i != 3; ++i)
      if(box.max(i) - box.min(i) > box.max(axis) - box.min(axis))
        axis = i;
    const auto key = [axis](const Primitive& p) { return std::make_pair(p.id()->vertex(0)[axis], p.id()); };
    std::nth_element(begin, begin + (end - begin) / 2, end,
                     [&](const Primitive& p, const Primitive& q) { return key(p) < key(q); });
  }

  static Sides_of_face sides(const Surface& surface, Surface::Face_index f)
  {
    const Surface::Halfedge_index h = surface.halfedge(f);
    return {h, surface.next(h), surface.prev(h)};
  }

  std::array<Point, 3> corners(Surface::Face_index f) const
  {
    const auto [a, b, c] = sides(surface_, f);
    return {surface_.point(surface_.target(a)), surface_.point(surface_.target(b)), surface_.point(surface_.target(c))};
  }

  Vector normal_of_face(Surface::Face_index f) const
  {
    const auto [a, b, c] = corners(f);
    const Vector normal = CGAL::cross_product(b - a, c - a);
    const double length = std::sqrt(normal.squared_length());
    return length > 0 ? normal / length : Vector(0, 0, 0);
  }

  // That at the place nearest to a point, which is in the face; 0 on a border.
  Vector normal(const Point& point, Surface::Face_index f) const
  {
    const std::array<double, 3> weights = weights_of_nearest(point, corners(f));
    const Sides_of_face around = sides(surface_, f);
    const auto zeros = std::count(weights.begin(), weights.end(), 0.);
    if(zeros == 0)
      return normal_of_face(f);
    if(zeros == 2)
      return normal_of_vertex(
        surface_.target(around[std::max_element(weights.begin(), weights.end()) - weights.begin()]));
    // the side that faces the corner without weight
    const std::size_t corner = std::find(weights.begin(), weights.end(), 0.) - weights.begin();
    const Surface::Face_index other = surface_.face(surface_.opposite(around[(corner + 2) % 3]));
    return other == Surface::null_face() ? Vector(0, 0, 0) : normal_of_face(f) + normal_of_face(other);
  }

  Vector normal_of_vertex(Surface::Vertex_index v) const
  {
    Vector sum(0, 0, 0);
    for(const Surface::Halfedge_index h : surface_.halfedges_around_target(surface_.halfedge(v)))
    {
      if(surface_.is_border(h))
        return Vector(0, 0, 0);
      const Vector before = surface_.point(surface_.source(h)) - surface_.point(v),
                   behind = surface_.point(surface_.target(surface_.next(h))) - surface_.point(v);
      const double angle = std::atan2(std::sqrt(CGAL::cross_product(before, behind).squared_length()), before * behind);
      sum = sum + angle * normal_of_face(surface_.face(h));
    }
    return sum;
  }

  const Surface& surface_;
  double size_ = 0, orientation_ = 1;
  Triangles triangles_; // with area
  std::vector<Surface::Face_index> faces_;
  Tree tree_;
  Tree::Point_and_primitive_id nearest_; // to the last point
  // A search looks at all triangles of a fan that its place is in. After too many, points stay where they are.
  static constexpr std::size_t most_steps = 100'000'000;
  std::size_t number_of_steps_ = 0;
  std::vector<std::size_t> numbers_of_neighbors_; // of the corners of each triangle
};

Surface_follower::Surface_follower(const Surface& surface) : sides_(std::make_unique<Sides>(surface)) {}

Surface_follower::~Surface_follower() = default;

Point Surface_follower::operator()(const Point& point) const
{
  return sides_->are_known() ? sides_->place_on_surface(point).value_or(point) : point;
}

Polyline Surface_follower::operator()(const Polyline& line) const
{
  if(!sides_->are_known())
    return line;
  const double step = sides_->size() / 200;
  Polyline result;
  // adds what follows a point up to another one, cut into pieces if one of them is moved
  const auto add = [&](const Point& from, const Point& to, int depth, const auto& add_again) -> void {
    const double length = distance(from, to);
    const auto number = static_cast<std::size_t>((std::max)(std::ceil(length / step), 2.));
    Polyline pieces;
    bool is_moved = false;
    for(std::size_t i = 1; i < number; ++i)
    {
      const Point point = from + static_cast<double>(i) / static_cast<double>(number) * (to - from);
      const std::optional<Point> place = sides_->place_on_surface(point);
      is_moved = is_moved || place;
      pieces.push_back(place.value_or(point));
    }
    if(!is_moved || depth == 0)
      return result.push_back(to);
    pieces.push_back(to);
    Point last = from;
    for(const Point& point : pieces)
    {
      add_again(last, point, depth - 1, add_again);
      last = point;
    }
  };
  for(const Point& given : line)
  {
    const Point point = (*this)(given);
    if(result.empty())
      result.push_back(point);
    else
      add(Point(result.back()), point, 3, add);
  }
  return result;
}

} // namespace reeb_graph_program
