// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_CONTOURS_OF_SECTORS_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_CONTOURS_OF_SECTORS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/union_find.h>
#include <CGAL/Reeb_graph/internal/complex/Simplicial_complex.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_vertices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace CGAL::Reeb_graph::internal {

struct Graph_node_tag;
typedef Index_of<Graph_node_tag> Graph_node;

// Two nodes of a graph that changes are joined from the time `begin` on, and no more at the time `end`.
struct Timed_link
{
  Graph_node a, b;
  Number begin, end;
};

// Finds which of some nodes are connected in a graph that changes, at several times that are known beforehand, by
// divide and conquer over the times: in an interval of them, the links that last all through are contracted, and only
// nodes at other links, or at which there is a question, are looked at any further.
//
// Proof of the bound: a link is kept in an interval only if it begins or ends inside, so in at most two intervals of
// each depth, and an interval has at most two nodes per link that it keeps, and one per question. Either half of an
// interval has at most half of its beginnings and ends, so the depth is at most log(2 m), and the links of all
// intervals that are kept at once decrease geometrically. So m links and s nodes in question take O((m + s) log m)
// steps of a union-find, and O(m + s) memory.
class Offline_connectivity
{
public:
  // At time t, the nodes in question are those from first_questions[t] to first_questions[t + 1].
  Offline_connectivity(Plain_vector<Graph_node> questions, const Plain_vector<Number>& first_questions)
    : first_questions_(first_questions),
      nodes_(std::move(questions))
  {}

  // Names the components of the nodes in question: two of one time have the same name if they are connected then.
  Plain_vector<Graph_node> operator()(Number number_of_nodes, const Plain_vector<Timed_link>& links)
  {
    divide(0, static_cast<Number>(first_questions_.size()) - 1, links, number_of_nodes);
    return std::move(nodes_);
  }

  // How many links have been looked at, in all intervals.
  std::size_t number_of_steps() const { return number_of_steps_; }

private:
  // Answers the questions of the times from `begin` to `end`. Each link that is kept begins or ends in between; where
  // none is left, nothing changes, and connected nodes have become one.
  void divide(Number begin, Number end, const Plain_vector<Timed_link>& links, Number number_of_nodes)
  {
    Plain_vector<Timed_link> kept;
    const Number number_of_kept_nodes = contract(begin, end, links, number_of_nodes, kept);
    if(kept.empty())
      return;
    number_of_steps_ += kept.size();
    const Number middle = find_middle(begin, end, kept);
    divide(begin, middle, kept, number_of_kept_nodes);
    divide(middle, end, kept, number_of_kept_nodes);
  }

  // Contracts the links that last all through an interval of the times, and keeps the other ones that are there, with
  // new names of their nodes, which the nodes in question get, too. Returns the number of names.
  Number contract(Number begin,
                  Number end,
                  const Plain_vector<Timed_link>& links,
                  Number number_of_nodes,
                  Plain_vector<Timed_link>& kept)
  {
    Disjoint_sets<Graph_node> sets(number_of_nodes);
    kept.reserve(links.size());
    for(const Timed_link& link : links)
    {
      if(link.begin <= begin && link.end >= end)
        sets.unite(link.a, link.b);
      else if(link.begin < end && link.end > begin)
        kept.push_back(link);
    }
    Indexed_vector<Graph_node, Graph_node> names(number_of_nodes, no_index); // by root
    Number number_of_names = 0;
    const auto name = [&](Graph_node root) {
      if(names[root] == no_index)
        names[root] = Graph_node(number_of_names++);
      return names[root];
    };
    std::size_t number_of_kept = 0;
    for(const Timed_link& link : kept)
    {
      const Graph_node a = sets.find(link.a), b = sets.find(link.b);
      if(a != b)
        kept[number_of_kept++] = {name(a), name(b), link.begin, link.end};
    }
    kept.resize(number_of_kept);
    for(Number i = first_questions_[begin]; i != first_questions_[end]; ++i)
      nodes_[i] = name(sets.find(nodes_[i]));
    return number_of_names;
  }

