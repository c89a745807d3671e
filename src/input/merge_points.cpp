// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/merge_points.h"

#include "input/repair_soup.h"

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
// The polygons from their smallest vertices on; if their orientation does not matter, towards the smaller neighbour.
Polygons normalize(const Polygons& polygons, bool have_same_orientation)
{
  Polygons result;
  result.reserve(polygons.size());
  std::vector<Corner> corners;
  for(std::size_t i = 0; i < polygons.size(); ++i)
  {
    corners.assign(polygons[i].begin(), polygons[i].end());
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    if(!have_same_orientation && corners.back() < corners[1])
      std::reverse(corners.begin() + 1, corners.end());
    result.add(corners);
  }
  return result;
}
} // namespace

Duplicates find_duplicates(const Polygons& polygons, bool have_same_orientation)
{
  const Polygons normalized = normalize(polygons, have_same_orientation);
  const auto is_less = [&](std::size_t i, std::size_t j) {
    return std::lexicographical_compare(normalized[i].begin(), normalized[i].end(), normalized[j].begin(),
                                        normalized[j].end());
  };
  std::vector<std::size_t> order(polygons.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), is_less);
  Duplicates duplicates;
  duplicates.firsts.resize(polygons.size());
  for(std::size_t k = 0; k < order.size(); ++k)
  {
    const bool is_repeated = k > 0 && !is_less(order[k - 1], order[k]);
    duplicates.firsts[order[k]] = is_repeated ? duplicates.firsts[order[k - 1]] : order[k];
    if(is_repeated)
      duplicates.numbers.push_back(order[k]);
  }
  std::sort(duplicates.numbers.begin(), duplicates.numbers.end());
  duplicates.number = duplicates.numbers.size();
  if(duplicates.number > 0)
    duplicates.first = duplicates.numbers.front();
  return duplicates;
}

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

CGAL::Bbox_3 box_of(const std::vector<Point>& points)
{
  CGAL::Bbox_3 box;
  for(const Point& p : points)
    box += p.bbox();
  return box;
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
    result.needed_distance = power_of_ten_above(std::sqrt(needed));
}

} // namespace

namespace {
// Calls visit(side, number of the polygons that have it).
template <class Visit>
void for_each_edge(const Polygons& polygons, const Visit& visit)
{
  std::vector<std::pair<Corner, Corner>> sides;
  sides.reserve(polygons.number_of_corners());
  for_each_side(polygons, [&](Corner u, Corner v) { sides.emplace_back(std::minmax(u, v)); });
  std::sort(sides.begin(), sides.end());
  for(auto begin = sides.begin(), end = begin; begin != sides.end(); begin = end)
  {
    end = std::find_if(begin, sides.end(), [&](const auto& side) { return side != *begin; });
    visit(*begin, end - begin);
  }
}

} // namespace

