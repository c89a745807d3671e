// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SPACE_VOLUMES_OF_PARTS_H
#define CGAL_REEB_GRAPH_INTERNAL_SPACE_VOLUMES_OF_PARTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Origin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// A triangle of a closed surface whose solid is cut into parts.
struct Part_triangle
{
  std::array<Index, 3> corners;
  std::size_t part;
};

// Multiplies points by a power of two, so that no product of three coordinates overflows. Returns its exponent.
template <class Point>
int scale_to_one(std::vector<Point>& points)
{
  Bbox_3 box;
  for(const Point& p : points)
    box += p.bbox();
  double size = 0;
  for(int i = 0; i != 3; ++i)
    size = (std::max)(size, (box.max)(i) / 2 - (box.min)(i) / 2);
  const int exponent = size > 0 ? -std::ilogb(size) : 0;
  for(Point& p : points)
    p = Point(std::scalbn(p.x(), exponent), std::scalbn(p.y(), exponent), std::scalbn(p.z(), exponent));
  return exponent;
}

// The edges at which another part begins: the end and the beginning of each, as its triangle has them, and the part of that.
inline std::vector<Part_triangle> triangles_on_borders(const std::vector<Part_triangle>& triangles)
{
  std::vector<std::tuple<Index, Index, std::size_t, bool>> edges;
  for(const auto& [v, part] : triangles)
    for(std::size_t i = 0; i != 3; ++i)
      edges.emplace_back((std::min)(v[i], v[(i + 1) % 3]), (std::max)(v[i], v[(i + 1) % 3]), part,
                         v[i] < v[(i + 1) % 3]);
  std::sort(edges.begin(), edges.end());
  std::vector<Part_triangle> result;
  for(auto first = edges.begin(); first != edges.end();)
  {
    auto last = first;
    while(last != edges.end() && std::get<0>(*last) == std::get<0>(*first) && std::get<1>(*last) == std::get<1>(*first))
      ++last;
    if(std::get<2>(*first) == std::get<2>(*(last - 1)))
      first = last;
    for(; first != last; ++first)
    {
      auto [a, b, part, is_upwards] = *first;
      if(is_upwards)
        std::swap(a, b);
      result.push_back({{a, b, no_index}, part});
    }
  }
  return result;
}

// How long the borders between parts are that share edges. `edges` are those of `triangles_on_borders()`.
template <class Point>
std::vector<std::map<std::size_t, double>> lengths_of_borders(const std::vector<Part_triangle>& edges,
                                                              const std::vector<Point>& points,
                                                              std::size_t number_of_parts)
{
  std::vector<std::map<std::size_t, double>> lengths(number_of_parts);
  for(std::size_t i = 1; i < edges.size(); ++i) // Those of one edge follow each other.
  {
    const auto& [v, part] = edges[i - 1];
    const auto& [w, other] = edges[i];
    if(part == other || std::minmax(v[0], v[1]) != std::minmax(w[0], w[1]))
      continue;
    const double length = distance_between(points[v[0]], points[v[1]]);
    lengths[part][other] += length;
    lengths[other][part] += length;
  }
  return lengths;
}

// Takes the volume of each part that would have less than none, seen from the side of the whole, from the part beside it with which
// its border is longest: the faces of such a part look at what belongs to that.
inline void take_from_neighbors(std::vector<std::map<std::size_t, double>> borders, std::vector<double>& volumes)
{
  const auto number_of_parts = static_cast<Index>(volumes.size());
  Disjoint_sets<Index> components(number_of_parts);
  for(Index part = 0; part != number_of_parts; ++part)
    for(const auto& [other, length] : borders[part])
      components.unite(part, static_cast<Index>(other));
  std::vector<double> wholes(volumes.size(), 0);
  for(Index part = 0; part != number_of_parts; ++part)
    wholes[components.find(part)] += volumes[part];
  typedef std::pair<double, std::size_t> Entry; // the volume of a part
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  const auto add = [&](std::size_t part) {
    const double volume = wholes[components.find(static_cast<Index>(part))] < 0 ? -volumes[part] : volumes[part];
    if(volume < 0)
      queue.push({volume, part});
  };
  for(std::size_t part = 0; part != volumes.size(); ++part)
    add(part);
  while(!queue.empty())
  {
    const std::size_t part = queue.top().second;
    queue.pop();
    std::map<std::size_t, double> beside = std::exchange(borders[part], {});
    if(beside.empty()) // It has gone already, or is a whole.
      continue;
    const std::size_t other = std::max_element(beside.begin(), beside.end(), [](const auto& a, const auto& b) {
                                return a.second < b.second;
                              })->first;
    for(const auto& [third, length] : beside)
    {
      borders[third].erase(part);
      if(third == other)
        continue;
      borders[third][other] += length;
      borders[other][third] += length;
    }
    volumes[other] += std::exchange(volumes[part], 0);
    add(other);
  }
}

// The volume of each part of a solid. A part is bounded by its triangles, and by cones over its border, whose tip is the middle of
// all edges between parts that are connected there. The same cones, turned, bound the parts beside it, so that the parts
// make the whole; a part that would have less than none takes from another one. Volumes are negative where the surface is
// inside out. The size of the solid is about 1.
template <class Point>
std::vector<double> volumes_of_parts(std::vector<Point> points,
                                     std::vector<Part_triangle> triangles,
                                     std::size_t number_of_parts)
{
  std::vector<Part_triangle> cones = triangles_on_borders(triangles);
  auto borders = lengths_of_borders(cones, points, number_of_parts);
  Disjoint_sets<Index> sets(static_cast<Index>(points.size()));
  for(const Part_triangle& cone : cones)
    sets.unite(cone.corners[0], cone.corners[1]);
  std::map<Index, std::pair<Point, double>> middles; // by the lengths of edges
  for(Part_triangle& cone : cones)
  {
    const Point &p = points[cone.corners[0]], &q = points[cone.corners[1]];
    auto& [middle, size] = middles.emplace(sets.find(cone.corners[0]), std::make_pair(p, 0.)).first->second;
    const double length = distance_between(p, q);
    size += length;
    middle = middle + (size > 0 ? length / size : 0) * (CGAL::midpoint(p, q) - middle);
  }
  std::map<Index, Index> tips;
  for(const auto& [set, middle] : middles)
  {
    tips[set] = static_cast<Index>(points.size());
    points.push_back(middle.first);
  }
  for(Part_triangle& cone : cones)
    cone.corners[2] = tips.at(sets.find(cone.corners[0]));
  triangles.insert(triangles.end(), cones.begin(), cones.end());
  std::vector<double> volumes(number_of_parts, 0);
  std::vector<Index> origins(number_of_parts, no_index); // any, but near, as sums are rounded
  for(const auto& [v, part] : triangles)
  {
    origins[part] = origins[part] == no_index ? v[0] : origins[part];
    const Point& origin = points[origins[part]];
    volumes[part] += (points[v[0]] - origin) * cross_product(points[v[1]] - origin, points[v[2]] - origin) / 6;
  }
  take_from_neighbors(std::move(borders), volumes);
  return volumes;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_SPACE_VOLUMES_OF_PARTS_H
