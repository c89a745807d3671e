// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_CHAIN_POLYLINES_H
#define CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_CHAIN_POLYLINES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/internal/way_back/contour_geometry.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/unordered_map.hpp>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

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
  std::vector<Point> points;
  std::vector<double> values;

  void add(const Point& point, double value)
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

  Line operator()(arc_descriptor arc) const
  {
    const auto& graph = augmentation_.graph();
    const auto& chain = graph[arc].chain;
    const vertex_descriptor lower = graph[source(arc, graph)].vertex, upper = graph[target(arc, graph)].vertex;
    Line line;
    if(source(chain.front(), mesh_) != lower)
    {
      add_vertex(source(chain.front(), mesh_), line);
      add_way_inside_level(chain.front(), lower, line);
      add_vertex(lower, line);
      std::reverse(line.points.begin(), line.points.end());
      std::reverse(line.values.begin(), line.values.end());
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
    return line;
  }

private:
  void add_vertex(vertex_descriptor v, Line& line) const { line.add(get(point_map_, v), augmentation_.value(v)); }

  // From where halfedge h crosses the level just below the vertex `end`, to before that vertex. If ties are contracted,
  // its source can be on that level already.
  void add_way_to_end(arc_descriptor arc, halfedge_descriptor h, vertex_descriptor end, Line& line) const
  {
    const Contour contour = augmentation_.contour_below(arc, end);
    const auto& edges = crossed_edges(contour);
    const std::size_t start = static_cast<std::size_t>(std::find(edges.begin(), edges.end(), h) - edges.begin());
    if(start == edges.size())
      return add_way_inside_level(h, end, line);
    const std::vector<Point> points = points_of(augmentation_, contour, point_map_);
    line.add(points[start], contour.value);
    const Way_along_contour way =
      way_along(contour, points, start, [&](std::size_t i) { return target(edges[i], mesh_) == end; });
    if(!way)
      return add_way_inside_level(h, end, line);
    for(const std::size_t i : *way)
      line.add(points[i], contour.value);
  }

  // From where halfedge h touches the level of the vertex `end`, to before that vertex.
  void add_way_inside_level(halfedge_descriptor h, vertex_descriptor end, Line& line) const
  {
    if constexpr(Is_contour_on_mesh<Contour>::value)
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

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_CHAIN_POLYLINES_H
