// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_LINE_CENTERING_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_LINE_CENTERING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/skeleton/internal/Bead_lines.h>
#include <CGAL/Reeb_graph/skeleton/internal/Blunt_end.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// Moves lines that are inside of a surface to where they are least long for how far they are from it: the sum of length by
// distance over their edges falls, with a price on bends. Ends and lines that are not inside stay.
class Line_centering : Bead_lines
{
public:
  Line_centering(const Sampled_graph& graph,
                 const Graph_chains& chains,
                 const Surface_tree& tree,
                 Skeleton_lines& lines,
                 double smooth,
                 const Stage_progress& progress)
    : Bead_lines(chains, tree, lines, smooth)
  {
    run(progress);
    write(lines, graph.number_of_nodes());
  }

private:
  // Every few rounds, lines get other points, and those that run together are joined, until all of them rest.
  void run(const Stage_progress& progress)
  {
    bool is_any_moving = true;
    for(int turn = 0; turn != most_turns && is_any_moving; ++turn)
    {
      const Stage_progress part = progress.part(0.9 * turn / most_turns, 0.9 * (turn + 1) / most_turns);
      rearrange(part.part(0, 0.2));
      for(int round = 0; round != rounds_between; ++round)
        move_all(part.part(0.2, 1));
      is_any_moving = false;
      for(Line& line : lines_)
      {
        line.is_resting = std::all_of(line.beads.begin(), line.beads.end(),
                                      [&](std::size_t bead) { return beads_[bead].way <= way_of_rest; });
        is_any_moving = is_any_moving || !(line.is_fixed || line.is_resting);
      }
    }
    join_junctions();
    find_tips();
    for(std::size_t i = 0; i != lines_.size(); ++i)
    {
      progress.part(0.9, 1).report_step(i, lines_.size());
      Line& line = lines_[i];
      if(line.is_fixed)
        continue;
      for(const bool is_last : {false, true})
        move_tip(line.beads, is_last);
      leave_out_folds_and_tops(line.beads);
      straighten(line.beads);
      decimate(line.beads);
      for(const bool is_last : {false, true})
        go_on_before_tip(line, is_last);
    }
  }

  void rearrange(const Stage_progress& progress)
  {
    let_go();
    for(std::size_t i = 0; i != lines_.size(); ++i)
    {
      progress.report_step(i, lines_.size());
      Line& line = lines_[i];
      if(!line.is_resting && !line.is_fixed)
      {
        resample(line);
        leave_out_folds_and_tops(line.beads);
      }
    }
    find_ends();
    join_lines();
    for(Bead& bead : beads_)
      bead.way = 0;
  }

  void move_all(const Stage_progress& progress)
  {
    for(const auto& [node, ends] : ends_of_nodes_)
      if(!beads_[node].is_on_surface() && !beads_[node].is_settled && !is_outside(node))
        move_node(node);
    std::size_t number = 0;
    for(const Line& line : lines_)
      for(std::size_t i = 1; i + 1 < line.beads.size() && !line.is_fixed && !line.is_resting; ++i)
        if(!beads_[line.beads[i]].is_settled)
        {
          progress.report_step(number++, beads_.size());
          move_bead(line.beads, i);
        }
  }

