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
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/skeleton/internal/Loop_linking.h>
#include <CGAL/Reeb_graph/skeleton/internal/Skeleton_lines.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_tree.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_ways.h>

#include <algorithm>
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
  Inside_lines(const Sampled_graph& graph,
               const Graph_chains& chains,
               const Surface_tree& tree,
               Skeleton_lines& lines,
               bool is_self_intersecting,
               const Stage_progress& progress)
    : graph_(graph),
      chains_(chains),
      tree_(tree),
      ways_(tree, progress),
      lines_(lines),
      progress_(progress),
      loops_(lines.ends())
  {
    for(auto& [index, node] : lines.nodes())
      if(node.kind == Line_end::JUNCTION)
        bring_inside(node.point);
    for(Index chain = 0; chain != lines.lines().size(); ++chain)
    {
      progress.part(0, 0.5).report_step(chain, lines.lines().size());
      Skeleton_lines::Line& line = lines.lines()[chain];
      Skeleton_lines::Line inside;
      for(Line_point& point : line)
        if(bring_inside(point))
          inside.push_back(point);
      line = std::move(inside);
      refine(chain);
    }
    if(!loops_.cycles().empty())
      let_loops_wind(is_self_intersecting);
  }

  // Measures how far the lines are from the surface, and counts what is wrong with them, as they are now.
  void certify(const Stage_progress& progress)
  {
    for(auto& [index, node] : lines_.nodes())
      if(node.kind != Line_end::TIP)
        measure(node.point, node.kind == Line_end::JUNCTION);
    for(Index line = 0; line != lines_.lines().size(); ++line)
    {
      progress.report_step(line, lines_.lines().size());
      for(Line_point& point : lines_.lines()[line])
        measure(point, true);
      for(std::size_t i = 0; i <= lines_.lines()[line].size() && !lines_.has_gone(line); ++i)
        number_of_crossings_ += tree_.is_crossed(lines_.place(line, i), lines_.place(line, i + 1)) ? 1 : 0;
    }
  }

  std::size_t number_outside() const { return number_outside_; }
  std::size_t number_of_crossings() const { return number_of_crossings_; }
  // Loops generate this group for good, as lines that are moved later never pass the surface.
  const Loop_group& loop_group() const { return loop_group_; }

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
    if(tree_.is_well_inside(p.point))
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

  typedef std::vector<std::vector<Point>> Ways; // by chain
  typedef std::vector<Row> Rows;

  // Looks whether the loops are a basis of those of the solid. If not, lines that wind otherwise than the surface does along their
  // chains are led as that leads, which can wind as contours do, where there is less wrong with loops then.
  void let_loops_wind(bool is_self_intersecting)
  {
    const Loop_tracing tracing(graph_, chains_, tree_);
    for(const Index chain : loops_.closing_chains())
      curves_.add(tracing.contour(chain, 0.5));
    const Surface_curves contours = curves_;
    const Ways lines = polylines();
    Rows of_lines = count(lines);
    loop_group_ = loops_.group(of_lines);
    if(loop_group_.is_whole())
      return;
    add_curves_along_cycles(tracing);
    of_lines = count(lines);
    loop_group_ = loops_.group(of_lines);
    if(loop_group_.is_whole())
      return;
    Ways ways = lines;
    lead(tracing, loops_.chains_on_cycles(), std::vector<int>(ways.size(), 0), progress_.part(0.55, 0.8), ways);
    Rows of_ways = count(ways);
    if(!is_self_intersecting && !loops_.group(of_ways).is_whole())
      wind_ways(tracing, contours, ways, of_ways);
    const Loop_group group = loops_.group(of_ways);
    if(!(group < loop_group_))
      return;
    loop_group_ = group;
    keep_lines(lines, of_lines, ways, of_ways);
    for(Index chain = 0; chain != ways.size(); ++chain)
      if(of_ways[chain] != of_lines[chain])
      {
        lines_.lines()[chain].clear();
        add_way(ways[chain], place_of_end(chain, false), place_of_end(chain, true), lines_.lines()[chain]);
      }
  }

  // Together with the contours, these curves are a basis of all on the surface.
  void add_curves_along_cycles(const Loop_tracing& tracing)
  {
    for(Index chain = 0; chain != chains_.chains().size(); ++chain)
    {
      if(!loops_.is_on_cycle(chain))
        continue;
      curves_.polygons.push_back(tracing.curve(chain));
      curves_.curves_of.push_back(loops_.cycles_of(chain));
      for(auto& [curve, direction] : curves_.curves_of.back())
        curve += static_cast<Index>(loops_.cycles().size());
    }
  }

  // Lets ways wind around the contours of closing chains, too. A loop of the graph can be one around which contours wind, as in a
  // thick pipe that fronts pass around before they pass along: then it goes around one of them.
  void wind_ways(const Loop_tracing& tracing, const Surface_curves& contours, Ways& ways, Rows& rows) const
  {
    const std::vector<Index>& closing = loops_.closing_chains();
    const Rows of_cycles = loops_.linking_numbers(rows);
    const Winding_choice choice(of_cycles, numbers_of_turns(tracing, contours, of_cycles), progress_);
    std::vector<int> windings(ways.size(), 0);
    for(std::size_t cycle = 0; cycle != closing.size(); ++cycle)
      windings[closing[cycle]] = choice.windings()[cycle];
    std::vector<Index> winding;
    for(const Index chain : closing)
      if(windings[chain] != 0)
        winding.push_back(chain);
    Ways wound(ways.size());
    lead(tracing, winding, windings, progress_.part(0.8, 1), wound);
    const Rows of_wound = count(wound);
    for(const Index chain : winding)
      if(!wound[chain].empty())
      {
        ways[chain] = std::move(wound[chain]);
        rows[chain] = of_wound[chain];
      }
  }

  // Turns right beneath contours of closing chains, and what each adds: it winds around another contour as its own contour does, and
  // around a curve along a cycle as the way of that does around the contour, and once more where the curve passes the contour.
  Rows numbers_of_turns(const Loop_tracing& tracing, const Surface_curves& contours, const Rows& of_cycles) const
  {
    const std::vector<Index>& closing = loops_.closing_chains();
    double sum_of_lengths = 0;
    for(const auto& chain : chains_.chains())
      sum_of_lengths += chain.length;
    Ways turns(lines_.lines().size());
    for(const Index chain : closing)
      if(chains_.chains()[chain].length > 1e-9 * sum_of_lengths) // Else contours can be the same points.
      {
        turns[chain] = tracing.contour(chain, 0.25);
        turns[chain].push_back(turns[chain].front());
      }
    const Rows crossings = loops_.crossings(turns, contours, progress_);
    Rows result;
    for(std::size_t i = 0; i != closing.size(); ++i)
    {
      result.push_back(crossings[closing[i]]);
      if(turns[closing[i]].empty())
        continue;
      Row of_curves = {{closing.size() + i, tree_.is_inward() ? 1 : -1}};
      for(std::size_t k = 0; k != closing.size(); ++k)
        if(const auto found = of_cycles[k].find(i); found != of_cycles[k].end())
          add_multiple(of_curves, {{closing.size() + k, found->second}}, 1);
      add_multiple(result.back(), of_curves, 1);
    }
    return result;
  }

  // Gives as many chains as can be their lines back, as ways along the surface are long: those first whose ways are longest.
  void keep_lines(const Ways& lines, const Rows& of_lines, const Ways& ways, Rows& of_ways) const
  {
    std::vector<std::pair<double, Index>> order;
    for(Index chain = 0; chain != ways.size(); ++chain)
      if(of_ways[chain] != of_lines[chain])
        order.emplace_back(length_of(lines[chain]) - length_of(ways[chain]), chain);
    std::sort(order.begin(), order.end());
    std::vector<Kept_lines::Candidate> candidates;
    for(const auto& [any, chain] : order)
    {
      candidates.push_back({loops_.cycles_of(chain), of_lines[chain]});
      add_multiple(candidates.back().change, of_ways[chain], -1);
    }
    const Kept_lines kept(loops_.linking_numbers(of_ways), candidates, progress_);
    Rows rows = of_ways;
    for(std::size_t i = 0; i != order.size(); ++i)
      if(kept.is_kept(i))
        rows[order[i].second] = of_lines[order[i].second];
    if(!(loop_group_ < loops_.group(rows)))
      of_ways = std::move(rows);
  }

  static double length_of(const std::vector<Point>& way)
  {
    double sum = 0;
    for(std::size_t i = 1; i < way.size(); ++i)
      sum += distance(way[i - 1], way[i]);
    return sum;
  }

  // Sets the ways of some chains as the surface leads, where there are such.
  void lead(const Loop_tracing& tracing,
            const std::vector<Index>& chains,
            const std::vector<int>& windings,
            const Stage_progress& progress,
            Ways& ways) const
  {
    for(std::size_t i = 0; i != chains.size(); ++i)
    {
      const Index chain = chains[i];
      progress.report_step(i, chains.size());
      auto way = ways_.way_along(place_of_end(chain, false).surface_place(), place_of_end(chain, true).surface_place(),
                                 tracing.path(chain, windings[chain]));
      if(!way.empty())
        ways[chain] = std::move(way);
    }
  }

  Rows count(const Ways& ways) const { return loops_.crossings(ways, curves_, progress_.part(0.5, 1)); }

  Ways polylines() const
  {
    Ways result(lines_.lines().size());
    for(Index line = 0; line != result.size(); ++line)
      for(std::size_t i = 0; i != lines_.lines()[line].size() + 2; ++i)
        result[line].push_back(lines_.place(line, i).point);
    return result;
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
    add_way(ways_.way_beneath(a.surface_place(), b.surface_place()), a, b, line);
  }

  // Adds the points of a way between two places.
  static void add_way(const std::vector<Point>& way, const Place& a, const Place& b, std::vector<Line_point>& line)
  {
    const double length = length_of(way);
    double passed = 0;
    for(std::size_t i = 1; i + 1 < way.size(); ++i)
    {
      passed += distance(way[i - 1], way[i]);
      const double t = passed / length;
      line.push_back({way[i], (1 - t) * a.point.radius + t * b.point.radius, 0,
                      (1 - t) * a.point.place + t * b.point.place, a.point.on_surface, NULL_VECTOR});
    }
  }

  static constexpr int greatest_depth = 4;

  const Sampled_graph& graph_;
  const Graph_chains& chains_;
  const Surface_tree& tree_;
  const Surface_ways ways_;
  Skeleton_lines& lines_;
  const Stage_progress progress_;
  const Loop_linking loops_;
  Surface_curves curves_; // around which loops are to wind
  Loop_group loop_group_{{}};
  std::size_t number_outside_ = 0, number_of_crossings_ = 0;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_INSIDE_LINES_H
