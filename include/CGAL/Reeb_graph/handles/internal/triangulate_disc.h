// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_INTERNAL_TRIANGULATE_DISC_H
#define CGAL_REEB_GRAPH_HANDLES_INTERNAL_TRIANGULATE_DISC_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/internal/space/Self_intersections.h>

// With the library, there is no need to read how holes are filled.
#ifndef CGAL_REEB_GRAPH_ARE_LOOPS_COMPILED
// Algorithms of Boost.Graph that look up get() for pointers as they are defined: they come first, as triangulate_hole.h of
// CGAL 6 includes compressed_sparse_row_graph.hpp, whose boost::detail::get() would hide that function from them.
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>
#endif

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The positions of corners on a closed polyline.
typedef std::vector<std::array<std::size_t, 3>> Disc_triangles;

// All discs of a short polyline are tried, in cubic time.
inline constexpr std::size_t most_corners_of_all_discs = 50;

// The disc of least dihedral angles and area that spans a closed polyline; of more corners, among those along edges of their
// Delaunay triangulation. Empty if there is none, or if that would take long: if many edges are none of that triangulation,
// or there are more than 1000. `third_points`, if there are any, are those of the triangles that its segments have on one
// side: the disc avoids to fold back on these. A template, so that the library can have it.
template <class Polyline>
Disc_triangles optimal_disc(const Polyline& polyline, const Polyline& third_points);

#ifndef CGAL_REEB_GRAPH_ARE_LOOPS_COMPILED
// Whether all edges of a closed polyline but a few are edges of the Delaunay triangulation of its corners.
template <class Polyline>
bool is_delaunay(const Polyline& polyline)
{
  constexpr std::size_t most_others = 10;
  CGAL::Delaunay_triangulation_3<Disc_kernel> triangulation;
  triangulation.insert(polyline.begin(), polyline.end());
  if(triangulation.dimension() < 2 || triangulation.number_of_vertices() != polyline.size())
    return false;
  std::map<typename Polyline::value_type, decltype(triangulation.infinite_vertex())> vertices;
  for(const auto v : triangulation.finite_vertex_handles())
    vertices[v->point()] = v;
  std::size_t others = 0;
  for(std::size_t i = 0; i != polyline.size() && others <= most_others; ++i)
  {
    decltype(triangulation.infinite_cell()) cell;
    int first = 0, second = 0;
    others +=
      triangulation.is_edge(vertices[polyline[i]], vertices[polyline[(i + 1) % polyline.size()]], cell, first, second)
        ? 0
        : 1;
  }
  return others <= most_others;
}

template <class Polyline>
Disc_triangles optimal_disc(const Polyline& polyline, const Polyline& third_points)
{
  constexpr std::size_t most_corners = 1000; // A table of all pairs is needed.
  Disc_triangles result;
  const bool is_long = polyline.size() > most_corners_of_all_discs;
  if(polyline.size() < 3 || (is_long && (polyline.size() > most_corners || !is_delaunay(polyline))))
    return result;
  // Where only edges of a Delaunay triangulation are tried, addresses in memory decide among discs that are as good as each
  // other.
  const auto np = parameters::use_delaunay_triangulation(is_long).do_not_use_cubic_algorithm(is_long);
  std::vector<CGAL::Triple<int, int, int>> triangles;
  if(third_points.empty())
    Polygon_mesh_processing::triangulate_hole_polyline(polyline, std::back_inserter(triangles), np);
  else
    Polygon_mesh_processing::triangulate_hole_polyline(polyline, third_points, std::back_inserter(triangles), np);
  for(const auto& t : triangles)
  {
    result.push_back(
      {static_cast<std::size_t>(t.first), static_cast<std::size_t>(t.second), static_cast<std::size_t>(t.third)});
    auto& corners = result.back();
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  }
  return result;
}
#endif

#define CGAL_REEB_GRAPH_OPTIMAL_DISC(PREFIX)                                                                           \
  PREFIX template Disc_triangles optimal_disc(const std::vector<Disc_point>&, const std::vector<Disc_point>&);
CGAL_REEB_GRAPH_FOR_LOOPS(CGAL_REEB_GRAPH_OPTIMAL_DISC)

