// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_LOOP_LINKING_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_LOOP_LINKING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/union_find.h>
#include <CGAL/Reeb_graph/skeleton/internal/Graph_chains.h>
#include <CGAL/Reeb_graph/skeleton/internal/Skeleton_lines.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// A closed polygon on the surface, which no line of a skeleton meets, and the cone from a point over it. The linking number
// of a closed line with the polygon is the number of times that it crosses the cone upwards.
class Probe
{
public:
  explicit Probe(std::vector<Point> polygon) : polygon_(std::move(polygon)), box_(box_of(polygon_)) {}

  // The number of crossings of each polyline, by exact signs. Where something is not in general position, all points are moved
  // at random, by less than lines are away from the surface. There are none if the polygon has no size.
  std::vector<int> crossings(const std::vector<std::vector<Point>>& lines, const std::vector<Bbox_3>& boxes) const
  {
    std::uint64_t random = 20130617;
    const auto next_between = [&](double low, double high) {
      random = random * 6364136223846793005u + 1442695040888963407u;
      const double t = static_cast<double>(random >> 40) / static_cast<double>(1 << 24);
      return (1 - t) * low + t * high;
    };
    const auto near = [&](const Point& p, double share) {
      const double dx = share * (box_.xmax() - box_.xmin()), dy = share * (box_.ymax() - box_.ymin()),
                   dz = share * (box_.zmax() - box_.zmin());
      return Point(p.x() + next_between(-dx, dx), p.y() + next_between(-dy, dy), p.z() + next_between(-dz, dz));
    };
    const Point middle((box_.xmin() + box_.xmax()) / 2, (box_.ymin() + box_.ymax()) / 2,
                       (box_.zmin() + box_.zmax()) / 2);
    std::vector<Point> polygon = polygon_;
    for(int trial = 0; trial != 8; ++trial)
    {
      if(const auto result = crossings_of_cone(near(middle, 0.25), polygon, lines, boxes))
        return *result;
      for(std::size_t i = 0; i != polygon.size(); ++i)
        polygon[i] = near(polygon_[i], 1e-13);
    }
    return std::vector<int>(lines.size(), 0);
  }

private:
  static Bbox_3 box_of(const std::vector<Point>& points) { return CGAL::bbox_3(points.begin(), points.end()); }

  // None if something is not in general position.
  std::optional<std::vector<int>> crossings_of_cone(const Point& apex,
                                                    const std::vector<Point>& polygon,
                                                    const std::vector<std::vector<Point>>& lines,
                                                    const std::vector<Bbox_3>& boxes) const
  {
    std::vector<int> result(lines.size(), 0);
    for(std::size_t i = 0; i != lines.size(); ++i)
      for(std::size_t k = 1; k < lines[i].size() && do_overlap(boxes[i], box_); ++k)
      {
        const Point &p = lines[i][k - 1], &q = lines[i][k];
        const Bbox_3 box = p.bbox() + q.bbox();
        if(p == q || !do_overlap(box, box_))
          continue;
        for(std::size_t j = 0; j != polygon.size(); ++j)
        {
          const Point &u = polygon[j], &v = polygon[(j + 1) % polygon.size()];
          if(u == v || !do_overlap(box, apex.bbox() + u.bbox() + v.bbox()))
            continue;
          const std::optional<int> sign = crossing(p, q, apex, u, v);
          if(!sign)
            return std::nullopt;
          result[i] += *sign;
        }
      }
    return result;
  }

  static std::optional<int> crossing(const Point& p, const Point& q, const Point& a, const Point& b, const Point& c)
  {
    const int from = orientation(a, b, c, p), to = orientation(a, b, c, q);
    if(from == 0 || to == 0)
      return std::nullopt;
    if(from == to)
      return 0;
    const std::array<int, 3> sides = {orientation(p, q, a, b), orientation(p, q, b, c), orientation(p, q, c, a)};
    const auto [least, greatest] = std::minmax_element(sides.begin(), sides.end());
    if(*least == -1 && *greatest == 1)
      return 0;
    if(*least == 0 || *greatest == 0)
      return std::nullopt;
    return to;
  }

  std::vector<Point> polygon_;
  Bbox_3 box_;
};

// Whether the loops of a skeleton are independent in the solid that the surface bounds. They are if the linking numbers with
// curves on the surface are.
class Loop_linking
{
public:
  typedef std::pair<Index, int> Step; // a chain, and 1 or -1 for its direction
  typedef std::vector<Step> Cycle;

  explicit Loop_linking(const Graph_chains& chains) : chains_(chains)
  {
    find_tree();
    for(const Index chain : closing_)
    {
      cycles_.push_back(cycle_through(chain));
      for(const Step& step : cycles_.back())
        is_on_cycle_[step.first] = true;
    }
  }

  const std::vector<Cycle>& cycles() const { return cycles_; }
  const std::vector<Index>& closing_chains() const { return closing_; } // one of each cycle
  bool is_on_cycle(Index chain) const { return is_on_cycle_[chain]; }
  const std::vector<bool>& chains_on_cycles() const { return is_on_cycle_; }

  // The cycles that depend on the ones before them.
  std::vector<std::size_t> dependent_cycles(const std::vector<Probe>& probes,
                                            const std::vector<std::vector<Point>>& polylines) const
  {
    std::vector<Row> all = rows(probes, polylines);
    std::vector<std::size_t> result;
    std::map<std::size_t, Row> pivots; // by column, with 1 there
    for(std::size_t i = 0; i != all.size(); ++i)
      if(!reduce(all[i], pivots))
        result.push_back(i);
    return result;
  }

