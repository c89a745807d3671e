// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_ARC_POLYLINES_H
#define CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_ARC_POLYLINES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/internal/way_back/contour_geometry.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/unordered_map.hpp>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

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

// The middles of the border loops that leaves of a graph on a mesh stand for. Each loop is walked once, however many
// leaves it has. A soup has no border loops.
template <class Augmentation, class PointMap>
class Leaf_borders
{
  typedef typename Augmentation::Mesh Mesh;
  typedef typename Augmentation::vertex_descriptor vertex_descriptor;
  typedef typename Augmentation::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::property_traits<PointMap>::value_type Point;

public:
  Leaf_borders(const Augmentation& augmentation, const PointMap& point_map)
    : augmentation_(augmentation),
      point_map_(point_map)
  {
    if constexpr(Is_contour_on_mesh<typename Augmentation::Contour>::value)
    {
      const auto& graph = augmentation.graph();
      for(const auto node : CGAL::make_range(vertices(graph)))
      {
        const bool is_leaf = (in_degree(node, graph) == 0) != (out_degree(node, graph) == 0);
        if(is_leaf && loop_of_vertex_.count(graph[node].vertex) == 0)
          add_loop(graph[node].vertex);
      }
    }
  }

  // Of length 0 if the vertex, which is that of a leaf, is not on a border of one value.
  Centroid centroid(vertex_descriptor v) const
  {
    const auto found = loop_of_vertex_.find(v);
    return found == loop_of_vertex_.end() ? Centroid() : centroids_[found->second];
  }

private:
  void add_loop(vertex_descriptor v)
  {
    const Mesh& mesh = augmentation_.mesh();
    const auto border = CGAL::is_border(v, mesh);
    if(!border)
      return;
    std::vector<Point> points;
    bool is_level = true;
    halfedge_descriptor h = *border;
    do
    {
      points.push_back(get(point_map_, target(h, mesh)));
      is_level = is_level && augmentation_.value(target(h, mesh)) == augmentation_.value(v);
      loop_of_vertex_[target(h, mesh)] = centroids_.size();
      h = next(h, mesh);
    } while(h != *border);
    centroids_.emplace_back();
    if(is_level)
      centroids_.back().add_curve(points, true);
  }

  const Augmentation& augmentation_;
  const PointMap& point_map_;
  boost::unordered_map<vertex_descriptor, std::size_t> loop_of_vertex_;
  std::vector<Centroid> centroids_;
};

// Contours along an arc, and for each one its centroid, a point of it, and its value.
struct Contours_of_arc
{
  std::vector<Coordinates> centroids;
  std::vector<Coordinates> contour_points;
  std::vector<double> values;
};

// The nodes and arcs of a graph at the centroids of contours.
template <class Augmentation, class PointMap>
class Centroid_polylines
{
  typedef typename Augmentation::Contour Contour;
  typedef typename Augmentation::arc_descriptor arc_descriptor;
  typedef typename Augmentation::node_descriptor node_descriptor;
  typedef typename Augmentation::vertex_descriptor vertex_descriptor;
  typedef typename boost::property_traits<PointMap>::value_type Point;
  static constexpr bool is_mesh = Is_contour_on_mesh<Contour>::value;

public:
  Centroid_polylines(const Augmentation& augmentation, const PointMap& point_map)
    : augmentation_(augmentation),
      graph_(augmentation.graph()),
      point_map_(point_map),
      leaf_borders_(augmentation, point_map)
  {}

  // A node with arcs above and below is at the centroid of the contours that meet there, a leaf at its vertex or, on a
  // mesh, in the middle of the border loop or of the tied vertices that it stands for.
  Point node_point(node_descriptor node) const
  {
    const vertex_descriptor vertex = graph_[node].vertex;
    const bool is_minimum = in_degree(node, graph_) == 0, is_leaf = is_minimum || out_degree(node, graph_) == 0;
    Centroid centroid = is_leaf ? leaf_borders_.centroid(vertex) : Centroid();
    if(centroid.is_of_length_zero() && (is_mesh || !is_leaf))
    {
      for(const arc_descriptor arc : CGAL::make_range(in_edges(node, graph_)))
        add_contour(augmentation_.contour_below(arc, vertex), vertex, is_leaf, centroid);
      if(is_minimum)
        for(const arc_descriptor arc : CGAL::make_range(out_edges(node, graph_)))
          add_contour(augmentation_.contour_above(arc, vertex), vertex, is_leaf, centroid);
    }
    return centroid.is_of_length_zero() ? Point(get(point_map_, vertex)) : make_point<Point>(centroid());
  }