  // The time up to which about half of the beginnings and ends are, neither the first nor the last one.
  static Number find_middle(Number begin, Number end, const Plain_vector<Timed_link>& links)
  {
    Plain_vector<Number> counts(end - begin, 0);
    std::size_t total = 0;
    const auto count = [&](Number time) {
      if(time <= begin || time >= end)
        return;
      ++counts[time - begin];
      ++total;
    };
    for(const Timed_link& link : links)
    {
      count(link.begin);
      count(link.end);
    }
    std::size_t sum = 0;
    Number middle = begin;
    while(2 * (sum += counts[middle - begin]) < total)
      ++middle;
    return middle;
  }

  const Plain_vector<Number>& first_questions_;
  Plain_vector<Graph_node> nodes_; // in question, by the names of the interval that is looked at
  std::size_t number_of_steps_ = 0;
};

// The links of the level sets, by the times of the vertices: an edge crosses the levels from the time of its lower end
// to that of its higher end. A triangle whose edges cross none of the levels has no link.
inline Plain_vector<Timed_link> find_links(const Simplicial_complex& complex,
                                           const Indexed_vector<Vertex_index, Number>& times)
{
  Plain_vector<Timed_link> links;
  for(const Triangle_index triangle : complex.triangles())
  {
    const std::array<Vertex_index, 3>& v = complex.vertices_of(triangle);
    const std::array<Number, 3> time = {times[v[0]], times[v[1]], times[v[2]]};
    if(time[0] == time[1] && time[1] == time[2])
      continue;
    std::array<std::size_t, 3> places = {0, 1, 2};
    std::sort(places.begin(), places.end(), [&](std::size_t i, std::size_t j) { return time[i] < time[j]; });
    // Edges are in the order of the vertices that they do not have, from the last one.
    const auto edge_opposite = [&](std::size_t i) {
      return Graph_node(complex.edges_of(triangle)[2 - places[i]].number());
    };
    const Number low = time[places[0]], middle = time[places[1]], high = time[places[2]];
    if(low != middle)
      links.push_back({edge_opposite(1), edge_opposite(2), low, middle});
    if(middle != high)
      links.push_back({edge_opposite(1), edge_opposite(0), middle, high});
  }
  return links;
}

// Finds which lower sectors of vertices, which have to ascend, are in one contour just below their vertex. The level
// sets are a graph that changes while the level rises: its nodes are the edges that cross the level, and a triangle
// joins two of them, first those at its lowest vertex, and above its middle vertex those at its highest one. (S. Parsa,
// A deterministic O(m log m) time algorithm for the Reeb graph, 2013, where links are replaced one by one.)
//
// Sets by lower sector of the vertices: the name of its contour, among those of its vertex. Components of the complex in
// which none of the vertices in question is can be left out: is_left_out(vertex). Returns how many links have been
// looked at.
template <class Order, class IsLeftOut>
std::size_t find_contours_of_sectors(const Simplicial_complex& complex,
                                     const Order& order,
                                     const Swept_vertices& critical_vertices,
                                     const Plain_vector<Swept_index>& vertices,
                                     const IsLeftOut& is_left_out,
                                     Indexed_vector<Sector_index, Number>& contours)
{
  if(vertices.empty())
    return 0;
  // The time of a vertex is how many of the vertices in question are not higher. What is left out stays at time 0.
  Indexed_vector<Vertex_index, Number> times(complex.number_of_vertices(), 0);
  for(const Vertex_index v : complex.vertices())
  {
    if(is_left_out(v))
      continue;
    const auto is_not_higher = [&](Swept_index i) { return !order(v, critical_vertices.vertex(i)); };
    times[v] =
      static_cast<Number>(std::partition_point(vertices.begin(), vertices.end(), is_not_higher) - vertices.begin());
  }
  Plain_vector<Graph_node> questions;
  Plain_vector<Number> first_questions = {0};
  for(const Swept_index i : vertices)
  {
    for(const Sector_index sector : critical_vertices.sectors(i, Side::LOWER))
      questions.push_back(Graph_node(edge_of(critical_vertices.sector(Side::LOWER, sector).edge).number()));
    first_questions.push_back(static_cast<Number>(questions.size()));
  }
  Offline_connectivity connectivity(std::move(questions), first_questions);
  const Plain_vector<Graph_node> components = connectivity(complex.number_of_edges(), find_links(complex, times));
  auto component = components.begin();
  for(const Swept_index i : vertices)
    for(const Sector_index sector : critical_vertices.sectors(i, Side::LOWER))
      contours[sector] = (component++)->number();
  return connectivity.number_of_steps();
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_CONTOURS_OF_SECTORS_H