// The disc of least area whose inner edges join no positions for which is_joined() holds; empty if there is none.
template <class IsJoined>
Disc_triangles triangulate_disc_without(const std::vector<Disc_point>& polyline, const IsJoined& is_joined)
{
  const std::size_t size = polyline.size();
  const auto area = [&](std::size_t i, std::size_t k, std::size_t j) {
    const auto normal = CGAL::cross_product(polyline[k] - polyline[i], polyline[j] - polyline[i]);
    return std::sqrt(normal.squared_length());
  };
  // of the part between two positions: its least area, and the corner of its triangle at the edge between these
  std::vector<double> areas(size * size, 0);
  std::vector<std::size_t> apexes(size * size, size);
  for(std::size_t length = 2; length < size; ++length)
    for(std::size_t i = 0; i + length != size; ++i)
    {
      const std::size_t j = i + length;
      double& least = areas[i * size + j] = std::numeric_limits<double>::infinity();
      for(std::size_t k = i + 1; k != j && (length + 1 == size || !is_joined(i, j)); ++k)
      {
        const double parts = areas[i * size + k] + areas[k * size + j], sum = parts + area(i, k, j);
        if(sum < least)
        {
          least = sum;
          apexes[i * size + j] = k;
        }
      }
    }
  Disc_triangles result;
  std::vector<std::pair<std::size_t, std::size_t>> edges = {{0, size - 1}};
  while(!edges.empty())
  {
    const auto [i, j] = edges.back();
    edges.pop_back();
    if(j - i < 2)
      continue;
    const std::size_t k = apexes[i * size + j];
    if(k == size)
      return {};
    result.push_back({i, k, j});
    edges.insert(edges.end(), {{i, k}, {k, j}});
  }
  return result;
}

// Spans a closed polyline by a disc. What is too long or too rough for an optimal one is cut in two by a segment, again and
// again.
template <class IsJoined>
class Disc_spanning
{
public:
  Disc_spanning(const std::vector<Disc_point>& polyline, const IsJoined& is_joined)
    : polyline_(polyline),
      is_joined_(is_joined)
  {}

  Disc_triangles span(const std::vector<Disc_point>& third_points)
  {
    std::vector<Part> parts(1);
    for(std::size_t i = 0; i != polyline_.size(); ++i)
      parts.front().corners.push_back(i);
    parts.front().third_points = third_points;
    Disc_triangles result;
    while(!parts.empty())
    {
      const Part part = std::move(parts.back());
      parts.pop_back();
      const Disc_triangles triangles = triangles_of(part);
      if(triangles.empty() && !cut(part, parts))
        return {};
      for(const auto& [i, j, k] : triangles)
        result.push_back({part.corners[i], part.corners[j], part.corners[k]});
    }
    std::sort(result.begin(), result.end()); // Addresses decide on their order, too.
    return result;
  }

private:
  struct Part
  {
    std::vector<std::size_t> corners;     // ascending positions
    std::vector<Disc_point> third_points; // beside the edges that begin at these, or none at all
  };

  bool is_any_joined(const Part& part, const Disc_triangles& triangles) const
  {
    const std::size_t size = part.corners.size();
    const auto is_inner = [&](std::size_t i, std::size_t j) { return j != i + 1 && (i != 0 || j + 1 != size); };
    return std::any_of(triangles.begin(), triangles.end(), [&](std::array<std::size_t, 3> t) {
      std::sort(t.begin(), t.end());
      const auto is_joined = [&](std::size_t i, std::size_t j) {
        return is_inner(i, j) && is_joined_(part.corners[i], part.corners[j]);
      };
      return is_joined(t[0], t[1]) || is_joined(t[1], t[2]) || is_joined(t[0], t[2]);
    });
  }

  // Empty if the part is to be cut.
  Disc_triangles triangles_of(const Part& part) const
  {
    const std::size_t size = part.corners.size();
    std::vector<Disc_point> points;
    for(const std::size_t corner : part.corners)
      points.push_back(polyline_[corner]);
    std::vector<Disc_point> places = points;
    std::sort(places.begin(), places.end());
    if(std::adjacent_find(places.begin(), places.end()) == places.end()) // else a triangle can be missing
    {
      Disc_triangles triangles = optimal_disc(points, part.third_points);
      if(triangles.size() + 2 == size && !is_any_joined(part, triangles))
        return triangles;
    }
    if(size > most_corners_of_all_discs)
      return {};
    return triangulate_disc_without(
      points, [&](std::size_t i, std::size_t j) { return is_joined_(part.corners[i], part.corners[j]); });
  }

