// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_DRAWING_NODE_SPREADING_H
#define CGAL_REEB_GRAPH_INTERNAL_DRAWING_NODE_SPREADING_H

#include <CGAL/license/Reeb_graph.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

typedef std::array<double, 2> Plane_point; // column and height

// The height of a drawing of so many nodes, and the diameter of its largest nodes, in pixels.
inline double height_of_drawing(std::size_t number_of_nodes)
{
  return (std::clamp)(360 + 26 * std::sqrt(static_cast<double>(number_of_nodes)), 420., 1400.);
}
constexpr double largest_node_diameter = 13.2;

// The same diameter in columns. Columns are at least two of it apart.
constexpr double node_width = 0.25;

// Gives each of some heights, which ascend, a place beside each other, so that at each place the distance from one
// height to the next is not less than the given one. Returns the number of places as well.
inline std::pair<std::vector<std::size_t>, std::size_t> places_side_by_side(const std::vector<double>& heights,
                                                                            double distance)
{
  typedef std::pair<double, std::size_t> Last; // height at a place
  std::priority_queue<Last, std::vector<Last>, std::greater<Last>> last;
  std::vector<std::size_t> places;
  for(const double height : heights)
  {
    std::size_t place = last.size();
    if(!last.empty() && last.top().first + distance <= height)
    {
      place = last.top().second;
      last.pop();
    }
    last.emplace(height, place);
    places.push_back(place);
  }
  return {std::move(places), last.size()};
}

// How much room a column of such nodes takes to either side, beyond that for two of them.
inline double room_of_nodes(const std::vector<double>& heights, double distance)
{
  constexpr std::size_t most = 24; // more nodes lie closer together
  const std::size_t number = places_side_by_side(heights, distance).second;
  return node_width / 2 * static_cast<double>(std::clamp<std::size_t>(number, 2, most) - 2);
}

// Moves nodes of one column sideways where they would lie on each other, and all that is drawn around them. Points keep
// their height and, at each height, their order from the left to the right, so that no crossing comes or goes.
class Node_spreading
{
public:
  explicit Node_spreading(double distance) : distance_(distance) {}

  // Spreads the nodes of a column, whose heights ascend.
  void add_column(double column, const std::vector<double>& heights, double room)
  {
    for(auto begin = heights.begin(), end = begin; begin != heights.end(); begin = end)
    {
      for(++end; end != heights.end() && *end - *std::prev(end) < distance_;)
        ++end;
      if(end - begin > 1)
        zones_[column].push_back(zone(std::vector<double>(begin, end), room));
    }
    largest_room_ = (std::max)(largest_room_, room);
  }

  Plane_point operator()(Plane_point point) const
  {
    const double given = point[0];
    for_each_zone(point, [&](double column, const Zone& zone) {
      point[0] += zone.shift(point[1]) * (std::max)(0., 1 - std::abs(given - column) / zone.half_width);
    });
    return point;
  }

  // A polyline gets the points that its image needs.
  std::vector<Plane_point> operator()(const std::vector<Plane_point>& polyline) const
  {
    std::vector<Plane_point> result;
    for(std::size_t i = 0; i + 1 < polyline.size(); ++i)
    {
      const Plane_point &from = polyline[i], &to = polyline[i + 1];
      for(const double t : breaks(from, to))
        result.push_back((*this)({from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])}));
    }
    result.push_back((*this)(polyline.back()));
    return result;
  }

private:
  // Where a column is bent: by how much at some heights, linearly between them, and less beside the column.
  struct Zone
  {
    std::vector<Plane_point> shifts; // and heights, which ascend
    double half_width;

    double low() const { return shifts.front()[1]; }
    double high() const { return shifts.back()[1]; }

    std::vector<Plane_point>::const_iterator first_above(double height) const
    {
      return std::upper_bound(shifts.begin(), shifts.end(), height,
                              [](double value, const Plane_point& shift) { return value < shift[1]; });
    }

    double shift(double height) const
    {
      const auto above = first_above(height);
      if(above == shifts.begin() || above == shifts.end())
        return 0;
      const Plane_point &from = *std::prev(above), &to = *above;
      return from[0] + (height - from[1]) / (to[1] - from[1]) * (to[0] - from[0]);
    }
  };

  Zone zone(const std::vector<double>& heights, double room) const
  {
    const auto [places, number] = places_side_by_side(heights, distance_);
    const double size = static_cast<double>(number), half_width = node_width + room;
    const double step = (std::min)(node_width, 2 * half_width / size);
    Zone zone = {{{0, heights.front() - distance_ / 2}}, half_width};
    for(std::size_t i = 0; i != heights.size(); ++i)
      zone.shifts.push_back({step * (static_cast<double>(places[i]) - (size - 1) / 2), heights[i]});
    zone.shifts.push_back({0, heights.back() + distance_ / 2});
    return zone;
  }

  // That which does not end below a height. The zones of a column are apart.
  static std::vector<Zone>::const_iterator first_zone(const std::vector<Zone>& zones, double height)
  {
    return std::lower_bound(zones.begin(), zones.end(), height,
                            [](const Zone& zone, double value) { return zone.high() < value; });
  }

  // Calls visit(column, zone) for the zones that a point is in.
  template <class Visit>
  void for_each_zone(const Plane_point& point, const Visit& visit) const
  {
    const double reach = node_width + largest_room_;
    for(auto column = zones_.lower_bound(point[0] - reach); column != zones_.end() && column->first < point[0] + reach;
        ++column)
    {
      const auto zone = first_zone(column->second, point[1]);
      if(zone != column->second.end() && zone->low() <= point[1]
         && std::abs(point[0] - column->first) < zone->half_width)
        visit(column->first, *zone);
    }
  }

  // Where the image of a segment is bent, from 0 to less than 1. What passes by several columns needs no bend there, as
  // it is all but horizontal.
  std::vector<double> breaks(const Plane_point& from, const Plane_point& to) const
  {
    std::vector<double> result = {0};
    const auto add = [&](int axis, double coordinate) {
      const double t = (coordinate - from[axis]) / (to[axis] - from[axis]);
      if(t > 0 && t < 1)
        result.push_back(t);
    };
    const auto add_zone = [&](double column, const Zone& zone) {
      for(const double side : {-1, 0, 1})
        add(0, column + side * zone.half_width);
      for(auto shift = zone.first_above(from[1]); shift != zone.shifts.end() && (*shift)[1] < to[1]; ++shift)
        add(1, (*shift)[1]);
    };
    for_each_zone(from, add_zone);
    for_each_zone(to, add_zone);
    if(from[0] == to[0]) // which can pass by several zones of its column
    {
      const auto column = zones_.find(from[0]);
      if(column != zones_.end())
      {
        auto zone = first_zone(column->second, from[1]);
        for(; zone != column->second.end() && zone->low() < to[1]; ++zone)
          add_zone(column->first, *zone);
      }
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  double distance_; // nodes of less are spread
  double largest_room_ = 0;
  std::map<double, std::vector<Zone>> zones_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_DRAWING_NODE_SPREADING_H
