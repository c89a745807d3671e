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
#include <CGAL/Reeb_graph/skeleton/internal/Loop_linking.h>
#include <CGAL/Reeb_graph/skeleton/internal/Skeleton_lines.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_tree.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// Brings the lines of a skeleton inside of the surface: points that are outside move, and edges that cross the surface
// get further points. What is left is counted.
class Inside_lines
{
public:
  Inside_lines(const Sampled_graph& graph,
               const Graph_chains& chains,
               const Surface_tree& tree,
               Skeleton_lines& lines,
               double sampling_ratio,
               bool is_self_intersecting)
    : graph_(graph),
      chains_(chains),
      tree_(tree),
      lines_(lines),
      sampling_ratio_(sampling_ratio),
      loops_(lines.ends())
  {
    for(auto& [index, node] : lines.nodes())
      if(node.kind == Line_end::JUNCTION)
        bring_inside(node.point);
    for(Index chain = 0; chain != lines.lines().size(); ++chain)
    {
      Skeleton_lines::Line& line = lines.lines()[chain];
      Skeleton_lines::Line inside;
      for(Line_point& point : line)
        if(bring_inside(point))
          inside.push_back(point);
      line = std::move(inside);
      refine(chain);
    }
    let_loops_wind(is_self_intersecting);
  }

  // Measures how far the lines are from the surface, and counts what is wrong with them, as they are now.
  void certify()
  {
    for(auto& [index, node] : lines_.nodes())
      if(node.kind != Line_end::TIP)
        measure(node.point, node.kind == Line_end::JUNCTION);
    for(Skeleton_lines::Line& line : lines_.lines())
      for(Line_point& point : line)
        measure(point, true);
    for(Index line = 0; line != lines_.lines().size(); ++line)
      for(std::size_t i = 0; i <= lines_.lines()[line].size() && !lines_.has_gone(line); ++i)
        number_of_crossings_ += tree_.is_crossed(lines_.place(line, i), lines_.place(line, i + 1)) ? 1 : 0;
    if(loops_.cycles().empty())
      return;
    std::vector<std::array<Index, 2>> ends;
    std::vector<std::vector<Point>> lines;
    for(Index line = 0; line != lines_.lines().size(); ++line)
      if(!lines_.has_gone(line))
      {
        ends.push_back(lines_.ends()[line]);
        lines.push_back(polyline(line));
      }
    const Loop_linking loops(ends);
    number_of_contractible_loops_ = Loop_linking::number_of_dependent(loops.linking_numbers(lines, polygons_));
  }

  std::size_t number_outside() const { return number_outside_; }
  std::size_t number_of_crossings() const { return number_of_crossings_; }
  // The loops that can be pulled to a point in the solid, or depend on others there.
  std::size_t number_of_contractible_loops() const { return number_of_contractible_loops_; }

private:
  struct Place
  {
    Line_point point;
    std::optional<Mesh::Vertex_index> vertex; // of the filled surface, at an end

    Surface_place surface_place() const { return {point.point, vertex}; }
  };

  // Where triangles intersect, there can be no such place.
  bool bring_inside(Line_point& p) const
  {
    if(tree_.is_well_inside(p.point, p.on_surface))
      return true;
    if(const auto inside = tree_.pulled_inside(p.point, p.on_surface))
      p.point = *inside;
    return tree_.is_inside(p.point);
  }

  void measure(Line_point& p, bool is_counted)
  {
    p.inscribed_radius = tree_.distance_from_wall(p.point, p.on_surface);
    if(is_counted && !tree_.is_inside(p.point))
    {
      p.inscribed_radius = 0;
      ++number_outside_;
    }
    p.radius = (std::max)(p.radius, p.inscribed_radius); // A contour that folds has less area than a flat one.
  }

  Place place_of_end(Index chain, bool is_last) const
  {
    const Skeleton_lines::Node& node = lines_.nodes().at(lines_.ends()[chain][is_last ? 1 : 0]);
    Place place = {node.point, node.vertex};
    place.point.place = is_last ? chains_.chains()[chain].length : 0;
    return place;
  }