std::vector<Corner> border_points(const Polygons& polygons)
{
  std::vector<Corner> result;
  for_each_edge(polygons, [&](const auto& side, std::ptrdiff_t number) {
    if(number == 1)
      result.insert(result.end(), {side.first, side.second});
  });
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

bool has_edge_of_many_faces(const Polygons& polygons)
{
  bool result = false;
  for_each_edge(polygons, [&](const auto&, std::ptrdiff_t number) { result = result || number > 2; });
  return result;
}

long double diagonal_of(const std::vector<Point>& points)
{
  const CGAL::Bbox_3 box = box_of(points);
  return std::sqrt(
    square_of_distance(Point(box.xmin(), box.ymin(), box.zmin()), Point(box.xmax(), box.ymax(), box.zmax())));
}

Close_points count_close_points(const std::vector<Point>& points, const std::vector<Corner>& candidates)
{
  Close_points result;
  if(candidates.empty())
    return result;
  const CGAL::Bbox_3 box = box_of(points);
  result.largest_distance = static_cast<double>(1e-6L * diagonal_of(points));
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
  if(points.on_edges > 0)
    command << "--all --stitch " << points.needed_distance;
  else if(points.close > 0)
    command << (points.have_edges_of_many_faces ? "--all " : "") << "--merge-within " << points.needed_distance;
  else
    command << (points.have_edges_of_many_faces ? "--all" : "--merge");
  return command.str();
}

namespace {
// Polygons of other vertices, without those that have one of them twice, and once what is there several times.
struct Joined_polygons
{
  Joined_polygons(const Polygons& given, const std::vector<Corner>& vertices)
  {
    Polygons all;
    std::vector<std::size_t> numbers;
    std::vector<Corner> corners, sorted;
    for(std::size_t i = 0; i < given.size(); ++i)
    {
      corners.clear();
      for(const Corner v : given[i])
        corners.push_back(vertices[v]);
      if(find_repeated_vertex(Polygons::Polygon(corners.data(), corners.data() + corners.size()), sorted))
        continue;
      all.add(corners);
      numbers.push_back(i);
    }
    const std::vector<std::size_t> repeated = find_duplicates(all, true).numbers;
    for(std::size_t i = 0; i < all.size(); ++i)
      if(!std::binary_search(repeated.begin(), repeated.end(), i))
      {
        polygons.add(all[i]);
        corners_given.insert(corners_given.end(), given[numbers[i]].begin(), given[numbers[i]].end());
      }
  }

  Polygons polygons;
  std::vector<Corner> corners_given; // the given vertex at each corner
};

class Point_merging
{
public:
  Point_merging(const Polygon_soup& soup, bool is_cut_kept)
    : soup_(soup),
      is_cut_kept_(is_cut_kept),
      fans_(count_fans(soup.polygons, sides_of(soup.polygons), soup.points.size()))
  {
    std::vector<Corner> all(soup.points.size());
    std::iota(all.begin(), all.end(), Corner(0));
    places_ = join_close_points(soup.points, all, 0);
  }

  // Where something is wrong, the points there are left as they are, and those around a vertex. What is wrong after many
  // turns is left with its whole component.
  std::vector<Corner> merge()
  {
    constexpr int most_turns = 8;
    for(int turn = 0;; ++turn)
    {
      std::vector<Corner> joined = join();
      std::vector<char> is_wrong = find_wrong(joined);
      if(std::find(is_wrong.begin(), is_wrong.end(), 1) == is_wrong.end())
        return joined;
      if(turn >= most_turns)
        spread_in_components(is_wrong);
      std::vector<char> is_left(places_.size(), 0);
      for(std::size_t v = 0; v < places_.size(); ++v)
        is_left[places_[v]] |= is_wrong[v];
      for(std::size_t v = 0; v < places_.size(); ++v) // the first vertex of a place comes before the other ones
        if(is_left[places_[v]] != 0)
        {
          is_left[v] = 1;
          places_[v] = static_cast<Corner>(v);
        }
    }
  }

private:
  // Joins both vertices at the ends of each edge of two faces, and what is on no face.
  std::vector<Corner> join() const
  {
    const Joined_polygons at_places(soup_.polygons, places_);
    Union_find_of_indices vertices(places_.size());
    std::vector<char> is_on_face(places_.size(), 0);
    for(const Corner v : at_places.corners_given)
      is_on_face[v] = 1;
    const Face_pairs pairs = pair_two_faces(at_places.polygons);
    const std::vector<Polygon_side>& sides = pairs.sides;
    for(std::size_t s = 1; s < sides.size(); ++s)
    {
      const bool is_of_two = !(sides[s - 1] < sides[s]) && (s == 1 || sides[s - 2] < sides[s])
                          && (s + 1 == sides.size() || sides[s] < sides[s + 1]);
      if(!is_of_two || (is_cut_kept_ && pairs.mates[s] == s))
        continue;
      const auto given = [&](std::size_t corner) { return at_places.corners_given[corner]; };
      vertices.unite(given(sides[s - 1].corner_of_u), given(sides[s].corner_of_u));
      vertices.unite(given(sides[s - 1].corner_of_v), given(sides[s].corner_of_v));
    }
    for(std::size_t v = 0; v < places_.size(); ++v)
      if(is_on_face[v] == 0)
        vertices.unite(v, places_[v]);
    std::vector<Corner> firsts(places_.size(), too_large_corner), joined(places_.size());
    for(std::size_t v = 0; v < places_.size(); ++v)
    {
      Corner& first = firsts[vertices.find(v)];
      first = std::min(first, static_cast<Corner>(v));
      joined[v] = first;
    }
    return joined;
  }

  // The vertices of edges that would get more than two faces, and those around vertices that would get several fans.
  std::vector<char> find_wrong(const std::vector<Corner>& joined) const
  {
    std::vector<char> is_wrong(joined.size(), 0), has_new_fans(joined.size(), 0);
    const Joined_polygons result(soup_.polygons, joined);
    const std::vector<Polygon_side> sides = sides_of(result.polygons);
    const auto ends = [&](std::size_t s) {
      return std::make_pair(result.corners_given[sides[s].corner_of_u], result.corners_given[sides[s].corner_of_v]);
    };
    for_each_edge(sides, [&](std::size_t begin, std::size_t end) {
      for(std::size_t s = begin + 1; end - begin > 2 && s < end; ++s)
        if(ends(s) != ends(begin))
          is_wrong[sides[s].u] = is_wrong[sides[s].v] = 1;
    });
    const std::vector<std::size_t> fans = count_fans(result.polygons, sides, joined.size());
    std::vector<std::size_t> given_fans(joined.size(), 0);
    for(std::size_t v = 0; v < joined.size(); ++v)
      given_fans[joined[v]] = std::max(given_fans[joined[v]], fans_[v]);
    for(std::size_t i = 0; i < soup_.polygons.size(); ++i)
    {
      const Polygons::Polygon polygon = soup_.polygons[i];
      if(std::any_of(polygon.begin(), polygon.end(),
                     [&](Corner v) { return fans[joined[v]] > std::max<std::size_t>(given_fans[joined[v]], 1); }))
        for(const Corner v : polygon)
          is_wrong[v] = 1;
    }
    return is_wrong;
  }

  void spread_in_components(std::vector<char>& is_wrong) const
  {
    Union_find_of_indices components(places_.size());
    for(std::size_t v = 0; v < places_.size(); ++v)
      components.unite(v, places_[v]);
    for(std::size_t i = 0; i < soup_.polygons.size(); ++i)
      for(const Corner v : soup_.polygons[i])
        components.unite(*soup_.polygons[i].begin(), v);
    std::vector<char> is_any_wrong(places_.size(), 0);
    for(std::size_t v = 0; v < places_.size(); ++v)
      is_any_wrong[components.find(v)] |= is_wrong[v];
    for(std::size_t v = 0; v < places_.size(); ++v)
      is_wrong[v] = is_any_wrong[components.find(v)];
  }

  const Polygon_soup& soup_;
  bool is_cut_kept_;
  std::vector<std::size_t> fans_; // of the given vertices
  std::vector<Corner> places_;    // the first vertex where each one is; itself where points are left as they are
};

} // namespace

std::vector<Corner> merge_coinciding_points(const Polygon_soup& soup, bool is_cut_kept)
{
  return Point_merging(soup, is_cut_kept).merge();
}

} // namespace reeb_graph_program
