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
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/space/Projected_segments.h>
#include <CGAL/Reeb_graph/skeleton/internal/Component_filling.h>
#include <CGAL/Reeb_graph/skeleton/internal/Loop_group.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

typedef std::vector<Point> Polyline;

// The loops of a skeleton, as cycles of chains, and around which curves on the surface they wind.
class Loop_linking
{
public:
  typedef std::pair<Index, int> Step; // a number, and 1 or -1 for a direction

  // By the nodes at the ends of chains.
  explicit Loop_linking(const std::vector<std::array<Index, 2>>& ends) : ends_(ends)
  {
    find_tree();
    cycles_of_.resize(ends_.size());
    for(Index cycle = 0; cycle != closing_.size(); ++cycle)
      for(const auto& [passed, direction] : cycle_through(closing_[cycle]))
        cycles_of_[passed].push_back({cycle, direction});
  }

  const std::vector<Index>& closing_chains() const { return closing_; } // one of each cycle
  bool is_on_cycle(Index chain) const { return !cycles_of_[chain].empty(); }
  const std::vector<Step>& cycles_of(Index chain) const { return cycles_of_[chain]; }

  // A row for each line, if it is not empty: its signed crossings over closed polygons, which it must not meet.
  std::vector<Row> crossings(const std::vector<Polyline>& lines,
                             const std::vector<Polyline>& curves,
                             const Stage_progress& progress) const
  {
    Segments over, under;
    for(Index line = 0; line != lines.size(); ++line)
      over.add(lines[line], line);
    for(Index curve = 0; curve != curves.size(); ++curve)
    {
      under.add(curves[curve], curve);
      under.add({curves[curve].back(), curves[curve].front()}, curve);
    }
    typedef std::map<std::array<Index, 2>, int> Crossings; // by line and curve
    const auto all = in_general_direction<Crossings>([&](const std::array<double, 3>& direction) {
      Crossings result;
      std::size_t number = 0;
      const Projected_segments view(direction);
      view.for_each_pair_that_may_cross(over.all, under.all, [&](const auto& a, const auto& b) {
        if(++number % 4096 == 0)
          progress(0); // so that it can be cancelled
        if(const int sign = view.crossing_over(a.segment, b.segment))
          result[{a.piece, b.piece}] += sign;
      });
      return result;
    });
    std::vector<Row> rows(lines.size());
    for(const auto& [pair, number] : all)
      if(number != 0)
        rows[pair[0]][pair[1]] = number;
    return rows;
  }

  // The linking numbers of each cycle: the sums of what its chains add.
  std::vector<Row> linking_numbers(const std::vector<Row>& of_chains) const
  {
    std::vector<Row> rows(closing_.size());
    for(Index chain = 0; chain != of_chains.size(); ++chain)
      for(const auto& [cycle, direction] : cycles_of_[chain])
        add_multiple(rows[cycle], of_chains[chain], direction);
    return rows;
  }

  std::vector<Index> chains_on_cycles() const
  {
    std::vector<Index> result;
    for(Index chain = 0; chain != cycles_of_.size(); ++chain)
      if(is_on_cycle(chain))
        result.push_back(chain);
    return result;
  }

private:
  // Segments with the number of their line.
  struct Segments
  {
    struct Located
    {
      Projected_segments::Segment segment;
      Index piece;
    };
    std::deque<std::array<double, 3>> points;
    std::vector<Located> all;

    void add(const Polyline& line, Index piece)
    {
      for(std::size_t i = 0; i != line.size(); ++i)
      {
        if(i != 0 && line[i] == line[i - 1])
          continue;
        points.push_back({line[i].x(), line[i].y(), line[i].z()});
        const auto end = [&](std::size_t k) { return Mean_point{{&points[points.size() - k], nullptr, nullptr}, 1}; };
        if(i != 0)
          all.push_back({{end(2), end(1)}, piece});
      }
    }
  };

  void find_tree()
  {
    const auto& all = ends_;
    Index number_of_nodes = 0;
    for(const auto& ends : all)
      number_of_nodes = (std::max)({number_of_nodes, ends[0] + 1, ends[1] + 1});
    arcs_of_.resize(number_of_nodes);
    Disjoint_sets<Index> parts(number_of_nodes);
    for(Index chain = 0; chain != all.size(); ++chain)
    {
      const auto& ends = all[chain];
      if(!parts.unite(ends[0], ends[1]))
      {
        closing_.push_back(chain);
        continue;
      }
      for(const Index end : ends)
        arcs_of_[end].push_back(chain);
    }
  }

  // The chain, and then the path in the tree from its end to its begin.
  std::vector<Step> cycle_through(Index closing) const
  {
    const auto& all = ends_;
    const Index begin = all[closing][0], end = all[closing][1];
    std::map<Index, Step> reached = {{begin, {no_index, 0}}};
    std::vector<Index> queue = {begin};
    for(std::size_t i = 0; i != queue.size() && reached.count(end) == 0; ++i)
      for(const Index chain : arcs_of_[queue[i]])
      {
        const auto& ends = all[chain];
        const bool is_upwards = ends[1] == queue[i]; // on the way back
        const Index other = ends[is_upwards ? 0 : 1];
        if(reached.insert({other, {chain, is_upwards ? -1 : 1}}).second)
          queue.push_back(other);
      }
    std::vector<Step> cycle = {{closing, 1}};
    for(Index node = end; node != begin;)
    {
      const auto [chain, direction] = reached.at(node);
      cycle.push_back({chain, -direction});
      node = all[chain][direction == 1 ? 0 : 1];
    }
    return cycle;
  }

  const std::vector<std::array<Index, 2>> ends_;
  std::vector<std::vector<Index>> arcs_of_; // of the tree, by node
  std::vector<Index> closing_;
  std::vector<std::vector<Step>> cycles_of_; // by chain
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_LOOP_LINKING_H
