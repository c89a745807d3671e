// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_STAGES_OF_COMPLEXES_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_STAGES_OF_COMPLEXES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/complex/Simplicial_complex.h>
#include <CGAL/Reeb_graph/internal/engine/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/walks.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The link sectors of the vertices of any complex. The link of a vertex is a graph: its points are the edges at the
// vertex, and the triangles there join them. So a sector is a set of edges that lead from the vertex upwards, or
// downwards, and a triangle joins two edges at its lowest vertex and two at its highest one: each edge is in one set at
// either end.
class Link_forests
{
public:
  Link_forests(const Simplicial_complex& complex, const Vertex_order& order)
    : complex_(complex),
      order_(order),
      sets_(
        {Disjoint_sets<Edge_index>(complex.number_of_edges()), Disjoint_sets<Edge_index>(complex.number_of_edges())}),
      numbers_of_sectors_(complex.number_of_vertices(), {0, 0}),
      sector_at_root_(complex.number_of_edges(), 0)
  {
    for(const Edge_index edge : complex.edges())
    {
      const Vertex_index u = complex.lower_end(edge), v = complex.higher_end(edge);
      const bool is_ascending = order(u, v);
      ++numbers_of_sectors_[u][side_of(is_ascending)];
      ++numbers_of_sectors_[v][side_of(!is_ascending)];
    }
    for(const Triangle_index triangle : complex.triangles())
      join_edges(triangle);
  }

  By_side<Index> numbers_of_sectors(Vertex_index vertex) const { return numbers_of_sectors_[vertex]; }

  // A lower and a higher neighbor.
  Monotone_neighbors neighbors(Vertex_index vertex) const
  {
    Monotone_neighbors result = {no_index, no_index};
    complex_.for_each_edge_around(
      vertex, [&](Vertex_index neighbor, Halfedge_index) { result[side_of(order_(vertex, neighbor))] = neighbor; });
    return result;
  }

  // Writes the sectors of a vertex to the two places, in the order of their first edges.
  void write(Vertex_index vertex, const By_side<Link_sector*>& places)
  {
    for(const Side side : both_sides)
      roots_[side].clear();
    complex_.for_each_edge_around(vertex, [&](Vertex_index neighbor, Halfedge_index halfedge) {
      const Side side = side_of(order_(vertex, neighbor));
      const Edge_index root = sets_[side].find(edge_of(halfedge));
      // A sector found there may be left from another vertex.
      const Index sector = sector_at_root_[root];
      if(sector < roots_[side].size() && roots_[side][sector] == root)
        return add_to_sector(places[side][sector], order_, side, neighbor, halfedge);
      sector_at_root_[root] = static_cast<Index>(roots_[side].size());
      places[side][roots_[side].size()] = {neighbor, halfedge};
      roots_[side].push_back(root);
    });
  }

private:
  void join_edges(Triangle_index triangle)
  {
    const std::array<Vertex_index, 3>& v = complex_.vertices_of(triangle);
    const std::array<Edge_index, 3>& edges = complex_.edges_of(triangle);
    const bool is_01 = order_(v[0], v[1]), is_02 = order_(v[0], v[2]), is_12 = order_(v[1], v[2]);
    // The place of the vertex that is below, or above, both other ones.
    const std::size_t lowest = is_01 ? (is_02 ? 0 : 2) : (is_12 ? 1 : 2);
    const std::size_t highest = is_01 ? (is_12 ? 2 : 1) : (is_02 ? 2 : 0);
    join(Side::UPPER, v[lowest], edges[lowest == 2], edges[lowest == 0 ? 1 : 2]);
    join(Side::LOWER, v[highest], edges[highest == 2], edges[highest == 0 ? 1 : 2]);
  }

  void join(Side side, Vertex_index vertex, Edge_index a, Edge_index b)
  {
    const Edge_index root_of_a = sets_[side].find(a), root_of_b = sets_[side].find(b);
    if(root_of_a == root_of_b)
      return;
    sets_[side].link(root_of_a, root_of_b);
    --numbers_of_sectors_[vertex][side];
  }

  const Simplicial_complex& complex_;
  const Vertex_order& order_;
  By_side<Disjoint_sets<Edge_index>> sets_; // by their upper, and by their lower end
  Indexed_vector<Vertex_index, By_side<Index>> numbers_of_sectors_;
  Indexed_vector<Edge_index, Index> sector_at_root_; // of the vertex of the last call
  By_side<Plain_vector<Edge_index>> roots_;          // by sector of that vertex
};

