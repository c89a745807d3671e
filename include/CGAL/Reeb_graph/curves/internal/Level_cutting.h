// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_INTERNAL_LEVEL_CUTTING_H
#define CGAL_REEB_GRAPH_CURVES_INTERNAL_LEVEL_CUTTING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/internal/Ranked_mesh.h>
#include <CGAL/Reeb_graph/curves/internal/trace_edges.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The place of a value among ascending levels, as a rank: 2 i + 1 on level i, 2 i between level i - 1 and level i.
template <class Scalar, class Less>
Long_index rank_among_levels(const std::vector<Scalar>& levels, const Scalar& value, const Less& less)
{
  const auto level = std::lower_bound(levels.begin(), levels.end(), value, less);
  const bool is_on_level = level != levels.end() && !less(value, *level);
  return 2 * static_cast<Long_index>(level - levels.begin()) + (is_on_level ? 1 : 0);
}

// The levels strictly between two ranks, the lower one first: those from `first` on, before `last`.
struct Levels_between
{
  Levels_between(Long_index lower, Long_index upper) : first((lower + 1) / 2), last((std::max)(first, upper / 2)) {}

  static Long_index rank_of(Long_index level) { return 2 * level + 1; }
  std::size_t size() const { return last - first; }

  Long_index first, last;
};

// Refines a mesh so that levels become paths of edges: edges are split where they cross a level, and faces between these
// points and the vertices on levels. All vertices have ranks among the levels.
template <class RankedMesh>
class Level_cutting
{
  typedef typename RankedMesh::Mesh Mesh;
  typedef typename RankedMesh::vertex_descriptor vertex_descriptor;
  typedef typename RankedMesh::halfedge_descriptor halfedge_descriptor;
  typedef typename RankedMesh::edge_descriptor edge_descriptor;
  typedef typename RankedMesh::face_descriptor face_descriptor;

public:
  // A vertex that has been added, and the number of its level.
  struct Added_vertex
  {
    vertex_descriptor vertex;
    std::size_t level;
  };

  // The levels have numbers as values of the field have.
  Level_cutting(const RankedMesh& ranked, const std::vector<double>& levels)
    : ranked_(ranked),
      mesh_(ranked.mesh()),
      levels_(levels)
  {
    for(const edge_descriptor e : edges(mesh_))
    {
      const Levels_between levels_between = levels_of(e);
      if(levels_between.size() == 0)
        continue;
      crossed_edges_.push_back(e);
      number_of_points_ += levels_between.size();
      number_of_added_faces_ += levels_between.size() * (is_border(e, mesh_) ? 1 : 2);
    }
    for(const face_descriptor f : faces(mesh_))
    {
      const auto [lowest, highest] = ends_of(f);
      if(Levels_between(rank(lowest), rank(highest)).size() > 0)
        crossed_faces_.push_back(f);
    }
  }

  // Each point on an edge makes one triangle more of each face beside it.
  std::size_t number_of_added_faces() const { return number_of_added_faces_; }

  std::vector<Added_vertex> operator()(const Stage_progress& progress)
  {
    std::vector<Added_vertex> added;
    added.reserve(number_of_points_);
    for(std::size_t i = 0; i != crossed_edges_.size(); ++i)
    {
      progress.part(0, 0.4).report_step(i, crossed_edges_.size());
      split_edge(crossed_edges_[i], added);
    }
    for(std::size_t i = 0; i != crossed_faces_.size(); ++i)
    {
      progress.part(0.4, 1).report_step(i, crossed_faces_.size());
      split_face(crossed_faces_[i]);
    }
    return added;
  }

private:
  Long_index rank(halfedge_descriptor h) const { return ranked_.rank(target(h, mesh_)); }

  Levels_between levels_of(edge_descriptor e) const
  {
    const auto [lower, upper] = std::minmax({ranked_.rank(source(e, mesh_)), ranked_.rank(target(e, mesh_))});
    return Levels_between(lower, upper);
  }

