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
#include <CGAL/Origin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
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

// The volume of each part of a solid. A part is bounded by its triangles, and by cones over its border, whose tip is the middle of
// all edges between parts that are connected there. The same cones, turned, bound the parts beside it, so that the parts
// make the whole. Volumes are negative where the surface is inside out. The size of the solid is about 1.
template <class Point>
std::vector<double> volumes_of_parts(std::vector<Point> points,
                                     std::vector<Part_triangle> triangles,
                                     std::size_t number_of_parts)
{
  std::vector<Part_triangle> cones = triangles_on_borders(triangles);
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
  return volumes;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_SPACE_VOLUMES_OF_PARTS_H
