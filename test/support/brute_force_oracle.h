// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_BRUTE_FORCE_ORACLE_H
#define CGAL_REEB_GRAPH_TEST_BRUTE_FORCE_ORACLE_H

#include "oracle_parts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

// The Reeb graph by definition: the contours of all levels between two consecutive vertices, each from scratch. Slow,
// and nothing in common with the package.
namespace brute_force_oracle {
using oracle_parts::none;

// Edge number i joins the corners number i and (i + 1) % 3. Two triangles are adjacent where they have an edge in
// common; two edges may join the same two vertices.
struct Triangle
{
  std::array<std::size_t, 3> vertices;
  std::array<std::size_t, 3> edges;
};

// the triangles of a simplicial complex, in which the vertices name the edge
inline std::vector<Triangle> make_triangles(const std::vector<std::array<std::size_t, 3>>& vertex_triples)
{
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> edges;
  std::vector<Triangle> triangles;
  for(const auto& t : vertex_triples)
  {
    Triangle triangle = {t, {}};
    for(int i = 0; i < 3; ++i)
      triangle.edges[i] = edges.emplace(std::minmax(t[i], t[(i + 1) % 3]), edges.size()).first->second;
    triangles.push_back(triangle);
  }
  return triangles;
}

struct Oracle_arc
{
  std::size_t lower, upper; // vertices
};

class Oracle
{
public:
  std::vector<std::size_t> order; // the vertices in the total order
  std::vector<std::size_t> rank;  // of each vertex in it

  // by vertex
  std::vector<std::size_t> contours_below, contours_above; // how many touch the vertex
  std::vector<std::size_t> lower_link_sectors, upper_link_sectors;
  std::vector<std::size_t> arc_of_vertex; // none at a node

  std::vector<Oracle_arc> arcs; // in no particular order

  // by level: level k is just above the vertex order[k]
  std::vector<std::size_t> number_of_contours;
  std::vector<std::vector<std::size_t>> arc_of_edge; // by edge, none if it does not cross the level

  template <class Scalar>
  Oracle(std::size_t number_of_vertices,
         const std::vector<Triangle>& triangles,
         const std::vector<Scalar>& values,
         bool keeps_degree_two_nodes)
    : order(oracle_parts::order_by_value(values)),
      rank(oracle_parts::ranks_in(order)),
      triangles_(triangles),
      edges_of_vertex_(number_of_vertices)
  {
    for(const Triangle& t : triangles)
      for(int i = 0; i < 3; ++i)
      {
        number_of_edges_ = std::max(number_of_edges_, t.edges[i] + 1);
        edges_of_vertex_[t.vertices[i]].insert({t.edges[i], t.edges[(i + 2) % 3]});
      }
    count_link_sectors();
    sweep(keeps_degree_two_nodes);
  }

  bool is_node(std::size_t v) const { return arc_of_vertex[v] == none; }

  bool is_critical(std::size_t v) const { return lower_link_sectors[v] != 1 || upper_link_sectors[v] != 1; }

private:
  // A partition of some edges: none for the other ones, and the same edge for all those of a class.
  typedef std::vector<std::size_t> Partition;

  static std::size_t find(Partition& partition, std::size_t edge)
  {
    while(partition[edge] != edge)
      edge = partition[edge] = partition[partition[edge]];
    return edge;
  }

  static void add(Partition& partition, std::size_t edge)
  {
    if(partition[edge] == none)
      partition[edge] = edge;
  }

  static void unite(Partition& partition, std::size_t edge, std::size_t other)
  {
    partition[find(partition, edge)] = find(partition, other);
  }

  // the connected components of the edges that join a vertex of rank <= k to one of rank > k
  Partition contours_of_level(std::size_t k) const
  {
    Partition contours(number_of_edges_, none);
    for(const Triangle& t : triangles_)
    {
      std::size_t crossing_edge = none;
      for(int i = 0; i < 3; ++i)
      {
        if((rank[t.vertices[i]] <= k) == (rank[t.vertices[(i + 1) % 3]] <= k))
          continue;
        add(contours, t.edges[i]);
        if(crossing_edge != none)
          unite(contours, crossing_edge, t.edges[i]);
        crossing_edge = t.edges[i];
      }
    }
    for(std::size_t edge = 0; edge < number_of_edges_; ++edge)
      if(contours[edge] != none)
        contours[edge] = find(contours, edge);
    return contours;
  }