  // Moves the tip of a limb that ends bluntly to the middle of its cap, and another one to where the limb goes on straight, if that
  // is farther, and near no other tip.
  void move_tip(Numbers& beads, bool is_last)
  {
    if(beads.size() < 3 || beads_[is_last ? beads.back() : beads.front()].depth > 0)
      return;
    Numbers line = beads; // from the tip
    if(is_last)
      std::reverse(line.begin(), line.end());
    Bead tip = beads_[line.front()];
    std::size_t farthest = 1;
    for(; farthest + 2 < line.size(); ++farthest) // In a corner, lines are near to all of its sides.
    {
      const double way = distance(beads_[line[farthest]].point.point, tip.point.point),
                   depth = beads_[line[farthest]].depth;
      if(way > 2 * depth && (way > 4 * depth || beads_[line[farthest + 1]].depth < 1.05 * depth))
        break;
    }
    const auto end = find_end(line, farthest, tip.point.point);
    if(!end)
      return;
    tip.point.point = end->place.point;
    tip.vertex = end->place.vertex;
    tip.face = end->place.face;
    std::size_t first = farthest;
    while(first > 1 && distance(beads_[line[first - 1]].point.point, tip.point.point) > end->radius)
      --first;
    while(first <= farthest && !is_free(beads_[line[first]], tip))
      ++first;
    if(first > farthest)
      return;
    beads_[line.front()] = tip;
    for(std::size_t i = first + 1;
        i + 1 < line.size() && distance(beads_[line[i]].point.point, tip.point.point) < 4 * end->radius; ++i)
      if(can_go_straight(line, i))
        first = i;
    line.erase(line.begin() + 1, line.begin() + static_cast<std::ptrdiff_t>(first));
    if(is_last)
      std::reverse(line.begin(), line.end());
    beads = line;
  }

  // Whether a line can go straight from a tip to one of its beads, and is hardly nearer to the surface then.
  bool can_go_straight(const Numbers& line, std::size_t to) const
  {
    for(std::size_t i = 1; i != to; ++i)
    {
      Line_point on_chord = beads_[line[i]].point;
      on_chord.point = foot(line, 0, to, i);
      if(make_bead(on_chord).depth < 0.95 * beads_[line[i]].depth)
        return false;
    }
    return is_free(line, 0, to);
  }

  struct End_of_limb
  {
    Surface_place place;
    double radius;
  };

  // The middle of the smallest cap that is seen along a line from its beads up to one, as it bends, or else what is farthest beyond
  // the tip.
  std::optional<End_of_limb> find_end(const Numbers& line, std::size_t farthest, const Point& tip) const
  {
    std::optional<End_of_limb> blunt, farther;
    double most = 0.01;
    const std::vector<Point> others = other_tips(tip, 8 * beads_[line[farthest]].depth);
    const auto is_nearer_to_another = [&](const Point& p) {
      return std::any_of(others.begin(), others.end(),
                         [&](const Point& other) { return distance(p, other) < distance(p, tip); });
    };
    for(std::size_t i = farthest; i != 0; --i)
    {
      const Bead& from = beads_[line[i]];
      const Vector along = from.point.point - beads_[line[i + 1]].point.point;
      const Vector to_tip = tip - from.point.point;
      if(!(length(along) > 0) || to_tip * along < 0.7 * length(to_tip) * length(along)) // The tip is around a corner.
        continue;
      const Blunt_end seen(tree_, from.point.point, along / length(along), from.depth, tip, others);
      if(seen.middle() && !(blunt && blunt->radius <= seen.radius()))
        blunt = End_of_limb{*seen.middle(), seen.radius()};
      if(!seen.seen() || distance(seen.seen()->point, tip) > 2 * from.depth || is_nearer_to_another(seen.seen()->point))
        continue;
      if(const double share = (seen.seen()->point - tip) * along / (length(along) * from.depth); share > most)
      {
        most = share;
        farther = End_of_limb{*seen.seen(), from.depth};
      }
    }
    return blunt ? blunt : farther;
  }

  void find_tips()
  {
    for(const Line& line : lines_)
      if(!line.beads.empty())
        for(const std::size_t bead : {line.beads.front(), line.beads.back()})
          if(beads_[bead].is_on_surface())
            tips_.push_back(beads_[bead].point.point);
    std::sort(tips_.begin(), tips_.end());
  }

  // The tips of other lines that are so near to one.
  std::vector<Point> other_tips(const Point& tip, double reach) const
  {
    std::vector<Point> result;
    const Vector to_right(reach, 0, 0);
    for(auto p = std::lower_bound(tips_.begin(), tips_.end(), tip - to_right);
        p != tips_.end() && p->x() <= tip.x() + reach; ++p)
      if(*p != tip && distance(*p, tip) <= reach)
        result.push_back(*p);
    return result;
  }

