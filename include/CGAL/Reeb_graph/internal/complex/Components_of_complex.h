// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_COMPONENTS_OF_COMPLEX_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_COMPONENTS_OF_COMPLEX_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/complex/Simplicial_complex.h>

#include <cstddef>

namespace CGAL::Reeb_graph::internal {

struct Complex_component_tag;
typedef Index_of<Complex_component_tag> Complex_component;

// The connected components of a complex, and what excludes loops of the Reeb graph in them, whatever the field is.
// Takes linear time.
class Components_of_complex
{
public:
  explicit Components_of_complex(const Simplicial_complex& complex)
    : complex_(complex),
      components_(complex.number_of_vertices(), no_index),
      is_edge_contracted_(complex.number_of_edges(), 0)
  {
    for(const Vertex_index v : complex.vertices())
    {
      if(components_[v] == no_index)
        add_component(v);
    }
    contract_edges();
    is_closed_.assign(number_of_components_, true);
    is_simply_connected_.assign(number_of_components_, true);
    for(const Edge_index edge : complex.edges())
    {
      const Complex_component component = components_[complex.lower_end(edge)];
      if(!complex.has_two_triangles(edge))
        is_closed_[component] = false;
      if(is_edge_contracted_[edge] == 0)
        is_simply_connected_[component] = false;
    }
  }

  // Whether each edge of the vertex's component has two triangles: contours are closed curves then.
  bool is_closed(Vertex_index vertex) const { return is_closed_[components_[vertex]]; }

  // Whether each closed path of the vertex's component has been found to be contractible. Then the graph has no loop
  // there, as it would be the image of a closed path that is not.
  bool is_simply_connected(Vertex_index vertex) const { return is_simply_connected_[components_[vertex]]; }

private:
  // Finds a component in breadth-first order. The edges over which vertices are found first are a spanning tree.
  void add_component(Vertex_index first)
  {
    const Complex_component component(number_of_components_++);
    components_[first] = component;
    Plain_vector<Vertex_index> found = {first};
    for(std::size_t i = 0; i != found.size(); ++i)
    {
      complex_.for_each_edge_around(found[i], [&](Vertex_index neighbor, Halfedge_index halfedge) {
        if(components_[neighbor] != no_index)
          return;
        components_[neighbor] = component;
        is_edge_contracted_[edge_of(halfedge)] = 1;
        found.push_back(neighbor);
      });
    }
  }

  // With the trees contracted, edges generate the fundamental groups, and triangles are their relations: an edge is
  // contractible if the other two edges of a triangle are.
  void contract_edges()
  {
    Plain_vector<Triangle_index> pending;
    for(const Triangle_index triangle : complex_.triangles())
    {
      pending.push_back(triangle);
      while(!pending.empty())
      {
        const Edge_index edge = last_edge(pending.back());
        pending.pop_back();
        if(edge == no_index)
          continue;
        is_edge_contracted_[edge] = 1;
        for(const Triangle_index beside : complex_.triangles_of(edge))
          pending.push_back(beside);
      }
    }
  }

  // The only edge of a triangle that has not been contracted, no_index if there is none or another one.
  Edge_index last_edge(Triangle_index triangle) const
  {
    Edge_index result = no_index;
    int number_of_edges = 0;
    for(const Edge_index edge : complex_.edges_of(triangle))
    {
      if(is_edge_contracted_[edge] != 0)
        continue;
      result = edge;
      ++number_of_edges;
    }
    return number_of_edges == 1 ? result : Edge_index(no_index);
  }

  const Simplicial_complex& complex_;
  Indexed_vector<Vertex_index, Complex_component> components_;
  Indexed_vector<Edge_index, unsigned char> is_edge_contracted_;
  std::size_t number_of_components_ = 0;
  Indexed_vector<Complex_component, bool> is_closed_;
  Indexed_vector<Complex_component, bool> is_simply_connected_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_COMPONENTS_OF_COMPLEX_H
