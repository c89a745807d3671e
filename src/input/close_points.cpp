// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/close_points.h"

#include <CGAL/Bbox_3.h>

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <sstream>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
typedef std::array<double, 3> Coordinates;

// Zeros of either sign are the same.
Coordinates coordinates(const Point& p) { return {p.x() + 0., p.y() + 0., p.z() + 0.}; }

// Without overflow, and without loss for the smallest distances.
long double square_of_distance(const Point& p, const Point& q)
{
  long double sum = 0;
  for(int i = 0; i < 3; ++i)
  {
    const long double d = static_cast<long double>(p[i]) - static_cast<long double>(q[i]);
    sum += d * d;
  }
  return sum;
}

// A grid of points. Its cells are twice as wide as the distance, and numbered by floating point numbers, which do not
// overflow: where these skip whole numbers, different coordinates are farther from each other than the distance.
class Point_grid
{
public:
  Point_grid(const std::vector<Point>& points, double distance)
    : points_(points),
      distance_(distance),
      width_(std::min(2 * distance, std::numeric_limits<double>::max()))
  {}

  void insert(Corner v) { cells_[cell(coordinates(points_[v]))].push_back(v); }

  // The nearest point within the distance, of several the first one; itself if there is none.
  Corner nearest(Corner v) const
  {
    const Coordinates p = coordinates(points_[v]);
    std::array<std::array<double, 3>, 3> numbers; // of cells that it meets, along each axis
    for(std::size_t i = 0; i < 3; ++i)
      numbers[i] = {number(bounded(p[i] - distance_)), number(p[i]), number(bounded(p[i] + distance_))};
    Corner nearest = v;
    long double least = static_cast<long double>(distance_) * distance_;
    for(std::size_t i = 0; i < 27; ++i)
    {
      const std::array<std::size_t, 3> k = {i / 9, i / 3 % 3, i % 3};
      if(is_repeated(numbers[0], k[0]) || is_repeated(numbers[1], k[1]) || is_repeated(numbers[2], k[2]))
        continue;
      const auto found = cells_.find({numbers[0][k[0]], numbers[1][k[1]], numbers[2][k[2]]});
      if(found == cells_.end())
        continue;
      for(const Corner other : found->second)
      {
        const long double square = square_of_distance(points_[v], points_[other]);
        if(square < least || (square == least && (nearest == v || other < nearest)))
        {
          least = square;
          nearest = other;
        }
      }
    }
    return nearest;
  }

private:
  static double bounded(double x)
  {
    return std::clamp(x, std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max());
  }
  double number(double x) const { return std::floor(x / width_) + 0.; }
  Coordinates cell(const Coordinates& p) const { return {number(p[0]), number(p[1]), number(p[2])}; }
  static bool is_repeated(const std::array<double, 3>& numbers, std::size_t k)
  {
    return std::find(numbers.begin(), numbers.begin() + k, numbers[k]) != numbers.begin() + k;
  }

  const std::vector<Point>& points_;
  double distance_, width_;
  std::unordered_map<Coordinates, std::vector<Corner>, boost::hash<Coordinates>> cells_;
};

// Orders points by how far they lie in a direction that no model is built along.
class Sweep
{
public:
  Sweep(const std::vector<Point>& points, const CGAL::Bbox_3& box) : points_(points), box_(box) {}

  long double operator()(Corner v) const
  {
    const Point& p = points_[v];
    return 0.4836L * (static_cast<long double>(p.x()) - box_.xmin())
         + 0.6517L * (static_cast<long double>(p.y()) - box_.ymin())
         + 0.5841L * (static_cast<long double>(p.z()) - box_.zmin());
  }

private:
  const std::vector<Point>& points_;
  const CGAL::Bbox_3& box_;
};

// One of the candidates at each place, and the number of those that are not alone there.
std::vector<Corner> places_of(const std::vector<Point>& points, std::vector<Corner> candidates, std::size_t& coinciding)
{
  std::vector<Corner> places;
  std::sort(candidates.begin(), candidates.end(),
            [&](Corner u, Corner v) { return coordinates(points[u]) < coordinates(points[v]); });
  for(std::size_t begin = 0, end = 0; begin < candidates.size(); begin = end)
  {
    for(end = begin;
        end < candidates.size() && coordinates(points[candidates[begin]]) == coordinates(points[candidates[end]]);)
      ++end;
    places.push_back(candidates[begin]);
    coinciding += end - begin > 1 ? end - begin : 0;
  }
  return places;
}

