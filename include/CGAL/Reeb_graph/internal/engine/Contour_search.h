// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_CONTOUR_SEARCH_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_CONTOUR_SEARCH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/complex/Simplicial_complex.h>
#include <CGAL/Reeb_graph/internal/engine/contour_tracing.h>

#include <array>
#include <cstddef>
#include <unordered_set>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The other edge that the level crosses of a triangle at a crossed edge.
template <class IsBelow>
Edge_index crossed_edge_beside(const Simplicial_complex& complex,
                               Edge_index crossed_edge,
                               Triangle_index triangle,
                               const IsBelow& is_below)
{
  // The edges of a triangle are those of its vertices 0 and 1, 0 and 2, 1 and 2.
  constexpr std::array<std::array<std::size_t, 2>, 3> other_edges = {{{1, 2}, {0, 2}, {0, 1}}};
  const std::array<Edge_index, 3>& edges = complex.edges_of(triangle);
  const std::size_t place = edges[0] == crossed_edge ? 0 : (edges[1] == crossed_edge ? 1 : 2);
  // The first of the two other edges has the lower end of the crossed one; it is not crossed if the apex is on the side
  // of that end.
  const bool is_apex_with_end =
    is_below(complex.vertices_of(triangle)[2 - place]) == is_below(complex.lower_end(crossed_edge));
  return edges[other_edges[place][is_apex_with_end ? 1 : 0]];
}

// Calls visit(edge, triangle) for the other edge of each triangle at a crossed edge that the level crosses.
template <class IsBelow, class Visit>
void for_each_crossed_edge_beside(const Simplicial_complex& complex,
                                  Edge_index crossed_edge,
                                  const IsBelow& is_below,
                                  const Visit& visit)
{
  for(const Triangle_index triangle : complex.triangles_of(crossed_edge))
    visit(crossed_edge_beside(complex, crossed_edge, triangle, is_below), triangle);
}

// Traces a contour of a complex, which is any connected graph there.
template <class IsBelow, class Visit>
void trace_contour(const Simplicial_complex& complex, Halfedge_index start, const IsBelow& is_below, const Visit& visit)
{
  std::unordered_set<Number> found = {edge_of(start).number()};
  Plain_vector<Edge_index> pending = {edge_of(start)};
  visit(start);
  while(!pending.empty())
  {
    const Edge_index edge = pending.back();
    pending.pop_back();
    for_each_crossed_edge_beside(complex, edge, is_below, [&](Edge_index beside, Triangle_index) {
      if(!found.insert(beside.number()).second)
        return;
      visit(even_halfedge(beside));
      pending.push_back(beside);
    });
  }
}

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

// Searches contours of one level of a complex, a triangle by turns. Edges keep the name of the search that has found
// them, so no search has to forget anything.
class Contour_search : public Contours_by_turns<Contour_search>
{
public:
  explicit Contour_search(const Simplicial_complex& complex)
    : complex_(complex),
      searches_(complex.number_of_edges(), 0)
  {}

  template <class IsBelow>
  void begin(const Plain_vector<Halfedge_index>& starts, const IsBelow& is_below)
  {
    first_search_ += static_cast<Number>(pending_.size());
    pending_.assign(starts.size(), {});
    for(std::size_t i = 0; i != starts.size(); ++i)
      reach(i, edge_of(starts[i]), is_below);
  }

  // Looks at one triangle, if there is one left.
  template <class IsBelow>
  bool go_on(std::size_t i, const IsBelow& is_below)
  {
    Plain_vector<Pending_edge>& pending = pending_[i];
    while(!pending.empty() && pending.back().number_of_triangles == complex_.triangles_of(pending.back().edge).size())
      pending.pop_back();
    if(pending.empty())
      return false;
    const Edge_index edge = pending.back().edge;
    const Triangle_index triangle = complex_.triangles_of(edge).begin()[pending.back().number_of_triangles++];
    reach(i, crossed_edge_beside(complex_, edge, triangle, is_below), is_below);
    return true;
  }

  bool is_border_reached(std::size_t) const { return false; } // Where a complex has its border is not asked.

private:
  // An edge that has been found, and how many of its triangles have been looked at.
  struct Pending_edge
  {
    Edge_index edge;
    Number number_of_triangles;
  };

  // An edge belongs to a contour now. If it does already, and to another one, these two are one.
  template <class IsBelow>
  void reach(std::size_t i, Edge_index edge, const IsBelow& is_below)
  {
    if(searches_[edge] < first_search_)
    {
      searches_[edge] = first_search_ + static_cast<Number>(i);
      const Halfedge_index even = even_halfedge(edge);
      crossed_edges_[i].push_back(is_below(complex_.source(even)) ? even : opposite_of(even));
      pending_[i].push_back({edge, 0});
      return;
    }
    const std::size_t other = leader(searches_[edge] - first_search_);
    if(other != i && is_open(other))
      join(i, other);
  }

  void join(std::size_t i, std::size_t other)
  {
    const bool is_smaller = crossed_edges_[i].size() < crossed_edges_[other].size();
    const std::size_t large = is_smaller ? other : i, small = is_smaller ? i : other;
    crossed_edges_[large].append(crossed_edges_[small].begin(), crossed_edges_[small].end());
    pending_[large].append(pending_[small].begin(), pending_[small].end());
    pending_[small] = {};
    close(small, large);
  }

  const Simplicial_complex& complex_;
  Indexed_vector<Edge_index, Number> searches_; // the number of the start from which the edge has been found
  Number first_search_ = 1;
  std::vector<Plain_vector<Pending_edge>> pending_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_CONTOUR_SEARCH_H
