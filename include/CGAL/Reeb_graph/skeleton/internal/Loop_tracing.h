// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_LOOP_TRACING_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_LOOP_TRACING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/skeleton/internal/Graph_chains.h>
#include <CGAL/Reeb_graph/skeleton/internal/Loop_linking.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_tree.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

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

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_LOOP_TRACING_H