  // The halfedges of a triangle, which may have been refined, that lead to a lowest and to a highest vertex.
  std::array<halfedge_descriptor, 2> ends_of(face_descriptor f) const
  {
    std::array<halfedge_descriptor, 2> ends = {halfedge(f, mesh_), halfedge(f, mesh_)};
    for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, mesh_), mesh_))
    {
      if(rank(h) < rank(ends[0]))
        ends[0] = h;
      if(rank(h) > rank(ends[1]))
        ends[1] = h;
    }
    return ends;
  }

  // Splits an edge from its lower end on, so that what is left of it is the upper part.
  void split_edge(edge_descriptor e, std::vector<Added_vertex>& added)
  {
    halfedge_descriptor h = halfedge(e, mesh_);
    if(ranked_.rank(source(h, mesh_)) > rank(h))
      h = opposite(h, mesh_);
    const vertex_descriptor lower = source(h, mesh_), upper = target(h, mesh_);
    const Levels_between levels_between = levels_of(e);
    for(Long_index level = levels_between.first; level != levels_between.last; ++level)
    {
      const double value = levels_[level];
      const halfedge_descriptor first =
        ranked_.split_edge(h, lower, upper, ranked_.crossing_fraction(lower, upper, value));
      ranked_.place(target(first, mesh_), Levels_between::rank_of(level), value);
      added.push_back({target(first, mesh_), static_cast<std::size_t>(level)});
    }
  }

  // Splits a triangle whose edges have been split. Two ways lead from a lowest to a highest corner, and each level
  // between them has one point on both. What is left below it is a polygon of up to five edges.
  void split_face(face_descriptor f)
  {
    const auto [lowest, highest] = ends_of(f);
    const Levels_between levels_between(rank(lowest), rank(highest));
    halfedge_descriptor left = next(lowest, mesh_), right = prev(lowest, mesh_), rest = left;
    for(Long_index level = levels_between.first; level != levels_between.last; ++level)
    {
      const Long_index wanted = Levels_between::rank_of(level);
      while(rank(left) != wanted)
        left = next(left, mesh_);
      while(rank(right) != wanted)
        right = prev(right, mesh_);
      rest = ranked_.split_face(right, left);
      ranked_.triangulate(opposite(rest, mesh_));
      left = next(rest, mesh_);
      right = prev(right, mesh_);
    }
    ranked_.triangulate(rest);
  }

  const RankedMesh& ranked_;
  Mesh& mesh_;
  const std::vector<double>& levels_;
  std::vector<edge_descriptor> crossed_edges_;
  std::vector<face_descriptor> crossed_faces_;
  std::size_t number_of_points_ = 0, number_of_added_faces_ = 0;
};

// Whether a face on the left of a halfedge of a level is higher than that, 1, or lower, -1. It is 0 beyond the border,
// and for a face in the level.
template <class RankedMesh>
int side_of_level(const RankedMesh& ranked, typename RankedMesh::halfedge_descriptor h)
{
  const auto& mesh = ranked.mesh();
  if(is_border(h, mesh))
    return 0;
  const Long_index level = ranked.rank(target(h, mesh)), third = ranked.rank(target(next(h, mesh), mesh));
  return (level < third ? 1 : 0) - (third < level ? 1 : 0);
}

// The curves of the levels of a refined mesh, those of a lower level first, with the higher side on the left of most
// edges.
template <class RankedMesh>
auto curves_of_levels(const RankedMesh& ranked, const std::vector<double>& levels)
{
  typedef typename RankedMesh::halfedge_descriptor halfedge_descriptor;
  auto& mesh = ranked.mesh();
  std::vector<typename RankedMesh::edge_descriptor> edges_of_curves;
  for(const auto e : edges(mesh))
  {
    const Long_index rank = ranked.rank(source(e, mesh));
    if(rank % 2 == 1 && rank == ranked.rank(target(e, mesh)))
      edges_of_curves.push_back(e);
  }
  auto paths = Edge_tracing(mesh)(edges_of_curves);
  const auto rank_of_path = [&](const auto& path) { return ranked.rank(target(path.front(), mesh)); };
  std::stable_sort(paths.begin(), paths.end(),
                   [&](const auto& a, const auto& b) { return rank_of_path(a) < rank_of_path(b); });
  std::vector<Curve<halfedge_descriptor>> curves;
  for(auto& path : paths)
  {
    long sides = 0;
    for(const halfedge_descriptor h : path)
      sides += side_of_level(ranked, h) - side_of_level(ranked, opposite(h, mesh));
    if(sides < 0)
    {
      std::reverse(path.begin(), path.end());
      for(halfedge_descriptor& h : path)
        h = opposite(h, mesh);
    }
    const double value = levels[rank_of_path(path) / 2];
    curves.push_back(make_curve(mesh, ranked.vertex_point_map(), std::move(path), value));
  }
  return curves;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_CURVES_INTERNAL_LEVEL_CUTTING_H