  // Looks whether loops wind around the holes of the surface, and leads those that do not along it, nearer to it where that is
  // needed. Chains on loops that meet those are led so, too, as all ends are moved. A loop of the graph can be one around
  // which contours wind, as in a thick pipe that fronts pass around before they pass along: then it goes around one of them.
  void let_loops_wind(bool is_self_intersecting)
  {
    if(loops_.cycles().empty())
      return;
    const Loop_tracing tracing(graph_, chains_, tree_);
    for(const Index chain : loops_.closing_chains())
      polygons_.push_back(chains_.contour_points(chain, chains_.chains()[chain].length / 2));
    const auto rows = loops_.linking_numbers(polylines(), polygons_);
    if(loops_.number_of_dependent(rows) == 0)
      return;
    std::vector<bool> is_bad = loops_.chains_of_bad_cycles(rows), is_wound(is_bad.size(), false);
    for(const Loop_linking::Cycle& cycle : loops_.cycles())
      polygons_.push_back(tracing.curve(cycle));
    const auto count = [&](double share) {
      trace_all(tracing, is_bad, is_wound, share);
      return loops_.number_of_dependent(loops_.linking_numbers(polylines(), polygons_));
    };
    const double least_share = 1e-6;
    const auto nodes_before = lines_.nodes();
    const auto lines_before = lines_.lines();
    if(count(1) == 0)
      return;
    if(is_self_intersecting)
    {
      lines_.nodes() = nodes_before;
      lines_.lines() = lines_before;
      return;
    }
    std::size_t least = count(least_share);
    // All lines are traced in each trial: there are few where there are many handles.
    std::size_t trials = 200 / loops_.cycles().size();
    for(Index chain = 0; chain != is_bad.size() && least != 0 && trials != 0; ++chain)
    {
      if(!loops_.is_on_cycle(chain))
        continue;
      --trials;
      is_bad = loops_.chains_on_cycles();
      is_wound[chain] = true;
      const std::size_t number = count(least_share);
      is_wound[chain] = number < least;
      least = (std::min)(number, least);
    }
    double share = 1;
    while(count(share) > least && share > least_share)
      share /= 100;
  }

  void trace_all(const Loop_tracing& tracing,
                 const std::vector<bool>& is_bad,
                 const std::vector<bool>& is_wound,
                 double share)
  {
    for(Index chain = 0; chain != is_bad.size(); ++chain)
      if(is_bad[chain])
        for(const Index end : chains_.chains()[chain].ends)
        {
          Line_point& point = lines_.nodes().at(end).point;
          point.on_surface = graph_.point(end);
          point.point = tree_.place_beneath(tracing.face_of(end), share);
        }
    for(Index chain = 0; chain != is_bad.size(); ++chain)
      if(is_bad[chain])
        trace(chain, tracing.path(chain, is_wound[chain]), share);
      else
        refine(chain);
  }

  std::vector<std::vector<Point>> polylines() const
  {
    std::vector<std::vector<Point>> result;
    for(Index chain = 0; chain != chains_.chains().size(); ++chain)
      result.push_back(polyline(chain));
    return result;
  }

  std::vector<Point> polyline(Index line) const
  {
    std::vector<Point> result;
    for(std::size_t i = 0; i != lines_.lines()[line].size() + 2; ++i)
      result.push_back(lines_.place(line, i).point);
    return result;
  }

  void trace(Index chain, const Loop_tracing::Path& path, double share)
  {
    const std::vector<Point> way = tree_.way_along(path.begin, path.steps, share, sampling_ratio_);
    if(way.empty())
      return refine(chain);
    std::vector<double> lengths = {0};
    for(std::size_t i = 1; i != way.size(); ++i)
      lengths.push_back(lengths.back() + distance(way[i - 1], way[i]));
    Skeleton_lines::Line& line = lines_.lines()[chain];
    line.clear();
    for(std::size_t i = 1; i + 1 < way.size(); ++i)
    {
      Line_point point = lines_.make_point(chain, chains_.chains()[chain].length * lengths[i] / lengths.back());
      point.point = way[i];
      line.push_back(point);
    }
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
  const double sampling_ratio_;
  const Loop_linking loops_;
  std::vector<Loop_linking::Line> polygons_; // around which loops are to wind
  std::size_t number_outside_ = 0, number_of_crossings_ = 0, number_of_contractible_loops_ = 0;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_INSIDE_LINES_H
