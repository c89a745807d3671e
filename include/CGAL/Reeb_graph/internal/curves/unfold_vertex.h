// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CURVES_UNFOLD_VERTEX_H
#define CGAL_REEB_GRAPH_INTERNAL_CURVES_UNFOLD_VERTEX_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/curves/Ranked_mesh.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Makes simple saddles of one multi-saddle inside of the surface, by refining its star.
//
// Let w_a .. w_b be the neighbors in one of its upper link sectors. The edge to each of them is split at a point p_i,
// with ranks just below the multi-saddle that fall from p_a to p_b. The link sector has then become lower and joins
// the two lower ones beside it; p_a, whose lower neighbors are w_{a-1} and p_{a+1}, or w_{a-1} and w_{b+1}, is a
// simple saddle; and p_{a+1} .. p_b are regular. Nothing changes for the other vertices.
template <class RankedMesh>
class Vertex_unfolding
{
  typedef typename RankedMesh::vertex_descriptor vertex_descriptor;
  typedef typename RankedMesh::halfedge_descriptor halfedge_descriptor;

  struct Sector
  {
    std::size_t first, size; // positions of the spokes
    Rank first_rank;         // makes the order independent of the spoke with which they begin
  };

public:
  explicit Vertex_unfolding(const RankedMesh& ranked) : ranked_(ranked), mesh_(ranked.mesh()) {}

  void operator()(vertex_descriptor v)
  {
    find_spokes(v);
    find_upper_sectors(v);
    if(sectors_.size() < 3)
      return;
    std::sort(sectors_.begin(), sectors_.end(), [](const Sector& a, const Sector& b) {
      return std::tie(a.size, a.first_rank) < std::tie(b.size, b.first_rank);
    });
    sectors_.resize(sectors_.size() - 2);
    Rank rank = ranked_.rank(v);
    for(const Sector& sector : sectors_)
    {
      split_spokes(v, sector, rank);
      split_faces(sector);
    }
  }

private:
  halfedge_descriptor& spoke(std::size_t i) { return spokes_[i % spokes_.size()]; }
  bool is_upper(vertex_descriptor v, std::size_t i) { return ranked_.rank(v) < ranked_.rank(target(spoke(i), mesh_)); }

  // The halfedges that leave the vertex, counterclockwise.
  void find_spokes(vertex_descriptor v)
  {
    spokes_.clear();
    const halfedge_descriptor first = opposite(halfedge(v, mesh_), mesh_);
    halfedge_descriptor h = first;
    do
    {
      spokes_.push_back(h);
      h = opposite(prev(h, mesh_), mesh_);
    } while(h != first);
  }

  void find_upper_sectors(vertex_descriptor v)
  {
    sectors_.clear();
    for(std::size_t i = 0; i != spokes_.size(); ++i)
    {
      const bool is_first = is_upper(v, i) && !is_upper(v, i + spokes_.size() - 1);
      if(!is_first)
        continue;
      Sector sector = {i, 1, ranked_.rank(target(spoke(i), mesh_))};
      while(is_upper(v, i + sector.size))
        ++sector.size;
      sectors_.push_back(sector);
    }
  }

  void split_spokes(vertex_descriptor v, const Sector& sector, Rank& rank)
  {
    for(std::size_t i = sector.first; i != sector.first + sector.size; ++i)
    {
      const double fraction = 1. / 3;
      const halfedge_descriptor first = ranked_.split_edge(spoke(i), v, target(spoke(i), mesh_), fraction);
      ranked_.place(target(first, mesh_), --rank, ranked_.value(v));
    }
  }

  // Splits the faces at a sector whose spokes have been split, and begin at their new vertices.
  void split_faces(const Sector& sector)
  {
    const std::size_t first = sector.first, last = sector.first + sector.size - 1;
    const halfedge_descriptor before = spoke(first + spokes_.size() - 1);
    ranked_.split_face(before, opposite(spoke(first), mesh_));
    for(std::size_t i = first; i != last; ++i)
    {
      const halfedge_descriptor to_next = opposite(spoke(i + 1), mesh_);
      ranked_.split_face(prev(spoke(i), mesh_), to_next);
      ranked_.triangulate(to_next);
    }
    ranked_.split_face(prev(spoke(last), mesh_), next(spoke(last), mesh_));
  }

  const RankedMesh& ranked_;
  typename RankedMesh::Mesh& mesh_;
  std::vector<halfedge_descriptor> spokes_;
  std::vector<Sector> sectors_;
};

// Makes simple saddles of all multi-saddles inside of the surface.
template <class RankedMesh>
void unfold_all_vertices(const RankedMesh& ranked)
{
  auto& mesh = ranked.mesh();
  std::vector<typename RankedMesh::vertex_descriptor> inner_vertices;
  for(const auto v : vertices(mesh))
  {
    const auto h = halfedge(v, mesh);
    const bool is_isolated = h == boost::graph_traits<typename RankedMesh::Mesh>::null_halfedge();
    if(!is_isolated && !is_border(v, mesh))
      inner_vertices.push_back(v);
  }
  Vertex_unfolding<RankedMesh> unfold(ranked);
  for(const auto v : inner_vertices)
    unfold(v);
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CURVES_UNFOLD_VERTEX_H
