// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_MESH_EDGE_DIRECTIONS_H
#define CGAL_REEB_GRAPH_INTERNAL_MESH_EDGE_DIRECTIONS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Calls prefetch(vertex) for the ends of the edge to which a sweep comes some rounds after `edge`.
template <class Complex, class Prefetch>
void prefetch_ends(const Complex& complex, Edge_index edge, const Prefetch& prefetch)
{
  constexpr std::size_t distance = 24;
  const Halfedge_index even = even_halfedge(Edge_index(edge.number() + distance));
  if(even.number() >= complex.number_of_halfedges())
    return;
  prefetch(complex.target(even));
  prefetch(complex.source(even));
}

// Which way the edges of a complex ascend: a bit for each, so that those of a million vertices stay in the caches in
// whatever order they are asked for.
class Edge_directions
{
public:
  // The numbers of halfedges of faces and of edges that have none, or one vertex at both ends, are added up on the way.
  template <class ConcurrencyTag, class Complex, class Order>
  static Edge_directions make(const Complex& complex, const Order& order)
  {
    Edge_directions directions;
    const std::size_t number_of_edges = complex.number_of_edges();
    directions.words_.resize(number_of_edges / word_size + 1);
    directions.counts_ = sum_of_parts<ConcurrencyTag, Counts>(
      directions.words_.size(), [&](std::size_t begin, std::size_t end, Counts& counts) {
        for(std::size_t i = begin; i != end; ++i)
          directions.words_[i] = word(complex, order, Edge_index(i * word_size),
                                      Edge_index((std::min)((i + 1) * word_size, number_of_edges)), counts);
      });
    return directions;
  }

  std::size_t number_of_halfedges_of_faces() const { return counts_.halfedges_of_faces; }
  bool has_bad_edge() const { return counts_.bad_edges != 0; }

  bool is_ascending(Halfedge_index halfedge) const
  {
    const std::size_t edge = edge_of(halfedge).number();
    return ((words_[edge / word_size] >> (edge % word_size) ^ halfedge.number()) & 1) != 0;
  }

private:
  struct Counts
  {
    std::size_t halfedges_of_faces = 0;
    std::size_t bad_edges = 0;

    Counts& operator+=(const Counts& other)
    {
      halfedges_of_faces += other.halfedges_of_faces;
      bad_edges += other.bad_edges;
      return *this;
    }
  };

  typedef std::uint64_t Word;
  static constexpr std::size_t word_size = 64;

  // Compares keys, for which no branch is taken: none could be foreseen where the surface is not in order in memory.
  template <class Complex, class Order>
  static Word word(const Complex& complex, const Order& order, Edge_index begin, Edge_index end, Counts& counts)
  {
    Word result = 0;
    for(const Edge_index e : Index_range(begin, end))
    {
      prefetch_ends(complex, e, [&](Vertex_index v) { order.prefetch(v); });
      if(!complex.has_edge(e))
        continue;
      const Halfedge_index even = even_halfedge(e);
      const std::size_t number_of_faces =
        std::size_t(complex.has_triangle(even)) + std::size_t(complex.has_triangle(opposite_of(even)));
      counts.halfedges_of_faces += number_of_faces;
      const Vertex_index source = complex.source(even), target = complex.target(even);
      if(number_of_faces == 0 || source == target)
        ++counts.bad_edges;
      else
        result |= Word(order(order.key(source, source), order.key(target, target))) << (e.number() % word_size);
    }
    return result;
  }

  std::vector<Word> words_; // set where the even halfedge of an edge ascends
  Counts counts_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_MESH_EDGE_DIRECTIONS_H