  // In the link of a vertex, the edges at the vertex are points, and the triangles at it are edges.
  void count_link_sectors()
  {
    for(std::size_t v = 0; v < rank.size(); ++v)
      for(bool is_upper : {false, true})
      {
        std::map<std::size_t, std::set<std::size_t>> sectors; // neighbours in that part of the link
        for(const Triangle& t : triangles_)
          for(int i = 0; i < 3; ++i)
          {
            if(t.vertices[i] != v)
              continue;
            const bool is_next_in = (rank[t.vertices[(i + 1) % 3]] > rank[v]) == is_upper;
            const bool is_previous_in = (rank[t.vertices[(i + 2) % 3]] > rank[v]) == is_upper;
            const std::size_t next = t.edges[i], previous = t.edges[(i + 2) % 3];
            if(is_next_in)
              sectors[next];
            if(is_previous_in)
              sectors[previous];
            if(is_next_in && is_previous_in)
            {
              sectors[next].insert(previous);
              sectors[previous].insert(next);
            }
          }
        (is_upper ? upper_link_sectors : lower_link_sectors).push_back(count_components(std::move(sectors)));
      }
  }

  static std::size_t count_components(std::map<std::size_t, std::set<std::size_t>> neighbours)
  {
    std::size_t number_of_components = 0;
    for(; !neighbours.empty(); ++number_of_components)
    {
      std::set<std::size_t> front = {neighbours.begin()->first};
      while(!front.empty())
      {
        const std::size_t point = *front.begin();
        front.erase(front.begin());
        const auto found = neighbours.find(point);
        if(found == neighbours.end())
          continue;
        front.insert(found->second.begin(), found->second.end());
        neighbours.erase(found);
      }
    }
    return number_of_components;
  }

  void sweep(bool keeps_degree_two_nodes)
  {
    Partition arcs_below(number_of_edges_, none); // the arc of each edge that crosses the level just below
    contours_below.resize(order.size());
    contours_above.resize(order.size());
    arc_of_vertex.assign(order.size(), none);
    for(std::size_t k = 0; k < order.size(); ++k)
    {
      const std::size_t v = order[k];
      const Partition contours = contours_of_level(k);
      std::set<std::size_t> touching_arcs, touching_contours, all_contours(contours.begin(), contours.end());
      all_contours.erase(none);
      for(std::size_t edge : edges_of_vertex_[v])
        (arcs_below[edge] != none ? touching_arcs : touching_contours)
          .insert(arcs_below[edge] != none ? arcs_below[edge] : contours[edge]);
      contours_below[v] = touching_arcs.size();
      contours_above[v] = touching_contours.size();
      number_of_contours.push_back(all_contours.size());

      std::map<std::size_t, std::size_t> arc_of_contour;
      const bool is_passed = touching_arcs.size() == 1 && touching_contours.size() == 1;
      if(is_passed && !(keeps_degree_two_nodes && is_critical(v)))
      {
        arc_of_vertex[v] = *touching_arcs.begin();
        arc_of_contour[*touching_contours.begin()] = *touching_arcs.begin();
      }
      else
      {
        for(std::size_t arc : touching_arcs)
          arcs[arc].upper = v;
        for(std::size_t contour : touching_contours)
        {
          arc_of_contour[contour] = arcs.size();
          arcs.push_back({v, none});
        }
      }
      // a contour that does not touch v crosses the same edges just below and just above it
      Partition arcs_above(number_of_edges_, none);
      for(std::size_t edge = 0; edge < number_of_edges_; ++edge)
        if(contours[edge] != none)
          arcs_above[edge] =
            arc_of_contour.count(contours[edge]) != 0 ? arc_of_contour[contours[edge]] : arcs_below[edge];
      arc_of_edge.push_back(arcs_above);
      arcs_below = arcs_above;
    }
  }

  std::vector<Triangle> triangles_;
  std::vector<std::set<std::size_t>> edges_of_vertex_;
  std::size_t number_of_edges_ = 0;
};

} // namespace brute_force_oracle

#endif // CGAL_REEB_GRAPH_TEST_BRUTE_FORCE_ORACLE_H
