// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_COMPONENT_FILLING_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_COMPONENT_FILLING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/skeleton/internal/Contour_shape.h>

#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

typedef CGAL::Surface_mesh<Point> Mesh;

// A border that has been filled by a fan of triangles around its centroid, the apex.
struct Filled_border
{
  Mesh::Vertex_index apex;
  std::vector<Mesh::Vertex_index> rim;
  double radius;
};

// A connected component of a surface, without borders: the given vertices come first, in their order, then the apexes.
struct Filled_component
{
  Mesh mesh;
  std::vector<Index> given; // the numbers of its vertices in the surface
  std::vector<Filled_border> borders;
  std::vector<double> values; // of the given vertices; empty if distances are to be used

  bool is_apex(Mesh::Vertex_index v) const { return v.idx() >= given.size(); }
};

// Makes the components of a checked surface, in the order of their first vertices. Vertices without faces are in none.
template <class Complex>
class Component_filling
{
public:
  Component_filling(const Complex& complex, const Indexed_vector<Vertex_index, Point>& points)
    : complex_(complex),
      points_(points)
  {
    local_vertices_.resize(complex.number_of_vertices());
    local_halfedges_.resize(complex.number_of_halfedges());
    component_of_.assign(complex.number_of_vertices(), no_index);
    label();
  }

  std::size_t number_of_components() const { return edges_.size(); }

  Filled_component make(std::size_t number)
  {
    Filled_component component;
    const std::vector<Edge_index>& edges = edges_[number];
    component.mesh.reserve(static_cast<Mesh::size_type>(given_[number].size()),
                           static_cast<Mesh::size_type>(edges.size()),
                           static_cast<Mesh::size_type>(2 * edges.size() / 3));
    for(const Index v : given_[number])
      local_vertices_[Vertex_index(v)] = component.mesh.add_vertex(points_[Vertex_index(v)]);
    component.given = std::move(given_[number]);
    for(const Edge_index e : edges)
      add_edge(component.mesh, e);
    for(const Edge_index e : edges)
      for(const Halfedge_index h : {even_halfedge(e), opposite_of(even_halfedge(e))})
      {
        if(complex_.has_triangle(h) && is_unset(component.mesh, h))
          add_triangle(component.mesh, h);
      }
    for(const Edge_index e : edges)
      for(const Halfedge_index h : {even_halfedge(e), opposite_of(even_halfedge(e))})
      {
        if(!complex_.has_triangle(h) && is_unset(component.mesh, h))
          component.borders.push_back(fill(component.mesh, h));
      }
    return component;
  }

private:
  void label()
  {
    std::vector<Vertex_index> queue;
    Index number_of_components = 0;
    for(const Vertex_index root : complex_.vertices())
    {
      if(component_of_[root] != no_index || !complex_.has_vertex(root) || complex_.first_halfedge(root) == no_index)
        continue;
      component_of_[root] = number_of_components;
      queue.assign(1, root);
      for(std::size_t i = 0; i != queue.size(); ++i)
        complex_.for_each_edge_around(queue[i], [&](Vertex_index neighbor, Halfedge_index) {
          if(component_of_[neighbor] == no_index)
          {
            component_of_[neighbor] = number_of_components;
            queue.push_back(neighbor);
          }
        });
      ++number_of_components;
    }
    given_.resize(number_of_components);
    edges_.resize(number_of_components);
    for(const Vertex_index v : complex_.vertices())
      if(component_of_[v] != no_index)
        given_[component_of_[v]].push_back(v.number());
    for(const Edge_index e : Index_range<Edge_index>(complex_.number_of_edges()))
      if(complex_.is_on_triangle(e))
        edges_[component_of_[complex_.target(even_halfedge(e))]].push_back(e);
  }

  void add_edge(Mesh& mesh, Edge_index e)
  {
    const Halfedge_index even = even_halfedge(e), odd = opposite_of(even);
    const auto h = mesh.add_edge();
    local_halfedges_[even] = h;
    local_halfedges_[odd] = mesh.opposite(h);
    mesh.set_target(h, local_vertices_[complex_.target(even)]);
    mesh.set_target(mesh.opposite(h), local_vertices_[complex_.target(odd)]);
  }

  bool is_unset(const Mesh& mesh, Halfedge_index h) const
  {
    return mesh.face(local_halfedges_[h]) == Mesh::null_face();
  }

  static void add_face(Mesh& mesh, Mesh::Halfedge_index a, Mesh::Halfedge_index b, Mesh::Halfedge_index c)
  {
    const auto face = mesh.add_face();
    mesh.set_halfedge(face, a);
    for(const auto& [h, next] : {std::make_pair(a, b), std::make_pair(b, c), std::make_pair(c, a)})
    {
      mesh.set_face(h, face);
      mesh.set_next(h, next);
      mesh.set_halfedge(mesh.target(h), h);
    }
  }

  void add_triangle(Mesh& mesh, Halfedge_index h)
  {
    const Halfedge_index second = complex_.next(h), third = complex_.next(second);
    add_face(mesh, local_halfedges_[h], local_halfedges_[second], local_halfedges_[third]);
  }

  // The halfedge of the border that begins where one ends.
  Halfedge_index next_on_border(Halfedge_index h) const
  {
    Halfedge_index leaving = opposite_of(h);
    while(complex_.has_triangle(leaving))
      leaving = opposite_of(complex_.previous(leaving));
    return leaving;
  }

  Filled_border fill(Mesh& mesh, Halfedge_index first)
  {
    std::vector<Mesh::Halfedge_index> cycle;
    std::vector<Point> polygon;
    Filled_border border;
    Halfedge_index h = first;
    do
    {
      cycle.push_back(local_halfedges_[h]);
      border.rim.push_back(mesh.source(cycle.back()));
      polygon.push_back(mesh.point(border.rim.back()));
      h = next_on_border(h);
    } while(h != first);
    const Contour_shape shape = measure(polygon);
    border.radius = shape.radius();
    border.apex = mesh.add_vertex(shape.centroid);
    std::vector<Mesh::Halfedge_index> spokes; // to the apex
    for(const auto v : border.rim)
    {
      spokes.push_back(mesh.add_edge());
      mesh.set_target(spokes.back(), border.apex);
      mesh.set_target(mesh.opposite(spokes.back()), v);
    }
    for(std::size_t i = 0; i != cycle.size(); ++i)
      add_face(mesh, cycle[i], spokes[(i + 1) % cycle.size()], mesh.opposite(spokes[i]));
    return border;
  }

  const Complex& complex_;
  const Indexed_vector<Vertex_index, Point>& points_;
  Indexed_vector<Vertex_index, Mesh::Vertex_index> local_vertices_;
  Indexed_vector<Halfedge_index, Mesh::Halfedge_index> local_halfedges_;
  Indexed_vector<Vertex_index, Index> component_of_;
  std::vector<std::vector<Index>> given_; // by component
  std::vector<std::vector<Edge_index>> edges_;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_COMPONENT_FILLING_H
