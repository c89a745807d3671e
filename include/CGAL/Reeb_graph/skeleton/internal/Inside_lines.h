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
#include <CGAL/Reeb_graph/skeleton/internal/Detour_choice.h>
#include <CGAL/Reeb_graph/skeleton/internal/Graph_chains.h>
#include <CGAL/Reeb_graph/skeleton/internal/Loop_group.h>
#include <CGAL/Reeb_graph/skeleton/internal/Loop_linking.h>
#include <CGAL/Reeb_graph/skeleton/internal/Sampled_graph.h>
#include <CGAL/Reeb_graph/skeleton/internal/Skeleton_lines.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_tree.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_ways.h>
#include <CGAL/Reeb_graph/skeleton/internal/Tunnel_loops.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
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
               Field field,
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
    if(!loops_.closing_chains().empty())
      let_loops_wind(field);
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

  typedef std::vector<Row> Rows;

  // Looks whether the loops are a basis of those of the solid. If not, lines make detours along tunnels. Contours of the chains
  // that close loops tell most that are one, and take less time than handles.
  void let_loops_wind(Field field)
  {
    std::vector<Polyline> contours;
    for(const Index chain : loops_.closing_chains())
      contours.push_back(contour(chain));
    loop_group_ = Loop_group(loops_.linking_numbers(crossings(polylines(), contours)));
    if(loop_group_.is_whole())
      return;
    Tunnel_loops tunnels(tree_, field, progress_.part(0.5, 0.7));
    loop_group_ = Loop_group(loops_.linking_numbers(crossings(polylines(), tunnels.handles())));
    make_detours(tunnels);
    if(loop_group_.number_of_dependent == 0)
      return;
    tunnels.free(ways_);
    make_detours(tunnels);
  }

  // Rounding, or a surface that crosses itself, can let a detour fail: other chains may do then.
  void make_detours(const Tunnel_loops& tunnels)
  {
    Rows of_lines = crossings(polylines(), tunnels.handles());
    std::vector<bool> has_failed(lines_.lines().size(), false);
    const int most_turns = tunnels.tunnels().empty() ? 0 : 8;
    for(int turn = 0; turn != most_turns && !loop_group_.is_whole(); ++turn)
    {
      const auto before = lines_.lines();
      const auto failed_before = has_failed;
      for(const Detour& detour : find_detours(tunnels, of_lines, has_failed))
      {
        progress_(0.7); // so that it can be cancelled
        has_failed[detour.chain] = !make(detour, !tunnels.are_free());
      }
      const Rows rows = crossings(polylines(), tunnels.handles());
      if(const Loop_group group(loops_.linking_numbers(rows)); group < loop_group_)
      {
        loop_group_ = group;
        of_lines = rows;
      }
      else
        lines_.lines() = before;
      if(has_failed == failed_before)
        return;
    }
  }

  // A way from a place of a chain to the surface, along a loop there, and back, or on to the end in place of the line.
  struct Detour
  {
    Index chain;
    std::size_t place;
    Face_path loop;
    double length; // how much longer the line gets
    bool is_whole = false;
  };

  // Chooses detours along tunnels, and shortens them. The last places of a chain come first, so that others stay where they are.
  std::vector<Detour> find_detours(const Tunnel_loops& tunnels,
                                   const Rows& of_lines,
                                   const std::vector<bool>& has_failed) const
  {
    Rows loops = loops_.linking_numbers(of_lines);
    std::vector<Tunnel_detour> offers = find_offers(tunnels, has_failed);
    const Rows of_tunnels = tunnels.are_free() ? crossings(first_ways(offers, tunnels), tunnels.handles()) : Rows();
    std::vector<Detour_choice::Cycles> cycles;
    for(Index chain = 0; chain != lines_.lines().size(); ++chain)
      cycles.push_back(loops_.cycles_of(chain));
    // Handles that are hidden in vertices have no loops: they may have any tunnel, but the best ones.
    for(; !tunnels.are_free() && loops.size() < tunnels.tunnels().size(); loops.emplace_back())
    {
      for(std::size_t tunnel = 0; tunnel != tunnels.tunnels().size(); ++tunnel)
        offers.push_back({cycles.size(), tunnel, 1});
      cycles.push_back({{static_cast<Index>(loops.size()), 1}});
    }
    Detour_choice choice(loops, of_tunnels, cycles, offers, progress_);
    std::vector<Detour> detours;
    for(const Tunnel_detour& detour : choice.detours())
      if(detour.chain < lines_.lines().size())
        detours.push_back(nearest_detour(detour, tunnels));
    std::stable_sort(detours.begin(), detours.end(),
                     [](const Detour& a, const Detour& b) { return a.length > b.length; });
    const std::vector<Polyline> ways = ways_of(detours);
    Rows of_ways = crossings(ways, tunnels.handles());
    for(Detour& detour : detours)
    {
      shorten(detour, tunnels, choice);
      const Polyline& way = ways[detour.chain];
      if(way.empty() || shares_chain(detour, detours))
        continue;
      add_multiple(of_ways[detour.chain], of_lines[detour.chain], -1);
      replace_line(detour, way, of_ways[detour.chain], tunnels, choice);
    }
    std::stable_sort(detours.begin(), detours.end(),
                     [](const Detour& a, const Detour& b) { return a.place > b.place; });
    return detours;
  }

  // By column, a way from a line and back along each tunnel, as the first offer has it. It is empty if there is none.
  std::vector<Polyline> first_ways(const std::vector<Tunnel_detour>& offers, const Tunnel_loops& tunnels) const
  {
    std::vector<Polyline> result(tunnels.handles().size());
    std::vector<bool> is_found(result.size(), false);
    for(const Tunnel_detour& offer : offers)
    {
      if(is_found[offer.tunnel])
        continue;
      is_found[offer.tunnel] = true;
      const Detour detour = nearest_detour(offer, tunnels);
      const Surface_place begin = begin_of(detour).surface_place();
      result[offer.tunnel] = ways_.way_along(begin, begin, detour.loop, false);
    }
    return result;
  }

  // Detours along tunnels, the shortest one first.
  std::vector<Tunnel_detour> find_offers(const Tunnel_loops& tunnels, const std::vector<bool>& has_failed) const
  {
    std::vector<std::pair<double, Tunnel_detour>> offers;
    for(const Index chain : loops_.chains_on_cycles())
      for(std::size_t tunnel = 0; tunnel != tunnels.tunnels().size() && !has_failed[chain]; ++tunnel)
      {
        progress_(0); // so that it can be cancelled
        offers.push_back({nearest_detour({chain, tunnel, 0}, tunnels).length, {chain, tunnel, 1}});
      }
    std::stable_sort(offers.begin(), offers.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Tunnel_detour> result;
    for(const auto& [length, detour] : offers)
      result.push_back(detour);
    return result;
  }

  // A detour from where its chain is nearest to its tunnel.
  Detour nearest_detour(const Tunnel_detour& along, const Tunnel_loops& tunnels) const
  {
    const Mesh& mesh = graph_.mesh();
    const auto chain = static_cast<Index>(along.chain);
    const auto& steps = tunnels.tunnels()[along.tunnel].steps;
    const std::size_t size = steps.size();
    Detour detour = {chain, 0, {}, std::numeric_limits<double>::infinity()};
    std::size_t first = 0;
    for(std::size_t place = 0; place <= lines_.lines()[chain].size(); ++place)
    {
      const Point p = lines_.place(chain, place).point;
      for(std::size_t i = 0; i != size; ++i)
        if(const double squared = squared_distance(p, mesh.point(mesh.source(steps[i]))); squared < detour.length)
        {
          detour.length = squared;
          detour.place = place;
          first = i;
        }
    }
    detour.length = 2 * std::sqrt(detour.length) + tunnels.length_of(tunnels.tunnels()[along.tunnel]);
    detour.loop.begin = mesh.face(steps[first]);
    for(std::size_t i = 0; i != size * static_cast<std::size_t>(std::abs(along.times)); ++i)
      detour.loop.steps.push_back(steps[(first + i) % size]);
    if(along.times < 0)
      detour.loop = detour.loop.reversed(mesh);
    return detour;
  }

  // Puts a shorter loop in place of that of a detour, with which loops generate as much.
  void shorten(Detour& detour, const Tunnel_loops& tunnels, Detour_choice& choice) const
  {
    const std::vector<std::int64_t> shares = choice.shares_of(detour.chain);
    if(shares.empty())
      return;
    Row change;
    const std::int64_t share = -add_shares(tunnels.tunnels_of(detour.loop), -1, shares, change);
    bool is_shorter = false;
    const std::size_t number_of_places = lines_.lines()[detour.chain].size() + 1;
    for(std::size_t place = 0; place < number_of_places; place += number_of_places / 8 + 1)
    {
      progress_(0); // so that it can be cancelled
      const Point p = lines_.place(detour.chain, place).point;
      const auto [foot, face] = tree_.closest_place(p);
      const double away = 2 * distance(p, foot);
      auto loop = tunnels.shorter_loop(face, detour.length - away, shares, {share, share - 2});
      if(!loop)
        continue;
      is_shorter = true;
      detour = {detour.chain, place, std::move(*loop), 0};
      detour.length = away + tunnels.length_of(detour.loop);
    }
    if(!is_shorter)
      return;
    add_multiple(change, tunnels.tunnels_of(detour.loop), 1);
    choice.change(detour.chain, change);
  }

  // Adds a multiple of a loop to a change, and returns that of the shares of its tunnels.
  static std::int64_t add_shares(const Row& loop, int times, const std::vector<std::int64_t>& shares, Row& change)
  {
    std::int64_t sum = 0;
    for(const auto& [tunnel, number] : loop)
      sum += times * static_cast<std::int64_t>(number) * shares[tunnel];
    add_multiple(change, loop, times);
    return sum;
  }

  // Puts a way along the surface in place of a line with a detour, and a loop at its begin, where both together are shorter.
  void replace_line(Detour& detour,
                    const Polyline& way,
                    const Row& of_way,
                    const Tunnel_loops& tunnels,
                    Detour_choice& choice) const
  {
    const std::vector<std::int64_t> shares = choice.shares_of(detour.chain);
    if(shares.empty())
      return;
    Row change;
    std::int64_t share = -add_shares(tunnels.tunnels_of(detour.loop), -1, shares, change);
    share -= add_shares(of_way, 1, shares, change);
    const Mesh::Face_index face = tree_.closest_place(way.front()).second;
    const double saved = length_of(polyline(detour.chain)) + detour.length - length_of(way);
    std::optional<Face_path> loop = Face_path{face, {}};
    if(share != 0 && share != 2)
      loop = tunnels.shorter_loop(face, saved, shares, {share, share - 2});
    if(!(saved > 0) || !loop)
      return;
    add_shares(tunnels.tunnels_of(*loop), 1, shares, change);
    detour = {detour.chain, 0, std::move(*loop), detour.length - saved, true};
    choice.change(detour.chain, change);
  }

  // Whether its chain has another detour, too.
  static bool shares_chain(const Detour& detour, const std::vector<Detour>& detours)
  {
    return std::count_if(detours.begin(), detours.end(), [&](const Detour& d) { return d.chain == detour.chain; }) > 1;
  }

  // Ways along the surface between the ends of the chains of detours.
  std::vector<Polyline> ways_of(const std::vector<Detour>& detours) const
  {
    std::vector<Polyline> result(lines_.lines().size());
    for(const Detour& detour : detours)
    {
      const Surface_place begin = place_of_end(detour.chain, false).surface_place();
      result[detour.chain] = ways_.way_along(begin, place_of_end(detour.chain, true).surface_place(),
                                             {tree_.closest_place(begin.point).second, {}}, true);
    }
    return result;
  }

  Place begin_of(const Detour& detour) const
  {
    return detour.place == 0 ? place_of_end(detour.chain, false)
                             : Place{lines_.lines()[detour.chain][detour.place - 1], std::nullopt};
  }

  // Returns whether there is such a way.
  bool make(const Detour& detour, bool is_swept)
  {
    auto& line = lines_.lines()[detour.chain];
    const Place begin = begin_of(detour);
    const Place end = detour.is_whole ? place_of_end(detour.chain, true) : begin;
    std::vector<Line_point> points;
    add_way(ways_.way_along(begin.surface_place(), end.surface_place(), detour.loop, is_swept), begin, end, points);
    if(points.empty())
      return false;
    if(detour.is_whole)
      line.clear();
    else
      points.push_back(begin.point);
    line.insert(line.begin() + static_cast<std::ptrdiff_t>(detour.place), points.begin(), points.end());
    return true;
  }

  // A contour of the longest arc of a chain, in its middle.
  std::vector<Point> contour(Index chain) const
  {
    const auto& pieces = chains_.chains()[chain].pieces;
    const auto size = [&](const auto& piece) {
      const auto& ends = graph_.ends(piece.arc);
      return graph_.value(ends[1]) - graph_.value(ends[0]);
    };
    const auto& longest =
      *std::max_element(pieces.begin(), pieces.end(), [&](const auto& p, const auto& q) { return size(p) < size(q); });
    return graph_.contour_points(longest.arc, 0.5);
  }

  static double length_of(const std::vector<Point>& way)
  {
    double sum = 0;
    for(std::size_t i = 1; i < way.size(); ++i)
      sum += distance(way[i - 1], way[i]);
    return sum;
  }

  Rows crossings(const std::vector<Polyline>& lines, const std::vector<Polyline>& curves) const
  {
    return loops_.crossings(lines, curves, progress_.part(0.5, 1));
  }

  Polyline polyline(Index line) const
  {
    Polyline points;
    for(std::size_t i = 0; i != lines_.lines()[line].size() + 2; ++i)
      points.push_back(lines_.place(line, i).point);
    return points;
  }

  // The points of lines on cycles, none of others.
  std::vector<Polyline> polylines() const
  {
    std::vector<Polyline> result;
    for(Index line = 0; line != lines_.lines().size(); ++line)
      result.push_back(loops_.is_on_cycle(line) ? polyline(line) : Polyline());
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
  Loop_group loop_group_{{}};
  std::size_t number_outside_ = 0, number_of_crossings_ = 0;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_INSIDE_LINES_H