  // `contour_at` is called with the arc and a place between 0 and 1.
  template <class ContourAt>
  Contours_of_arc contours(arc_descriptor arc, std::size_t number_of_contours, const ContourAt& contour_at) const
  {
    Contours_of_arc result;
    for(std::size_t i = 1; i <= number_of_contours; ++i)
    {
      const double t = static_cast<double>(i) / static_cast<double>(number_of_contours + 1);
      const Contour contour = contour_at(arc, t);
      const std::vector<Point> points = points_of(augmentation_, contour, point_map_);
      Centroid centroid;
      add_to_centroid(contour, points, centroid);
      result.centroids.push_back(centroid());
      result.contour_points.push_back(coordinates_of(inner_point(contour, points)));
      result.values.push_back(contour.value);
    }
    return result;
  }

private:
  // Adds a contour next to a node, but not one that is no more than the vertex of a leaf.
  void add_contour(const Contour& contour, vertex_descriptor vertex, bool is_leaf, Centroid& centroid) const
  {
    const auto& mesh = augmentation_.mesh();
    const auto& crossed = crossed_edges(contour);
    const bool is_point =
      is_leaf && std::all_of(crossed.begin(), crossed.end(), [&](const auto& h) {
        const vertex_descriptor from = source(h, mesh), to = target(h, mesh);
        return (from == vertex || to == vertex) && augmentation_.value(from) != augmentation_.value(to);
      });
    if(!is_point)
      add_to_centroid(contour, points_of(augmentation_, contour, point_map_), centroid);
  }

  const Augmentation& augmentation_;
  const typename Augmentation::Graph& graph_;
  const PointMap& point_map_;
  const Leaf_borders<Augmentation, PointMap> leaf_borders_;
};

// How far apart two lines are that look like one: about the width of a line in a picture of all.
inline double width_of_lines(const std::vector<Contours_of_arc>& contours)
{
  constexpr double part_of_picture = 0.015, infinity = std::numeric_limits<double>::infinity();
  Coordinates low, high;
  low.fill(infinity);
  high.fill(-infinity);
  for(const Contours_of_arc& arc : contours)
    for(const Coordinates& point : arc.contour_points)
      for(std::size_t i = 0; i != point.size(); ++i)
      {
        low[i] = (std::min)(low[i], point[i]);
        high[i] = (std::max)(high[i], point[i]);
      }
  return low[0] <= high[0] ? part_of_picture * distance(low, high) : 0;
}

// Whether the two sides of a loop look like one line, as those of a round tube inside of another one.
inline bool do_coincide(const Contours_of_arc& a, const Contours_of_arc& b, double small)
{
  return std::equal(a.centroids.begin(), a.centroids.end(), b.centroids.begin(), b.centroids.end(),
                    [&](const Coordinates& p, const Coordinates& q) { return distance(p, q) <= small; });
}

// Moves those arcs halfway to their contours that lead from the same node to the same node along the same line.
template <class Graph>
void separate_parallel_arcs(const Graph& graph, std::vector<Contours_of_arc>& contours)
{
  std::vector<std::pair<std::pair<std::size_t, std::size_t>, std::size_t>> arcs; // by their ends
  for(const auto arc : CGAL::make_range(edges(graph)))
    arcs.push_back({{source(arc, graph), target(arc, graph)}, arcs.size()});
  std::sort(arcs.begin(), arcs.end());
  std::vector<bool> is_moved(contours.size(), false);
  const double width = width_of_lines(contours);
  for(auto first = arcs.begin(), last = first; first != arcs.end(); first = last)
  {
    last = std::find_if(first, arcs.end(), [&](const auto& arc) { return arc.first != first->first; });
    for(auto i = first; i != last; ++i)
      for(auto j = first; j != i; ++j)
        if(do_coincide(contours[i->second], contours[j->second], width))
          is_moved[i->second] = is_moved[j->second] = true;
  }
  for(std::size_t i = 0; i != contours.size(); ++i)
  {
    for(std::size_t j = 0; is_moved[i] && j != contours[i].centroids.size(); ++j)
      contours[i].centroids[j] = mix(0.5, contours[i].centroids[j], contours[i].contour_points[j]);
  }
}

// Replaces each inner point by the mean of itself and the middle of its neighbors, as many times as given.
inline void smooth(std::vector<Coordinates>& points, std::size_t number_of_steps)
{
  for(std::size_t step = 0; step != number_of_steps; ++step)
  {
    const std::vector<Coordinates> old = points;
    for(std::size_t i = 1; i + 1 < points.size(); ++i)
      points[i] = mix(0.5, old[i], mix(0.5, old[i - 1], old[i + 1]));
  }
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_ARC_POLYLINES_H
