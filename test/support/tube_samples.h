// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_TUBE_SAMPLES_H
#define CGAL_REEB_GRAPH_TEST_TUBE_SAMPLES_H

#include "generated_surfaces/implicit_surface.h"
#include "random_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Surfaces of tubes whose centerlines and radii are known.
namespace tube_samples {
using generated_surfaces::Triangle_soup;
typedef std::array<double, 3> Point;

inline Point between(const Point& p, const Point& q, double t)
{
  return {p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])};
}
inline double product(const Point& p, const Point& q, const Point& r) // of the ways from p to q and to r
{
  return (q[0] - p[0]) * (r[0] - p[0]) + (q[1] - p[1]) * (r[1] - p[1]) + (q[2] - p[2]) * (r[2] - p[2]);
}
inline double distance(const Point& p, const Point& q) { return std::sqrt(product(p, q, q)); }

// Balls along a segment, of radii that change linearly.
struct Tube
{
  Point from, to;
  double radius_from, radius_to;

  double place(const Point& p) const
  {
    const double squared_length = product(from, to, to);
    return squared_length > 0 ? std::clamp(product(from, p, to) / squared_length, 0., 1.) : 0;
  }
  double radius(double t) const { return (1 - t) * radius_from + t * radius_to; }
  double distance_to(const Point& p) const // negative inside
  {
    const double t = place(p);
    return distance(p, between(from, to, t)) - radius(t);
  }
};

struct Ball
{
  Point center;
  double radius;
};

// Tubes, what is cut out of their surface, and what their skeleton is.
struct Tubes
{
  std::string name;
  std::vector<Tube> tubes;
  std::vector<Ball> holes;
  std::size_t ends = 0, border_ends = 0, loops = 0, components = 1;
  double length = 0; // of the centerlines, which lead to the surface at ends without border
  double cell_size = 0.12;

  // Of the tube whose surface is nearest: how far the axis is, as a share of the radius, and that radius.
  std::pair<double, double> deviation(const Point& p) const
  {
    std::pair<double, double> best = {std::numeric_limits<double>::infinity(), 0};
    for(const Tube& tube : tubes)
    {
      const double t = tube.place(p);
      best = std::min(best, {distance(p, between(tube.from, tube.to, t)) / tube.radius(t), tube.radius(t)});
    }
    return best;
  }
};

// The distance from the union of the tubes, negative inside.
inline double distance_from(const std::vector<Tube>& tubes, const Point& p)
{
  double least = std::numeric_limits<double>::infinity();
  for(const Tube& tube : tubes)
    least = std::min(least, tube.distance_to(p));
  return least;
}

// Takes triangles out that have a corner in a ball, and further ones until each vertex has one fan.
inline void cut_out(Triangle_soup& soup, const std::vector<Ball>& holes)
{
  std::vector<bool> is_bad(soup.points.size(), false);
  for(std::size_t v = 0; v != soup.points.size(); ++v)
    for(const Ball& hole : holes)
      is_bad[v] = is_bad[v] || distance(soup.points[v], hole.center) < hole.radius;
  for(bool is_any_bad = true; is_any_bad;)
  {
    auto& triangles = soup.triangles;
    const auto has_bad = [&](const auto& t) { return is_bad[t[0]] || is_bad[t[1]] || is_bad[t[2]]; };
    triangles.erase(std::remove_if(triangles.begin(), triangles.end(), has_bad), triangles.end());
    std::map<std::pair<std::size_t, std::size_t>, int> sides;
    for(const auto& t : triangles)
      for(std::size_t i = 0; i != 3; ++i)
        ++sides[std::minmax(t[i], t[(i + 1) % 3])];
    std::vector<int> border_edges(soup.points.size(), 0);
    for(const auto& [edge, count] : sides)
      if(count == 1)
        ++border_edges[edge.first], ++border_edges[edge.second];
    is_any_bad = false;
    for(std::size_t v = 0; v != soup.points.size(); ++v)
      if(border_edges[v] > 2)
        is_any_bad = is_bad[v] = true;
  }
}

// Leaves points out that no triangle has.
inline Triangle_soup without_unused_points(const Triangle_soup& soup)
{
  Triangle_soup result;
  std::vector<std::size_t> numbers(soup.points.size(), soup.points.size());
  for(auto triangle : soup.triangles)
  {
    for(std::size_t& v : triangle)
    {
      if(numbers[v] == soup.points.size())
      {
        numbers[v] = result.points.size();
        result.points.push_back(soup.points[v]);
      }
      v = numbers[v];
    }
    result.triangles.push_back(triangle);
  }
  return result;
}

