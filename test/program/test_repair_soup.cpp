// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/close_points.h"
#include "input/repair_soup.h"
#include "input/soup_counts.h"
#include "random_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

// Points join those that a search through all of them finds, and repaired meshes have what the map says.

namespace {
using random_meshes::Random;
using namespace reeb_graph_program;

int number_of_faults = 0;

void check(bool is_right, const std::string& what)
{
  if(is_right)
    return;
  ++number_of_faults;
  std::cerr << what << '\n';
}

// Exact for small whole numbers times a power of two.
double square_of_distance(const Point& p, const Point& q)
{
  return (p.x() - q.x()) * (p.x() - q.x()) + (p.y() - q.y()) * (p.y() - q.y()) + (p.z() - q.z()) * (p.z() - q.z());
}

// By definition: each candidate in its order looks at all kept ones.
std::vector<Corner> join_by_search(const std::vector<Point>& points, const std::vector<Corner>& candidates, double most)
{
  std::vector<Corner> joined(points.size()), kept;
  for(std::size_t v = 0; v < points.size(); ++v)
    joined[v] = static_cast<Corner>(v);
  for(const Corner v : candidates)
  {
    double least = most * most;
    for(const Corner other : kept)
    {
      const double square = square_of_distance(points[v], points[other]);
      if(square < least || (square == least && joined[v] == v))
      {
        least = square;
        joined[v] = other;
      }
    }
    if(joined[v] == v)
      kept.push_back(v);
  }
  return joined;
}

std::vector<Corner> all_of(const std::vector<Point>& points)
{
  std::vector<Corner> numbers;
  for(std::size_t v = 0; v < points.size(); ++v)
    numbers.push_back(static_cast<Corner>(v));
  return numbers;
}

// Whole numbers, whose distances are exact, at places of many sizes.
void test_random_points(std::size_t seed)
{
  Random random(seed);
  std::vector<Point> points;
  std::vector<Corner> candidates;
  const double width = 1 + static_cast<double>(random.below(12));
  const double scale = std::ldexp(1, static_cast<int>(random.below(200)) - 100);
  const auto coordinate = [&] { return scale * (static_cast<double>(random.below(25)) - 12); };
  for(std::size_t i = 0; i < 60; ++i)
  {
    const double x = coordinate(), y = coordinate(), z = random.below(3) == 0 ? coordinate() : -0.;
    points.emplace_back(x, y, z);
    if(random.below(5) != 0)
      candidates.push_back(static_cast<Corner>(i));
  }
  const double most = random.below(6) == 0 ? 0 : scale * width / 2;
  check(join_close_points(points, candidates, most) == join_by_search(points, candidates, most),
        "points of seed " + std::to_string(seed) + " join others than those that are nearest");
  std::size_t coinciding = 0;
  for(const Corner v : candidates)
    coinciding +=
      std::any_of(candidates.begin(), candidates.end(), [&](Corner u) { return u != v && points[u] == points[v]; }) ? 1
                                                                                                                    : 0;
  const Close_points counts = count_close_points(points, candidates);
  check(counts.coinciding == coinciding && counts.close == 0, "coinciding points are counted wrongly");
}

void test_chain()
{
  std::vector<Point> points;
  for(int i = 0; i < 1001; ++i)
    points.emplace_back(0.9 * i, 0, 0);
  const std::vector<Corner> joined = join_close_points(points, all_of(points), 1);
  std::size_t kept = 0;
  for(std::size_t v = 0; v < joined.size(); ++v)
  {
    kept += joined[v] == v ? 1 : 0;
    check(joined[v] == v - v % 2, "a chain is joined in another way");
  }
  check(kept == 501, "a chain of 1,001 points becomes " + std::to_string(kept));
}

// Numbers of cells that no integer holds, and a distance that is larger than all coordinates.
void test_extreme_numbers()
{
  const double huge = 1e308, next = std::nextafter(1., 2.);
  const std::vector<Point> points = {Point(huge, huge, huge), Point(-huge, 0, 0),     Point(huge, huge, huge),
                                     Point(1, 0, 0),          Point(next, 0, 0),      Point(0, -0., 0),
                                     Point(-0., 0, 0),        Point(5e-324, 0., -0.), Point(huge, -huge, 0)};
  check(join_close_points(points, all_of(points), 5e-324) == std::vector<Corner>({0, 1, 0, 3, 4, 5, 5, 5, 8}),
        "the smallest distance joins other points");
  check(join_close_points(points, all_of(points), next - 1) == std::vector<Corner>({0, 1, 0, 3, 3, 5, 5, 5, 8}),
        "the distance of the last bit joins other points");
  const std::vector<Point> near = {Point(huge / 2, 0, 0), Point(-huge / 4, 0, 0), Point(0, 0, 0), Point(-huge, 0, 0)};
  check(join_close_points(near, all_of(near), std::numeric_limits<double>::max()) == std::vector<Corner>({0, 0, 0, 0}),
        "the largest distance joins other points");
  check(count_close_points(points, all_of(points)).coinciding == 4, "extreme points that coincide are counted wrongly");
}

void test_wrong_distances()
{
  for(const double wrong : {0., -0., -1., std::nan(""), std::numeric_limits<double>::infinity()})
  {
    Polygon_soup soup;
    Repair_options options;
    options.distance = wrong;
    try
    {
      repair_soup(soup, options);
      check(false, "the distance " + std::to_string(wrong) + " is taken");
    }
    catch(const std::runtime_error&)
    {}
  }
}

Polygon_soup make_soup(std::size_t number_of_points, const std::vector<std::vector<std::size_t>>& faces)
{
  Polygon_soup soup;
  for(std::size_t v = 0; v < number_of_points; ++v)
    soup.points.emplace_back(static_cast<double>(v), static_cast<double>(v * v), 0);
  for(const auto& face : faces)
  {
    for(const std::size_t v : face)
      soup.polygons.add_corner(v);
    soup.polygons.end_polygon();
  }
  return soup;
}

bool has_faces(const Polygon_soup& soup, const std::vector<std::vector<Corner>>& faces)
{
  if(soup.polygons.size() != faces.size())
    return false;
  for(std::size_t i = 0; i < faces.size(); ++i)
    if(!std::equal(faces[i].begin(), faces[i].end(), soup.polygons[i].begin(), soup.polygons[i].end()))
      return false;
  return true;
}

Repair_options options_of(bool is_oriented, bool is_split)
{
  Repair_options options;
  options.are_faces_oriented = is_oriented;
  options.is_split = is_split;
  return options;
}

// Three faces at an edge, two cones that meet in a vertex, a band of one side.
void test_splitting()
{
  Polygon_soup book = make_soup(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  const Repair_result split = repair_soup(book, options_of(false, true));
  check(split.counts.given.edges_of_many_faces == 1 && split.counts.result.is_surface()
          && split.counts.result.components == 3 && split.counts.added_points == book.points.size() - 5,
        "a book is not split");
  for(std::size_t v = 0; v < book.points.size(); ++v)
    check(book.points[v]
            == Point(double(split.old_vertices[v]), double(split.old_vertices[v] * split.old_vertices[v]), 0),
          "an added point is elsewhere");
  Polygon_soup cones = make_soup(7, {{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {0, 5, 6}});
  check(count_soup(cones.polygons, 7).vertices_of_several_fans == 1, "fans are not counted");
  repair_soup(cones, options_of(false, true));
  check(cones.points.size() == 8 && count_soup(cones.polygons, 8).is_surface(), "cones are not split");
  Polygon_soup fan = make_soup(5, {{0, 1, 2}, {0, 3, 2}, {0, 3, 4}});
  const Repair_result oriented = repair_soup(fan, options_of(true, false));
  check(has_faces(fan, {{0, 1, 2}, {2, 3, 0}, {0, 3, 4}}) && oriented.counts.reversed_faces == 1
          && oriented.counts.result.is_surface(),
        "a fan is not oriented");
  Polygon_soup band = make_soup(5, {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}});
  Polygon_soup whole = band;
  const Repair_result band_oriented = repair_soup(whole, options_of(true, false));
  check(whole.points.size() == 5 && band_oriented.counts.result.edges_without_orientation > 0, "a band is cut");
  repair_soup(band, options_of(true, true));
  check(count_soup(band.polygons, band.points.size()).is_surface(), "a band is not cut");
}

// A face whose corners become one, one that becomes that beside it, and the largest component.
void test_merging()
{
  Polygon_soup soup = make_soup(8, {{0, 1, 2}, {3, 4, 5}, {0, 1, 6}, {2, 1, 7}});
  soup.points[3] = soup.points[0];
  soup.points[4] = soup.points[1];
  soup.points[5] = soup.points[2];
  soup.points[6] = Point(0, -0., 0);
  soup.points[0] = soup.points[3] = Point(-0., 0, 0);
  Repair_options options;
  options.are_coinciding_points_merged = true;
  const Repair_result result = repair_soup(soup, options);
  check(result.new_vertices == std::vector<std::size_t>({0, 1, 2, 0, 1, 2, 0, 3})
          && result.old_vertices == std::vector<std::size_t>({0, 1, 2, 7}),
        "the map of merged points is wrong");
  check(has_faces(soup, {{0, 1, 2}, {2, 1, 3}}) && result.counts.collapsed_faces == 1
          && result.counts.faces_repeated_by_merging == 1 && result.counts.merged_points == 4,
        "merged faces are left out wrongly");
  Polygon_soup parts = make_soup(10, {{0, 1, 2}, {3, 4, 5}, {4, 3, 6}, {7, 8, 9}});
  Repair_options largest;
  largest.is_largest_kept = true;
  const Repair_result kept = repair_soup(parts, largest);
  check(kept.new_vertices
            == std::vector<std::size_t>({no_vertex, no_vertex, no_vertex, 0, 1, 2, 3, no_vertex, no_vertex, no_vertex})
          && has_faces(parts, {{0, 1, 2}, {1, 0, 3}}) && kept.counts.other_faces == 2,
        "the largest component is another one");
}

// Each face of a closed mesh with points of its own, and these moved by less than half of the distance.
void test_closing(std::size_t seed)
{
  Random random(seed);
  const std::vector<std::vector<std::size_t>> torus = [] {
    std::vector<std::vector<std::size_t>> faces;
    for(std::size_t i = 0; i < 7; ++i)
    {
      faces.push_back({i, (i + 1) % 7, (i + 3) % 7});
      faces.push_back({i, (i + 3) % 7, (i + 2) % 7});
    }
    return faces;
  }();
  Polygon_soup soup;
  for(const auto& face : torus)
  {
    for(const std::size_t v : face)
    {
      const auto noise = [&] { return 1e-9 * (static_cast<double>(random.below(1000)) - 500) / 500 / 4; };
      soup.polygons.add_corner(soup.points.size());
      soup.points.emplace_back(static_cast<double>(v) + noise(), static_cast<double>(v * v) + noise(), noise());
    }
    soup.polygons.end_polygon();
  }
  const Close_points close = count_close_points(soup.points, border_points(soup.polygons));
  check(close.coinciding + close.close > 0 && close.needed_distance > 1e-11 && close.needed_distance <= 1e-8,
        "the distance that is needed is wrong");
  Repair_options options;
  options.distance = 1e-9;
  const Repair_result result = repair_soup(soup, options);
  check(result.counts.result.vertices == 7 && result.counts.result.euler_characteristic() == 0
          && result.counts.result.is_surface() && result.counts.result.border_edges == 0
          && result.counts.given.components == 14,
        "the torus of seed " + std::to_string(seed) + " is not closed");
}

} // namespace

int main()
{
  for(std::size_t seed = 0; seed < 3000; ++seed)
    test_random_points(seed);
  for(std::size_t seed = 0; seed < 100; ++seed)
    test_closing(seed);
  test_chain();
  test_extreme_numbers();
  test_wrong_distances();
  test_splitting();
  test_merging();
  return number_of_faults == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