  // Puts points nearer to the straight line between their neighbors where that is hardly nearer to the surface: there is room in
  // flat parts, and for what noise has bent.
  void straighten(const Numbers& line)
  {
    std::vector<double> least;
    for(const std::size_t bead : line)
      least.push_back(0.98 * beads_[bead].depth);
    for(int round = 0; round != 4; ++round)
      for(std::size_t i = 1; i + 1 < line.size(); ++i)
        straighten(line, i, least[i]);
  }

  void straighten(const Numbers& line, std::size_t i, double least)
  {
    Bead& bead = beads_[line[i]];
    const Bead &before = beads_[line[i - 1]], &after = beads_[line[i + 1]];
    Line_point middle = bead.point;
    middle.point = CGAL::midpoint(middle.point, foot(line, i - 1, i + 1, i));
    if(!(before.depth > 0 && after.depth > 0) || distance(middle.point, bead.point.point) < least_share * bead.depth)
      return;
    const Bead moved = make_bead(middle);
    if(moved.depth >= least && is_free(before, bead, moved.place()) && is_free(after, bead, moved.place()))
      bead = moved;
  }

  // Makes two junctions one that are nearer to each other than the surface is, and joined by a line in the balls around them: the
  // lines of one go on to the other.
  void join_junctions()
  {
    find_ends();
    for(bool is_any_joined = true; is_any_joined;)
    {
      is_any_joined = false;
      for(std::size_t line = 0; line != lines_.size(); ++line)
        is_any_joined = join_ends(lines_[line]) || is_any_joined;
    }
  }

  double length_of(const Numbers& line) const
  {
    double sum = 0;
    for(std::size_t i = 1; i < line.size(); ++i)
      sum += distance(beads_[line[i - 1]].point.point, beads_[line[i]].point.point);
    return sum;
  }

  bool join_ends(Line& line)
  {
    if(line.beads.empty() || line.beads.front() == line.beads.back())
      return false;
    const Bead &a = beads_[line.beads.front()], &b = beads_[line.beads.back()];
    if(a.is_on_surface() || b.is_on_surface() || a.is_fixed || b.is_fixed
       || !(distance(a.point.point, b.point.point) < (std::min)(a.depth, b.depth))
       || !(length_of(line.beads) < a.depth + b.depth)) // It leaves the balls around them.
      return false;
    Numbers path = std::exchange(line.beads, {});
    if(a.depth < b.depth)
      std::reverse(path.begin(), path.end()); // to the node that goes
    line.joined = joined_[path.back()] = path.front();
    extend(path);
    return true;
  }

  // Leads all lines that end at the last bead of a path along it to the first one. Each gets beads of its own, at the places
  // where it ended.
  void extend(const Numbers& path)
  {
    std::vector<End_of_line>& kept = ends_of_nodes_[path.front()];
    kept.erase(
      std::remove_if(kept.begin(), kept.end(), [&](const End_of_line& end) { return lines_[end.line].beads.empty(); }),
      kept.end());
    for(const End_of_line& end : std::exchange(ends_of_nodes_[path.back()], {}))
    {
      Line& line = lines_[end.line];
      if(line.beads.empty())
        continue;
      Numbers added = {path.front()};
      for(std::size_t i = 1; i != path.size(); ++i)
      {
        added.push_back(beads_.size());
        beads_.push_back(Bead(beads_[path[i]]));
        beads_.back().point.place = line.places[end.is_last ? 1 : 0];
      }
      if(end.is_last)
        std::reverse(added.begin(), added.end());
      line.beads.erase(end.is_last ? line.beads.end() - 1 : line.beads.begin());
      line.beads.insert(end.is_last ? line.beads.end() : line.beads.begin(), added.begin(), added.end());
      go_straight(end, path.size() - 1);
      kept.push_back(end);
    }
    ends_of_nodes_.erase(path.back());
  }

