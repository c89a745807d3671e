// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_COMPLEX_POLYLINES_H
#define CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_COMPLEX_POLYLINES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Soup_contour.h>
#include <CGAL/Reeb_graph/internal/embedding/Centroid.h>
#include <CGAL/Reeb_graph/internal/embedding/Centroid_polylines.h>
#include <CGAL/Reeb_graph/internal/embedding/Surface_polylines.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// What the graphs of soups and of tetrahedra are embedded with in the place of Centroid_polylines and
// Surface_polylines. A `PointMap` has the points of vertices by number.
template <class Augmentation, class PointMap>
class Contours_in_space
{
protected:
  typedef typename Augmentation::Contour Contour;
  typedef typename Augmentation::arc_descriptor arc_descriptor;
  typedef typename boost::property_traits<PointMap>::value_type Point;

  Contours_in_space(const Augmentation& augmentation, const PointMap& point_map)
    : augmentation_(augmentation),
      graph_(augmentation.graph()),
      point_map_(point_map)
  {}

  Point point(std::size_t vertex) const { return get(point_map_, vertex); }

  std::vector<Point> points_of(const Contour& contour) const
  {
    std::vector<Point> points;
    for(std::size_t i = 0; i != contour.edges.size(); ++i)
      points.push_back(point_of_crossing(contour, i, [&](std::size_t v) { return point(v); }));
    return points;
  }

  const Augmentation& augmentation_;
  const typename Augmentation::Graph& graph_;

private:
  const PointMap& point_map_;
};

// The centroid of a contour: of its polylines, or of its triangles, and of its only point if it has none of these.
template <class Arc, class Point>
Centroid centroid_of(const Soup_contour<Arc>& contour, const std::vector<Point>& points)
{
  Centroid centroid;
  for(const std::vector<std::size_t>& polyline : contour.polylines)
  {
    std::vector<Point> curve;
    for(const std::size_t i : polyline)
      curve.push_back(points[i]);
    centroid.add_curve(curve, false);
  }
  if(contour.polylines.empty())
    centroid.add_curve(points, false);
  return centroid;
}

