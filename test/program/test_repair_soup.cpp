// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/merge_points.h"
#include "input/repair_soup.h"
#include "random_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
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

// Three faces at an edge, of which two are paired, two cones that meet in a vertex, a band of one side.
void test_splitting()
{
  Polygon_soup book = make_soup(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  const Repair_result split = repair_soup(book, options_of(false, true));
  check(split.counts.given.edges_of_many_faces == 1 && split.counts.result.is_surface()
          && split.counts.result.components == 2 && split.counts.paired_edges == 1 && split.counts.unpaired_sides == 1
          && split.counts.added_points == book.points.size() - 5,
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

typedef std::vector<std::vector<std::size_t>> Faces;

// A box with corners of its own, whose faces are triangles; they look inside if it is turned.
void add_box(Polygon_soup& soup, std::array<double, 3> low, std::array<double, 3> high, bool is_turned = false)
{
  const std::size_t first = soup.points.size();
  for(std::size_t i = 0; i < 8; ++i)
    soup.points.emplace_back(i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]);
  for(const auto& [a, b, c, d] : std::vector<std::array<std::size_t, 4>>{
        {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    for(std::array<std::size_t, 3> t : {std::array<std::size_t, 3>{a, b, c}, std::array<std::size_t, 3>{a, c, d}})
    {
      if(is_turned)
        std::swap(t[1], t[2]);
      soup.polygons.add(std::array<std::size_t, 3>{first + t[0], first + t[1], first + t[2]});
    }
}

// Points at one place become one, whatever that makes of edges.
void join_all(Polygon_soup& soup)
{
  const std::vector<Corner> joined = join_by_search(soup.points, all_of(soup.points), 0);
  Polygons polygons;
  for(std::size_t i = 0; i < soup.polygons.size(); ++i)
  {
    for(const Corner v : soup.polygons[i])
      polygons.add_corner(joined[v]);
    polygons.end_polygon();
  }
  soup.polygons = polygons;
}

Repair_options all_options()
{
  Repair_options options;
  options.are_coinciding_points_merged = options.are_opposite_faces_cancelled = true;
  options.is_split = options.are_faces_oriented = true;
  return options;
}

double signed_volume(const Polygon_soup& soup)
{
  double sum = 0;
  for(std::size_t i = 0; i < soup.polygons.size(); ++i)
  {
    const auto at = [&](std::size_t k) { return soup.points[soup.polygons[i].begin()[k]] - CGAL::ORIGIN; };
    sum += at(0) * CGAL::cross_product(at(1), at(2)) / 6;
  }
  return sum;
}

bool are_equal(const Polygons& a, const Polygons& b)
{
  if(a.size() != b.size())
    return false;
  for(std::size_t i = 0; i < a.size(); ++i)
    if(!std::equal(a[i].begin(), a[i].end(), b[i].begin(), b[i].end()))
      return false;
  return true;
}

// Boxes that share an edge are one solid then, whose surface is cut at two midpoints; those that share a corner are two;
// those with a common face, cut along one diagonal, are one box; and cut along the other one, a box and a flat pillow.
void test_boxes()
{
  Polygon_soup beside;
  add_box(beside, {0, 0, 0}, {1, 1, 1});
  add_box(beside, {1, 1, 0}, {2, 2, 1});
  join_all(beside);
  const Repair_result at_edge = repair_soup(beside, all_options());
  check(at_edge.counts.paired_edges == 1 && at_edge.counts.added_midpoints == 2 && at_edge.counts.unpaired_sides == 0
          && at_edge.counts.result.is_surface() && at_edge.counts.result.border_edges == 0
          && at_edge.counts.result.components == 1 && at_edge.counts.result.euler_characteristic() == 2
          && std::abs(signed_volume(beside) - 2) < 1e-12,
        "boxes with a common edge are no solid");
  Polygon_soup inside_out;
  add_box(inside_out, {0, 0, 0}, {1, 1, 1}, true);
  add_box(inside_out, {1, 1, 0}, {2, 2, 1}, true);
  join_all(inside_out);
  check(repair_soup(inside_out, all_options()).counts.result.components == 1
          && std::abs(signed_volume(inside_out) - 2) < 1e-12,
        "boxes with a common edge are no solid if they are inside out");
  Polygon_soup touching;
  add_box(touching, {0, 0, 0}, {1, 1, 1});
  add_box(touching, {1, 1, 1}, {2, 2, 2});
  Polygon_soup apart = touching;
  check(repair_soup(apart, all_options()).counts.unmerged_points == 1 && apart.points.size() == 16,
        "boxes that touch in a corner are merged there");
  join_all(touching);
  const Repair_result at_corner = repair_soup(touching, all_options());
  check(at_corner.counts.added_points == 1 && at_corner.counts.result.is_surface(), "a corner is not split");
  for(const bool is_same : {true, false})
  {
    Polygon_soup pressed;
    add_box(pressed, {0, 0, 0}, {1, 1, 1});
    if(is_same)
      add_box(pressed, {1, 0, 0}, {2, 1, 1});
    else
      add_box(pressed, {1, 1, 0}, {2, 0, 1}, true); // seen in a mirror
    join_all(pressed);
    Repair_options options = all_options();
    options.least_share = 1e-6;
    const Repair_result result = repair_soup(pressed, options);
    check(result.counts.result.components == 1 && result.counts.result.is_surface()
            && result.counts.result.border_edges == 0 && result.counts.result.euler_characteristic() == 2
            && std::abs(signed_volume(pressed) - 2) < 1e-12 && result.counts.cancelled_faces == (is_same ? 4u : 0u)
            && result.counts.pieces_without_volume == (is_same ? 0u : 1u),
          "boxes with a common face are not one");
  }
}

// Each point is turned, and multiplied: no coordinate plane is left, and no unit.
struct Placement
{
  std::array<std::array<double, 3>, 3> axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  double unit = 1;

  static Placement random(Random& random)
  {
    const auto number = [&] { return double(random.below(2001)) / 1000 - 1.0005; };
    const std::array<double, 3> a = {number(), number(), 2}, b = {2, number(), number()};
    const auto product = [](const std::array<double, 3>& u, const std::array<double, 3>& v) {
      return std::array<double, 3>{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    };
    const auto unit_vector = [](std::array<double, 3> u) {
      const double length = std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
      return std::array<double, 3>{u[0] / length, u[1] / length, u[2] / length};
    };
    const std::array<double, 3> z = unit_vector(a), x = unit_vector(product(a, b));
    return {{x, product(z, x), z}, std::array<double, 5>{1, 1, 1e-150, 1e150, 1000}[random.below(5)]};
  }

  Point operator()(double x, double y, double z) const
  {
    const auto at = [&](std::size_t k) { return unit * (x * axes[0][k] + y * axes[1][k] + z * axes[2][k]); };
    return {at(0), at(1), at(2)};
  }
};

// In units of the placement.
double volume_of(Polygon_soup soup, const Placement& placement)
{
  for(Point& p : soup.points)
    p = Point(p.x() / placement.unit, p.y() / placement.unit, p.z() / placement.unit);
  return signed_volume(soup);
}

// The polygons in another order.
void shuffle(Polygon_soup& soup, Random& random)
{
  std::vector<std::size_t> order(soup.polygons.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  for(std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.below(i)]);
  Polygons polygons;
  for(const std::size_t i : order)
    polygons.add(soup.polygons[i]);
  soup.polygons = polygons;
}

// Boxes in boxes, some of which are inside out.
struct Boxes
{
  Polygon_soup soup;
  double volume = 0; // if each group of nested boxes is turned whose outermost one is inside out
  std::size_t number = 0, inside_out = 0;

  // With up to two boxes inside, side by side.
  void add(Random& random, std::array<double, 3> low, std::array<double, 3> high, int depth, int sign)
  {
    const bool is_turned = random.below(2) == 0;
    const int outermost = sign != 0 ? sign : is_turned ? -1 : 1;
    add_box(soup, low, high, is_turned);
    ++number;
    inside_out += sign == 0 && is_turned ? 1 : 0;
    volume += (is_turned ? -1 : 1) * outermost * (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
    for(std::size_t i = random.below(3); depth > 0 && i > 0; --i)
    {
      std::array<double, 3> inner_low = low, inner_high = high;
      for(std::size_t k = 0; k < 3; ++k)
      {
        const double length = high[k] - low[k];
        inner_low[k] += length * (k == 0 && i == 2 ? 0.55 : 0.1);
        inner_high[k] -= length * (k == 0 && i == 1 ? 0.55 : 0.1);
      }
      add(random, inner_low, inner_high, depth - 1, outermost);
    }
  }
};

// Groups of boxes beside each other, and open sheets of any size between and around them, which decide nothing.
void test_nested_boxes(std::size_t seed)
{
  Random random(seed);
  Boxes boxes;
  const std::size_t groups = 1 + random.below(3);
  for(std::size_t i = 0; i < groups; ++i)
    boxes.add(random, {2. * double(i), 0, 0}, {2. * double(i) + 1 + double(random.below(9)) / 10, 1, 1.5}, 2, 0);
  Polygon_soup& soup = boxes.soup;
  const std::size_t sheets = random.below(3);
  for(std::size_t i = 0; i < sheets; ++i)
  {
    const double size = std::array<double, 3>{0.2, 3, 50}[random.below(3)], height = random.below(2) == 0 ? 0.3 : -7;
    const std::size_t first = soup.points.size();
    for(const auto& [x, y] : {std::pair(-1., -1.), std::pair(1., -1.), std::pair(1., 1.), std::pair(-1., 1.)})
      soup.points.emplace_back(size * x, size * y, height + 0.01 * x * y);
    soup.polygons.add(std::array<std::size_t, 3>{first, first + 1, first + 2});
    soup.polygons.add(std::array<std::size_t, 3>{first, first + 2, first + 3});
  }
  const Placement placement = Placement::random(random);
  for(Point& p : soup.points)
    p = placement(p.x(), p.y(), p.z());
  shuffle(soup, random);
  const std::string name = " with seed " + std::to_string(seed);
  Repair_options least;
  least.least_share = 1e-9;
  Polygon_soup kept = soup;
  const Repair_result unchanged = repair_soup(kept, least);
  check(unchanged.counts.faces_of_pieces == 0 && are_equal(kept.polygons, soup.polygons), "a solid is left out" + name);
  check(find_inside_out(soup).solids == boxes.inside_out, "other solids are inside out" + name);
  Repair_options options = all_options();
  options.least_share = 1e-9;
  const Repair_result result = repair_soup(soup, options);
  Polygon_soup closed = soup;
  closed.polygons = Polygons();
  const std::vector<std::size_t> components = components_of_polygons(soup.polygons, soup.points.size());
  for(std::size_t i = 0; i < soup.polygons.size(); ++i)
    if(std::count(components.begin(), components.end(), components[i]) == 12)
      closed.polygons.add(soup.polygons[i]);
  check(closed.polygons.size() == 12 * boxes.number
          && std::abs(volume_of(closed, placement) - boxes.volume) < 1e-9 * (1 + boxes.volume)
          && result.counts.turned_solids == boxes.inside_out && find_inside_out(soup).solids == 0,
        "solids are inside out" + name);
}

// A cavity stays, and so does what it lies in, whatever is outside; what has no volume goes, and a fleck. What is said: a cube
// of side 3 with one of side 1 inside is 28 if both look outside, 26 if it has a cavity, also inside out.
void test_pieces()
{
  Polygon_soup soup;
  add_box(soup, {0, 0, 0}, {10, 10, 10});
  add_box(soup, {4, 4, 4}, {6, 6, 6}, true);
  add_box(soup, {20, 0, 0}, {23, 3, 3}, true);
  add_box(soup, {30, 0, 0}, {33, 3, 0});
  add_box(soup, {40, 0, 0}, {40.1, 0.1, 0.1});
  Repair_options options;
  options.least_share = 1e-3;
  const Repair_result result = repair_soup(soup, options);
  check(result.counts.small_pieces == 1 && result.counts.pieces_without_volume == 1
          && result.counts.faces_of_pieces == 24 && result.counts.result.components == 3 && soup.points.size() == 24
          && std::abs(signed_volume(soup) - (1000 - 8 - 27)) < 1e-9,
        "other pieces are left out");
  check(std::count(result.new_vertices.begin(), result.new_vertices.end(), no_vertex) == 16,
        "the map of pieces is wrong");
  // The border of a face that is left out is filled before solids are turned.
  for(const bool is_outer_turned : {false, true})
    for(const bool is_inner_turned : {false, true})
      for(const std::size_t left_out : {24, 0, 12})
      {
        Polygon_soup boxes, nested;
        add_box(boxes, {0, 0, 0}, {3, 3, 3}, is_outer_turned);
        add_box(boxes, {1, 1, 1}, {2, 2, 2}, is_inner_turned);
        nested.points = boxes.points;
        for(std::size_t face = 0; face < boxes.polygons.size(); ++face)
          if(face != left_out)
            nested.polygons.add(boxes.polygons[face]);
        Repair_options filling = all_options();
        filling.most_filled_edges = left_out == 24 ? 0 : 3;
        const Repair_result turned = repair_soup(nested, filling);
        check(std::abs(signed_volume(nested) - (is_outer_turned == is_inner_turned ? 28 : 26)) < 1e-9
                && turned.counts.turned_solids == (is_outer_turned ? 1u : 0u),
              "nested cubes have another volume");
      }
}

// A prism, each face of which has its own points on its edges, which are cut at any places, and a center: no two faces agree
// on an edge. The noise is less than half of the distance.
void test_stitching(std::size_t seed)
{
  Random random(seed);
  const std::size_t sides = 3 + random.below(4), most = 1 + random.below(12);
  const Placement placement = Placement::random(random);
  const double distance = 1e-6 * placement.unit, noise = random.below(2) == 0 ? 0 : 1e-7;
  const auto corner = [&](std::size_t i, bool is_top) {
    const double angle = 2 * 3.14159265358979 * double(i % sides) / double(sides);
    return std::array<double, 3>{std::cos(angle), std::sin(angle), is_top ? 1.5 : 0};
  };
  Polygon_soup soup;
  const auto add_face = [&](const std::vector<std::array<double, 3>>& corners) {
    const auto add_point = [&](const std::array<double, 3>& p, double by) {
      const auto moved = [&](double x) { return x + by * (double(random.below(1001)) / 500 - 1) / 2; };
      soup.points.push_back(placement(moved(p[0]), moved(p[1]), moved(p[2])));
    };
    std::array<double, 3> center = {0, 0, 0};
    const std::size_t first = soup.points.size();
    for(std::size_t i = 0; i < corners.size(); ++i)
    {
      const auto &p = corners[i], &q = corners[(i + 1) % corners.size()];
      const std::size_t number = 1 + random.below(most);
      for(std::size_t k = 0; k < number; ++k)
      {
        const double t = (double(k) + (k == 0 ? 0 : double(random.below(900)) / 1000)) / double(number);
        add_point({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])}, noise);
      }
      for(std::size_t k = 0; k < 3; ++k)
        center[k] += p[k] / double(corners.size());
    }
    const std::size_t last = soup.points.size();
    add_point(center, 0);
    for(std::size_t i = first; i < last; ++i)
      soup.polygons.add(std::array<std::size_t, 3>{i, i + 1 == last ? first : i + 1, last});
  };
  std::vector<std::array<double, 3>> lid, floor;
  for(std::size_t i = 0; i < sides; ++i)
  {
    lid.push_back(corner(i, true));
    floor.push_back(corner(sides - i, false));
    add_face({corner(i, false), corner(i + 1, false), corner(i + 1, true), corner(i, true)});
  }
  add_face(lid);
  add_face(floor);
  shuffle(soup, random);
  const Polygon_soup given = soup;
  const std::string name = " with seed " + std::to_string(seed);
  Close_points close = count_close_points(soup.points, border_points(soup.polygons));
  count_points_on_edges(soup, border_points(soup.polygons), close);
  check((close.on_edges > 0) == (most > 1) || most == 2, "T-junctions are not counted" + name);
  Repair_options options = all_options();
  options.stitching = Threshold{distance, false, false};
  const Repair_result result = repair_soup(soup, options);
  const double area = double(sides) / 2 * std::sin(2 * 3.14159265358979 / double(sides));
  check(result.counts.result.components == 1 && result.counts.result.border_edges == 0
          && result.counts.result.is_surface() && result.counts.result.euler_characteristic() == 2
          && soup.polygons.are_triangles() && std::abs(volume_of(soup, placement) - 1.5 * area) < 1e-5,
        "a prism is not stitched" + name);
  for(std::size_t v = 0; v < given.points.size(); ++v)
    check(result.new_vertices[v] != no_vertex
            && std::sqrt(
                 square_of_distance(Point(soup.points[result.new_vertices[v]].x() / placement.unit,
                                          soup.points[result.new_vertices[v]].y() / placement.unit,
                                          soup.points[result.new_vertices[v]].z() / placement.unit),
                                    Point(given.points[v].x() / placement.unit, given.points[v].y() / placement.unit,
                                          given.points[v].z() / placement.unit)))
                 <= 1.0001e-6,
          "a point moves too far" + name);
  Polygon_soup again = soup;
  check(repair_soup(again, options).counts.stitched_points == 0 && are_equal(again.polygons, soup.polygons),
        "a second repair changes something" + name);
}

// By definition: of each triple of corners, one copy stays if there are more one way round, unless nothing of a component
// would stay.
void test_cancelling(std::size_t seed)
{
  Random random(seed);
  Polygon_soup soup;
  for(std::size_t v = 0; v < 9; ++v)
    soup.points.emplace_back(double(random.below(100)), double(random.below(100)), double(random.below(100)));
  std::map<std::array<std::size_t, 3>, int> sums;
  const std::size_t number = 1 + random.below(16), many = 4 + random.below(6);
  for(std::size_t i = 0; i < number; ++i)
  {
    std::array<std::size_t, 3> t = {random.below(many), random.below(many), random.below(many)};
    if(t[0] == t[1] || t[1] == t[2] || t[0] == t[2])
      continue;
    for(std::size_t copies = 1 + random.below(3); copies > 0; --copies)
    {
      std::rotate(t.begin(), t.begin() + 1, t.end());
      if(random.below(3) == 0)
        std::swap(t[0], t[1]);
      soup.polygons.add(t);
      std::array<std::size_t, 3> sorted = t;
      std::sort(sorted.begin(), sorted.end());
      const bool is_even = (t[0] < t[1]) + (t[1] < t[2]) + (t[2] < t[0]) == 2;
      sums[sorted] += is_even ? 1 : -1;
    }
  }
  std::vector<std::size_t> labels(9);
  std::iota(labels.begin(), labels.end(), std::size_t(0));
  for(int turn = 0; turn < 9; ++turn)
    for(const auto& [t, sum] : sums)
      for(const std::size_t v : t)
        labels[v] = std::min({labels[t[0]], labels[t[1]], labels[t[2]]});
  std::map<std::size_t, bool> is_anything_left;
  for(const auto& [t, sum] : sums)
    is_anything_left[labels[t[0]]] |= sum != 0;
  std::map<std::array<std::size_t, 3>, int> left;
  for(const auto& [t, sum] : sums)
    if(sum != 0 || !is_anything_left[labels[t[0]]])
      left[t] = sum > 0 ? 1 : sum < 0 ? -1 : 0; // 0: either side
  Input_findings unused;
  leave_out_repeated_faces(soup, unused);
  Repair_options options;
  options.are_opposite_faces_cancelled = true;
  const Repair_result result = repair_soup(soup, options);
  std::size_t sheets = 0;
  for(const auto& [label, is_left] : is_anything_left)
    sheets += is_left ? 0 : 1;
  bool is_right = soup.polygons.size() == left.size() && result.counts.sheets == sheets;
  for(std::size_t i = 0; i < soup.polygons.size(); ++i)
  {
    std::array<std::size_t, 3> t;
    for(std::size_t k = 0; k < 3; ++k)
      t[k] = result.old_vertices[soup.polygons[i].begin()[k]];
    std::array<std::size_t, 3> sorted = t;
    std::sort(sorted.begin(), sorted.end());
    const int sign = (t[0] < t[1]) + (t[1] < t[2]) + (t[2] < t[0]) == 2 ? 1 : -1;
    const auto found = left.find(sorted);
    is_right = is_right && found != left.end() && (found->second == 0 || found->second == sign);
  }
  check(is_right, "other faces are cancelled with seed " + std::to_string(seed));
}

// Any faces on few places, all of them on top of each other, or on many: the result is a surface, of what was there, where
// the map says.
void test_anything(std::size_t seed)
{
  Random random(seed);
  Polygon_soup soup;
  const std::size_t number_of_points = 4 + random.below(12), width = 2 + random.below(random.below(2) == 0 ? 3 : 12);
  for(std::size_t v = 0; v < number_of_points; ++v)
    soup.points.emplace_back(double(random.below(width)), double(random.below(width)), double(random.below(width)));
  for(std::size_t i = 1 + random.below(40); i > 0; --i)
    soup.polygons.add(std::array<std::size_t, 3>{random.below(number_of_points), random.below(number_of_points),
                                                 random.below(number_of_points)});
  Input_findings unused;
  leave_out_degenerate_faces(soup.polygons, unused);
  leave_out_repeated_faces(soup, unused);
  const Polygon_soup given = soup;
  Repair_options options = all_options();
  options.are_opposite_faces_cancelled = random.below(2) == 0;
  options.are_coinciding_points_merged = random.below(2) == 0;
  options.most_filled_edges = random.below(2) == 0 ? 0 : 3 + random.below(6);
  options.is_largest_kept = random.below(2) == 0;
  const Repair_result result = repair_soup(soup, options);
  const std::string name = " with seed " + std::to_string(seed);
  check(result.counts.result.is_surface(), "there is no surface" + name);
  const std::vector<std::size_t> components = components_of_polygons(soup.polygons, soup.points.size());
  check(!options.is_largest_kept || std::set<std::size_t>(components.begin(), components.end()).size() <= 1,
        "another component is kept" + name);
  bool is_right = result.new_vertices.size() == given.points.size() && result.old_vertices.size() == soup.points.size();
  for(std::size_t v = 0; is_right && v < given.points.size(); ++v)
    if(const std::size_t now = result.new_vertices[v]; now != no_vertex)
      is_right = soup.points[now] == given.points[v] && result.old_vertices[now] <= v
              && given.points[result.old_vertices[now]] == given.points[v];
  check(is_right, "the map is wrong" + name);
  check(std::all_of(soup.points.begin(), soup.points.end(), [](const Point& p) { return p.x() == p.x(); }),
        "a point is none" + name);
  Polygon_soup again = soup;
  const Repair_result second = repair_soup(again, options);
  check(are_equal(again.polygons, soup.polygons) && again.points == soup.points,
        "a second repair changes something" + name);
  const auto area_of = [](const Polygon_soup& of) {
    double sum = 0;
    for(std::size_t i = 0; i < of.polygons.size(); ++i)
    {
      const auto at = [&](std::size_t k) { return of.points[of.polygons[i].begin()[k]]; };
      sum += std::sqrt(CGAL::cross_product(at(1) - at(0), at(2) - at(0)).squared_length());
    }
    return sum;
  };
  const double area = area_of(soup), area_before = area_of(given);
  if(!options.are_opposite_faces_cancelled && result.counts.faces_repeated_by_merging == 0
     && options.most_filled_edges == 0 && !options.is_largest_kept)
    check(std::abs(area - area_before) < 1e-9 * (1 + area), "area is lost" + name);
}

// What merging may do: no edge of several given ones has more than two faces, no point has new fans; and what was cut apart
// along all its edges is whole again.
void test_merging_anywhere(std::size_t seed)
{
  Random random(seed);
  const auto mesh =
    random.below(2) == 0 ? random_meshes::seven_vertex_torus() : random_meshes::bipyramid(3 + random.below(9));
  std::vector<Point> places;
  for(std::size_t v = 0; v < mesh.number_of_vertices; ++v)
    places.emplace_back(double(v), double(v * v), double(v * v * v));
  Polygon_soup soup;
  for(const auto& t : mesh.triangles)
  {
    for(const std::size_t v : t)
    {
      soup.polygons.add_corner(soup.points.size());
      soup.points.push_back(places[v]);
    }
    soup.polygons.end_polygon();
  }
  Repair_options options;
  options.are_coinciding_points_merged = true;
  Polygon_soup whole = soup;
  const Repair_result merged = repair_soup(whole, options);
  check(whole.points.size() == mesh.number_of_vertices && merged.counts.unmerged_points == 0
          && merged.counts.result.border_edges == 0 && merged.counts.result.is_surface(),
        "what was cut apart is not whole again with seed " + std::to_string(seed));
  for(Point& p : soup.points) // now at the places of others
    if(random.below(6) == 0)
      p = soup.points[random.below(soup.points.size())];
  const Polygon_soup given = soup;
  const Repair_result result = repair_soup(soup, options);
  check(result.counts.result.edges_of_many_faces == 0 && result.counts.result.vertices_of_several_fans == 0,
        "merging makes what is no surface with seed " + std::to_string(seed));
  std::set<std::array<double, 3>> different;
  for(const Point& p : soup.points)
    different.insert({p.x(), p.y(), p.z()});
  check(result.counts.unmerged_points == soup.points.size() - different.size(),
        "points that are left are counted wrongly");
}

// Holes in closed surfaces are filled, and those of more edges stay.
void test_filling(std::size_t seed)
{
  Random random(seed);
  const auto mesh =
    random.below(2) == 0 ? random_meshes::seven_vertex_torus() : random_meshes::bipyramid(3 + random.below(9));
  Faces faces;
  for(const auto& t : mesh.triangles)
    if(random.below(4) != 0)
      faces.push_back({t[0], t[1], t[2]});
  Polygon_soup soup = make_soup(mesh.number_of_vertices, faces);
  Repair_options options = options_of(true, true);
  options.most_filled_edges = 100;
  const Repair_result result = repair_soup(soup, options);
  check(result.counts.result.border_edges == 0 && result.counts.result.is_surface(),
        "holes are not filled with seed " + std::to_string(seed));
  for(std::size_t i = 0; i < faces.size(); ++i)
    for(std::size_t k = 0; k < 3; ++k)
      check(result.old_vertices[soup.polygons[i].begin()[k]] == faces[i][k], "faces change where holes are filled");
  Polygon_soup open = make_soup(5, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
  options.most_filled_edges = 4;
  check(repair_soup(open, options).counts.filled_borders == 0 && open.polygons.size() == 3, "a long border is filled");
}

// The rims of cones, flat and bent, pressed to slits and to few places, in any units: closed, and flat ones with their area.
void test_rims(std::size_t size, double unit)
{
  for(const char* form : {"flat", "bent", "rough", "slit", "few places", "one place"})
  {
    const std::string name = form;
    Polygon_soup soup;
    double area = 0;
    for(std::size_t i = 0; i < size; ++i)
    {
      const double angle = 2 * 3.14159265358979
                         * double(name == "few places"  ? i % 2
                                  : name == "one place" ? 0
                                                        : i)
                         / double(size);
      soup.points.emplace_back(unit * std::cos(angle), name == "slit" ? 0 : unit * std::sin(angle),
                               name == "bent"    ? 0.3 * unit * std::cos(3 * angle)
                               : name == "rough" ? 0.1 * unit * double(i * i * 7 % 11) / 11
                                                 : 0);
      soup.polygons.add(std::array<std::size_t, 3>{i, (i + 1) % size, size});
      area += std::sin(2 * 3.14159265358979 / double(size)) / 2;
    }
    soup.points.emplace_back(0, 0, -unit);
    Repair_options options;
    options.most_filled_edges = size;
    const Repair_result result = repair_soup(soup, options);
    const std::string what = name + " rim of " + std::to_string(size) + " edges";
    check(result.counts.result.is_surface() && result.counts.result.border_edges == 0, what + " is not closed");
    double filled = 0;
    for(std::size_t i = size; i < soup.polygons.size(); ++i)
    {
      const auto at = [&](std::size_t k) {
        const Point& p = soup.points[soup.polygons[i].begin()[k]];
        return Point(p.x() / unit, p.y() / unit, p.z() / unit);
      };
      filled += std::sqrt(CGAL::cross_product(at(1) - at(0), at(2) - at(0)).squared_length()) / 2;
    }
    if(name == "flat")
      check(std::abs(filled - area) < 1e-9 && result.counts.filling_faces == size - 2, what + " is not filled flat");
    else if(name == "bent")
      check(filled < 4.1 && result.counts.filling_faces == size - 2, what + " is filled with folds");
  }
}

} // namespace

int main()
{
  for(std::size_t seed = 0; seed < 3000; ++seed)
    test_random_points(seed);
  for(std::size_t seed = 0; seed < 100; ++seed)
    test_closing(seed);
  for(const std::size_t size : {3, 4, 20, 60, 300, 2000})
    for(const double unit : {1., 1e-200, 1e200})
      test_rims(size, unit);
  test_chain();
  test_extreme_numbers();
  test_wrong_distances();
  for(std::size_t seed = 0; seed < 3000; ++seed)
  {
    test_cancelling(seed);
    test_anything(seed);
    test_merging_anywhere(seed);
    test_filling(seed);
    test_nested_boxes(seed);
  }
  for(std::size_t seed = 0; seed < 500; ++seed)
    test_stitching(seed);
  test_splitting();
  test_merging();
  test_boxes();
  test_pieces();
  return number_of_faults == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