inline Triangle_soup surface(const Tubes& sample)
{
  const auto function = [&](const Point& p) { return distance_from(sample.tubes, p); };
  Point lowest = sample.tubes[0].from, highest = lowest;
  for(const Tube& tube : sample.tubes)
    for(std::size_t i = 0; i != 3; ++i)
    {
      const double reach = std::max(tube.radius_from, tube.radius_to) + 2 * sample.cell_size;
      lowest[i] = std::min({lowest[i], tube.from[i] - reach, tube.to[i] - reach});
      highest[i] = std::max({highest[i], tube.from[i] + reach, tube.to[i] + reach});
    }
  generated_surfaces::internal::Marching_tetrahedra marching(function, lowest, highest, sample.cell_size);
  Triangle_soup soup = marching.take_surface();
  generated_surfaces::internal::smooth(soup, function, 4);
  cut_out(soup, sample.holes);
  return without_unused_points(soup);
}

// The surface with points that are moved along the normal by up to a share of the radius there.
inline Triangle_soup with_noise(Triangle_soup soup, const Tubes& sample, double noise, std::size_t seed)
{
  random_meshes::Random random(seed);
  for(Point& p : soup.points)
  {
    const double share = noise * (2. * static_cast<double>(random.below(1000001)) / 1e6 - 1);
    const auto& tube = *std::min_element(sample.tubes.begin(), sample.tubes.end(), [&](const Tube& a, const Tube& b) {
      return a.distance_to(p) < b.distance_to(p);
    });
    const double t = tube.place(p), r = std::min(tube.radius(t), 4 * sample.cell_size);
    p = between(p, between(tube.from, tube.to, t), -share * r / distance(p, between(tube.from, tube.to, t)));
  }
  return soup;
}

inline Triangle_soup surface(const Tubes& sample, double noise, std::size_t seed)
{
  return with_noise(surface(sample), sample, noise, seed);
}

inline void add_length(Tubes& sample)
{
  for(const Tube& tube : sample.tubes)
    sample.length += distance(tube.from, tube.to);
}

// A trunk that forks twice, with ends that are closed or open.
inline Tubes tree(bool is_open)
{
  Tubes sample;
  sample.name = is_open ? "open tree" : "tree";
  sample.tubes = {{{0, 0, 0}, {0, 0, 5}, .6, .6},
                  {{0, 0, 5}, {3, 0, 8}, .45, .45},
                  {{0, 0, 5}, {-2, 1, 8}, .5, .5},
                  {{-2, 1, 8}, {-4, 1, 11}, .4, .4},
                  {{-2, 1, 8}, {-1, 3, 12}, .4, .4}};
  add_length(sample);
  const std::vector<Ball> ends = {{{0, 0, 0}, .6}, {{3, 0, 8}, .45}, {{-4, 1, 11}, .4}, {{-1, 3, 12}, .4}};
  sample.ends = 4;
  sample.border_ends = is_open ? 4 : 0;
  for(const Ball& end : ends) // what is cut off reaches 0.32 radii into the tube
    sample.length += (is_open ? -0.32 : 1) * end.radius;
  if(is_open)
    for(const Ball& end : ends)
      sample.holes.push_back({end.center, 1.05 * end.radius});
  return sample;
}

// A ball with five spikes, or a tube with four, whose heights over it are given as multiples of their radius: those that are
// not higher than that are no ends.
inline Tubes spiked(bool is_ball, double radius, double height)
{
  Tubes sample;
  sample.tubes = {{{0, 0, is_ball ? 0. : -4.}, {0, 0, is_ball ? 0.01 : 4.}, 1, 1}};
  for(int i = 0; i != (is_ball ? 5 : 4); ++i)
  {
    const double length = 1 + (height - 1) * radius, turn = is_ball ? 1.2566 * i + 0.2 : 1.1 * i;
    const double steep = !is_ball ? 0 : i % 2 == 0 ? -0.53 : 0.53, flat = length * std::sqrt(1 - steep * steep);
    const double z = is_ball ? 0 : 1.9 * i - 3;
    const Point top = {flat * std::cos(turn), flat * std::sin(turn), z + length * steep};
    sample.tubes.push_back({{0, 0, z}, top, radius, radius});
  }
  sample.ends = is_ball ? 5 : height > 1 ? 6 : 2;
  sample.cell_size = 0.09;
  return sample;
}