// Finds the wanted vertices of any complex; `is_wanted` gets the vertex, and its numbers of lower and upper sectors.
// Links need not alternate, so both sides are counted. Two sweeps on one thread; only sorting uses more.
template <class IsWanted>
Swept_vertices find_vertices_of_complex(const Threads& threads,
                                        const Simplicial_complex& complex,
                                        const Vertex_order& order,
                                        const IsWanted& is_wanted)
{
  Link_forests forests(complex, order);
  Plain_vector<Vertex_index> wanted;
  Sector_counts numbers_of_sectors = {0, 0};
  auto kept_neighbors = std::make_shared<Kept_neighbors>(complex.number_of_vertices());
  Kept_neighbors::Block neighbors = {};
  for(std::size_t begin = 0; begin < complex.number_of_vertices(); begin += neighbors.size())
  {
    const std::size_t end = (std::min)(begin + neighbors.size(), std::size_t(complex.number_of_vertices()));
    const std::size_t number_of_earlier = wanted.size();
    for(const Vertex_index v : Index_range(Vertex_index(begin), Vertex_index(end)))
    {
      const By_side<Index> numbers = forests.numbers_of_sectors(v);
      if(!is_wanted(v, numbers))
        continue;
      wanted.push_back(v);
      for(const Side side : both_sides)
        numbers_of_sectors[side] += numbers[side];
    }
    if(!Kept_neighbors::are_worth_keeping(wanted.size() - number_of_earlier, end - begin))
      continue;
    for(const Vertex_index v : Index_range(Vertex_index(begin), Vertex_index(end)))
      neighbors[v.number() - begin] = forests.neighbors(v);
    kept_neighbors->keep(neighbors, begin, end);
  }

  Swept_vertices result;
  result.resize(wanted.size(), numbers_of_sectors);
  Sector_counts first_sectors = {0, 0};
  Swept_index i(0);
  for(const Vertex_index v : wanted)
  {
    forests.write(v, result.set(i, v, false, complex.is_on_border(v), first_sectors));
    ++i;
    for(const Side side : both_sides)
      first_sectors[side] += forests.numbers_of_sectors(v)[side];
  }
  result.sort(threads, order);
  result.set_kept_neighbors(std::move(kept_neighbors));
  return result;
}

// Whether a vertex with such numbers of sectors is critical.
struct Are_critical
{
  bool operator()(Vertex_index, const By_side<Index>& numbers_of_sectors) const
  {
    return numbers_of_sectors[Side::LOWER] != 1 || numbers_of_sectors[Side::UPPER] != 1;
  }
};

#define CGAL_REEB_GRAPH_FIND_VERTICES_OF_COMPLEX(PREFIX, COMPLEX)                                                      \
  PREFIX template Swept_vertices find_vertices_of_complex(const Threads&, const COMPLEX&, const Vertex_order&,         \
                                                          const Are_critical&);
CGAL_REEB_GRAPH_FOR_SOUPS(CGAL_REEB_GRAPH_FIND_VERTICES_OF_COMPLEX)

inline Swept_vertices classify_vertices(const Threads& threads,
                                        const Simplicial_complex& complex,
                                        const Vertex_order& order)
{
  return find_vertices_of_complex(threads, complex, order, Are_critical());
}

// There is nothing left to check of a complex.
inline Classified_complex<Simplicial_complex> check_and_classify_vertices(const Threads& threads,
                                                                          Simplicial_complex complex,
                                                                          const Vertex_order& order)
{
  Swept_vertices critical_vertices = classify_vertices(threads, complex, order);
  return {std::move(complex), std::move(critical_vertices)};
}

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
  std::unordered_set<Index> found = {edge_of(start).number()};
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
    first_search_ += static_cast<Index>(pending_.size());
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
    Index number_of_triangles;
  };

  // An edge belongs to a contour now. If it does already, and to another one, these two are one.
  template <class IsBelow>
  void reach(std::size_t i, Edge_index edge, const IsBelow& is_below)
  {
    if(searches_[edge] < first_search_)
    {
      searches_[edge] = first_search_ + static_cast<Index>(i);
      const Halfedge_index even = even_halfedge(edge);
      crossed_edges_[i].push_back(is_below(complex_.source(even)) ? even : opposite_of(even));
      pending_[i].push_back({edge, 0});
      return;
    }
    const std::size_t other = leader(searches_[edge] - first_search_);
    if(other != i)
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
  Indexed_vector<Edge_index, Index> searches_; // the number of the start from which the edge has been found
  Index first_search_ = 1;
  std::vector<Plain_vector<Pending_edge>> pending_;
};

struct Graph_node_tag;
typedef Index_of<Graph_node_tag> Graph_node;

// Two nodes of a graph that changes are joined from the time `begin` on, and no more at the time `end`.
struct Timed_link
{
  Graph_node a, b;
  Index begin, end;
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
  Offline_connectivity(Plain_vector<Graph_node> questions, const Plain_vector<Index>& first_questions)
    : first_questions_(first_questions),
      nodes_(std::move(questions))
  {}

