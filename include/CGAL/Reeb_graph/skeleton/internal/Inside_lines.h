// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_INSIDE_LINES_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_INSIDE_LINES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/skeleton/internal/Skeleton_lines.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_tree.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// Brings the lines of a skeleton inside of the surface: points that are outside move, and edges that cross the surface
// get further points. What is left is counted.
class Inside_lines
{
public:
  Inside_lines(const Sampled_graph& graph, const Graph_chains& chains, const Surface_tree& tree, Skeleton_lines& lines)
    : graph_(graph),
      chains_(chains),
      tree_(tree),
      lines_(lines)
  {
    for(auto& [index, node] : lines.nodes())
      if(node.kind == Line_end::JUNCTION)
        bring_inside(node.point);
    for(Index chain = 0; chain != lines.lines().size(); ++chain)
    {
      for(Line_point& point : lines.lines()[chain])
        bring_inside(point);
      refine(chain);
    }
    for(auto& [index, node] : lines.nodes())
      if(node.kind != Line_end::TIP)
        measure(node.point, node.kind == Line_end::JUNCTION);
    for(Index chain = 0; chain != lines.lines().size(); ++chain)
    {
      Skeleton_lines::Line& line = lines.lines()[chain];
      for(Line_point& point : line)
        measure(point, true);
      for(const bool is_last : {false, true})
        if(auto& end = lines.nodes().at(chains.chains()[chain].ends[is_last ? 1 : 0]);
           end.kind == Line_end::TIP && !line.empty())
          end.point.radius = (is_last ? line.back() : line.front()).radius;
    }
  }

  std::size_t number_outside() const { return number_outside_; }
  std::size_t number_of_crossings() const { return number_of_crossings_; }

private:
  struct Place
  {
    Line_point point;
    std::optional<Mesh::Vertex_index> vertex; // of the filled surface, at an end

    Surface_place surface_place() const { return {point.point, vertex}; }
  };

  void bring_inside(Line_point& p) const
  {
    if(tree_.is_well_inside(p.point, p.on_surface))
      return;
    if(const auto inside = tree_.pulled_inside(p.point, p.on_surface))
      p.point = *inside;
  }

  void measure(Line_point& p, bool is_counted)
  {
    p.inscribed_radius = tree_.distance_from(p.point, p.on_surface);
    if(is_counted && !tree_.is_inside(p.point))
    {
      p.inscribed_radius = 0;
      ++number_outside_;
    }
    p.radius = (std::max)(p.radius, p.inscribed_radius); // A contour that folds has less area than a flat one.
  }

  Place place_of_end(Index chain, bool is_last) const
  {
    const Graph_chains::Chain& whole = chains_.chains()[chain];
    const Index node = whole.ends[is_last ? 1 : 0];
    const Skeleton_lines::Node& end = lines_.nodes().at(node);
    Place place = {end.point, std::nullopt};
    place.point.place = is_last ? whole.length : 0;
    if(end.kind != Line_end::JUNCTION)
      place.vertex = graph_.vertex(node);
    return place;
  }

  void refine(Index chain)
  {
    std::vector<Line_point>& line = lines_.lines()[chain];
    std::vector<Line_point> result;
    Place last = place_of_end(chain, false);
    for(std::size_t i = 0; i <= line.size(); ++i)
    {
      const Place next = i == line.size() ? place_of_end(chain, true) : Place{line[i], std::nullopt};
      connect(chain, last, next, 0, result);
      if(i != line.size())
        result.push_back(next.point);
      last = next;
    }
    line = std::move(result);
  }

  // Adds what is needed between two points: centers of further contours, or a way beneath the surface.
  void connect(Index chain, const Place& a, const Place& b, int depth, std::vector<Line_point>& line)
  {
    if(!tree_.is_crossed(a.surface_place(), b.surface_place()))
      return;
    if(depth != greatest_depth)
    {
      Place middle = {lines_.make_point(chain, (a.point.place + b.point.place) / 2), std::nullopt};
      bring_inside(middle.point);
      if(tree_.is_inside(middle.point.point))
      {
        connect(chain, a, middle, depth + 1, line);
        line.push_back(middle.point);
        connect(chain, middle, b, depth + 1, line);
        return;
      }
    }
    const std::vector<Point> way = tree_.way_beneath(a.surface_place(), b.surface_place());
    if(way.empty())
      ++number_of_crossings_;
    for(std::size_t i = 1; i + 1 < way.size(); ++i)
    {
      const double t = static_cast<double>(i) / static_cast<double>(way.size() - 1);
      line.push_back({way[i], (1 - t) * a.point.radius + t * b.point.radius, 0,
                      (1 - t) * a.point.place + t * b.point.place, a.point.on_surface, NULL_VECTOR});
    }
  }

  static constexpr int greatest_depth = 4;

  const Sampled_graph& graph_;
  const Graph_chains& chains_;
  const Surface_tree& tree_;
  Skeleton_lines& lines_;
  std::size_t number_outside_ = 0, number_of_crossings_ = 0;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_INSIDE_LINES_H
