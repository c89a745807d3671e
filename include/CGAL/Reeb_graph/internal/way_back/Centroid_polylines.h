// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_CENTROID_POLYLINES_H
#define CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_CENTROID_POLYLINES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/way_back/contour_geometry.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/unordered_map.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

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

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_CENTROID_POLYLINES_H
