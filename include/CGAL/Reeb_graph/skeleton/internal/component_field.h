// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_COMPONENT_FIELD_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_COMPONENT_FIELD_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/geodesic_field.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/skeleton/internal/Component_filling.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

typedef Mesh::Property_map<Mesh::Vertex_index, double> Field;

// The vertex that is farthest from the centroid of the surface.
inline Mesh::Vertex_index farthest_from_centroid(const Mesh& mesh)
{
  const Point origin = mesh.point(*mesh.vertices().begin());
  Vector sum = NULL_VECTOR;
  double area = 0;
  for(const auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    const Vector a = mesh.point(mesh.source(h)) - origin, b = mesh.point(mesh.target(h)) - origin,
                 c = mesh.point(mesh.target(mesh.next(h))) - origin;
    const double size = length(cross_product(b - a, c - a));
    sum = sum + size / 3 * (a + b + c);
    area += size;
  }
  const Point centroid = area > 0 ? origin + sum / area : origin;
  const auto range = mesh.vertices();
  return *std::max_element(range.begin(), range.end(), [&](auto u, auto v) {
    return squared_distance(centroid, mesh.point(u)) < squared_distance(centroid, mesh.point(v));
  });
}

// The vertex that is farthest from another one along edges.
inline Mesh::Vertex_index farthest_along_edges(const Mesh& mesh, Mesh::Vertex_index from)
{
  typedef std::pair<double, Mesh::Vertex_index> Entry;
  std::vector<double> distances(mesh.num_vertices(), std::numeric_limits<double>::infinity());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  distances[from] = 0;
  queue.push({0, from});
  Mesh::Vertex_index last = from;
  while(!queue.empty())
  {
    const auto [reached, v] = queue.top();
    queue.pop();
    if(reached > distances[v])
      continue;
    last = v;
    const auto first = mesh.halfedge(v);
    auto h = first;
    do // The halfedges end at v.
    {
      const auto u = mesh.source(h);
      if(const double old = distances[u]; reached < old)
        if(const double next = reached + distance(mesh.point(v), mesh.point(u)); next < old)
        {
          distances[u] = next;
          queue.push({next, u});
        }
      h = mesh.opposite(mesh.next(h));
    } while(h != first);
  }
  return last;
}

// The apex of the border that a vertex is on, or else the vertex.
inline Mesh::Vertex_index apex_beside(const Filled_component& component, Mesh::Vertex_index v)
{
  const auto first = component.mesh.halfedge(v);
  auto h = first;
  do
  {
    if(component.is_apex(component.mesh.source(h)))
      return component.mesh.source(h);
    h = component.mesh.opposite(component.mesh.next(h));
  } while(h != first);
  return v;
}

// Makes the apex of a border a leaf of the graph: a maximum, or, where the surface rises from the border, a minimum.
inline void raise_apex(const Filled_component& component, const Filled_border& border, bool may_be_minimum, Field field)
{
  const Mesh& mesh = component.mesh;
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest, rise = 0;
  for(const auto v : border.rim)
  {
    lowest = (std::min)(lowest, field[v]);
    highest = (std::max)(highest, field[v]);
    const auto first = mesh.halfedge(v);
    auto h = first;
    do
    {
      if(mesh.source(h) != border.apex)
        rise += field[mesh.source(h)] - field[v];
      h = mesh.opposite(mesh.next(h));
    } while(h != first);
  }
  const double step = border.radius > 0 ? border.radius : 1;
  field[border.apex] = may_be_minimum && rise > 0 ? lowest - step : highest + step;
}

// Writes the distances from the tip of a component, and returns the tip. Borders are leaves, if that is wanted.
inline Mesh::Vertex_index write_distances(Filled_component& component,
                                          bool are_borders_ends,
                                          Field field,
                                          const Stage_progress& progress)
{
  Mesh& mesh = component.mesh;
  progress(0);
  auto tip = farthest_along_edges(mesh, farthest_from_centroid(mesh));
  progress(0.15);
  tip = farthest_along_edges(mesh, tip);
  if(are_borders_ends)
    tip = apex_beside(component, tip);
  progress(0.3);
  compute_geodesic_field(mesh, field, std::array<Mesh::Vertex_index, 1>{tip},
                         parameters::callback(progress.part(0.3, 1).callback()));
  for(const Filled_border& border : component.borders)
    if(are_borders_ends && border.apex != tip)
      raise_apex(component, border, false, field);
  return tip;
}

// Writes the given values, and those of the apexes: the mean of the border, if that is to be no end.
inline void write_values(const Filled_component& component, bool are_borders_ends, Field field)
{
  for(std::size_t i = 0; i != component.values.size(); ++i)
    field[Mesh::Vertex_index(static_cast<Mesh::size_type>(i))] = component.values[i];
  const auto set_mean = [&](const Filled_border& border) {
    double sum = 0;
    for(const auto v : border.rim)
      sum += field[v] / static_cast<double>(border.rim.size());
    field[border.apex] = sum;
  };
  std::for_each(component.seams.begin(), component.seams.end(), set_mean);
  for(const Filled_border& border : component.borders)
    if(are_borders_ends)
      raise_apex(component, border, true, field);
    else
      set_mean(border);
}

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_COMPONENT_FIELD_H