  // The chains of cycles that do not wind once around the contour of their closing chain, the first probes, and around no other
  // one, and of all cycles that meet these.
  std::vector<bool> chains_of_bad_cycles(const std::vector<Probe>& probes,
                                         const std::vector<std::vector<Point>>& polylines) const
  {
    const std::vector<Row> all = rows(probes, polylines);
    std::vector<bool> is_bad(chains_.chains().size(), false), is_node_bad(arcs_of_.size(), false);
    const auto add = [&](Index chain) {
      is_bad[chain] = true;
      for(const Index end : chains_.chains()[chain].ends)
        is_node_bad[end] = true;
    };
    for(std::size_t i = 0; i != all.size(); ++i)
      if(all[i].size() != 1 || all[i].begin()->first != i)
        for(const auto& [chain, direction] : cycles_[i])
          add(chain);
    for(bool is_done = false; !is_done;)
    {
      is_done = true;
      for(Index chain = 0; chain != is_bad.size(); ++chain)
      {
        const auto& ends = chains_.chains()[chain].ends;
        if(is_bad[chain] || !is_on_cycle_[chain] || !(is_node_bad[ends[0]] || is_node_bad[ends[1]]))
          continue;
        add(chain);
        is_done = false;
      }
    }
    return is_bad;
  }

private:
  typedef std::map<std::size_t, std::int64_t> Row; // by column, modulo a prime number
  static constexpr std::int64_t prime = 2147483647;

  std::vector<Row> rows(const std::vector<Probe>& probes, const std::vector<std::vector<Point>>& polylines) const
  {
    std::vector<Row> rows(cycles_.size());
    std::vector<Bbox_3> boxes;
    for(const std::vector<Point>& line : polylines)
      boxes.push_back(CGAL::bbox_3(line.begin(), line.end()));
    for(std::size_t column = 0; column != probes.size(); ++column)
    {
      const std::vector<int> crossings = probes[column].crossings(polylines, boxes);
      for(std::size_t i = 0; i != cycles_.size(); ++i)
      {
        int sum = 0;
        for(const auto& [chain, direction] : cycles_[i])
          sum += direction * crossings[chain];
        if(sum != 0)
          rows[i][column] = (sum + prime) % prime;
      }
    }
    return rows;
  }

  void find_tree()
  {
    const auto& all = chains_.chains();
    is_on_cycle_.assign(all.size(), false);
    Index number_of_nodes = 0;
    for(const auto& chain : all)
      number_of_nodes = (std::max)({number_of_nodes, chain.ends[0] + 1, chain.ends[1] + 1});
    arcs_of_.resize(number_of_nodes);
    Disjoint_sets<Index> parts(number_of_nodes);
    for(Index chain = 0; chain != all.size(); ++chain)
    {
      const auto& ends = all[chain].ends;
      if(parts.find(ends[0]) == parts.find(ends[1]))
      {
        closing_.push_back(chain);
        continue;
      }
      parts.unite(ends[0], ends[1]);
      for(const Index end : ends)
        arcs_of_[end].push_back(chain);
    }
  }

  // The chain, and then the path in the tree from its end to its begin.
  Cycle cycle_through(Index closing) const
  {
    const auto& all = chains_.chains();
    const Index begin = all[closing].ends[0], end = all[closing].ends[1];
    std::map<Index, Step> reached = {{begin, {no_index, 0}}};
    std::vector<Index> queue = {begin};
    for(std::size_t i = 0; i != queue.size() && reached.count(end) == 0; ++i)
      for(const Index chain : arcs_of_[queue[i]])
      {
        const auto& ends = all[chain].ends;
        const bool is_upwards = ends[1] == queue[i]; // on the way back
        const Index other = ends[is_upwards ? 0 : 1];
        if(reached.insert({other, {chain, is_upwards ? -1 : 1}}).second)
          queue.push_back(other);
      }
    Cycle cycle = {{closing, 1}};
    for(Index node = end; node != begin;)
    {
      const auto [chain, direction] = reached.at(node);
      cycle.push_back({chain, -direction});
      node = all[chain].ends[direction == 1 ? 0 : 1];
    }
    return cycle;
  }

  // Adds a row to independent ones, unless it depends on them.
  static bool reduce(Row& row, std::map<std::size_t, Row>& pivots)
  {
    while(!row.empty())
    {
      const auto [column, value] = *row.begin();
      const auto pivot = pivots.find(column);
      if(pivot == pivots.end())
      {
        const std::int64_t factor = inverse(value);
        for(auto& entry : row)
          entry.second = entry.second * factor % prime;
        pivots[column] = std::move(row);
        return true;
      }
      for(const auto& [other, entry] : pivot->second)
        if((row[other] = (row[other] + (prime - value) * entry) % prime) == 0)
          row.erase(other);
    }
    return false;
  }

  static std::int64_t inverse(std::int64_t value)
  {
    std::int64_t result = 1;
    for(std::int64_t exponent = prime - 2; exponent != 0; exponent /= 2, value = value * value % prime)
      if(exponent % 2 == 1)
        result = result * value % prime;
    return result;
  }

  const Graph_chains& chains_;
  std::vector<std::vector<Index>> arcs_of_; // of the tree, by node
  std::vector<Index> closing_;
  std::vector<Cycle> cycles_;
  std::vector<bool> is_on_cycle_;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_LOOP_LINKING_H
