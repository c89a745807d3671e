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
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/space/Projected_segments.h>
#include <CGAL/Reeb_graph/skeleton/internal/Branch_pruning.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_tree.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// Whether the loops of a skeleton are independent in the solid that the surface bounds. They are if the linking numbers with
// curves on the surface are.
class Loop_linking
{
public:
  typedef std::pair<Index, int> Step; // a chain, and 1 or -1 for its direction
  typedef std::vector<Step> Cycle;

  // By the nodes at the ends of chains.
  explicit Loop_linking(const std::vector<std::array<Index, 2>>& ends) : ends_(ends)
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

  typedef std::vector<Point> Line;
  typedef std::map<std::size_t, std::int64_t> Row; // by column, modulo a prime number

  // The linking numbers of each cycle with closed polygons on the surface: the sums of its signed crossings over them. The lines of
  // chains must not meet the polygons.
  std::vector<Row> linking_numbers(const std::vector<Line>& lines, const std::vector<Line>& polygons) const
  {
    Segments over, under;
    for(Index chain = 0; chain != lines.size(); ++chain)
      if(is_on_cycle_[chain])
        over.add(lines[chain], chain);
    for(Index column = 0; column != polygons.size(); ++column)
    {
      Line closed = polygons[column];
      closed.push_back(closed.front());
      under.add(closed, column);
    }
    typedef std::vector<std::map<std::size_t, int>> Crossings; // by chain, then by polygon
    const auto crossings = in_general_direction<Crossings>([&](const std::array<double, 3>& direction) {
      Crossings result(lines.size());
      const Projected_segments view(direction);
      view.for_each_pair_that_may_cross(over.all, under.all, [&](const auto& a, const auto& b) {
        if(const int sign = view.crossing_over(a.segment, b.segment))
          result[a.piece][b.piece] += sign;
      });
      return result;
    });
    std::vector<Row> rows(cycles_.size());
    for(std::size_t i = 0; i != cycles_.size() && !crossings.empty(); ++i)
    {
      std::map<std::size_t, int> sums;
      for(const auto& [chain, direction] : cycles_[i])
        for(const auto& [column, number] : crossings[chain])
          sums[column] += direction * number;
      for(const auto& [column, sum] : sums)
        if(sum != 0)
          rows[i][column] = (sum + prime) % prime;
    }
    return rows;
  }

  // The number of cycles that depend on the ones before them.
  static std::size_t number_of_dependent(std::vector<Row> rows)
  {
    std::size_t result = 0;
    std::map<std::size_t, Row> pivots; // by column, with 1 there
    for(Row& row : rows)
      result += reduce(row, pivots) ? 0 : 1;
    return result;
  }

  // The chains of cycles that do not wind once around the contour of their closing chain, in the first columns, and around no
  // other one, and of all cycles that meet these.
  std::vector<bool> chains_of_bad_cycles(const std::vector<Row>& all) const
  {
    std::vector<bool> is_bad(ends_.size(), false), is_node_bad(arcs_of_.size(), false);
    const auto add = [&](Index chain) {
      is_bad[chain] = true;
      for(const Index end : ends_[chain])
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
        const auto& ends = ends_[chain];
        if(is_bad[chain] || !is_on_cycle_[chain] || !(is_node_bad[ends[0]] || is_node_bad[ends[1]]))
          continue;
        add(chain);
        is_done = false;
      }
    }
    return is_bad;
  }

