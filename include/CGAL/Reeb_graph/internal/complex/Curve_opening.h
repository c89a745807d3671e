// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_CURVE_OPENING_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_CURVE_OPENING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <functional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Parts a mesh along curves, which may branch, and end anywhere. The left side of a curve keeps the halfedges, which
// become border, and the vertices; the other side gets copies of both. Of several fans on the left of curves, the first
// one keeps a vertex. Edges of the border stay as they are, and so does an edge that is a curve by itself and ends at no
// other one and at no border: its two copies would have the same ends.
template <class Mesh, class VertexPointMap, class Visitor>
class Curve_opening
{
  typedef boost::graph_traits<Mesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;

public:
  // Calls on_vertex(old, created) before the visitor.
  Curve_opening(
    Mesh& mesh,
    const VertexPointMap& vertex_point_map,
    Visitor& visitor,
    std::function<void(vertex_descriptor, vertex_descriptor)> on_vertex = [](vertex_descriptor, vertex_descriptor) {})
    : mesh_(mesh),
      vertex_point_map_(vertex_point_map),
      visitor_(visitor),
      on_vertex_(std::move(on_vertex))
  {}

  // Opens one curve, which has the members `halfedges` and `lower_halfedges` of a `Reeb_graph::Curve`. One call is
  // allowed.
  template <class Curve>
  void operator()(Curve& curve)
  {
    std::vector<Curve> curves;
    curves.push_back(std::move(curve));
    (*this)(curves);
    curve = std::move(curves.front());
  }

  template <class Curve>
  void operator()(std::vector<Curve>& curves)
  {
    count_edges(curves);
    for(Curve& curve : curves)
    {
      first_added_.push_back(added_.size());
      if(!is_alone(curve))
        add_edges(curve);
    }
    first_added_.push_back(added_.size());
    for(const auto* borders : {&kept_, &added_})
      for(const halfedge_descriptor h : *borders)
        link(h);
    part_fans(kept_, 0, kept_.size());
    for(std::size_t i = 0; i != curves.size(); ++i)
      part_fans(added_, first_added_[i], first_added_[i + 1]);
  }

private:
  // Counts the edges of curves at each of their vertices.
  template <class Curves>
  void count_edges(const Curves& curves)
  {
    for(const auto& curve : curves)
      for(const halfedge_descriptor h : curve.halfedges)
        for(const vertex_descriptor v : {source(h, mesh_), target(h, mesh_)})
          ++number_of_edges_[v];
  }

  template <class Curve>
  bool is_alone(const Curve& curve) const
  {
    const halfedge_descriptor h = curve.halfedges.front();
    const auto is_end = [&](vertex_descriptor v) { return number_of_edges_.at(v) == 1 && !is_border(v, mesh_); };
    return curve.halfedges.size() == 1 && is_end(source(h, mesh_)) && is_end(target(h, mesh_));
  }

  // Gives the faces on the right of the curve new edges in the place of those of the curve.
  template <class Curve>
  void add_edges(Curve& curve)
  {
    for(std::size_t i = 0; i != curve.halfedges.size(); ++i)
    {
      const halfedge_descriptor old = opposite(curve.halfedges[i], mesh_);
      if(is_border(edge(old, mesh_), mesh_))
        continue;
      const halfedge_descriptor inner = halfedge(add_edge(mesh_), mesh_), outer = opposite(inner, mesh_);
      kept_.push_back(old);
      added_.push_back(outer);
      set_target(inner, target(old, mesh_), mesh_);
      set_target(outer, source(old, mesh_), mesh_);
      set_next(prev(old, mesh_), inner, mesh_);
      set_next(inner, next(old, mesh_), mesh_);
      set_face(inner, face(old, mesh_), mesh_);
      if(halfedge(face(old, mesh_), mesh_) == old) // so that faces begin where they did
        set_halfedge(face(old, mesh_), inner, mesh_);
      set_face(old, Graph_traits::null_face(), mesh_);
      set_face(outer, Graph_traits::null_face(), mesh_);
      curve.lower_halfedges[i] = inner;
      visitor_.halfedge_duplicated(old, inner);
    }
  }

  // Links a border halfedge with those before and behind it, on the other sides of the fans of faces at its ends.
  void link(halfedge_descriptor border)
  {
    halfedge_descriptor following = opposite(border, mesh_), preceding = following;
    while(!is_border(following, mesh_))
      following = opposite(prev(following, mesh_), mesh_);
    while(!is_border(preceding, mesh_))
      preceding = opposite(next(preceding, mesh_), mesh_);
    set_next(border, following, mesh_);
    set_next(preceding, border, mesh_);
  }

  // Gives a vertex to each fan at some of the halfedges that have become border.
  void part_fans(const std::vector<halfedge_descriptor>& borders, std::size_t begin, std::size_t end)
  {
    for(std::size_t i = begin; i != end; ++i)
      part_fan(borders[i]);
    for(std::size_t i = begin; i != end; ++i)
      part_fan(prev(borders[i], mesh_));
  }

  // The fan is the one that the border enters: the first one keeps the vertex.
  void part_fan(halfedge_descriptor border)
  {
    if(!done_fans_.insert(border).second)
      return;
    const vertex_descriptor old = target(border, mesh_);
    if(kept_vertices_.insert(old).second)
    {
      set_halfedge(old, border, mesh_);
      return;
    }
    const vertex_descriptor created = add_vertex(mesh_);
    const auto point = get(vertex_point_map_, old);
    put(vertex_point_map_, created, point);
    set_halfedge(created, border, mesh_);
    halfedge_descriptor h = border;
    do
    {
      set_target(h, created, mesh_);
      h = opposite(next(h, mesh_), mesh_);
    } while(h != border);
    on_vertex_(old, created);
    visitor_.vertex_duplicated(old, created);
  }

  Mesh& mesh_;
  const VertexPointMap& vertex_point_map_;
  Visitor& visitor_;
  const std::function<void(vertex_descriptor, vertex_descriptor)> on_vertex_;
  std::unordered_map<vertex_descriptor, std::size_t> number_of_edges_; // of curves
  std::unordered_set<vertex_descriptor> kept_vertices_;                // by a fan
  std::unordered_set<halfedge_descriptor> done_fans_;                  // by the border that enters the fan
  std::vector<halfedge_descriptor> kept_, added_; // border halfedges on the left and on the right of the curves
  std::vector<std::size_t> first_added_;          // positions in `added_`, by curve, and one more
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_CURVE_OPENING_H
