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

#include <CGAL/Reeb_graph/internal/embedding/Centroid.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The ascending lines of arcs on the surface: along the halfedges of the chain, and where the chain passes by its end,
// or by that of a piece of it, along the contour just below that vertex, the shorter way.
template <class Augmentation, class PointMap, class NamedParameters>
class Surface_polylines
{
  typedef typename Augmentation::Contour Contour;
  typedef typename Augmentation::arc_descriptor arc_descriptor;
  typedef typename Augmentation::vertex_descriptor vertex_descriptor;
  typedef typename Augmentation::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::property_traits<PointMap>::value_type Point;

public:
  struct Line
  {
    std::vector<Point> points;
    std::vector<double> values;

    void add(const Point& point, double value)
    {
      points.push_back(point);
      values.push_back(value);
    }
  };

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
    add_vertex(lower, line);
    if(source(chain.front(), mesh) != lower)
      add_vertex(source(chain.front(), mesh), line);
    for(std::size_t i = 0; i != chain.size(); ++i)
    {
      const vertex_descriptor end = i + 1 == chain.size() ? upper : source(chain[i + 1], mesh);
      if(target(chain[i], mesh) != end)
        add_way_along_contour(arc, chain[i], end, line);
      add_vertex(end, line);
    }
    return line;
  }

private:
  void add_vertex(vertex_descriptor v, Line& line) const { line.add(get(point_map_, v), augmentation_.value(v)); }

  // From where halfedge h crosses the level just below the vertex `end`, to before that vertex.
  void add_way_along_contour(arc_descriptor arc, halfedge_descriptor h, vertex_descriptor end, Line& line) const
  {
    const Contour contour = augmentation_.contour_below(arc, end);
    std::vector<Point> points;
    augmentation_.points_of_contour(contour, std::back_inserter(points), np_);
    const auto& halfedges = contour.halfedges;
    const std::size_t size = halfedges.size();
    const std::size_t start = std::find(halfedges.begin(), halfedges.end(), h) - halfedges.begin();
    // The places of the contour from the start on, in one direction; empty if that does not lead to the vertex.
    const auto way = [&](bool is_forward) {
      std::vector<std::size_t> places;
      for(std::size_t i = start, count = 0; count != size && i < size; ++count)
      {
        if(target(halfedges[i], augmentation_.mesh()) == end)
          return places;
        places.push_back(i);
        const bool is_last = i + 1 == size;
        i = is_forward ? (is_last && contour.is_closed ? 0 : i + 1) : (i == 0 && contour.is_closed ? size - 1 : i - 1);
      }
      return std::vector<std::size_t>();
    };
    const auto length = [&](const std::vector<std::size_t>& places) {
      double sum = 0;
      for(std::size_t i = 0; i + 1 < places.size(); ++i)
        sum += distance(coordinates_of(points[places[i]]), coordinates_of(points[places[i + 1]]));
      return places.empty()
             ? sum
             : sum + distance(coordinates_of(points[places.back()]), coordinates_of(get(point_map_, end)));
    };
    const std::vector<std::size_t> forward = way(true), backward = way(false);
    const bool is_forward = backward.empty() || (!forward.empty() && length(forward) <= length(backward));
    line.add(points[start], contour.value);
    const std::vector<std::size_t>& places = is_forward ? forward : backward;
    for(std::size_t i = 1; i < places.size(); ++i)
      line.add(points[places[i]], contour.value);
  }

  const Augmentation& augmentation_;
  const PointMap& point_map_;
  const NamedParameters& np_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_SURFACE_POLYLINES_H
