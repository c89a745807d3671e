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
#include <CGAL/Reeb_graph/skeleton/internal/Graph_chains.h>
#include <CGAL/Reeb_graph/skeleton/internal/Loop_group.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_ways.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <deque>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// Closed curves on a surface, as sums of polygons.
struct Surface_curves
{
  typedef std::pair<Index, int> Step; // a number, and 1 or -1 for a direction

  std::vector<std::vector<Point>> polygons;
  std::vector<std::vector<Step>> curves_of; // of each polygon

  // Adds a curve that is one polygon.
  void add(std::vector<Point> polygon)
  {
    polygon.push_back(polygon.front());
    curves_of.push_back({{static_cast<Index>(polygons.size()), 1}});
    polygons.push_back(std::move(polygon));
  }
};

// The loops of a skeleton, as cycles of chains, and around which curves on the surface they wind.
class Loop_linking
{
public:
  typedef Surface_curves::Step Step; // a chain
  typedef std::vector<Step> Cycle;
  typedef std::vector<Point> Line;

  // By the nodes at the ends of chains.
  explicit Loop_linking(const std::vector<std::array<Index, 2>>& ends) : ends_(ends)
  {
    find_tree();
    cycles_of_.resize(ends_.size());
    for(const Index chain : closing_)
    {
      const auto number = static_cast<Index>(cycles_.size());
      cycles_.push_back(cycle_through(chain));
      for(const auto& [passed, direction] : cycles_.back())
        cycles_of_[passed].push_back({number, direction});
    }
  }

  const std::vector<Cycle>& cycles() const { return cycles_; }
  const std::vector<Index>& closing_chains() const { return closing_; } // one of each cycle
  bool is_on_cycle(Index chain) const { return !cycles_of_[chain].empty(); }
  const std::vector<Step>& cycles_of(Index chain) const { return cycles_of_[chain]; }

  // The rows that the line of each chain adds to linking numbers with curves: its signed crossings over them. A chain can have no
  // line. The lines must not meet the polygons.
  std::vector<Row> crossings(const std::vector<Line>& lines,
                             const Surface_curves& curves,
                             const Stage_progress& progress) const
  {
    Segments over, under;
    for(Index chain = 0; chain != lines.size(); ++chain)
      if(is_on_cycle(chain))
        over.add(lines[chain], chain);
    for(Index polygon = 0; polygon != curves.polygons.size(); ++polygon)
      under.add(curves.polygons[polygon], polygon);
    typedef std::map<std::array<Index, 2>, int> Crossings; // by chain and polygon
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
      for(const auto& [curve, direction] : curves.curves_of[pair[1]])
        add_multiple(rows[pair[0]], {{curve, number}}, direction);
    return rows;
  }

  // The group that the loops generate, by what their chains add to linking numbers.
  Loop_group group(const std::vector<Row>& of_chains) const { return Loop_group(linking_numbers(of_chains)); }

  // The linking numbers of each cycle: the sums of what its chains add.
  std::vector<Row> linking_numbers(const std::vector<Row>& of_chains) const
  {
    std::vector<Row> rows(cycles_.size());
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

  const std::vector<std::array<Index, 2>> ends_;
  std::vector<std::vector<Index>> arcs_of_; // of the tree, by node
  std::vector<Index> closing_;
  std::vector<Cycle> cycles_;
  std::vector<std::vector<Step>> cycles_of_; // by chain
};

// Leads lines of loops as the surface leads, where centers of contours have left the family of contours: beneath the faces
// along their arcs.
class Loop_tracing
{
public:
  Loop_tracing(const Sampled_graph& graph, const Graph_chains& chains, const Surface_tree& tree)
    : graph_(graph),
      chains_(chains),
      tree_(tree)
  {}

  // A path of faces from that of the node at one end of a chain to that at the other one, which goes so many times around a
  // contour of its first arc.
  Face_path path(Index chain, int windings) const
  {
    const auto& [ends, pieces, length] = chains_.chains()[chain];
    Face_path result = {face_of(ends[0]), {}};
    for(const auto& piece : pieces)
    {
      const Face_path next = path_of_arc(piece.arc, piece.is_upwards, &piece == &pieces.front() ? windings : 0);
      turn(graph_.vertex(graph_.ends(piece.arc)[piece.is_upwards ? 0 : 1]), result.end(mesh()), next.begin,
           result.steps);
      result.steps.insert(result.steps.end(), next.steps.begin(), next.steps.end());
    }
    turn(graph_.vertex(ends[1]), result.end(mesh()), face_of(ends[1]), result.steps);
    return result;
  }

  // A contour of the longest arc of a chain, at a share of the way along that, in the direction in which paths wind.
  std::vector<Point> contour(Index chain, double share) const
  {
    const auto& pieces = chains_.chains()[chain].pieces;
    const auto size = [&](const auto& piece) {
      const auto& ends = graph_.ends(piece.arc);
      return graph_.value(ends[1]) - graph_.value(ends[0]);
    };
    const auto& longest =
      *std::max_element(pieces.begin(), pieces.end(), [&](const auto& p, const auto& q) { return size(p) < size(q); });
    std::vector<Point> points = graph_.contour_points(longest.arc, share);
    if(!longest.is_upwards)
      std::reverse(points.begin(), points.end());
    return points;
  }

  // A polygon on the surface along a chain.
  std::vector<Point> curve(Index chain) const
  {
    const Face_path along = path(chain, 0);
    std::vector<Point> points = {tree_.center(along.begin)};
    for(const auto h : along.steps)
    {
      points.push_back(CGAL::midpoint(mesh().point(mesh().source(h)), mesh().point(mesh().target(h))));
      points.push_back(tree_.center(mesh().face(mesh().opposite(h))));
    }
    return points;
  }

private:
  const Mesh& mesh() const { return graph_.mesh(); }
  Mesh::Face_index face_of(Index node) const { return mesh().face(mesh().halfedge(graph_.vertex(node))); }
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

  Face_path path_of_arc(Index arc, bool is_upwards, int windings) const
  {
    const auto [chain, contour] = graph_.chain_and_end(arc);
    Face_path result = {mesh().face(chain.front()), {}};
    for(std::size_t i = 1; i < chain.size(); ++i)
      turn_to(chain[i - 1], chain[i], result.steps);
    // Along the contour below the upper end to that.
    const auto top = graph_.vertex(graph_.ends(arc)[1]);
    const std::size_t size = contour.size();
    auto step = static_cast<std::size_t>(std::find(contour.begin(), contour.end(), chain.back()) - contour.begin());
    for(std::size_t i = 0; i != size * static_cast<std::size_t>(std::abs(windings)); ++i)
      result.steps.push_back(windings > 0 ? contour[(step + i) % size]
                                          : mesh().opposite(contour[(step + size - 1 - i % size) % size]));
    for(; mesh().target(contour[step]) != top; step = (step + 1) % size)
      result.steps.push_back(contour[step]);
    return is_upwards ? result : result.reversed(mesh());
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
