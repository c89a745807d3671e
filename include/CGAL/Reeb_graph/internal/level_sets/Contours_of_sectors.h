// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_LEVEL_SETS_CONTOURS_OF_SECTORS_H
#define CGAL_REEB_GRAPH_INTERNAL_LEVEL_SETS_CONTOURS_OF_SECTORS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/base/Plain_vector.h>
#include <CGAL/Reeb_graph/internal/base/Side.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/level_sets/Offline_connectivity.h>
#include <CGAL/Reeb_graph/internal/mesh/Simplicial_complex.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Finds which lower sectors of vertices are in one contour just below their vertex. The level sets are a graph that
// changes while the level rises: its nodes are the edges that cross the level, and a triangle joins two of them, first
// those at its lowest vertex, and above its middle vertex those at its highest one. (S. Parsa, A deterministic
// O(m log m) time algorithm for the Reeb graph, 2013, where links are replaced one by one.)
template <class Order>
class Contours_of_sectors
{
public:
  // The vertices have to ascend.
  Contours_of_sectors(const Simplicial_complex& complex,
                      const Order& order,
                      const Swept_vertices& critical_vertices,
                      const Plain_vector<Swept_index>& vertices)
    : complex_(complex),
      order_(order),
      critical_vertices_(critical_vertices),
      vertices_(vertices)
  {}

  // Sets by lower sector of the vertices: the name of its contour, among those of its vertex. Components of the complex
  // in which none of the vertices in question is can be left out: is_left_out(vertex).
  template <class IsLeftOut>
  void operator()(const IsLeftOut& is_left_out, Indexed_vector<Sector_index, Number>& contours)
  {
    if(vertices_.empty())
      return;
    find_times(is_left_out);
    Plain_vector<Graph_node> questions;
    Plain_vector<Number> first_questions;
    for(const Swept_index i : vertices_)
    {
      first_questions.push_back(static_cast<Number>(questions.size()));
      for(const Sector_index sector : critical_vertices_.sectors(i, Side::LOWER))
        questions.push_back(Graph_node(edge_of(critical_vertices_.sector(Side::LOWER, sector).edge).number()));
    }
    first_questions.push_back(static_cast<Number>(questions.size()));

    Offline_connectivity connectivity(questions, first_questions);
    const Plain_vector<Graph_node> components = connectivity(complex_.number_of_edges(), find_links());
    number_of_steps_ = connectivity.number_of_steps();
    auto component = components.begin();
    for(const Swept_index i : vertices_)
      for(const Sector_index sector : critical_vertices_.sectors(i, Side::LOWER))
        contours[sector] = (component++)->number();
  }

  std::size_t number_of_steps() const { return number_of_steps_; }

private:
  // The time of a vertex is how many of the vertices in question are not higher: an edge crosses the level just below
  // one of these from the time of its lower end to that of its higher end. What is left out stays at time 0.
  template <class IsLeftOut>
  void find_times(const IsLeftOut& is_left_out)
  {
    times_.renew(complex_.number_of_vertices(), 0);
    for(const Vertex_index v : complex_.vertices())
    {
      if(is_left_out(v))
        continue;
      const auto is_not_higher = [&](Swept_index i) { return !order_(v, critical_vertices_.vertex(i)); };
      times_[v] = static_cast<Number>(std::partition_point(vertices_.begin(), vertices_.end(), is_not_higher)
                                      - vertices_.begin());
    }
  }

  // A triangle whose edges cross none of the levels in question has no link.
  Plain_vector<Timed_link> find_links() const
  {
    Plain_vector<Timed_link> links;
    for(const Triangle_index triangle : complex_.triangles())
    {
      const std::array<Vertex_index, 3>& v = complex_.vertices_of(triangle);
      const std::array<Number, 3> times = {times_[v[0]], times_[v[1]], times_[v[2]]};
      if(times[0] == times[1] && times[1] == times[2])
        continue;
      std::array<std::size_t, 3> places = {0, 1, 2};
      std::sort(places.begin(), places.end(), [&](std::size_t i, std::size_t j) { return times[i] < times[j]; });
      add_links(triangle, times, places, links);
    }
    return links;
  }

  void add_links(Triangle_index triangle,
                 const std::array<Number, 3>& times,
                 const std::array<std::size_t, 3>& places,
                 Plain_vector<Timed_link>& links) const
  {
    const std::array<Edge_index, 3>& edges = complex_.edges_of(triangle);
    // Edges are in the order of the vertices that they do not have, from the last one.
    const auto edge_opposite = [&](std::size_t place) { return Graph_node(edges[2 - place].number()); };
    const Number low = times[places[0]], middle = times[places[1]], high = times[places[2]];
    const Graph_node outer = edge_opposite(places[1]);
    if(low != middle)
      links.push_back({outer, edge_opposite(places[2]), low, middle});
    if(middle != high)
      links.push_back({outer, edge_opposite(places[0]), middle, high});
  }

  const Simplicial_complex& complex_;
  const Order& order_;
  const Swept_vertices& critical_vertices_;
  const Plain_vector<Swept_index>& vertices_;
  Indexed_vector<Vertex_index, Number> times_;
  std::size_t number_of_steps_ = 0;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_LEVEL_SETS_CONTOURS_OF_SECTORS_H