private:
  static constexpr std::int64_t prime = 2147483647;

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

    void add(const Line& line, Index piece)
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
    is_on_cycle_.assign(all.size(), false);
    Index number_of_nodes = 0;
    for(const auto& ends : all)
      number_of_nodes = (std::max)({number_of_nodes, ends[0] + 1, ends[1] + 1});
    arcs_of_.resize(number_of_nodes);
    Disjoint_sets<Index> parts(number_of_nodes);
    for(Index chain = 0; chain != all.size(); ++chain)
    {
      const auto& ends = all[chain];
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
    Cycle cycle = {{closing, 1}};
    for(Index node = end; node != begin;)
    {
      const auto [chain, direction] = reached.at(node);
      cycle.push_back({chain, -direction});
      node = all[chain][direction == 1 ? 0 : 1];
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

  const std::vector<std::array<Index, 2>> ends_;
  std::vector<std::vector<Index>> arcs_of_; // of the tree, by node
  std::vector<Index> closing_;
  std::vector<Cycle> cycles_;
  std::vector<bool> is_on_cycle_;
};

// Leads lines of loops as the surface leads, where centers of contours have left the family of contours: beneath the faces
// along their arcs.
class Loop_tracing
{
public:
  struct Path
  {
    Mesh::Face_index begin;
    std::vector<Mesh::Halfedge_index> steps; // the halfedges through which faces are left
  };

  Loop_tracing(const Sampled_graph& graph, const Graph_chains& chains, const Surface_tree& tree)
    : graph_(graph),
      chains_(chains),
      tree_(tree)
  {}

  // A face at the vertex of a node.
  Mesh::Face_index face_of(Index node) const { return tree_.face_at(graph_.vertex(node)); }

  // A path of faces from that of the node at one end of a chain to that at the other one. A wound one goes once around a contour
  // of its first arc.
  Path path(Index chain, bool is_wound) const
  {
    const auto& [ends, pieces, length] = chains_.chains()[chain];
    Path result = {face_of(ends[0]), {}};
    for(const auto& piece : pieces)
    {
      const Path next = path_of_arc(piece.arc, piece.is_upwards, is_wound && &piece == &pieces.front());
      turn(graph_.vertex(graph_.ends(piece.arc)[piece.is_upwards ? 0 : 1]), last_face(result), next.begin,
           result.steps);
      result.steps.insert(result.steps.end(), next.steps.begin(), next.steps.end());
    }
    turn(graph_.vertex(ends[1]), last_face(result), face_of(ends[1]), result.steps);
    return result;
  }

  // A closed curve on the surface along a cycle of chains.
  std::vector<Point> curve(const Loop_linking::Cycle& cycle) const
  {
    std::vector<Point> result;
    for(const auto& [chain, direction] : cycle)
    {
      const Path along = path(chain, false);
      std::vector<Point> points = {center(along.begin)};
      for(const auto h : along.steps)
      {
        points.push_back(CGAL::midpoint(mesh().point(mesh().source(h)), mesh().point(mesh().target(h))));
        points.push_back(center(mesh().face(mesh().opposite(h))));
      }
      if(direction == -1)
        std::reverse(points.begin(), points.end());
      result.insert(result.end(), points.begin(), points.end());
    }
    return result;
  }

private:
  const Mesh& mesh() const { return graph_.mesh(); }
  Mesh::Face_index last_face(const Path& path) const
  {
    return path.steps.empty() ? path.begin : mesh().face(mesh().opposite(path.steps.back()));
  }

  Point center(Mesh::Face_index f) const
  {
    const auto h = mesh().halfedge(f);
    return CGAL::centroid(mesh().point(mesh().source(h)), mesh().point(mesh().target(h)),
                          mesh().point(mesh().target(mesh().next(h))));
  }

  // Around a vertex from one face to another one.
  void turn(Mesh::Vertex_index v,
            Mesh::Face_index from,
            Mesh::Face_index to,
            std::vector<Mesh::Halfedge_index>& path) const
  {
    auto h = mesh().halfedge(from);
    while(mesh().source(h) != v)
      h = mesh().next(h);
    for(; mesh().face(h) != to; h = mesh().next(mesh().opposite(h)))
      path.push_back(h);
  }

  Path path_of_arc(Index arc, bool is_upwards, bool is_wound) const
  {
    const auto [chain, contour] = graph_.chain_and_end(arc);
    Path result = {mesh().face(chain.front()), {}};
    for(std::size_t i = 1; i < chain.size(); ++i)
      turn_to(chain[i - 1], chain[i], result.steps);
    // Along the contour below the upper end to that.
    const auto top = graph_.vertex(graph_.ends(arc)[1]);
    auto step = std::find(contour.begin(), contour.end(), chain.back());
    for(std::size_t rest = is_wound ? contour.size() : 0; rest != 0 || mesh().target(*step) != top; rest -= rest != 0)
    {
      result.steps.push_back(*step);
      if(++step == contour.end())
        step = contour.begin();
    }
    if(is_upwards)
      return result;
    result.begin = last_face(result);
    std::reverse(result.steps.begin(), result.steps.end());
    for(auto& h : result.steps)
      h = mesh().opposite(h);
    return result;
  }

  // From the face of one halfedge around its target to that of the next one.
  void turn_to(Mesh::Halfedge_index h, Mesh::Halfedge_index next, std::vector<Mesh::Halfedge_index>& steps) const
  {
    for(auto g = mesh().next(h); g != next; g = mesh().next(mesh().opposite(g)))
      steps.push_back(g);
  }

  const Sampled_graph& graph_;
  const Graph_chains& chains_;
  const Surface_tree& tree_;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_LOOP_LINKING_H
