// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_INTERNAL_CURVE_OPENING_H
#define CGAL_REEB_GRAPH_CURVES_INTERNAL_CURVE_OPENING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/internal/Ranked_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Parts a mesh along one curve after the other. The higher side keeps the vertices of the curve, and the halfedges that
// have become its border; the lower side gets copies of both.
template <class RankedMesh>
class Curve_opening
{
  typedef typename RankedMesh::Mesh Mesh;
  typedef typename RankedMesh::vertex_descriptor vertex_descriptor;
  typedef typename RankedMesh::halfedge_descriptor halfedge_descriptor;

public:
  explicit Curve_opening(const RankedMesh& ranked) : ranked_(ranked), mesh_(ranked.mesh()) {}

  void operator()(Curve<halfedge_descriptor>& curve)
  {
    remember_borders(curve);
    add_edges(curve);
    link_borders(curve);
    add_vertices(curve);
  }

private:
  // Keeps the border halfedges that lead to the ends of a curve from border to border.
  void remember_borders(const Curve<halfedge_descriptor>& curve)
  {
    if(curve.is_closed)
      return;
    const auto border_at = [&](halfedge_descriptor h) {
      while(!is_border(h, mesh_))
        h = opposite(next(h, mesh_), mesh_);
      return h;
    };
    to_start_ = border_at(opposite(curve.halfedges.front(), mesh_));
    to_end_ = border_at(curve.halfedges.back());
  }

  // Gives the faces below the curve new edges in the place of those of the curve.
  void add_edges(Curve<halfedge_descriptor>& curve)
  {
    added_.clear();
    for(std::size_t i = 0; i != curve.halfedges.size(); ++i)
    {
      const halfedge_descriptor old = opposite(curve.halfedges[i], mesh_);
      const halfedge_descriptor inner = halfedge(add_edge(mesh_), mesh_);
      added_.push_back(opposite(inner, mesh_));
      set_target(inner, target(old, mesh_), mesh_);
      set_target(added_.back(), source(old, mesh_), mesh_);
      set_next(prev(old, mesh_), inner, mesh_);
      set_next(inner, next(old, mesh_), mesh_);
      set_face(inner, face(old, mesh_), mesh_);
      set_halfedge(face(old, mesh_), inner, mesh_);
      set_face(old, boost::graph_traits<Mesh>::null_face(), mesh_);
      set_face(added_.back(), boost::graph_traits<Mesh>::null_face(), mesh_);
      curve.lower_halfedges[i] = inner;
      ranked_.visitor().halfedge_duplicated(old, inner);
    }
  }

  void link_borders(const Curve<halfedge_descriptor>& curve)
  {
    const auto old = [&](std::size_t i) { return opposite(curve.halfedges[i], mesh_); };
    const std::size_t last = curve.halfedges.size() - 1;
    for(std::size_t i = 0; i != last; ++i)
    {
      set_next(old(i + 1), old(i), mesh_);
      set_next(added_[i], added_[i + 1], mesh_);
    }
    if(curve.is_closed)
    {
      set_next(old(0), old(last), mesh_);
      set_next(added_[last], added_[0], mesh_);
      return;
    }
    const halfedge_descriptor from_start = next(to_start_, mesh_), from_end = next(to_end_, mesh_);
    set_next(to_start_, added_[0], mesh_);
    set_next(old(0), from_start, mesh_);
    set_next(added_[last], from_end, mesh_);
    set_next(to_end_, old(last), mesh_);
  }

  void add_vertices(const Curve<halfedge_descriptor>& curve)
  {
    for(const halfedge_descriptor h : added_)
      add_vertex_at(h);
    if(!curve.is_closed)
      add_vertex_at(prev(added_.front(), mesh_));
    for(const halfedge_descriptor h : curve.halfedges)
      set_halfedge(source(h, mesh_), opposite(h, mesh_), mesh_);
    if(!curve.is_closed)
      set_halfedge(target(to_end_, mesh_), to_end_, mesh_);
  }

  void add_vertex_at(halfedge_descriptor border)
  {
    const vertex_descriptor old = target(border, mesh_), created = add_vertex(mesh_);
    const auto point = get(ranked_.vertex_point_map(), old);
    put(ranked_.vertex_point_map(), created, point);
    set_halfedge(created, border, mesh_);
    halfedge_descriptor h = border;
    do
    {
      set_target(h, created, mesh_);
      h = opposite(next(h, mesh_), mesh_);
    } while(h != border);
    ranked_.visitor().vertex_duplicated(old, created);
  }

  const RankedMesh& ranked_;
  Mesh& mesh_;
  std::vector<halfedge_descriptor> added_; // border halfedges of the lower side
  halfedge_descriptor to_start_, to_end_;  // border halfedges that lead to the ends of the curve
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_CURVES_INTERNAL_CURVE_OPENING_H
