// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
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
#include <CGAL/Reeb_graph/internal/engine/Slab.h>

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
  Offline_connectivity(const Plain_vector<Graph_node>& questions, const Plain_vector<Number>& first_questions)
    : first_questions_(first_questions),
      nodes_(questions)
  {}

  // Names the components of the nodes in question: two of one time have the same name if they are connected then.
  Plain_vector<Graph_node> operator()(Number number_of_nodes, Plain_vector<Timed_link> links)
  {
    if(number_of_times() == 0)
      return {};
    Part all(0, number_of_times(), number_of_nodes, links.size());
    for(const Timed_link& link : links)
      all.contract_if_lasting(link);
    for(const Timed_link& link : links)
      all.keep_if_changing(link);
    links = Plain_vector<Timed_link>();
    rename_questions(all);
    divide(all.begin, all.end, std::move(all.links), all.number_of_nodes);
    return std::move(nodes_);
  }

  // How many links have been looked at, in all intervals.
  std::size_t number_of_steps() const { return number_of_steps_; }

private:
  Number number_of_times() const { return static_cast<Number>(first_questions_.size()) - 1; }

  // An interval of the times, in which links that last all through are contracted, and the other ones are kept with new
  // names of their nodes.
  struct Part
  {
    Part(Number begin, Number end, Number number_of_old_nodes, std::size_t most_links)
      : begin(begin),
        end(end),
        sets(number_of_old_nodes),
        names(number_of_old_nodes, no_index)
    {
      links.reserve(most_links);
    }

    void contract_if_lasting(const Timed_link& link)
    {
      if(link.begin <= begin && link.end >= end)
        sets.unite(link.a, link.b);
    }

    void keep_if_changing(const Timed_link& link)
    {
      const bool is_there = link.begin < end && link.end > begin, is_lasting = link.begin <= begin && link.end >= end;
      if(!is_there || is_lasting)
        return;
      const Graph_node a = sets.find(link.a), b = sets.find(link.b);
      if(a != b)
        links.push_back({name_of_root(a), name_of_root(b), link.begin, link.end});
    }

    Graph_node name(Graph_node node) { return name_of_root(sets.find(node)); }

    Number begin, end;
    Disjoint_sets<Graph_node> sets;
    Indexed_vector<Graph_node, Graph_node> names; // by root
    Number number_of_nodes = 0;
    Plain_vector<Timed_link> links;

  private:
    Graph_node name_of_root(Graph_node root)
    {
      Graph_node& result = names[root];
      if(result == no_index)
        result = Graph_node(number_of_nodes++);
      return result;
    }
  };

  void rename_questions(Part& part)
  {
    for(Number i = first_questions_[part.begin]; i != first_questions_[part.end]; ++i)
      nodes_[i] = part.name(nodes_[i]);
  }

  // Answers the questions of the times from `begin` to `end`. Each link begins or ends in between; where none is left,
  // nothing changes, and connected nodes have become one.
  void divide(Number begin, Number end, Plain_vector<Timed_link> links, Number number_of_nodes)
  {
    if(links.empty())
      return;
    number_of_steps_ += links.size();
    const Number middle = find_middle(begin, end, links);
    Plain_vector<Timed_link> lower_links, upper_links;
    Number size_of_lower = 0, size_of_upper = 0;
    {
      Part lower(begin, middle, number_of_nodes, links.size() / 2),
        upper(middle, end, number_of_nodes, links.size() / 2);
      for(const Timed_link& link : links)
      {
        lower.contract_if_lasting(link);
        upper.contract_if_lasting(link);
      }
      for(const Timed_link& link : links)
      {
        lower.keep_if_changing(link);
        upper.keep_if_changing(link);
      }
      links = Plain_vector<Timed_link>();
      rename_questions(lower);
      rename_questions(upper);
      lower_links = std::move(lower.links);
      upper_links = std::move(upper.links);
      size_of_lower = lower.number_of_nodes;
      size_of_upper = upper.number_of_nodes;
    }
    divide(begin, middle, std::move(lower_links), size_of_lower);
    divide(middle, end, std::move(upper_links), size_of_upper);
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

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_CONTOURS_OF_SECTORS_H
