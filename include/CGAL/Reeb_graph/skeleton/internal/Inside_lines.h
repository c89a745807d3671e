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
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/skeleton/internal/Loop_linking.h>
#include <CGAL/Reeb_graph/skeleton/internal/Skeleton_lines.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_tree.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
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
               bool is_self_intersecting,
               const Stage_progress& progress)
    : graph_(graph),
      chains_(chains),
      tree_(tree),
      lines_(lines),
      sampling_ratio_(sampling_ratio),
      progress_(progress),
      loops_(lines.ends())
  {
    for(auto& [index, node] : lines.nodes())
      if(node.kind == Line_end::JUNCTION)
        bring_inside(node.point);
    for(Index chain = 0; chain != lines.lines().size(); ++chain)
    {
      progress_.part(0, 0.2).report_step(chain, lines.lines().size());
      Skeleton_lines::Line& line = lines.lines()[chain];
      Skeleton_lines::Line inside;
      for(Line_point& point : line)
        if(bring_inside(point))
          inside.push_back(point);
      line = std::move(inside);
      refine(chain);
    }
    let_loops_wind(is_self_intersecting);
    places_along_.clear();
    for(Index chain = 0; chain != lines.lines().size(); ++chain)
    {
      progress_.part(0.9, 1).report_step(chain, lines.lines().size());
      thin(chain);
    }
  }

  // Measures how far the lines are from the surface, and counts what is wrong with them, as they are now.
  void certify(const Stage_progress& progress)
  {
    for(auto& [index, node] : lines_.nodes())
      if(node.kind != Line_end::TIP)
        measure(node.point, node.kind == Line_end::JUNCTION);
    for(Index line = 0; line != lines_.lines().size(); ++line)
    {
      progress.part(0, 0.8).report_step(line, lines_.lines().size());
      auto& points = lines_.lines()[line];
      for(Line_point& point : points)
        measure(point, true);
      for(const bool is_last : {false, true})
        if(auto& end = lines_.nodes().at(lines_.ends()[line][is_last ? 1 : 0]);
           end.kind == Line_end::TIP && !points.empty())
          end.point.radius = (is_last ? points.back() : points.front()).radius;
    }
    for(Index line = 0; line != lines_.lines().size(); ++line)
      for(std::size_t i = 0; i <= lines_.lines()[line].size() && !lines_.has_gone(line); ++i)
        number_of_crossings_ += tree_.is_crossed(surface_place(line, i), surface_place(line, i + 1)) ? 1 : 0;
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
    loop_group_ = Loop_group(loops.linking_numbers(loops.crossings(lines, curves_, progress.part(0.8, 1))));
  }

  std::size_t number_outside() const { return number_outside_; }
  std::size_t number_of_crossings() const { return number_of_crossings_; }
  const Loop_group& certified_loops() const { return loop_group_; }

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

  // A point of a line, from 0 for the node where it begins.
  Surface_place surface_place(Index line, std::size_t i) const
  {
    const auto& points = lines_.lines()[line];
    if(i != 0 && i <= points.size())
      return {points[i - 1].point, std::nullopt};
    const Index node = lines_.ends()[line][i == 0 ? 0 : 1];
    const Skeleton_lines::Node& end = lines_.nodes().at(node);
    if(end.kind == Line_end::JUNCTION)
      return {end.point.point, std::nullopt};
    return {end.point.point, graph_.vertex(node)};
  }

  Place place_of_end(Index chain, bool is_last) const
  {
    const Index node = lines_.ends()[chain][is_last ? 1 : 0];
    Place place = {lines_.nodes().at(node).point,
                   surface_place(chain, is_last ? lines_.lines()[chain].size() + 1 : 0).vertex};
    place.point.place = is_last ? chains_.chains()[chain].length : 0;
    return place;
  }

  // Looks whether the loops are a basis of those of the solid, and leads all of them along the surface if not, nearer to it where
  // that is needed.
  void let_loops_wind(bool is_self_intersecting)
  {
    if(loops_.cycles().empty())
      return;
    for(const Index chain : loops_.closing_chains())
      curves_.add(chains_.contour_points(chain, chains_.chains()[chain].length / 2));
    const Ways lines(chains_.chains().size());
    if(loop_group(lines).is_whole())
      return;
    const Loop_tracing tracing(graph_, chains_, tree_);
    add_curves_along_cycles(tracing);
    const Loop_group before = loop_group(lines);
    if(before.is_whole())
      return;
    std::vector<int> windings(lines.size(), 0);
    Ways ways = ways_along(tracing, windings, 1);
    const Loop_group traced = loop_group(ways);
    if(is_self_intersecting)
    {
      if(traced < before)
        lead_along(ways);
      return;
    }
    if(!traced.is_whole())
    {
      windings = find_windings(tracing);
      const Loop_group least = loop_group(ways_along(tracing, windings, least_share));
      double share = 1;
      for(ways = ways_along(tracing, windings, share); share > least_share && least < loop_group(ways);)
        ways = ways_along(tracing, windings, share /= 100);
    }
    lead_along(ways);
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

  // How often chains have to wind around contours. A loop of the graph can be one around which contours wind, as in a thick pipe
  // that fronts pass around before they pass along. Where loops depend on others, modulo a prime number or at all, each of them
  // winds once around the contour of its closing chain, and then they do not: curves on the surface that bound inside cross
  // each other as often to one side as to the other, so that, as a matrix, dependences are the same by rows and by columns.
  // By another prime number, they can be dependent then: windings are taken only where there is less of that.
  std::vector<int> find_windings(const Loop_tracing& tracing)
  {
    std::vector<int> windings(chains_.chains().size(), 1);
    const std::vector<Row> wound = crossings(ways_along(tracing, windings, least_share));
    windings.assign(windings.size(), 0);
    const std::vector<Row> unwound = crossings(ways_along(tracing, windings, least_share));
    std::vector<Row> rows = unwound;
    Loop_group least(loops_.linking_numbers(rows));
    for(int direction = 1; direction != 0 && !least.is_whole();)
    {
      std::vector<Row> trial = rows;
      const auto dependent = Generated_group().add_all(loops_.linking_numbers(rows), least.modulus());
      for(const std::size_t cycle : dependent)
      {
        const Index chain = loops_.closing_chains()[cycle];
        add_multiple(trial[chain], wound[chain], direction);
        add_multiple(trial[chain], unwound[chain], -direction);
      }
      const Loop_group group(loops_.linking_numbers(trial));
      if(!(group < least))
      {
        direction = direction == 1 ? -1 : 0;
        continue;
      }
      for(const std::size_t cycle : dependent)
        windings[loops_.closing_chains()[cycle]] += direction;
      rows = std::move(trial);
      least = group;
      direction = 1;
    }
    return windings;
  }

  typedef std::vector<std::vector<Point>> Ways; // by chain

  // For all chains on loops, in a share of the depth that they could have. What is found beneath paths is kept for other depths.
  Ways ways_along(const Loop_tracing& tracing, const std::vector<int>& windings, double share)
  {
    Ways ways(windings.size());
    for(Index chain = 0; chain != windings.size(); ++chain)
    {
      progress_.part(0.2, 0.9).report_step(chain, windings.size());
      if(!loops_.is_on_cycle(chain))
        continue;
      const auto [places, is_new] = places_along_.try_emplace({chain, windings[chain]});
      if(is_new)
      {
        const Loop_tracing::Path path = tracing.path(chain, windings[chain]);
        places->second = tree_.places_along(path.begin, path.steps);
      }
      ways[chain] = tree_.way_along(places->second, share, sampling_ratio_);
    }
    return ways;
  }

  void lead_along(const Ways& ways)
  {
    for(Index chain = 0; chain != ways.size(); ++chain)
      if(!ways[chain].empty())
        for(const int k : {0, 1})
        {
          const Index end = chains_.chains()[chain].ends[k];
          Line_point& point = lines_.nodes().at(end).point;
          point.on_surface = graph_.point(end);
          point.point = k == 0 ? ways[chain].front() : ways[chain].back();
        }
    for(Index chain = 0; chain != ways.size(); ++chain)
      if(ways[chain].empty())
        refine(chain);
      else
        set_line(chain, ways[chain]);
  }

  // Where there is no way, it is the line.
  std::vector<Row> crossings(Ways ways) const
  {
    for(Index chain = 0; chain != ways.size(); ++chain)
      if(ways[chain].empty() && loops_.is_on_cycle(chain))
        ways[chain] = polyline(chain);
    return loops_.crossings(ways, curves_, progress_.part(0.2, 0.9));
  }
  Loop_group loop_group(const Ways& ways) const { return Loop_group(loops_.linking_numbers(crossings(ways))); }

  std::vector<Point> polyline(Index line) const
  {
    std::vector<Point> result;
    for(std::size_t i = 0; i != lines_.lines()[line].size() + 2; ++i)
      result.push_back(surface_place(line, i).point);
    return result;
  }

  void set_line(Index chain, const std::vector<Point>& way)
  {
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

  // Leaves points out that are much nearer to one neighbor than to the other one, or than the radius asks for, where nothing is
  // in the way, and all that are where a neighbor is.
  void thin(Index chain)
  {
    std::vector<Place> kept = {place_of_end(chain, false)};
    std::vector<Line_point>& line = lines_.lines()[chain];
    for(const Line_point& point : line)
      add_thinned(chain, {point, std::nullopt}, kept);
    add_thinned(chain, place_of_end(chain, true), kept);
    line.clear();
    for(std::size_t i = 1; i + 1 < kept.size(); ++i)
      line.push_back(kept[i].point);
  }

  void add_thinned(Index chain, const Place& next, std::vector<Place>& kept) const
  {
    while(kept.size() > 1)
    {
      const Place &before = kept[kept.size() - 2], &last = kept.back();
      const double from = distance(before.point.point, last.point.point),
                   to = distance(last.point.point, next.point.point);
      const bool is_same = from == 0 || to == 0;
      // a thin branch begins far from the center of its trunk
      const double far = (std::min)((std::max)(from, to), 4 * lines_.step(last.point.radius));
      if(!is_same && (std::min)(from, to) >= 0.1 * far)
        break;
      if(!is_same && is_in_the_way(chain, before, last, next))
        break;
      kept.pop_back();
    }
    kept.push_back(next);
  }

  bool is_in_the_way(Index chain, const Place& a, const Place& b, const Place& c) const
  {
    return tree_.is_crossed(a.surface_place(), c.surface_place())
        || (loops_.is_on_cycle(chain) && tree_.is_met_by_triangle(a.point.point, b.point.point, c.point.point));
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
  static constexpr double least_share = 1e-6; // of the depth, at which lines are right beneath the surface

  const Sampled_graph& graph_;
  const Graph_chains& chains_;
  const Surface_tree& tree_;
  Skeleton_lines& lines_;
  const double sampling_ratio_;
  const Stage_progress progress_;
  const Loop_linking loops_;
  Surface_curves curves_; // around which loops are to wind
  std::map<std::pair<Index, int>, std::vector<Surface_tree::Sunk_place>> places_along_; // by chain and windings
  Loop_group loop_group_{{}};
  std::size_t number_outside_ = 0, number_of_crossings_ = 0;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_INSIDE_LINES_H
