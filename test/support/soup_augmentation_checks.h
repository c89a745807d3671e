// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_SOUP_AUGMENTATION_CHECKS_H
#define CGAL_REEB_GRAPH_TEST_SOUP_AUGMENTATION_CHECKS_H

#include "complex_oracle.h"
#include "random_complexes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

// What contours in complexes have to be. The checks return the first fault that they find, the empty string if none.
namespace soup_augmentation_checks {
using complex_oracle::Edge;
using complex_oracle::none;
using complex_oracle::Oracle;
using complex_oracle::Simplex;

// the numbers of the crossed edges, ascending
template <class Contour>
std::vector<std::size_t> edges_of(const Oracle& oracle, const Contour& contour)
{
  std::vector<std::size_t> result;
  for(const auto& edge : contour.edges)
    result.push_back(oracle.edge(edge.first, edge.second));
  std::sort(result.begin(), result.end());
  return result;
}

// Each edge leads upwards, and holds the value where its fraction says.
template <class Augmentation, class Contour, class Scalar>
std::string fault_of_points(const Oracle& oracle,
                            const Augmentation& augmentation,
                            const Contour& contour,
                            const std::vector<Scalar>& values)
{
  for(std::size_t i = 0; i < contour.edges.size(); ++i)
  {
    const auto& edge = contour.edges[i];
    const double lower = values[edge.first], upper = values[edge.second], t = augmentation.fraction(contour, i);
    if(oracle.rank[edge.first] >= oracle.rank[edge.second])
      return "an edge leads downwards";
    if(!(t >= 0 && t <= 1) || std::abs(lower + t * (upper - lower) - contour.value) > 1e-12)
      return "a point is at another value";
  }
  return "";
}

// The different simplices of a size, each sorted.
template <class Cells>
std::set<Simplex> different(const Cells& cells)
{
  std::set<Simplex> result;
  for(const auto& cell : cells)
  {
    Simplex simplex(cell.begin(), cell.end());
    std::sort(simplex.begin(), simplex.end());
    result.insert(simplex);
  }
  return result;
}

// The pairs of points whose edges are in one triangle, with the number of triangles: each is there once.
template <class Contour>
std::set<Edge> pairs_in_triangles(const Contour& contour, const std::set<Simplex>& triangles)
{
  std::map<Edge, std::size_t> point_of_edge;
  for(std::size_t i = 0; i < contour.edges.size(); ++i)
    point_of_edge[complex_oracle::make_edge(contour.edges[i].first, contour.edges[i].second)] = i;
  std::set<Edge> result;
  for(const Simplex& t : triangles)
  {
    std::vector<std::size_t> points;
    for(const Edge& edge : {Edge(t[0], t[1]), Edge(t[0], t[2]), Edge(t[1], t[2])})
    {
      const auto found = point_of_edge.find(edge);
      if(found != point_of_edge.end())
        points.push_back(found->second);
    }
    if(points.size() == 2)
      result.insert(complex_oracle::make_edge(points[0], points[1]));
  }
  return result;
}

// The polylines hold each line of a crossed triangle once, and end where not exactly two lines meet.
template <class Contour>
std::string fault_of_polylines(const Contour& contour, const std::set<Simplex>& triangles)
{
  const std::set<Edge> expected = pairs_in_triangles(contour, triangles);
  std::vector<std::size_t> degrees(contour.edges.size(), 0);
  for(const Edge& line : expected)
  {
    ++degrees[line.first];
    ++degrees[line.second];
  }
  std::vector<std::size_t> branch_points;
  for(std::size_t i = 0; i < degrees.size(); ++i)
    if(degrees[i] > 2)
      branch_points.push_back(i);
  if(contour.branch_points != branch_points)
    return "other branch points";
  const bool is_closed = std::all_of(degrees.begin(), degrees.end(), [](std::size_t degree) { return degree == 2; });
  if(contour.is_closed() != is_closed)
    return "the contour is closed, or not";
  std::set<Edge> found;
  for(const auto& polyline : contour.polylines)
  {
    if(polyline.size() < 2 && contour.edges.size() > 1)
      return "a polyline of no line";
    for(std::size_t i = 1; i < polyline.size(); ++i)
      if(!found.insert(complex_oracle::make_edge(polyline[i - 1], polyline[i])).second)
        return "a line is there twice";
    for(std::size_t i = 1; i + 1 < polyline.size(); ++i)
      if(degrees[polyline[i]] != 2)
        return "a polyline passes a point at which it should end";
    for(const std::size_t end : {polyline.front(), polyline.back()})
      if(degrees[end] == 2 && !contour.is_closed())
        return "a polyline ends inside of a line";
  }
  return found == expected ? "" : "other lines";
}

// The triangles fill the crossed tetrahedra, at each facet as many as there are tetrahedra.
template <class Contour>
std::string fault_of_patch(const Contour& contour, const std::set<Simplex>& tetrahedra)
{
  std::map<Edge, std::size_t> point_of_edge;
  for(std::size_t i = 0; i < contour.edges.size(); ++i)
    point_of_edge[complex_oracle::make_edge(contour.edges[i].first, contour.edges[i].second)] = i;
  // what the section of each tetrahedron has as vertices, with the number of its triangles
  std::map<std::set<std::size_t>, std::size_t> expected;
  std::map<Edge, std::size_t> expected_sides; // in facets
  for(const Simplex& t : tetrahedra)
  {
    std::set<std::size_t> section;
    for(std::size_t i = 0; i < 4; ++i)
      for(std::size_t j = 0; j < i; ++j)
      {
        const auto found = point_of_edge.find(Edge(t[j], t[i]));
        if(found != point_of_edge.end())
          section.insert(found->second);
      }
    if(section.empty())
      continue;
    expected[section] = section.size() - 2;
    std::set<Simplex> facets;
    for(std::size_t i = 0; i < 4; ++i)
    {
      Simplex facet = t;
      facet.erase(facet.begin() + i);
      facets.insert(facet);
    }
    for(const Edge& side : pairs_in_triangles(contour, facets))
      ++expected_sides[side];
  }
  std::map<Edge, std::size_t> sides;
  std::size_t number_of_triangles = 0;
  for(const auto& t : contour.triangles)
    for(std::size_t i = 0; i < 3; ++i)
      ++sides[complex_oracle::make_edge(t[i], t[(i + 1) % 3])];
  const bool is_closed =
    !sides.empty() && std::all_of(sides.begin(), sides.end(), [](const auto& side) { return side.second > 1; });
  if(contour.is_closed() != is_closed)
    return "the contour has a border, or not";
  for(const auto& section : expected)
  {
    number_of_triangles += section.second;
    std::size_t found = 0;
    for(const auto& t : contour.triangles)
      found += section.first.count(t[0]) * section.first.count(t[1]) * section.first.count(t[2]);
    if(found != section.second)
      return "a tetrahedron has another number of triangles";
  }
  if(contour.triangles.size() != number_of_triangles)
    return "another number of triangles";
  for(const auto& side : sides)
  {
    const auto in_facet = expected_sides.find(side.first);
    // the diagonal of a quadrangle has the two triangles of its tetrahedron
    if(side.second != (in_facet == expected_sides.end() ? 2 : in_facet->second))
      return "a side has another number of triangles";
  }
  for(const auto& side : expected_sides)
    if(sides.count(side.first) == 0)
      return "a facet without a side";
  return "";
}

// Whether the triangles are a 2-manifold with border that is oriented: at most two at each side, which pass it in
// opposite directions, and one fan at each point.
template <class Contour>
bool is_oriented_manifold(const Contour& contour)
{
  std::set<Edge> directed_sides;
  std::vector<std::map<std::size_t, std::size_t>> next(contour.edges.size()); // around each point
  for(const auto& t : contour.triangles)
    for(std::size_t i = 0; i < 3; ++i)
    {
      if(!directed_sides.insert({t[i], t[(i + 1) % 3]}).second)
        return false;
      if(!next[t[i]].emplace(t[(i + 1) % 3], t[(i + 2) % 3]).second)
        return false;
    }
  for(const auto& fan : next)
  {
    std::set<std::size_t> starts;
    for(const auto& step : fan)
      starts.insert(step.first);
    for(const auto& step : fan)
      starts.erase(step.second);
    if(starts.size() > 1 || fan.empty())
      return false;
    const std::size_t start = starts.empty() ? fan.begin()->first : *starts.begin();
    std::size_t steps = 0;
    for(auto step = fan.find(start); step != fan.end() && steps < fan.size(); step = fan.find(step->second))
    {
      ++steps;
      if(step->second == start)
        break;
    }
    if(steps != fan.size())
      return false;
  }
  return true;
}

} // namespace soup_augmentation_checks

#endif // CGAL_REEB_GRAPH_TEST_SOUP_AUGMENTATION_CHECKS_H