inline Tubes ring()
{
  Tubes sample;
  sample.name = "ring";
  const auto point = [](int i) {
    return Point{3 * std::cos(i * 3.14159265358979 / 12), 3 * std::sin(i * 3.14159265358979 / 12), 0};
  };
  for(int i = 0; i != 24; ++i)
    sample.tubes.push_back({point(i), point(i + 1), .5, .5});
  sample.loops = 1;
  add_length(sample);
  return sample;
}

// A ring whose hole is hardly wider than its tube, with bends.
inline Tubes fat_ring(std::size_t seed)
{
  Tubes sample;
  sample.name = "fat ring";
  random_meshes::Random random(seed);
  const auto share = [&] { return static_cast<double>(random.below(1001)) / 1000; };
  const double radius = 1.6 + 0.8 * share();
  std::vector<Point> points;
  for(int i = 0; i != 12; ++i)
  {
    const double angle = i * 3.14159265358979 / 6;
    points.push_back({radius * std::cos(angle), radius * (0.9 + 0.2 * share()) * std::sin(angle), 0.4 * share()});
  }
  for(std::size_t i = 0; i != points.size(); ++i)
    sample.tubes.push_back({points[i], points[(i + 1) % points.size()], 1, 1});
  sample.loops = 1;
  sample.cell_size = 0.3;
  return sample;
}

// Two rails with one rung more than there are loops.
inline Tubes ladder(std::size_t loops)
{
  Tubes sample;
  sample.name = "ladder with " + std::to_string(loops) + " loops";
  const double top = 3. * static_cast<double>(loops);
  for(const double x : {0., 3.})
    sample.tubes.push_back({{x, 0, -2.5}, {x, 0, top + 2.5}, .5, .5});
  for(std::size_t i = 0; i <= loops; ++i)
    sample.tubes.push_back({{0, 0, 3. * static_cast<double>(i)}, {3, 0, 3. * static_cast<double>(i)}, .4, .4});
  sample.ends = 4;
  sample.loops = loops;
  add_length(sample);
  sample.length += 4 * .5;
  return sample;
}

// A straight tube with two holes in its wall that face each other, which are no ends here.
inline Tubes pierced_tube(double hole_radius)
{
  Tubes sample;
  sample.name = "tube with two holes";
  sample.tubes = {{{0, 0, 0}, {0, 0, 9}, 1, 1}};
  sample.holes = {{{1, 0, 4.5}, hole_radius}, {{-1, 0, 4.5}, hole_radius}};
  sample.ends = 2;
  add_length(sample);
  sample.length += 2;
  sample.cell_size = 0.16;
  return sample;
}

// A body with five thin arms that bend and fork.
inline Tubes neuron()
{
  Tubes sample;
  sample.name = "neuron";
  sample.tubes = {{{0, 0, 0}, {0, 0, 0.2}, 1.3, 1.3},   {{0, 0, 0}, {3, 0, 0}, .3, .3},
                  {{3, 0, 0}, {6, 1, 1}, .3, .25},      {{6, 1, 1}, {8, 3, 1}, .25, .22},
                  {{6, 1, 1}, {8, -1, 2}, .25, .22},    {{0, 0, 0}, {-2, 2, 0}, .3, .3},
                  {{-2, 2, 0}, {-5, 3, 1}, .3, .22},    {{0, 0, 0}, {-2, -2, 0}, .3, .3},
                  {{-2, -2, 0}, {-4, -5, -1}, .3, .22}, {{0, 0, 0}, {0, 0, 4}, .3, .25}};
  add_length(sample);
  sample.ends = 5;
  sample.length += 4 * .22 + .25 - 0.2;
  sample.cell_size = 0.085;
  return sample;
}

// A ring beside a tube.
inline Tubes two_components()
{
  Tubes sample = ring();
  sample.name = "two components";
  sample.tubes.push_back({{0, 0, 3}, {0, 4, 5}, .5, .5});
  sample.length += std::hypot(4, 2) + 1;
  sample.ends = 2;
  sample.components = 2;
  return sample;
}

inline std::vector<Tubes> all()
{
  return {tree(false), tree(true), ring(), ladder(0), ladder(1), ladder(3), neuron(), two_components()};
}

} // namespace tube_samples

#endif // CGAL_REEB_GRAPH_TEST_TUBE_SAMPLES_H