  // Leaves out as many of so many beads beside an end as the surface allows, as other lines pass the same places.
  void go_straight(const End_of_line& end, std::size_t most)
  {
    Numbers& beads = lines_[end.line].beads;
    const std::size_t least = beads.front() == beads.back() ? 4 : 2;
    for(; most != 0 && beads.size() > least; --most)
    {
      if(!is_free(beads_[from_end(end, 0)], beads_[from_end(end, 1)], beads_[from_end(end, 2)].place()))
        return;
      beads.erase(end.is_last ? beads.end() - 2 : beads.begin() + 1);
    }
  }

  // Joins lines from where they part at a junction as long as they are within a quarter of the distance from the surface.
  void join_lines()
  {
    Numbers nodes;
    for(const auto& [node, ends] : ends_of_nodes_)
      nodes.push_back(node);
    for(std::size_t i = 0; i != nodes.size(); ++i)
      for(int turn = 0; turn != 20 && join_lines_at(nodes[i]); ++turn)
        if(ends_of_nodes_.rbegin()->first > nodes.back())
          nodes.push_back(ends_of_nodes_.rbegin()->first);
  }

  bool join_lines_at(std::size_t node)
  {
    const auto ends = ends_of_nodes_[node];
    if(ends.size() < 3 || beads_[node].is_on_surface() || beads_[node].is_fixed)
      return false;
    for(std::size_t i = 0; i != ends.size(); ++i)
      for(std::size_t j = 0; j != i; ++j)
        if(are_beside(node, ends[i], ends[j], ends.size() > 3) && join_two(node, ends[i], ends[j]))
          return true;
    return false;
  }

  // Whether two lines run beside each other at a node, and, if that is asked, until outside of the ball around it.
  bool are_beside(std::size_t node, const End_of_line& a, const End_of_line& b, bool is_long) const
  {
    const std::size_t size_a = lines_[a.line].beads.size(), size_b = lines_[b.line].beads.size();
    const std::size_t size = a.line == b.line ? size_a / 2 - 1 : (std::min)(size_a, size_b) - 1;
    for(std::size_t i = 1; i < size; ++i)
    {
      const Bead &p = beads_[from_end(a, i)], &q = beads_[from_end(b, i)];
      const double depth = (std::min)(p.depth, q.depth);
      if(!(distance(p.point.point, q.point.point) < 0.25 * depth))
        return false;
      if(!is_long || distance(p.point.point, beads_[node].point.point) > (std::min)(depth, beads_[node].depth))
        return true;
    }
    return false;
  }

  // Lets two lines part at their next points, if the surface is not in the way: the node moves there, or a new one is made.
  bool join_two(std::size_t node, const End_of_line& a, const End_of_line& b)
  {
    const Bead &p = beads_[from_end(a, 1)], &q = beads_[from_end(b, 1)];
    Line_point middle = p.point;
    middle.point = CGAL::midpoint(p.point.point, q.point.point);
    const Bead moved = make_bead(middle);
    const auto can_part = [&](const End_of_line& end, const Bead& next) {
      const Bead& after = beads_[from_end(end, 2)];
      return is_free(beads_[node], next, moved.place()) && is_free(moved, next, after.place());
    };
    if(!can_part(a, p) || !can_part(b, q))
      return false;
    std::size_t parting = node;
    const auto is_of = [](const End_of_line& e, const End_of_line& f) {
      return e.line == f.line && e.is_last == f.is_last;
    };
    std::vector<End_of_line>& ends = ends_of_nodes_.at(node);
    const auto others =
      std::stable_partition(ends.begin(), ends.end(), [&](const auto& end) { return is_of(end, a) || is_of(end, b); });
    if(ends.size() == 3)
    {
      const End_of_line& rest = *others;
      Line& line = lines_[rest.line];
      line.is_resting = false;
      beads_.push_back(beads_[node]);
      beads_.back().point.place = line.places[rest.is_last ? 1 : 0];
      line.beads.insert(rest.is_last ? line.beads.end() - 1 : line.beads.begin() + 1, beads_.size() - 1);
    }
    else
    {
      parting = beads_.size();
      beads_.push_back(moved);
      ends.erase(ends.begin(), others);
      ends.push_back({lines_.size(), false});
      ends_of_nodes_[parting] = {a, b, {lines_.size(), true}};
      lines_.push_back({{node, parting}});
    }
    for(const End_of_line& end : {a, b})
    {
      lines_[end.line].is_resting = false;
      Numbers& beads = lines_[end.line].beads;
      beads.erase(end.is_last ? beads.end() - 2 : beads.begin() + 1);
      (end.is_last ? beads.back() : beads.front()) = parting;
    }
    beads_[parting].point.point = moved.point.point;
    beads_[parting].point.on_surface = moved.point.on_surface;
    beads_[parting].depth = moved.depth;
    beads_[parting].is_settled = false;
    return true;
  }