  // Names the components of the nodes in question: two of one time have the same name if they are connected then.
  Plain_vector<Graph_node> operator()(Index number_of_nodes, const Plain_vector<Timed_link>& links)
  {
    divide(0, static_cast<Index>(first_questions_.size()) - 1, links, number_of_nodes);
    return std::move(nodes_);
  }

  // How many links have been looked at, in all intervals.
  std::size_t number_of_steps() const { return number_of_steps_; }

private:
  // Answers the questions of the times from `begin` to `end`. Each link that is kept begins or ends in between; where
  // none is left, nothing changes, and connected nodes have become one.
  void divide(Index begin, Index end, const Plain_vector<Timed_link>& links, Index number_of_nodes)
  {
    Plain_vector<Timed_link> kept;
    const Index number_of_kept_nodes = contract(begin, end, links, number_of_nodes, kept);
    if(kept.empty())
      return;
    number_of_steps_ += kept.size();
    const Index middle = find_middle(begin, end, kept);
    divide(begin, middle, kept, number_of_kept_nodes);
    divide(middle, end, kept, number_of_kept_nodes);
  }

  // Contracts the links that last all through an interval of the times, and keeps the other ones that are there, with
  // new names of their nodes, which the nodes in question get, too. Returns the number of names.
  Index contract(Index begin,
                 Index end,
                 const Plain_vector<Timed_link>& links,
                 Index number_of_nodes,
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
    Index number_of_names = 0;
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
    for(Index i = first_questions_[begin]; i != first_questions_[end]; ++i)
      nodes_[i] = name(sets.find(nodes_[i]));
    return number_of_names;
  }

  // The time up to which about half of the beginnings and ends are, neither the first nor the last one.
  static Index find_middle(Index begin, Index end, const Plain_vector<Timed_link>& links)
  {
    Plain_vector<Index> counts(end - begin, 0);
    std::size_t total = 0;
    const auto count = [&](Index time) {
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
    Index middle = begin;
    while(2 * (sum += counts[middle - begin]) < total)
      ++middle;
    return middle;
  }

  const Plain_vector<Index>& first_questions_;
  Plain_vector<Graph_node> nodes_; // in question, by the names of the interval that is looked at
  std::size_t number_of_steps_ = 0;
};

// The links of the level sets, by the times of the vertices: an edge crosses the levels from the time of its lower end
// to that of its higher end. A triangle whose edges cross none of the levels has no link.
inline Plain_vector<Timed_link> find_links(const Simplicial_complex& complex,
                                           const Indexed_vector<Vertex_index, Index>& times)
{
  Plain_vector<Timed_link> links;
  for(const Triangle_index triangle : complex.triangles())
  {
    const std::array<Vertex_index, 3>& v = complex.vertices_of(triangle);
    const std::array<Index, 3> time = {times[v[0]], times[v[1]], times[v[2]]};
    if(time[0] == time[1] && time[1] == time[2])
      continue;
    std::array<std::size_t, 3> places = {0, 1, 2};
    std::sort(places.begin(), places.end(), [&](std::size_t i, std::size_t j) { return time[i] < time[j]; });
    // Edges are in the order of the vertices that they do not have, from the last one.
    const auto edge_opposite = [&](std::size_t i) {
      return Graph_node(complex.edges_of(triangle)[2 - places[i]].number());
    };
    const Index low = time[places[0]], middle = time[places[1]], high = time[places[2]];
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
template <class IsLeftOut>
std::size_t find_contours_of_sectors(const Simplicial_complex& complex,
                                     const Vertex_order& order,
                                     const Swept_vertices& critical_vertices,
                                     const Plain_vector<Swept_index>& vertices,
                                     const IsLeftOut& is_left_out,
                                     Indexed_vector<Sector_index, Index>& contours)
{
  if(vertices.empty())
    return 0;
  // The time of a vertex is how many of the vertices in question are not higher. What is left out stays at time 0.
  Indexed_vector<Vertex_index, Index> times(complex.number_of_vertices(), 0);
  for(const Vertex_index v : complex.vertices())
  {
    if(is_left_out(v))
      continue;
    const auto is_not_higher = [&](Swept_index i) { return !order(v, critical_vertices.vertex(i)); };
    times[v] =
      static_cast<Index>(std::partition_point(vertices.begin(), vertices.end(), is_not_higher) - vertices.begin());
  }
  Plain_vector<Graph_node> questions;
  Plain_vector<Index> first_questions = {0};
  for(const Swept_index i : vertices)
  {
    for(const Sector_index sector : critical_vertices.sectors(i, Side::LOWER))
      questions.push_back(Graph_node(edge_of(critical_vertices.sector(Side::LOWER, sector).edge).number()));
    first_questions.push_back(static_cast<Index>(questions.size()));
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

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_STAGES_OF_COMPLEXES_H
