// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_CHOOSE_CONTOURS_H
#define CGAL_REEB_GRAPH_SRC_CHOOSE_CONTOURS_H

#include "computation/contours.h"
#include "computation/nearest_place.h"

#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/boost/graph/iterator.h>
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
#include <vector>

// The contours of a choice, for surfaces and for complexes. convert(contour) makes a contour of the augmentation one of
// numbers and points.
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

inline double distance_to(const Point& point, const Contour& contour)
{
  double least = std::numeric_limits<double>::infinity();
  const auto visit = [&](const std::array<Point, 3>& triangle) {
    least = (std::min)(least, CGAL::Reeb_graph::internal::distance_between(point, nearest_point(point, triangle)));
  };
  const std::vector<Point>& points = contour.points;
  for(const std::vector<std::size_t>& line : contour.polylines)
    for(std::size_t i = 0; i < line.size(); ++i)
      visit({points[line[i == 0 ? 0 : i - 1]], points[line[i]], points[line[i]]});
  for(const auto& [a, b, c] : contour.triangles)
    visit({points[a], points[b], points[c]});
  return least;
}

template <class AnyAugmentation, class Convert>
std::vector<Contour> nearest_contour(const AnyAugmentation& augmentation,
                                     const Convert& convert,
                                     const Nearest_place& place)
{
  std::vector<Contour> nearest;
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
      Contour candidate = convert(contour);
      const double distance = distance_to(place.place(), candidate);
      if(!(distance < least))
        continue;
      least = distance;
      nearest = {std::move(candidate)};
    }
  return nearest;
}

inline std::string no_contour_at(double level)
{
  std::ostringstream message;
  message << "there is no contour at the level " << level;
  return message.str();
}

template <class AnyAugmentation, class Convert>
void add_level(const AnyAugmentation& augmentation,
               const Convert& convert,
               double level,
               std::vector<Contour>& contours)
{
  for(const auto& contour : augmentation.template contours_at_value<CGAL::Parallel_if_available_tag>(level))
    contours.push_back(convert(contour));
}

// `find_place` finds the place on the mesh that is nearest to a point.
template <class AnyAugmentation, class Convert, class FindPlace>
std::vector<Contour> choose_contours(const AnyAugmentation& augmentation,
                                     const Convert& convert,
                                     Scalar_map scalar_map,
                                     const Contour_choice& choice,
                                     const FindPlace& find_place)
{
  const auto& graph = augmentation.graph();
  std::vector<Contour> contours;
  if(choice.point)
    contours = nearest_contour(augmentation, convert, find_place(*choice.point));
  else if(choice.arc)
    contours.push_back(convert(augmentation.contour(arc_of_number(graph, *choice.arc), *choice.t)));
  else if(choice.t)
    for(const auto arc : CGAL::make_range(edges(graph)))
      contours.push_back(convert(augmentation.contour(arc, *choice.t)));
  else if(choice.number_of_levels)
    for(const double level : equal_steps(*choice.number_of_levels, scalar_map))
      add_level(augmentation, convert, level, contours);
  for(const double level : choice.levels)
    add_level(augmentation, convert, level, contours);
  if(contours.empty() && !choice.may_be_none)
    throw std::runtime_error(choice.point                ? "there is no contour near the point"
                             : choice.t                  ? "there is no contour: the graph has no arc"
                             : choice.levels.size() == 1 ? no_contour_at(choice.levels.front())
                                                         : "there is no contour at these levels");
  return contours;
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_CHOOSE_CONTOURS_H