template <class Arc, class Point>
Centroid centroid_of(const Isosurface_patch<Arc>& contour, const std::vector<Point>& points)
{
  Centroid centroid;
  for(const std::array<std::size_t, 3>& t : contour.triangles)
    centroid.add_triangle(coordinates_of(points[t[0]]), coordinates_of(points[t[1]]), coordinates_of(points[t[2]]));
  if(contour.triangles.empty())
    centroid.add_curve(points, false);
  return centroid;
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

// The nodes and arcs of a graph at the centroids of contours.
template <class Augmentation, class PointMap>
class Complex_centroids : Contours_in_space<Augmentation, PointMap>
{
  typedef Contours_in_space<Augmentation, PointMap> Base;
  using typename Base::arc_descriptor;
  using typename Base::Contour;
  using typename Base::Point;

public:
  Complex_centroids(const Augmentation& augmentation, const PointMap& point_map) : Base(augmentation, point_map) {}

  // A node with arcs above and below is at the centroid of the contours that meet there, any other one at its vertex.
  Point node_point(std::size_t node) const
  {
    const std::size_t vertex = this->graph_[node].vertex;
    Centroid centroid;
    const bool is_leaf = in_degree(node, this->graph_) == 0 || out_degree(node, this->graph_) == 0;
    if(!is_leaf)
    {
      for(const arc_descriptor arc : CGAL::make_range(in_edges(node, this->graph_)))
      {
        const Contour contour = this->augmentation_.contour_below(arc, vertex);
        centroid.add(centroid_of(contour, this->points_of(contour)));
      }
    }
    return centroid.is_of_length_zero() ? this->point(vertex) : make_point<Point>(centroid());
  }

  // `contour_at` is called with the arc and a place between 0 and 1.
  template <class ContourAt>
  Places places(arc_descriptor arc, std::size_t number_of_contours, const ContourAt& contour_at) const
  {
    Places result;
    for(std::size_t i = 1; i <= number_of_contours; ++i)
    {
      const double t = static_cast<double>(i) / static_cast<double>(number_of_contours + 1);
      const Contour contour = contour_at(arc, t);
      const std::vector<Point> points = this->points_of(contour);
      const Centroid centroid = centroid_of(contour, points);
      result.centroids.push_back(centroid());
      result.contour_points.push_back(coordinates_of(points[0]));
      result.values.push_back(contour.value);
    }
    return result;
  }
};

// The ascending lines of arcs in the complex: along the edges of the chain, and where that passes by its end, or by
// that of a piece of it, along the contour just below that vertex, on a way of few triangles. If that contour touches
// the vertex only by way of others that are tied with it, the line goes there straight.
template <class Augmentation, class PointMap>
class Complex_polylines : Contours_in_space<Augmentation, PointMap>
{
  typedef Contours_in_space<Augmentation, PointMap> Base;
  using typename Base::arc_descriptor;
  using typename Base::Contour;
  using typename Base::Point;

public:
  typedef Line_with_values<Point> Line;

  Complex_polylines(const Augmentation& augmentation, const PointMap& point_map) : Base(augmentation, point_map) {}

  Line operator()(arc_descriptor arc) const
  {
    const auto& chain = this->graph_[arc].chain;
    const std::size_t lower = this->graph_[source(arc, this->graph_)].vertex,
                      upper = this->graph_[target(arc, this->graph_)].vertex;
    Line line;
    add_vertex(lower, line);
    if(chain.front().first != lower)
      add_vertex(chain.front().first, line);
    for(std::size_t i = 0; i != chain.size(); ++i)
    {
      const std::size_t end = i + 1 == chain.size() ? upper : chain[i + 1].first;
      if(chain[i].second != end)
        add_way_to_end(this->augmentation_.contour_below(arc, end), chain[i], end, line);
      add_vertex(end, line);
    }
    return line;
  }

private:
  void add_vertex(std::size_t v, Line& line) const { line.add(this->point(v), this->augmentation_.value(v)); }

  template <class Edge>
  void add_way_to_end(const Contour& contour, const Edge& edge, std::size_t end, Line& line) const
  {
    const auto found = std::find(contour.edges.begin(), contour.edges.end(), edge);
    if(found == contour.edges.end())
      return;
    const std::vector<Point> points = this->points_of(contour);
    for(const std::size_t i : way(contour, static_cast<std::size_t>(found - contour.edges.begin()), end))
      line.add(points[i], contour.value);
  }

  // The numbers of the points from `start` to before one on an edge to the vertex `end`; only `start` if there is none.
  static std::vector<std::size_t> way(const Contour& contour, std::size_t start, std::size_t end)
  {
    constexpr std::size_t nowhere = (std::numeric_limits<std::size_t>::max)();
    std::vector<std::vector<std::size_t>> neighbors(contour.edges.size());
    for_each_line(contour, [&](std::size_t i, std::size_t j) {
      neighbors[i].push_back(j);
      neighbors[j].push_back(i);
    });
    std::vector<std::size_t> from(contour.edges.size(), nowhere);
    from[start] = start;
    for(std::deque<std::size_t> queue = {start}; !queue.empty(); queue.pop_front())
    {
      std::size_t i = queue.front();
      if(contour.edges[i].second == end)
      {
        std::vector<std::size_t> result;
        while(i != start)
          result.push_back(i = from[i]);
        std::reverse(result.begin(), result.end());
        return result;
      }
      for(const std::size_t neighbor : neighbors[i])
      {
        if(from[neighbor] != nowhere)
          continue;
        from[neighbor] = i;
        queue.push_back(neighbor);
      }
    }
    return {start};
  }
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_COMPLEX_POLYLINES_H
