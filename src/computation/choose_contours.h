// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_CHOOSE_CONTOURS_H
#define CGAL_REEB_GRAPH_SRC_CHOOSE_CONTOURS_H

#include "computation/contours.h"
#include "computation/nearest_place.h"

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/squared_distance_3.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

// The contours of a choice, for surfaces and for complexes. add(contour, contours) draws a contour of the augmentation
// as lines or as triangles, and counts it.
namespace reeb_graph_program {
// Throws std::runtime_error if there is no such arc.
template <class AnyGraph>
typename boost::graph_traits<AnyGraph>::edge_descriptor arc_of_number(const AnyGraph& graph, std::size_t arc)
{
  if(arc >= num_edges(graph))
    throw std::runtime_error("there is no arc " + std::to_string(arc) + ": the graph has "
                             + std::to_string(num_edges(graph)) + ", numbered from 0");
  return *std::next(edges(graph).first, static_cast<std::ptrdiff_t>(arc));
}

inline void add_line(Polyline points, std::size_t arc, double value, bool is_closed, Contours& contours)
{
  contours.lines.push_back({std::move(points), arc, value, 0, is_closed});
  contours.lines.back().length = length_of(contours.lines.back().points);
}

// N levels between the least and the greatest value, which they cut into N + 1 equal steps.
inline std::vector<double> equal_steps(std::size_t number_of_levels, Scalar_map scalar_map)
{
  std::vector<double> levels;
  if(scalar_map.begin() == scalar_map.end())
    return levels;
  const auto [lowest, highest] = std::minmax_element(scalar_map.begin(), scalar_map.end());
  if(!std::isfinite(*lowest) || !std::isfinite(*highest))
    throw std::runtime_error("--levels needs a field of finite range");
  for(std::size_t i = 1; i <= number_of_levels; ++i)
  {
    const double t = static_cast<double>(i) / (static_cast<double>(number_of_levels) + 1);
    levels.push_back((1 - t) * *lowest + t * *highest);
  }
  return levels;
}

inline double squared_distance(const Point& point, const Contours& contours)
{
  double least = std::numeric_limits<double>::infinity();
  const auto visit = [&](const std::array<Point, 3>& triangle) {
    least = (std::min)(least, CGAL::squared_distance(point, nearest_point(point, triangle)));
  };
  for(const Contour_line& line : contours.lines)
    for(std::size_t i = 0; i < line.points.size(); ++i)
      visit({line.points[i == 0 ? 0 : i - 1], line.points[i], line.points[i]});
  for(const auto& [a, b, c] : contours.triangles)
    visit({contours.points[a], contours.points[b], contours.points[c]});
  return least;
}

template <class AnyAugmentation, class Add>
Contours nearest_contour(const AnyAugmentation& augmentation, const Add& add, const Nearest_place& place)
{
  Contours nearest;
  if(!place.is_found())
    return nearest;
  // Where the place is the highest one of its cell, the level just above it can be elsewhere.
  std::vector<double> levels = {place.value()};
  if(!place.is_level_in_cell())
    levels.push_back(std::nextafter(place.value(), -std::numeric_limits<double>::infinity()));
  double least = std::numeric_limits<double>::infinity();
  for(const double level : levels)
    for(const auto& contour : augmentation.template contours_at_value<CGAL::Parallel_if_available_tag>(level))
    {
      Contours candidate;
      add(contour, candidate);
      const double distance = squared_distance(place.place(), candidate);
      if(!(distance < least))
        continue;
      least = distance;
      nearest = std::move(candidate);
    }
  return nearest;
}

template <class AnyAugmentation, class Add>
void add_level(const AnyAugmentation& augmentation, const Add& add, double level, Contours& contours)
{
  for(const auto& contour : augmentation.template contours_at_value<CGAL::Parallel_if_available_tag>(level))
    add(contour, contours);
}

// `find_place` finds the place on the mesh that is nearest to a point.
template <class AnyAugmentation, class Add, class FindPlace>
Contours choose_contours(const AnyAugmentation& augmentation,
                         const Add& add,
                         Scalar_map scalar_map,
                         const Contour_choice& choice,
                         const FindPlace& find_place)
{
  const auto& graph = augmentation.graph();
  Contours contours;
  if(choice.point)
    contours = nearest_contour(augmentation, add, find_place(*choice.point));
  else if(choice.arc)
    add(augmentation.contour(arc_of_number(graph, *choice.arc), *choice.t), contours);
  else if(choice.t)
    for(const auto arc : CGAL::make_range(edges(graph)))
      add(augmentation.contour(arc, *choice.t), contours);
  else if(choice.number_of_levels)
    for(const double level : equal_steps(*choice.number_of_levels, scalar_map))
      add_level(augmentation, add, level, contours);
  for(const double level : choice.levels)
  {
    const std::size_t number = contours.number;
    add_level(augmentation, add, level, contours);
    if(contours.number == number)
    {
      std::ostringstream message;
      message << "there is no contour at the level " << level;
      throw std::runtime_error(message.str());
    }
  }
  if(contours.number == 0)
    throw std::runtime_error(choice.point ? "there is no contour near the point"
                             : choice.t   ? "there is no contour: the graph has no arc"
                                          : "there is no contour at these levels");
  return contours;
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_CHOOSE_CONTOURS_H
