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
    if(sets_[side].unite(a, b))
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

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_STAGES_OF_COMPLEXES_H