  // The price of an edge, and how that changes with its end `p`, where the distance is `depth` and grows towards `away`.
  struct Cost
  {
    double value = 0;
    Vector gradient = NULL_VECTOR;
  };

  void add_edge(const Point& p, double depth, const Vector& away, const Bead& other, Cost& cost) const
  {
    if(!(other.depth > 0))
      return; // A tip can be beside the axis: it does not draw what is before it there.
    const Vector edge = p - other.point.point;
    const double size = length(edge), weight = (1 / depth + 1 / other.depth) / 2;
    cost.value += size * weight;
    if(size > 0)
      cost.gradient = cost.gradient + weight / size * edge;
    cost.gradient = cost.gradient - size / (2 * depth * depth) * away;
  }

  // A bend at `b` costs, too; the gradient is that of its point number `of`.
  void add_bend(const Point& a, const Point& b, const Point& c, int of, Cost& cost) const
  {
    const Vector from = b - a, to = c - b;
    const double before = length(from), after = length(to);
    if(!(before > 0) || !(after > 0))
      return;
    const Vector u = from / before, v = to / after;
    const double cosine = u * v, price = bending * smooth_;
    cost.value += price * (1 - cosine);
    const Vector by_from = 1 / before * (v - cosine * u), by_to = 1 / after * (u - cosine * v);
    cost.gradient = cost.gradient + price * (of == 0 ? by_from : of == 1 ? by_to - by_from : -by_to);
  }

  Cost cost_of_bead(const Numbers& line, std::size_t i, const Point& p, double depth, const Vector& away) const
  {
    Cost cost;
    const auto at = [&](std::size_t k) -> const Point& { return k == i ? p : beads_[line[k]].point.point; };
    add_edge(p, depth, away, beads_[line[i - 1]], cost);
    add_edge(p, depth, away, beads_[line[i + 1]], cost);
    for(std::size_t k = (std::max)(i, std::size_t(2)) - 1; k <= i + 1 && k + 1 < line.size(); ++k)
      add_bend(at(k - 1), at(k), at(k + 1), static_cast<int>(i + 1 - k), cost);
    return cost;
  }

  // Thick lines hold a junction much more than thin ones: these begin in the middle of those.
  Cost cost_of_node(const Numbers& neighbors, const Point& p, double depth, const Vector& away) const
  {
    Cost cost;
    double most = 0;
    for(const std::size_t neighbor : neighbors)
      most = (std::max)(most, beads_[neighbor].depth);
    for(const std::size_t neighbor : neighbors)
    {
      if(!(beads_[neighbor].depth > 0))
        continue;
      Cost of_edge;
      add_edge(p, depth, away, beads_[neighbor], of_edge);
      const double share = neighbors.size() == 2 ? 1 : beads_[neighbor].depth / most,
                   weight = share * share * share * share;
      cost.value += weight * of_edge.value;
      cost.gradient = cost.gradient + weight * of_edge.gradient;
    }
    return cost;
  }

  void move_bead(const Numbers& line, std::size_t i)
  {
    const Vector along = beads_[line[i + 1]].point.point - beads_[line[i - 1]].point.point;
    move(line[i], {line[i - 1], line[i + 1]}, along,
         [&](const Point& p, double depth, const Vector& away) { return cost_of_bead(line, i, p, depth, away); });
  }

