// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_LINE_SAMPLING_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_LINE_SAMPLING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/skeleton/internal/Bead_ways.h>
#include <CGAL/Reeb_graph/skeleton/internal/Graph_chains.h>
#include <CGAL/Reeb_graph/skeleton/internal/Plane_contour.h>
#include <CGAL/Reeb_graph/skeleton/internal/Skeleton_lines.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_tree.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// Gives lines the points that are written, as far apart as the radii there ask for, or at equal steps, and measures the
// radius at each.
class Line_sampling : Bead_ways
{
public:
  // Steps of 0 are as the radii ask for.
  Line_sampling(const Graph_chains& chains,
                const Surface_tree& tree,
                Skeleton_lines& lines,
                double spacing,
                const Stage_progress& progress)
    : Bead_ways(tree),
      chains_(chains),
      lines_(lines),
      spacing_(spacing)
  {
    for(Index chain = 0; chain != lines.lines().size(); ++chain)
      beads_.push_back(lines.has_gone(chain) ? Beads() : beads_of(chain));
    measure_junctions();
    for(Index chain = 0; chain != lines.lines().size(); ++chain)
    {
      progress.report_step(chain, lines.lines().size());
      if(!lines.has_gone(chain))
        sample(chain);
    }
  }

private:
  typedef std::vector<Bead> Beads;

  Skeleton_lines::Node& end(Index chain, bool is_last) const
  {
    return lines_.nodes().at(lines_.ends()[chain][is_last ? 1 : 0]);
  }

  Beads beads_of(Index chain) const
  {
    Beads beads = {make_bead(end(chain, false))};
    for(const Line_point& point : lines_.lines()[chain])
      beads.push_back(make_bead(point));
    beads.push_back(make_bead(end(chain, true)));
    beads.front().point.place = 0;
    beads.back().point.place = chain < chains_.chains().size() ? chains_.chains()[chain].length : 0;
    return beads;
  }

  // The radius at a junction is the mean of those of its lines where they leave the ball inscribed there.
  void measure_junctions()
  {
    std::map<Index, std::vector<double>> radii;
    for(Index chain = 0; chain != beads_.size(); ++chain)
      for(const bool is_last : {false, true})
        if(!beads_[chain].empty() && end(chain, is_last).kind == Line_end::JUNCTION)
          radii[lines_.ends()[chain][is_last ? 1 : 0]].push_back(radius_beside(chain, is_last));
    for(const auto& [node, found] : radii)
    {
      double sum = 0;
      for(const double radius : found)
        sum += radius / static_cast<double>(found.size());
      lines_.nodes().at(node).point.radius = sum;
    }
  }

  double radius_beside(Index chain, bool is_last) const
  {
    Beads beads = beads_[chain];
    if(is_last)
      std::reverse(beads.begin(), beads.end());
    const Point center = beads.front().point.point;
    std::size_t i = 1;
    while(i + 1 != beads.size() && !(distance(center, beads[i].point.point) > beads.front().depth))
      ++i;
    const Bead &a = beads[i - 1], &b = beads[i];
    const double t = distance(center, b.point.point) > beads.front().depth
                     ? exit_of_ball(center, beads.front().depth, a.point.point, b.point.point)
                     : 0.5;
    return between(a, b, t).point.radius;
  }

  // Where a way from inside of a ball to outside of it leaves it, from 0 to 1.
  static double exit_of_ball(const Point& center, double radius, const Point& from, const Point& to)
  {
    const Vector way = to - from, start = from - center;
    const double a = way.squared_length(), b = way * start, c = start.squared_length() - radius * radius;
    const double root = std::sqrt((std::max)(b * b - a * c, 0.));
    const double t = b > 0 ? -c / (b + root) : (root - b) / a;
    return std::clamp(t, 0., 1.);
  }

  // Takes the radius of the contour in the plane across the line. Where that is not one across a tube, what it is stays.
  void measure(const Vector& along, Bead& bead) const
  {
    Line_point& p = bead.point;
    const double size = length(along);
    if(!(size > 0))
      return;
    const Plane_contour contour(tree_, p.point, along / size, p.on_surface);
    if(contour.is_across_tube())
      p.radius = *contour.radius();
    bead.is_across_tube = contour.is_across_tube() && p.radius < 1.5 * bead.depth;
  }

  // Where a line begins at a junction, contours can be those of the trunk, or oblique: the radius there is that of the first one
  // across a tube.
  static void measure_mouth(Beads& beads, bool is_last)
  {
    const auto at = [&](std::size_t i) -> Bead& { return beads[is_last ? beads.size() - 1 - i : i]; };
    std::size_t first = 1;
    while(first + 1 < beads.size() && !at(first).is_across_tube
          && distance(at(first).point.point, at(0).point.point) < 2 * at(0).depth)
      ++first;
    for(std::size_t i = 1; i != first && at(first).is_across_tube; ++i)
      at(i).point.radius = at(first).point.radius;
  }

  void measure_mouths(Index chain, Beads& beads) const
  {
    for(const bool is_last : {false, true})
      if(end(chain, is_last).kind == Line_end::JUNCTION)
        measure_mouth(beads, is_last);
  }

  // A bead between two, with its radius.
  Bead between(const Bead& a, const Bead& b, double t) const
  {
    Bead bead = Bead_ways::between(a, b, t);
    measure(b.point.point - a.point.point, bead);
    return bead;
  }

