// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_SURFACE_POLYLINES_H
#define CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_SURFACE_POLYLINES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/crossing_fraction.h>
#include <CGAL/Reeb_graph/internal/embedding/Centroid.h>
#include <CGAL/Reeb_graph/internal/embedding/level_path.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A line whose points have values.
template <class Point>
struct Line_with_values
{
  std::vector<Point> points;
  std::vector<double> values;

  void add(const Point& point, double value)
  {
    points.push_back(point);
    values.push_back(value);
  }
};

// The ascending lines of arcs on the surface: along the halfedges of the chain, and where the chain passes by its end,
// or by that of a piece of it, along the contour just below that vertex, the shorter way. If that contour touches the
// vertex only by way of others that are tied with it, the line goes over them, inside of the level set.
template <class Augmentation, class PointMap, class NamedParameters>
class Surface_polylines
{
  typedef typename Augmentation::Contour Contour;
  typedef typename Augmentation::arc_descriptor arc_descriptor;
  typedef typename Augmentation::vertex_descriptor vertex_descriptor;
  typedef typename Augmentation::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::property_traits<PointMap>::value_type Point;

public:
  typedef Line_with_values<Point> Line;

  Surface_polylines(const Augmentation& augmentation, const PointMap& point_map, const NamedParameters& np)
    : augmentation_(augmentation),
      point_map_(point_map),
      np_(np)
  {}

  Line operator()(arc_descriptor arc) const
  {
    const auto& mesh = augmentation_.mesh();
    const auto& graph = augmentation_.graph();
    const auto& chain = graph[arc].chain;
    const vertex_descriptor lower = graph[source(arc, graph)].vertex, upper = graph[target(arc, graph)].vertex;
    Line line;
    if(source(chain.front(), mesh) != lower)
    {
      add_vertex(source(chain.front(), mesh), line);
      add_way_inside_level(chain.front(), lower, line);
      add_vertex(lower, line);
      std::reverse(line.points.begin(), line.points.end());
    }
    else
      add_vertex(lower, line);
    for(std::size_t i = 0; i != chain.size(); ++i)
    {
      const vertex_descriptor end = i + 1 == chain.size() ? upper : source(chain[i + 1], mesh);
      if(target(chain[i], mesh) != end)
        add_way_to_end(arc, chain[i], end, line);
      add_vertex(end, line);
    }
    return line;
  }

private:
  void add_vertex(vertex_descriptor v, Line& line) const { line.add(get(point_map_, v), augmentation_.value(v)); }

  // From where halfedge h crosses the level just below the vertex `end`, to before that vertex. If ties are contracted,
  // its source can be on that level already.
  void add_way_to_end(arc_descriptor arc, halfedge_descriptor h, vertex_descriptor end, Line& line) const
  {
    const Contour contour = augmentation_.contour_below(arc, end);
    const auto start_of_way = std::find(contour.halfedges.begin(), contour.halfedges.end(), h);
    if(start_of_way == contour.halfedges.end())
      return add_way_inside_level(h, end, line);
    const std::size_t start = static_cast<std::size_t>(start_of_way - contour.halfedges.begin());
    std::vector<Point> points;
    augmentation_.points_of_contour(contour, std::back_inserter(points), np_);
    line.add(points[start], contour.value);
    const Way forward = way(contour, points, start, end, true), backward = way(contour, points, start, end, false);
    const Way& shorter = backward.length < forward.length ? backward : forward;
    if(shorter.length == infinite)
      return add_way_inside_level(h, end, line);
    for(const std::size_t i : shorter.places)
      line.add(points[i], contour.value);
  }

  // A part of a contour, without the place where it starts.
  struct Way
  {
    std::vector<std::size_t> places;
    double length = 0; // infinite if the way does not lead to the vertex
  };
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  Way way(const Contour& contour,
          const std::vector<Point>& points,
          std::size_t start,
          vertex_descriptor end,
          bool is_forward) const
  {
    const std::size_t size = points.size();
    Way result;
    for(std::size_t i = start, step = 1; step != size; ++step)
    {
      const std::size_t last = i;
      if(i == (is_forward ? size - 1 : 0) && !contour.is_closed)
        break;
      i = (i + (is_forward ? 1 : size - 1)) % size;
      result.length += distance(coordinates_of(points[last]), coordinates_of(points[i]));
      if(target(contour.halfedges[i], augmentation_.mesh()) == end)
        return result;
      result.places.push_back(i);
    }
    result.length = infinite;
    return result;
  }

  // From where halfedge h touches the level of the vertex `end`, to before that vertex.
  void add_way_inside_level(halfedge_descriptor h, vertex_descriptor end, Line& line) const
  {
    const auto& mesh = augmentation_.mesh();
    const double level = augmentation_.value(end);
    const auto value = [&](vertex_descriptor v) { return augmentation_.value(v); };
    for(const halfedge_descriptor edge : level_path(mesh, value, h, end))
    {
      const vertex_descriptor from = source(edge, mesh), to = target(edge, mesh);
      const double fraction = crossing_fraction(value(from), value(to), level);
      line.add(point_between(get(point_map_, from), get(point_map_, to), fraction), level);
    }
  }

  const Augmentation& augmentation_;
  const PointMap& point_map_;
  const NamedParameters& np_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_SURFACE_POLYLINES_H
