// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_CENTROID_POLYLINES_H
#define CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_CENTROID_POLYLINES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/embedding/Centroid.h>
#include <CGAL/Reeb_graph/internal/embedding/Leaf_borders.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The places along an arc, without its ends, and for each one the value there and a point of the contour itself.
struct Places
{
  std::vector<Coordinates> centroids;
  std::vector<Coordinates> contour_points;
  std::vector<double> values;
};

// The nodes and arcs of a graph at the centroids of contours.
template <class Augmentation, class PointMap, class NamedParameters>
class Centroid_polylines
{
  typedef typename Augmentation::Contour Contour;
  typedef typename Augmentation::arc_descriptor arc_descriptor;
  typedef typename Augmentation::node_descriptor node_descriptor;
  typedef typename Augmentation::vertex_descriptor vertex_descriptor;
  typedef typename boost::property_traits<PointMap>::value_type Point;

public:
  Centroid_polylines(const Augmentation& augmentation, const PointMap& point_map, const NamedParameters& np)
    : augmentation_(augmentation),
      graph_(augmentation.graph()),
      point_map_(point_map),
      leaf_borders_(augmentation, point_map),
      np_(np)
  {}

  // A node with arcs above and below is at the centroid of the contours that meet there, a leaf at its vertex, or in
  // the middle of the border loop or of the tied vertices that it stands for.
  Point node_point(node_descriptor node) const
  {
    const vertex_descriptor vertex = graph_[node].vertex;
    const bool is_minimum = in_degree(node, graph_) == 0, is_leaf = is_minimum || out_degree(node, graph_) == 0;
    Centroid centroid = is_leaf ? leaf_borders_.centroid(vertex) : Centroid();
    if(centroid.is_of_length_zero())
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
  Places places(arc_descriptor arc, std::size_t number_of_contours, const ContourAt& contour_at) const
  {
    Places result;
    for(std::size_t i = 1; i <= number_of_contours; ++i)
    {
      const double t = static_cast<double>(i) / static_cast<double>(number_of_contours + 1);
      const Contour contour = contour_at(arc, t);
      const std::vector<Point> points = points_of(contour);
      Centroid centroid;
      centroid.add_curve(points, contour.is_closed);
      result.centroids.push_back(centroid());
      result.contour_points.push_back(coordinates_of(points[contour.is_closed ? 0 : points.size() / 2]));
      result.values.push_back(contour.value);
    }
    return result;
  }

private:
  // Adds a contour next to a node, but not one that is no more than the vertex of a leaf.
  void add_contour(const Contour& contour, vertex_descriptor vertex, bool is_leaf, Centroid& centroid) const
  {
    const auto& mesh = augmentation_.mesh();
    const bool is_point =
      is_leaf && std::all_of(contour.halfedges.begin(), contour.halfedges.end(), [&](const auto h) {
        const vertex_descriptor from = source(h, mesh), to = target(h, mesh);
        return (from == vertex || to == vertex) && augmentation_.value(from) != augmentation_.value(to);
      });
    if(!is_point)
      centroid.add_curve(points_of(contour), contour.is_closed);
  }

  std::vector<Point> points_of(const Contour& contour) const
  {
    std::vector<Point> points;
    points.reserve(contour.halfedges.size());
    augmentation_.points_of_contour(contour, std::back_inserter(points), np_);
    return points;
  }

  const Augmentation& augmentation_;
  const typename Augmentation::Graph& graph_;
  const PointMap& point_map_;
  const Leaf_borders<Augmentation, PointMap> leaf_borders_;
  const NamedParameters& np_;
};

// How far apart two lines are that look like one: about the width of a line in a picture of all.
inline double width_of_lines(const std::vector<Places>& places)
{
  constexpr double part_of_picture = 0.015, infinity = std::numeric_limits<double>::infinity();
  Coordinates low, high;
  low.fill(infinity);
  high.fill(-infinity);
  for(const Places& arc : places)
    for(const Coordinates& point : arc.contour_points)
      for(std::size_t i = 0; i != point.size(); ++i)
      {
        low[i] = (std::min)(low[i], point[i]);
        high[i] = (std::max)(high[i], point[i]);
      }
  return low[0] <= high[0] ? part_of_picture * distance(low, high) : 0;
}

// Whether the two sides of a loop look like one line, as those of a round tube inside of another one.
inline bool do_coincide(const Places& a, const Places& b, double small)
{
  return std::equal(a.centroids.begin(), a.centroids.end(), b.centroids.begin(), b.centroids.end(),
                    [&](const Coordinates& p, const Coordinates& q) { return distance(p, q) <= small; });
}

// Moves those arcs halfway to their contours that lead from the same node to the same node along the same line.
template <class Graph>
void separate_parallel_arcs(const Graph& graph, std::vector<Places>& places)
{
  std::vector<std::pair<std::pair<std::size_t, std::size_t>, std::size_t>> arcs; // by their ends
  for(const auto arc : CGAL::make_range(edges(graph)))
    arcs.push_back({{source(arc, graph), target(arc, graph)}, arcs.size()});
  std::sort(arcs.begin(), arcs.end());
  std::vector<bool> is_moved(places.size(), false);
  const double width = width_of_lines(places);
  for(auto first = arcs.begin(), last = first; first != arcs.end(); first = last)
  {
    last = std::find_if(first, arcs.end(), [&](const auto& arc) { return arc.first != first->first; });
    for(auto i = first; i != last; ++i)
      for(auto j = first; j != i; ++j)
        if(do_coincide(places[i->second], places[j->second], width))
          is_moved[i->second] = is_moved[j->second] = true;
  }
  for(std::size_t i = 0; i != places.size(); ++i)
  {
    for(std::size_t j = 0; is_moved[i] && j != places[i].centroids.size(); ++j)
      places[i].centroids[j] = mix(0.5, places[i].centroids[j], places[i].contour_points[j]);
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

#endif // CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_CENTROID_POLYLINES_H
