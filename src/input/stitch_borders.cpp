// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/assemble_surface.h"
#include "input/merge_points.h"
#include "input/repair_soup.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
typedef std::array<long double, 3> Difference; // in which nothing overflows

Difference difference(const Point& p, const Point& q)
{
  Difference result;
  for(int i = 0; i < 3; ++i)
    result[static_cast<std::size_t>(i)] = static_cast<long double>(p[i]) - static_cast<long double>(q[i]);
  return result;
}

long double product(const Difference& a, const Difference& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// A point that lies on the inside of a side of a polygon, nearly.
struct Junction
{
  std::size_t corner; // of all polygons, at which the side begins
  long double place;  // on the side, from 0 to 1
  Corner point;
  long double square_of_distance;
};

// Where the perpendicular from a point meets a side.
Junction junction_of(const std::vector<Point>& points, const Polygon_side& side, Corner point)
{
  const Corner from = side.is_descending ? side.v : side.u, to = side.is_descending ? side.u : side.v;
  const Difference along = difference(points[to], points[from]), offset = difference(points[point], points[from]);
  Junction result = {side.is_descending ? side.corner_of_v : side.corner_of_u, 0, point, 0};
  result.place = product(along, offset) / product(along, along);
  for(std::size_t i = 0; i < 3; ++i)
  {
    const long double d = offset[i] - result.place * along[i];
    result.square_of_distance += d * d;
  }
  return result;
}

// Those of borders, in the order of the sides, and along each.
std::vector<Junction> find_junctions(const std::vector<Point>& points, const Polygons& polygons, double distance)
{
  typedef CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t> Box;
  const std::vector<Polygon_side> sides = sides_of(polygons);
  std::vector<Box> boxes_of_sides, boxes_of_points;
  std::vector<Corner> ends;
  for_each_edge(sides, [&](std::size_t begin, std::size_t end) {
    if(end - begin != 1)
      return;
    ends.insert(ends.end(), {sides[begin].u, sides[begin].v});
    const CGAL::Bbox_3 box = points[sides[begin].u].bbox() + points[sides[begin].v].bbox();
    const auto below = [&](double x) { return std::nextafter(x - distance, -std::numeric_limits<double>::infinity()); };
    const auto above = [&](double x) { return std::nextafter(x + distance, std::numeric_limits<double>::infinity()); };
    boxes_of_sides.emplace_back(CGAL::Bbox_3(below(box.xmin()), below(box.ymin()), below(box.zmin()), above(box.xmax()),
                                             above(box.ymax()), above(box.zmax())),
                                begin);
  });
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  for(const Corner v : ends)
    boxes_of_points.emplace_back(points[v].bbox(), v);
  const long double most = static_cast<long double>(distance) * distance;
  std::vector<Junction> result;
  CGAL::box_intersection_d(boxes_of_sides.begin(), boxes_of_sides.end(), boxes_of_points.begin(), boxes_of_points.end(),
                           [&](const Box& a, const Box& b) {
                             const Polygon_side& side = sides[a.info()];
                             const auto point = static_cast<Corner>(b.info());
                             const Polygons::Polygon polygon = polygons[side.face];
                             if(std::find(polygon.begin(), polygon.end(), point) != polygon.end())
                               return;
                             const Junction junction = junction_of(points, side, point);
                             if(junction.place > 0 && junction.place < 1 && junction.square_of_distance <= most)
                               result.push_back(junction);
                           });
  std::sort(result.begin(), result.end(), [](const Junction& a, const Junction& b) {
    return std::tie(a.corner, a.place, a.point) < std::tie(b.corner, b.place, b.point);
  });
  return result;
}

} // namespace

std::size_t cut_at_junctions(Polygon_soup& soup, double distance)
{
  const std::vector<Junction> junctions = find_junctions(soup.points, soup.polygons, distance);
  if(junctions.empty())
    return 0;
  Polygons polygons;
  std::vector<char> is_triangle;
  std::vector<std::size_t> corners;
  std::size_t corner = 0, number = 0;
  auto next = junctions.begin();
  for(std::size_t i = 0; i < soup.polygons.size(); ++i)
  {
    corners.clear();
    for(const Corner v : soup.polygons[i])
    {
      corners.push_back(v);
      for(; next != junctions.end() && next->corner == corner; ++next)
        if(std::find(corners.begin(), corners.end(), next->point) == corners.end()) // else on two sides of the polygon
        {
          corners.push_back(next->point);
          ++number;
        }
      ++corner;
    }
    polygons.add(corners);
    is_triangle.push_back(soup.polygons[i].size() == 3 ? 1 : 0);
  }
  soup.polygons = std::move(polygons);
  cut_into_triangles(soup, is_triangle);
  return number;
}

void count_points_on_edges(const Polygon_soup& soup, const std::vector<Corner>& border_points, Close_points& result)
{
  if(border_points.empty() || !(result.largest_distance > 0))
    return;
  const auto join = [](const Polygons& polygons, const std::vector<Corner>& joined, const auto& is_meant) {
    Polygons others;
    std::vector<Corner> corners, sorted;
    for(std::size_t i = 0; i < polygons.size(); ++i)
    {
      corners.clear();
      for(const Corner v : polygons[i])
        corners.push_back(joined[v]);
      if(is_meant(polygons[i])
         && !find_repeated_vertex(Polygons::Polygon(corners.data(), corners.data() + corners.size()), sorted))
        others.add(corners);
    }
    return others;
  };
  std::vector<char> is_on_border(soup.points.size(), 0);
  for(const Corner v : border_points)
    is_on_border[v] = 1;
  // What coincides is joined first: few borders are left then, if faces have corners of their own.
  Polygons beside =
    join(soup.polygons, join_close_points(soup.points, border_points, 0), [&](const Polygons::Polygon& polygon) {
      return std::count_if(polygon.begin(), polygon.end(), [&](Corner v) { return is_on_border[v] != 0; }) > 1;
    });
  result.have_edges_of_many_faces = has_edge_of_many_faces(beside);
  const std::vector<Corner> left = reeb_graph_program::border_points(beside);
  if(left.empty())
    return;
  beside = join(beside, join_close_points(soup.points, left, result.largest_distance),
                [](const Polygons::Polygon&) { return true; });
  long double largest = 0;
  std::vector<Corner> found;
  for(const Junction& junction : find_junctions(soup.points, beside, result.largest_distance))
  {
    found.push_back(junction.point);
    largest = std::max(largest, junction.square_of_distance);
  }
  std::sort(found.begin(), found.end());
  result.on_edges = static_cast<std::size_t>(std::unique(found.begin(), found.end()) - found.begin());
  if(result.on_edges > 0) // perhaps exactly
    result.needed_distance = std::max(
      result.needed_distance, power_of_ten_above(std::max(std::sqrt(largest), result.largest_distance / 1000.L)));
}

} // namespace reeb_graph_program
