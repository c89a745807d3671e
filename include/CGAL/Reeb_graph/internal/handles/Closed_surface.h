// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_HANDLES_CLOSED_SURFACE_H
#define CGAL_REEB_GRAPH_INTERNAL_HANDLES_CLOSED_SURFACE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/point_map.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A closed walk: consecutive halfedges.
typedef std::vector<Index> Halfedge_walk;

// A triangle mesh as arrays, closed: each border cycle is filled by a fan around a new vertex, its apex. The halfedges
// of an edge are 2e and 2e + 1. Loops never pass an apex, so its place does not matter.
struct Closed_surface
{
  typedef std::array<double, 3> Point;

  std::vector<Point> points;       // by vertex
  std::vector<Index> target, next; // by halfedge
  std::vector<Index> face;         // by halfedge
  std::vector<Index> outgoing;     // a halfedge that leaves a vertex; no_index if there is none
  std::vector<Index> halfedge;     // one of each face
  Index number_of_given_vertices = 0, number_of_given_halfedges = 0;
  std::vector<Halfedge_walk> border_cycles; // with the surface on the left

  static Index opposite(Index h) { return h ^ 1; }
  Index source(Index h) const { return target[h ^ 1]; }
  Index previous(Index h) const { return next[next[h]]; }
  // The next halfedge that leaves the same vertex, counterclockwise.
  Index turned(Index h) const { return opposite(previous(h)); }
  bool is_apex(Index v) const { return v >= number_of_given_vertices; }
  bool is_given(Index h) const { return h < number_of_given_halfedges; }

  double length(Index h) const
  {
    const Point &p = points[source(h)], &q = points[target[h]];
    return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
  }
  double length(const Halfedge_walk& walk) const
  {
    double sum = 0;
    for(const Index h : walk)
      sum += length(h);
    return sum;
  }
};

// Makes the closed surface of a mesh that has been checked, and keeps the descriptors of its halfedges.
template <class Mesh>
class Surface_closing
{
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::property_map<Mesh, dynamic_halfedge_property_t<Index>>::const_type Number_map;

public:
  template <class PointMap>
  Surface_closing(const Mesh& mesh, const PointMap& point_map)
    : mesh_(mesh),
      number_map_(get(dynamic_halfedge_property_t<Index>(), mesh))
  {
    for(const auto e : edges(mesh))
      for(const halfedge_descriptor h : {halfedge(e, mesh), opposite(halfedge(e, mesh), mesh)})
      {
        put(number_map_, h, static_cast<Index>(halfedges_.size()));
        halfedges_.push_back(h);
      }
    surface_.number_of_given_halfedges = checked_index(halfedges_.size());
    checked_index(2 * halfedges_.size());
    read(point_map);
    close();
    number_faces();
  }

  Closed_surface& surface() { return surface_; }
  const std::vector<halfedge_descriptor>& halfedges() const { return halfedges_; } // those given
  Index number(halfedge_descriptor h) const { return get(number_map_, h); }

private:
  template <class PointMap>
  void read(const PointMap& point_map)
  {
    const auto vertex_number_map = get(dynamic_vertex_property_t<Index>(), mesh_);
    for(const auto v : vertices(mesh_))
    {
      put(vertex_number_map, v, static_cast<Index>(surface_.points.size()));
      const auto& point = get(point_map, v);
      surface_.points.push_back({CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z())});
      for(const double coordinate : surface_.points.back())
        if(!std::isfinite(coordinate))
          throw Non_finite_point_error(surface_.points.size() - 1);
    }
    surface_.number_of_given_vertices = checked_index(surface_.points.size());
    surface_.target.reserve(halfedges_.size());
    surface_.next.reserve(halfedges_.size());
    for(const halfedge_descriptor h : halfedges_)
    {
      surface_.target.push_back(get(vertex_number_map, target(h, mesh_)));
      surface_.next.push_back(number(next(h, mesh_)));
    }
  }

  void close()
  {
    std::vector<bool> is_closed(halfedges_.size(), false);
    for(Index h = 0; h != surface_.number_of_given_halfedges; ++h)
    {
      if(!is_closed[h] && is_border(halfedges_[h], mesh_))
        fill(h, is_closed);
    }
  }

  // Fills the hole that a border halfedge belongs to.
  void fill(Index first, std::vector<bool>& is_closed)
  {
    Halfedge_walk cycle;
    for(Index h = first; !is_closed[h]; h = surface_.next[h])
    {
      is_closed[h] = true;
      cycle.push_back(h);
    }
    const Index apex = static_cast<Index>(surface_.points.size());
    surface_.points.push_back(surface_.points[surface_.target[first]]);
    const Index first_spoke = static_cast<Index>(surface_.next.size()), size = static_cast<Index>(cycle.size());
    for(Index i = 0; i != size; ++i)
    {
      surface_.target.push_back(apex);
      surface_.target.push_back(surface_.source(cycle[i]));
      surface_.next.push_back(no_index); // set by the face before
      surface_.next.push_back(cycle[i]);
    }
    for(Index i = 0; i != size; ++i)
    {
      const Index next_to_apex = first_spoke + 2 * ((i + 1) % size);
      surface_.next[cycle[i]] = next_to_apex;
      surface_.next[next_to_apex] = first_spoke + 2 * i + 1;
    }
    Halfedge_walk border;
    for(auto h = cycle.rbegin(); h != cycle.rend(); ++h)
      border.push_back(Closed_surface::opposite(*h));
    surface_.border_cycles.push_back(border);
  }

  void number_faces()
  {
    surface_.face.assign(surface_.next.size(), no_index);
    surface_.outgoing.assign(surface_.points.size(), no_index);
    for(Index h = 0; h != surface_.next.size(); ++h)
    {
      surface_.outgoing[surface_.source(h)] = h;
      if(surface_.face[h] != no_index)
        continue;
      const Index face = static_cast<Index>(surface_.halfedge.size());
      surface_.halfedge.push_back(h);
      surface_.face[h] = surface_.face[surface_.next[h]] = surface_.face[surface_.previous(h)] = face;
    }
  }

  const Mesh& mesh_;
  Number_map number_map_;
  std::vector<halfedge_descriptor> halfedges_;
  Closed_surface surface_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_HANDLES_CLOSED_SURFACE_H