  void sample(Index chain)
  {
    Beads beads = spacing_ > 0 ? at_equal_steps(chain) : thinned(beads_[chain]);
    for(const bool is_last : {false, true})
      (is_last ? beads.back() : beads.front()).point.radius = end(chain, is_last).point.radius;
    for(std::size_t i = 1; i + 1 < beads.size(); ++i)
      measure(beads[i + 1].point.point - beads[i - 1].point.point, beads[i]);
    measure_mouths(chain, beads);
    // Added points have contours of their own, which are narrowed in a mouth, too, and so ask for more points.
    for(int turn = 0; turn != 2 && !(spacing_ > 0); ++turn)
    {
      beads = with_points_between(beads);
      measure_mouths(chain, beads);
    }
    Skeleton_lines::Line& line = lines_.lines()[chain];
    line.clear();
    for(std::size_t i = 1; i + 1 < beads.size(); ++i)
      line.push_back(beads[i].point);
    for(const bool is_last : {false, true})
      if(Skeleton_lines::Node& node = end(chain, is_last); node.kind == Line_end::TIP && !line.empty())
        node.point.radius = (is_last ? line.back() : line.front()).radius;
  }

  // Leaves points out that are much nearer to one neighbor than to the other one, or than the room there asks for, where nothing
  // is in the way, and all that are where a neighbor is.
  Beads thinned(const Beads& beads) const
  {
    Beads kept;
    for(const Bead& next : beads)
    {
      while(kept.size() > 1)
      {
        const Bead &before = kept[kept.size() - 2], &last = kept.back();
        const double from = distance(before.point.point, last.point.point),
                     to = distance(last.point.point, next.point.point);
        // a thin branch begins far from the center of its trunk
        const double far = (std::min)((std::max)(from, to), 4 * lines_.step(last.depth));
        if(from > 0 && to > 0 && ((std::min)(from, to) >= 0.1 * far || !is_free(before, last, next.place())))
          break;
        kept.pop_back();
      }
      kept.push_back(next);
    }
    return kept;
  }

  // Points as far from each other as is wanted.
  Beads at_equal_steps(Index chain) const
  {
    const Beads& beads = beads_[chain];
    Beads result = {beads.front()}, passed; // since the last one
    for(std::size_t i = 1; i != beads.size(); ++i)
    {
      const Point& to = beads[i].point.point;
      while(distance(result.back().point.point, to) > (1 + 1e-9) * spacing_)
      {
        const Bead& from = passed.empty() ? result.back() : passed.back();
        const double t = exit_of_ball(result.back().point.point, spacing_, from.point.point, to);
        const Bead next = between(from, beads[i], t);
        if(!tree_.is_inside(next.point.point))
          break;
        go_on(next, passed, result);
      }
      passed.push_back(beads[i]);
    }
    passed.pop_back();
    if(lines_.ends()[chain][0] == lines_.ends()[chain][1] && result.size() < 3) // A ring stays one.
      std::move(passed.begin(), passed.end(), std::back_inserter(result)), passed.clear();
    go_on(beads.back(), passed, result);
    return result;
  }

  // Goes straight on to a bead or, where the surface is in the way, by those that have been passed.
  void go_on(const Bead& next, Beads& passed, Beads& result) const
  {
    const Bead& last = result.back();
    bool is_way_free = true;
    for(std::size_t i = 0; i != passed.size() && is_way_free; ++i)
      is_way_free = is_free(last, passed[i], (i + 1 == passed.size() ? next : passed[i + 1]).place());
    if(!is_way_free)
      result.insert(result.end(), passed.begin(), passed.end());
    result.push_back(next);
    passed.clear();
  }

  // Makes no step longer than one and a half times what is asked for; an edge between nodes gets its middle.
  Beads with_points_between(const Beads& beads) const
  {
    Beads result = {beads.front()};
    for(std::size_t i = 1; i != beads.size(); ++i)
    {
      add_between(beads[i - 1], beads[i], beads.size() == 2 ? 2 : 1, result);
      result.push_back(beads[i]);
    }
    return result;
  }

  // Points outside of a surface that an edge crosses are left out, and all if more edges would cross it.
  void add_between(const Bead& a, const Bead& b, std::size_t least, Beads& result) const
  {
    const double radius = !(a.depth > 0) ? b.point.radius
                        : !(b.depth > 0) ? a.point.radius
                                         : (std::min)(a.point.radius, b.point.radius);
    const double steps = distance(a.point.point, b.point.point) / (1.5 * lines_.step(radius));
    const auto pieces = (std::max)(static_cast<std::size_t>(std::ceil(steps)), least);
    Beads added = {a};
    for(std::size_t k = 1; k < pieces; ++k)
      if(Bead next = between(a, b, static_cast<double>(k) / static_cast<double>(pieces));
         tree_.is_inside(next.point.point))
        added.push_back(std::move(next));
    if(added.size() == 1)
      return;
    added.push_back(b);
    std::size_t number_of_crossed = 0; // Points on an edge are rounded.
    for(std::size_t i = 1; i != added.size(); ++i)
      number_of_crossed += is_free(added[i - 1], added[i]) ? 0 : 1;
    if(number_of_crossed > 1 || (number_of_crossed == 1 && is_free(a, b)))
      return;
    for(std::size_t i = 1; i != added.size(); ++i)
    {
      add_between(added[i - 1], added[i], 1, result);
      if(i + 1 != added.size())
        result.push_back(added[i]);
    }
  }

  const Graph_chains& chains_;
  Skeleton_lines& lines_;
  const double spacing_;
  std::vector<Beads> beads_; // of each line, from node to node
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_LINE_SAMPLING_H
