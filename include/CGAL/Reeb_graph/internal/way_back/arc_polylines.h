// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_ARC_POLYLINES_H
#define CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_ARC_POLYLINES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Buckets.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/interpolation.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/unordered_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <queue>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

template <class Point>
Point make_point(const Coordinates& coordinates)
{
  typedef std::decay_t<decltype(std::declval<const Point&>().x())> Coordinate;
  return Point(Coordinate(coordinates[0]), Coordinate(coordinates[1]), Coordinate(coordinates[2]));
}

inline Coordinates mix(double t, const Coordinates& a, const Coordinates& b)
{
  return {(1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1], (1 - t) * a[2] + t * b[2]};
}

inline double distance(const Coordinates& a, const Coordinates& b)
{
  return length_of(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// The area of a triangle whose sides are shortened by a power of two.
inline double area(const Coordinates& a, const Coordinates& b, const Coordinates& c, int exponent)
{
  const auto side = [&](const Coordinates& end, int i) { return std::scalbn(end[i] - a[i], -exponent); };
  const Coordinates u = {side(b, 0), side(b, 1), side(b, 2)}, v = {side(c, 0), side(c, 1), side(c, 2)};
  return 0.5 * length_of(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}

// The centroid of curves, or of triangles: the mean of their points, each piece with the weight of its length or area,
// so that it does not count into how many pieces they are split. Where all weights are 0, it is that of the first
// point.
class Centroid
{
public:
  // All of a contour.
  template <class Contour, class Point>
  void add(const Contour& contour, const std::vector<Point>& points)
  {
    const auto at = [&](std::size_t i) { return coordinates_of(points[i]); };
    contour.for_each_line([&](std::size_t i, std::size_t j) { add_segment(at(i), at(j)); });
    contour.for_each_triangle([&](std::size_t i, std::size_t j, std::size_t k) { add_triangle(at(i), at(j), at(k)); });
    if(!has_first_) // a contour of one point
      add_segment(at(0), at(0));
  }

  void add_segment(const Coordinates& a, const Coordinates& b)
  {
    const double length = distance(a, b);
    set_unit(length);
    add_piece(a, mix(0.5, a, b), std::scalbn(length, -exponent_));
  }

  void add_triangle(const Coordinates& a, const Coordinates& b, const Coordinates& c)
  {
    set_unit((std::max)(distance(a, b), distance(a, c)));
    add_piece(a, {(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3, (a[2] + b[2] + c[2]) / 3},
              area(a, b, c, exponent_));
  }

  bool is_of_length_zero() const { return !(length_ > 0); }

  Coordinates operator()() const
  {
    return is_of_length_zero() ? first_ : mix(1, {}, {sum_[0] / length_, sum_[1] / length_, sum_[2] / length_});
  }

private:
  // The first length makes the unit of weights: their products with coordinates are as large as those.
  void set_unit(double length)
  {
    if(!(length_ > 0) && length > 0 && std::isfinite(length))
      exponent_ = std::ilogb(length);
  }

  void add_piece(const Coordinates& first, const Coordinates& middle, double weight)
  {
    if(!has_first_)
      first_ = first;
    has_first_ = true;
    length_ += weight;
    for(std::size_t i = 0; i != 3; ++i)
      sum_[i] += weight * middle[i];
  }

  bool has_first_ = false;
  int exponent_ = 0;
  double length_ = 0;
  Coordinates first_ = {}, sum_ = {};
};

template <class Augmentation, class PointMap>
auto points_of(const Augmentation& augmentation,
               const typename Augmentation::Contour& contour,
               const PointMap& point_map)
{
  std::vector<typename boost::property_traits<PointMap>::value_type> points;
  points.reserve(contour.number_of_crossings());
  augmentation.points_of_contour(contour, std::back_inserter(points), point_map);
  return points;
}

struct Crossing_tag;
typedef Index_of<Crossing_tag> Crossing_index;

// The shortest way along the lines of a contour, and the sides of its triangles, from its point `start` to one that
// is_end(i) tells of: the numbers of the points between the two, or nothing if there is no way.
template <class Contour, class Point, class IsEnd>
std::optional<std::vector<std::size_t>> way_along(const Contour& contour,
                                                  const std::vector<Point>& points,
                                                  std::size_t start,
                                                  const IsEnd& is_end)
{
  const Buckets<Crossing_index, std::size_t> neighbors(points.size(), [&](const auto& visit) {
    const auto join = [&](std::size_t i, std::size_t j) {
      visit(Crossing_index(i), j);
      visit(Crossing_index(j), i);
    };
    contour.for_each_line(join);
    contour.for_each_triangle([&](std::size_t i, std::size_t j, std::size_t k) {
      join(i, j);
      join(j, k);
      join(k, i);
    });
  });
  typedef std::pair<double, std::size_t> Entry;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  std::vector<Entry> best(points.size(), {std::numeric_limits<double>::infinity(), start}); // and where it comes from
  best[start].first = 0;
  for(queue.emplace(0, start); !queue.empty();)
  {
    const auto [length, i] = queue.top();
    queue.pop();
    if(is_end(i))
    {
      std::vector<std::size_t> way;
      for(std::size_t j = best[i].second; j != start; j = best[j].second)
        way.push_back(j);
      std::reverse(way.begin(), way.end());
      return way;
    }
    for(const std::size_t j : neighbors[Crossing_index(i)])
      if(const double there = length + distance(coordinates_of(points[i]), coordinates_of(points[j]));
         there < best[j].first)
      {
        best[j] = {there, i};
        queue.emplace(there, j);
      }
  }
  return std::nullopt;
}

// The edges that lead inside of a level set from halfedge h to a face at the vertex `end`, whose value the level is:
// the fewest that there are; none if there is no way. `value` is called with a vertex. In each triangle, a level set is
// convex, so that it leads from triangle to triangle over the edges that it touches.
template <class FaceListGraph, class Value>
std::vector<typename boost::graph_traits<FaceListGraph>::halfedge_descriptor> level_path(
  const FaceListGraph& mesh,
  const Value& value,
  typename boost::graph_traits<FaceListGraph>::halfedge_descriptor h,
  typename boost::graph_traits<FaceListGraph>::vertex_descriptor end)
{
  typedef typename boost::graph_traits<FaceListGraph>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<FaceListGraph>::face_descriptor face_descriptor;
  const double level = value(end);
  const auto is_touched = [&](halfedge_descriptor edge) {
    const auto [low, high] = std::minmax({value(source(edge, mesh)), value(target(edge, mesh))});
    return low <= level && level <= high;
  };
  boost::unordered_map<face_descriptor, halfedge_descriptor> entries; // of the faces that have been found
  std::deque<halfedge_descriptor> queue;
  const auto enter = [&](halfedge_descriptor edge) {
    if(!is_border(edge, mesh) && entries.emplace(face(edge, mesh), edge).second)
      queue.push_back(edge);
  };
  enter(h);
  enter(opposite(h, mesh));
  std::vector<halfedge_descriptor> path;
  for(; !queue.empty(); queue.pop_front())
  {
    const halfedge_descriptor entry = queue.front();
    const auto around = CGAL::halfedges_around_face(entry, mesh);
    if(std::any_of(around.begin(), around.end(), [&](halfedge_descriptor edge) { return target(edge, mesh) == end; }))
    {
      halfedge_descriptor edge = entry;
      for(; edge != h && edge != opposite(h, mesh); edge = entries.at(face(opposite(edge, mesh), mesh)))
        path.push_back(edge);
      std::reverse(path.begin(), path.end());
      return path;
    }
    for(const halfedge_descriptor edge : around)
    {
      if(is_touched(edge))
        enter(opposite(edge, mesh));
    }
  }
  return path;
}

// A line whose points have values.
template <class Point>
struct Line_with_values
{
  std::vector<Point>& points;
  std::vector<double>& values;

  void add(const Point& point, double value) const
  {
    points.push_back(point);
    values.push_back(value);
  }
};

// The ascending lines of arcs on the mesh: along the halfedges of the chain, and where the chain passes by its end, or
// by that of a piece of it, along the contour just below that vertex, a short way. If that contour touches the vertex
// only by way of others that are tied with it, the line goes over them on a surface, inside of the level set, and
// straight elsewhere.
template <class Augmentation, class PointMap>
class Chain_polylines
{
  typedef typename Augmentation::Contour Contour;
  typedef typename Augmentation::arc_descriptor arc_descriptor;
  typedef typename Augmentation::vertex_descriptor vertex_descriptor;
  typedef typename Augmentation::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::property_traits<PointMap>::value_type Point;

public:
  typedef Line_with_values<Point> Line;

  Chain_polylines(const Augmentation& augmentation, const PointMap& point_map)
    : augmentation_(augmentation),
      mesh_(augmentation.mesh()),
      point_map_(point_map)
  {}

  void operator()(arc_descriptor arc, std::vector<Point>& points, std::vector<double>& values) const
  {
    const auto& graph = augmentation_.graph();
    const auto& chain = graph[arc].chain;
    const vertex_descriptor lower = graph[source(arc, graph)].vertex, upper = graph[target(arc, graph)].vertex;
    const Line line = {points, values};
    if(source(chain.front(), mesh_) != lower)
    {
      add_vertex(source(chain.front(), mesh_), line);
      add_way_inside_level(chain.front(), lower, line);
      add_vertex(lower, line);
      std::reverse(points.begin(), points.end());
      std::reverse(values.begin(), values.end());
    }
    else
      add_vertex(lower, line);
    for(std::size_t i = 0; i != chain.size(); ++i)
    {
      const vertex_descriptor end = i + 1 == chain.size() ? upper : source(chain[i + 1], mesh_);
      if(target(chain[i], mesh_) != end)
        add_way_to_end(arc, chain[i], end, line);
      add_vertex(end, line);
    }
  }

private:
  void add_vertex(vertex_descriptor v, const Line& line) const { line.add(get(point_map_, v), augmentation_.value(v)); }

  // From where halfedge h crosses the level just below the vertex `end`, to before that vertex. If ties are contracted,
  // its source can be on that level already.
  void add_way_to_end(arc_descriptor arc, halfedge_descriptor h, vertex_descriptor end, const Line& line) const
  {
    const Contour contour = augmentation_.contour_below(arc, end);
    const auto& edges = contour.edges;
    const std::size_t start = static_cast<std::size_t>(std::find(edges.begin(), edges.end(), h) - edges.begin());
    if(start == edges.size())
      return add_way_inside_level(h, end, line);
    const std::vector<Point> points = points_of(augmentation_, contour, point_map_);
    line.add(points[start], contour.value);
    const auto way = way_along(contour, points, start, [&](std::size_t i) { return target(edges[i], mesh_) == end; });
    if(!way)
      return add_way_inside_level(h, end, line);
    for(const std::size_t i : *way)
      line.add(points[i], contour.value);
  }

  // From where halfedge h touches the level of the vertex `end`, to before that vertex.
  void add_way_inside_level(halfedge_descriptor h, vertex_descriptor end, const Line& line) const
  {
    if constexpr(Is_face_list_graph<typename Augmentation::Mesh>::value)
    {
      const double level = augmentation_.value(end);
      const auto value = [&](vertex_descriptor v) { return augmentation_.value(v); };
      for(const halfedge_descriptor edge : level_path(mesh_, value, h, end))
      {
        const vertex_descriptor from = source(edge, mesh_), to = target(edge, mesh_);
        const double fraction = crossing_fraction(value(from), value(to), level);
        line.add(point_between(get(point_map_, from), get(point_map_, to), fraction), level);
      }
    }
  }

  const Augmentation& augmentation_;
  const typename Augmentation::Mesh& mesh_;
  const PointMap& point_map_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_ARC_POLYLINES_H