// Counts the places that have another one within the distance, and finds how far that is at most. In a crowd, no more
// than some others are looked at.
void count_close_places(const std::vector<Point>& points,
                        const std::vector<Corner>& places,
                        const CGAL::Bbox_3& box,
                        Close_points& result)
{
  constexpr std::size_t most_others = 1000;
  const Sweep sweep(points, box);
  std::vector<std::pair<long double, Corner>> order;
  for(const Corner v : places)
    order.emplace_back(sweep(v), v);
  std::sort(order.begin(), order.end());
  const long double none = std::numeric_limits<long double>::infinity();
  const long double most = static_cast<long double>(result.largest_distance) * result.largest_distance;
  std::vector<long double> nearest(order.size(), none);
  for(std::size_t i = 0; i < order.size(); ++i)
  {
    const std::size_t end = std::min(order.size(), i + most_others);
    for(std::size_t j = i + 1; j < end && order[j].first - order[i].first <= result.largest_distance; ++j)
    {
      const long double square = square_of_distance(points[order[i].second], points[order[j].second]);
      if(square > most)
        continue;
      nearest[i] = std::min(nearest[i], square);
      nearest[j] = std::min(nearest[j], square);
    }
  }
  long double needed = 0;
  for(const long double square : nearest)
    if(square != none)
    {
      ++result.close;
      needed = std::max(needed, square);
    }
  if(needed > 0)
    result.needed_distance = std::pow(10., std::ceil(static_cast<double>(std::log10(1.01L * std::sqrt(needed)))));
}

} // namespace

std::vector<Corner> border_points(const Polygons& polygons)
{
  std::vector<std::pair<Corner, Corner>> sides;
  sides.reserve(polygons.number_of_corners());
  for(std::size_t i = 0; i < polygons.size(); ++i)
  {
    Corner previous = *(polygons[i].end() - 1);
    for(const Corner v : polygons[i])
    {
      sides.emplace_back(std::minmax(previous, v));
      previous = v;
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<Corner> result;
  for(std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    for(end = begin; end < sides.size() && sides[begin] == sides[end];)
      ++end;
    if(end - begin == 1)
      result.insert(result.end(), {sides[begin].first, sides[begin].second});
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

Close_points count_close_points(const std::vector<Point>& points, const std::vector<Corner>& candidates)
{
  Close_points result;
  if(candidates.empty())
    return result;
  CGAL::Bbox_3 box;
  for(const Point& p : points)
    box += p.bbox();
  result.largest_distance =
    static_cast<double>(1e-6L
                        * std::sqrt(square_of_distance(Point(box.xmin(), box.ymin(), box.zmin()),
                                                       Point(box.xmax(), box.ymax(), box.zmax()))));
  const std::vector<Corner> places = places_of(points, candidates, result.coinciding);
  if(result.largest_distance > 0)
    count_close_places(points, places, box, result);
  return result;
}

std::vector<Corner> join_close_points(const std::vector<Point>& points,
                                      const std::vector<Corner>& candidates,
                                      double distance)
{
  std::vector<Corner> joined(points.size());
  std::iota(joined.begin(), joined.end(), Corner(0));
  if(distance == 0)
  {
    std::unordered_map<Coordinates, Corner, boost::hash<Coordinates>> first;
    for(const Corner v : candidates)
      joined[v] = first.emplace(coordinates(points[v]), v).first->second;
    return joined;
  }
  Point_grid kept(points, distance);
  for(const Corner v : candidates)
  {
    joined[v] = kept.nearest(v);
    if(joined[v] == v)
      kept.insert(v);
  }
  return joined;
}

std::string suggested_repair(const Close_points& points)
{
  if(!points.is_any())
    return "";
  std::ostringstream command;
  command << "reeb_graph repair ";
  if(points.close > 0)
    command << "--merge-within " << points.needed_distance;
  else
    command << "--merge";
  return command.str();
}

} // namespace reeb_graph_program