  void move_node(std::size_t node)
  {
    Numbers neighbors, free;
    for(const End_of_line& end : ends_of_nodes_[node])
    {
      const Line& line = lines_[end.line];
      if(line.is_fixed && line.is_on_cycle)
        return;
      neighbors.push_back(from_end(end, 1));
      if(!line.is_fixed)
        free.push_back(neighbors.back());
    }
    if(!free.empty()) // Edges that cross the surface follow.
      move(node, free, NULL_VECTOR,
           [&](const Point& p, double depth, const Vector& away) { return cost_of_node(neighbors, p, depth, away); });
  }

  // Moves down the gradient, across the line, if that pays. A step over a ridge, beyond which other points of the surface are
  // closest, does not: then the least vector between the gradients on both sides leads along it.
  template <class Cost_of>
  void move(std::size_t number, const Numbers& neighbors, const Vector& along, const Cost_of& cost_of)
  {
    Bead& bead = beads_[number];
    bead.is_settled = true;
    if(!(bead.depth > 0))
      return;
    const auto cost_at = [&](const Bead& b) {
      return b.depth > 0 ? cost_of(b.point.point, b.depth, (b.point.point - b.point.on_surface) / b.depth)
                         : Cost{std::numeric_limits<double>::infinity(), NULL_VECTOR};
    };
    const Cost before = cost_at(bead);
    const Vector gradient = across(before.gradient, along);
    std::optional<Bead> next = stepped(bead, gradient);
    if(!next)
      return;
    Cost after = cost_at(*next);
    const bool is_over_ridge = !(after.value < before.value);
    if(is_over_ridge)
    {
      next = stepped(bead, least_between(gradient, across(after.gradient, along)));
      after = next ? cost_at(*next) : before;
    }
    const bool is_better =
      after.value < before.value && std::all_of(neighbors.begin(), neighbors.end(), [&](std::size_t neighbor) {
        return is_free(beads_[neighbor], bead, next->place());
      });
    bead.is_settled = !is_better && bead.pace < 0.04;
    bead.pace = (std::min)((!is_better ? 0.5 : is_over_ridge ? 0.7 : 1.4) * bead.pace, 1.);
    if(!is_better)
      return;
    bead.way += distance(next->point.point, bead.point.point) / bead.depth;
    bead.point = next->point;
    bead.depth = next->depth;
    for(const std::size_t neighbor : neighbors)
      if(beads_[neighbor].is_settled)
      {
        beads_[neighbor].is_settled = false;
        beads_[neighbor].pace = (std::max)(beads_[neighbor].pace, 0.1);
      }
  }

  static Vector across(const Vector& v, const Vector& along)
  {
    const double square = along.squared_length();
    return square > 0 ? v - (v * along) / square * along : v;
  }

  static Vector least_between(const Vector& v, const Vector& w)
  {
    const Vector way = w - v;
    const double square = way.squared_length();
    return square > 0 ? v + std::clamp(-(v * way) / square, 0., 1.) * way : v;
  }

  // None for a step that is not worth looking for the surface.
  std::optional<Bead> stepped(const Bead& bead, const Vector& gradient) const
  {
    Vector step = -bead.pace * bead.depth * bead.depth * gradient;
    const double size = length(step), most = 0.3 * bead.depth;
    if(size > most)
      step = most / size * step;
    Line_point point = bead.point;
    point.point = point.point + step;
    if(!(distance(point.point, bead.point.point) > least_share * bead.depth))
      return std::nullopt;
    return make_bead(point);
  }

  std::vector<Point> tips_; // of all lines, before they are moved

  static constexpr int most_turns = 12, rounds_between = 5;
  static constexpr double way_of_rest = 0.05;  // by depths, in a turn
  static constexpr double least_share = 0.005; // of the depth, in a step
  static constexpr double bending = 0.1;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_LINE_CENTERING_H
