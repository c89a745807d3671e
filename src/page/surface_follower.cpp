// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#include "page/surface_follower.h"

#include "computation/nearest_place.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
typedef CGAL::Kernel_traits<Point>::Kernel Kernel;

double distance(const Point& p, const Point& q) { return std::sqrt((p - q).squared_length()); }

// Faces, to find the one nearest to a point. A part of them is halved when a search first comes to it, as searches along
// lines come to few parts.
class Halved_faces
{
public:
  struct Face
  {
    CGAL::Bbox_3 box;
    std::array<Surface::Vertex_index, 3> vertices; // known at once, as halfedges are not
    Surface::Face_index index;
  };

  void add(const Face& face)
  {
    faces_.push_back(face);
    parts_.front().box += face.box;
    parts_.front().end = faces_.size();
  }

  bool empty() const { return faces_.empty(); }

  // Calls look(face) for faces, among which are all that are at most at the least squared distance, which look() lowers.
  template <class Look>
  void search(const Point& point, const double& least, const Look& look, std::size_t number = 0)
  {
    if(squared_distance(parts_[number].box, point) > least)
      return;
    constexpr std::size_t most_faces = 16; // of a part that is not halved
    if(parts_[number].end - parts_[number].begin <= most_faces)
    {
      for(std::size_t i = parts_[number].begin; i != parts_[number].end; ++i)
        if(squared_distance(faces_[i].box, point) <= least)
          look(faces_[i]);
      return;
    }
    if(parts_[number].first_half == 0)
      halve(number);
    const std::size_t first = parts_[number].first_half, second = first + 1;
    const bool is_first_nearer =
      squared_distance(parts_[first].box, point) <= squared_distance(parts_[second].box, point);
    search(point, least, look, is_first_nearer ? first : second);
    search(point, least, look, is_first_nearer ? second : first);
  }

private:
  struct Part
  {
    CGAL::Bbox_3 box;
    std::size_t begin = 0, end = 0;
    std::size_t first_half = 0; // its number, before that of the second one; 0 if there are none yet
  };

  // At most that of a place in the box, whatever rounding makes of that.
  static double squared_distance(const CGAL::Bbox_3& box, const Point& point)
  {
    double sum = 0;
    for(int i = 0; i != 3; ++i)
    {
      const double way = (std::max)((std::max)(box.min(i) - point[i], point[i] - box.max(i)), 0.);
      sum += way * way;
    }
    return (1 - 1e-12) * sum;
  }

  void halve(std::size_t number)
  {
    const Part whole = parts_[number];
    int axis = 0;
    for(int i = 1; i != 3; ++i)
      if(whole.box.max(i) - whole.box.min(i) > whole.box.max(axis) - whole.box.min(axis))
        axis = i;
    const std::size_t middle = whole.begin + (whole.end - whole.begin) / 2;
    std::nth_element(faces_.data() + whole.begin, faces_.data() + middle, faces_.data() + whole.end,
                     [axis](const Face& f, const Face& g) {
                       return f.box.min(axis) + f.box.max(axis) < g.box.min(axis) + g.box.max(axis);
                     });
    parts_[number].first_half = parts_.size();
    for(const auto& [begin, end] : {std::pair(whole.begin, middle), std::pair(middle, whole.end)})
    {
      parts_.push_back({{}, begin, end});
      for(std::size_t i = begin; i != end; ++i)
        parts_.back().box += faces_[i].box;
    }
  }

  std::vector<Face> faces_; // in the order of the parts
  std::vector<Part> parts_ = std::vector<Part>(1);
};

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
    double volume = 0;
    for(const Surface::Face_index f : surface.faces())
    {
      const auto [a, b, c] = corners(f);
      const Vector normal = CGAL::cross_product(b - a, c - a);
      volume += (a - middle) * normal;
      if(!(normal.squared_length() > 0))
        continue;
      const auto [p, q, r] = sides(surface, f);
      nearest_ = {a.bbox() + b.bbox() + c.bbox(), {surface.target(p), surface.target(q), surface.target(r)}, f};
      faces_.add(nearest_);
    }
    orientation_ = volume < 0 ? -1 : 1;
  }

  bool are_known() const { return !faces_.empty(); }
  double size() const { return size_; } // of the surface

  // The nearest place if the point is outside.
  std::optional<Point> place_on_surface(const Point& point)
  {
    if(number_of_steps_ > most_steps)
      return std::nullopt;
    Point place = place_on_face(point, nearest_);
    double least = (point - place).squared_length();
    faces_.search(point, least, [&](const Halved_faces::Face& face) {
      ++number_of_steps_;
      const Point other = place_on_face(point, face);
      const double other_distance = (point - other).squared_length();
      // Of faces that are equally near the first one counts, whichever one was near to the point before.
      if(other_distance > least || (other_distance == least && face.index >= nearest_.index))
        return;
      least = other_distance;
      place = other;
      nearest_ = face;
    });
    const Vector way = point - place;
    const double least_distance = 1e-4 * size_;
    if(!(way.squared_length() > least_distance * least_distance))
      return std::nullopt;
    if(!(orientation_ * (way * normal(point, nearest_.index)) > 0))
      return std::nullopt;
    return place;
  }

private:
  typedef std::array<Surface::Halfedge_index, 3> Sides_of_face;

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

  // The nearest one in a face with area.
  Point place_on_face(const Point& point, const Halved_faces::Face& face) const
  {
    const auto [a, b, c] = face.vertices;
    const Kernel::Triangle_3 triangle(surface_.point(a), surface_.point(b), surface_.point(c));
    return Kernel().construct_projected_point_3_object()(triangle, point);
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
  Halved_faces faces_;         // with area
  Halved_faces::Face nearest_; // to the last point
  // A search looks at all triangles of a fan that its place is in. After too many, points stay where they are.
  static constexpr std::size_t most_steps = 15'000'000;
  std::size_t number_of_steps_ = 0;
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
