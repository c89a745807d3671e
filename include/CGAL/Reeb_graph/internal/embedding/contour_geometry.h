// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_CONTOUR_GEOMETRY_H
#define CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_CONTOUR_GEOMETRY_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Contour.h>
#include <CGAL/Reeb_graph/Soup_contour.h>
#include <CGAL/Reeb_graph/internal/base/crossing_fraction.h>
#include <CGAL/Reeb_graph/internal/embedding/Centroid.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <iterator>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// What an embedding asks of a contour, of any kind: one on a mesh, in triangles, or in tetrahedra.

template <class Contour>
struct Is_contour_on_mesh : std::false_type
{
};
template <class Arc, class Halfedge>
struct Is_contour_on_mesh<Contour<Arc, Halfedge>> : std::true_type
{
};

// The edges that a contour crosses, one for each of its points.
template <class Arc, class Halfedge>
const std::vector<Halfedge>& crossed_edges(const Contour<Arc, Halfedge>& contour)
{
  return contour.halfedges;
}
template <class Arc>
const auto& crossed_edges(const Crossed_edges<Arc>& contour)
{
  return contour.edges;
}

template <class Augmentation, class PointMap>
auto points_of(const Augmentation& augmentation,
               const typename Augmentation::Contour& contour,
               const PointMap& point_map)
{
  std::vector<typename boost::property_traits<PointMap>::value_type> points;
  points.reserve(crossed_edges(contour).size());
  if constexpr(Is_contour_on_mesh<typename Augmentation::Contour>::value)
    augmentation.points_of_contour(contour, std::back_inserter(points), parameters::vertex_point_map(point_map));
  else
    for(std::size_t i = 0; i != contour.edges.size(); ++i)
      points.push_back(point_of_crossing(contour, i, [&](std::size_t v) { return get(point_map, v); }));
  return points;
}

// ---- The centroid of a contour, to which each part of it counts by its length, or by its area in tetrahedra.

template <class Arc, class Halfedge, class Point>
void add_to_centroid(const Contour<Arc, Halfedge>& contour, const std::vector<Point>& points, Centroid& centroid)
{
  centroid.add_curve(points, contour.is_closed);
}

template <class Arc, class Point>
void add_to_centroid(const Soup_contour<Arc>& contour, const std::vector<Point>& points, Centroid& centroid)
{
  for(const std::vector<std::size_t>& polyline : contour.polylines)
  {
    std::vector<Point> curve;
    for(const std::size_t i : polyline)
      curve.push_back(points[i]);
    centroid.add_curve(curve, false);
  }
  if(contour.polylines.empty()) // a point of an edge without triangles
    centroid.add_curve(points, false);
}

template <class Arc, class Point>
void add_to_centroid(const Isosurface_patch<Arc>& contour, const std::vector<Point>& points, Centroid& centroid)
{
  for(const std::array<std::size_t, 3>& t : contour.triangles)
    centroid.add_triangle(coordinates_of(points[t[0]]), coordinates_of(points[t[1]]), coordinates_of(points[t[2]]));
  if(contour.triangles.empty())
    centroid.add_curve(points, false);
}

// A point of the contour, off its ends.
template <class Arc, class Halfedge, class Point>
const Point& inner_point(const Contour<Arc, Halfedge>& contour, const std::vector<Point>& points)
{
  return points[contour.is_closed ? 0 : points.size() / 2];
}
template <class Arc, class Point>
const Point& inner_point(const Crossed_edges<Arc>&, const std::vector<Point>& points)
{
  return points[0];
}

// ---- The way along a contour from its point `start` to one that is_end(i) tells of: the numbers of the points between
// the two, or nothing if there is no way.

typedef std::optional<std::vector<std::size_t>> Way_along_contour;

// The shorter one of the two on a mesh.
template <class Arc, class Halfedge, class Point, class IsEnd>
Way_along_contour way_along(const Contour<Arc, Halfedge>& contour,
                            const std::vector<Point>& points,
                            std::size_t start,
                            const IsEnd& is_end)
{
  const std::size_t size = points.size();
  Way_along_contour shorter;
  double least_length = std::numeric_limits<double>::infinity();
  for(const bool is_forward : {true, false})
  {
    std::vector<std::size_t> way;
    double length = 0;
    for(std::size_t i = start, step = 1; step != size; ++step)
    {
      const std::size_t last = i;
      if(i == (is_forward ? size - 1 : 0) && !contour.is_closed)
        break;
      i = (i + (is_forward ? 1 : size - 1)) % size;
      length += distance(coordinates_of(points[last]), coordinates_of(points[i]));
      if(is_end(i))
      {
        if(length < least_length)
          shorter = way;
        least_length = (std::min)(least_length, length);
        break;
      }
      way.push_back(i);
    }
  }
  return shorter;
}

// Calls visit(i, j) for the lines between points of a contour.
template <class Arc, class Visit>
void for_each_line(const Soup_contour<Arc>& contour, const Visit& visit)
{
  for(const std::vector<std::size_t>& polyline : contour.polylines)
    for(std::size_t i = 1; i < polyline.size(); ++i)
      visit(polyline[i - 1], polyline[i]);
}

template <class Arc, class Visit>
void for_each_line(const Isosurface_patch<Arc>& contour, const Visit& visit)
{
  for(const std::array<std::size_t, 3>& t : contour.triangles)
    for(std::size_t i = 0; i != 3; ++i)
      visit(t[i], t[(i + 1) % 3]);
}

// One of fewest lines in triangles and in tetrahedra.
template <template <class> class ContourOfArc, class Arc, class Point, class IsEnd>
Way_along_contour way_along(const ContourOfArc<Arc>& contour,
                            const std::vector<Point>& points,
                            std::size_t start,
                            const IsEnd& is_end)
{
  constexpr std::size_t nowhere = (std::numeric_limits<std::size_t>::max)();
  std::vector<std::vector<std::size_t>> neighbors(points.size());
  for_each_line(contour, [&](std::size_t i, std::size_t j) {
    neighbors[i].push_back(j);
    neighbors[j].push_back(i);
  });
  std::vector<std::size_t> from(points.size(), nowhere);
  from[start] = start;
  for(std::deque<std::size_t> queue = {start}; !queue.empty(); queue.pop_front())
  {
    const std::size_t i = queue.front();
    if(is_end(i))
    {
      std::vector<std::size_t> way;
      for(std::size_t j = from[i]; j != start; j = from[j])
        way.push_back(j);
      std::reverse(way.begin(), way.end());
      return way;
    }
    for(const std::size_t neighbor : neighbors[i])
    {
      if(from[neighbor] != nowhere)
        continue;
      from[neighbor] = i;
      queue.push_back(neighbor);
    }
  }
  return std::nullopt;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_CONTOUR_GEOMETRY_H