  // Cuts a part by the segment beside which both parts have the least area, seen from three sides, and which is short. None
  // has less than a quarter of the corners. Returns false if there is no such segment.
  bool cut(const Part& part, std::vector<Part>& parts) const
  {
    constexpr std::size_t most_ends = 256; // that are tried
    const std::size_t size = part.corners.size(), step = size / most_ends + 1;
    if(size <= most_corners_of_all_discs)
      return false;
    const auto from_first = [&](std::size_t i) {
      return polyline_[part.corners[i % size]] - polyline_[part.corners[0]];
    };
    std::vector<Disc_kernel::Vector_3> areas(1, NULL_VECTOR); // swept by the edges before each corner
    for(std::size_t i = 0; i != size; ++i)
      areas.push_back(areas.back() + cross_product(from_first(i), from_first(i + 1)) / 2);
    double least = std::numeric_limits<double>::infinity();
    std::size_t first = 0, last = 0;
    for(std::size_t i = 0; i < size; i += step)
      for(std::size_t j = i + size / 4 + 1; j < size && j - i < size - size / 4; j += step)
      {
        const Disc_kernel::Vector_3 area = areas[j] - areas[i] + cross_product(from_first(j), from_first(i)) / 2;
        const double cost = std::sqrt(area.squared_length()) + std::sqrt((areas[size] - area).squared_length())
                          + (from_first(j) - from_first(i)).squared_length() / 4;
        if(cost < least && !is_joined_(part.corners[i], part.corners[j]))
        {
          least = cost;
          first = i;
          last = j;
        }
      }
    if(first == last)
      return false;
    Part inner, outer;
    for(std::size_t i = 0; i != size; ++i)
    {
      if(first <= i && i <= last)
        add(part, i, inner);
      if(i <= first || last <= i)
        add(part, i, outer);
    }
    if(!part.third_points.empty()) // A part goes on in the other one.
    {
      // the corner of the outer part that is opposite to the segment
      inner.third_points.back() = polyline_[outer.corners[(first + outer.corners.size() / 2) % outer.corners.size()]];
      outer.third_points[first] = polyline_[inner.corners[inner.corners.size() / 2]];
    }
    parts.push_back(std::move(inner));
    parts.push_back(std::move(outer));
    return true;
  }

  static void add(const Part& part, std::size_t i, Part& result)
  {
    result.corners.push_back(part.corners[i]);
    if(!part.third_points.empty())
      result.third_points.push_back(part.third_points[i]);
  }

  const std::vector<Disc_point>& polyline_;
  const IsJoined& is_joined_;
};

// Points in a unit in which those of `polyline` are near 1: else products of coordinates can be 0, or infinite.
inline std::vector<Disc_point> in_unit_of(const std::vector<Disc_point>& polyline,
                                          const std::vector<Disc_point>& points)
{
  double greatest = 0;
  for(const Disc_point& p : polyline)
    greatest = (std::max)({greatest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
  const int exponent = greatest > 0 && std::isfinite(greatest) ? -std::ilogb(greatest) : 0;
  std::vector<Disc_point> result;
  for(const Disc_point& p : points)
    result.emplace_back(std::scalbn(p.x(), exponent), std::scalbn(p.y(), exponent), std::scalbn(p.z(), exponent));
  return result;
}

// A disc of triangles with little area that spans a closed polyline, by positions of its points, and whose inner edges join no
// positions for which is_joined() holds. Empty if there is none, or if the polyline has less than 3 points. `third_points`, if
// there are any, are those of the triangles that its segments have on one side: the disc avoids to fold back on these. Takes
// O(n log n) time.
template <class IsJoined>
Disc_triangles triangulate_disc(const std::vector<Disc_point>& polyline,
                                const std::vector<Disc_point>& third_points,
                                const IsJoined& is_joined)
{
  if(polyline.size() < 3)
    return {};
  const auto scaled = in_unit_of(polyline, polyline);
  return Disc_spanning<IsJoined>(scaled, is_joined).span(in_unit_of(polyline, third_points));
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_TRIANGULATE_DISC_H
