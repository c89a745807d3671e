// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_OUTPUT_ARC_CHAINS_H
#define CGAL_REEB_GRAPH_INTERNAL_OUTPUT_ARC_CHAINS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/arcs/Flat_graph.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/base/Plain_vector.h>
#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/walks/ascending_path.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The chains of all arcs, one behind the other as their pieces are.
struct Flat_chains
{
  std::vector<Plain_vector<Halfedge_index>> parts; // of the sequence of all halfedges, which are ascending
  Plain_vector<std::size_t> begins_of_parts;
  Indexed_vector<Piece_index, std::size_t> begins_of_pieces; // and the end of the last one

  std::size_t size() const { return begins_of_pieces.back(); }
  std::size_t begin(const Flat_arc& arc) const { return begins_of_pieces[arc.first_piece]; }
  std::size_t end(const Flat_arc& arc) const
  {
    return begins_of_pieces[Piece_index(arc.first_piece.number() + arc.number_of_pieces)];
  }
};

// Walks the pieces of chains from `begin` to `end`. A path that has entered an arc cannot leave it below the upper
// node, so comparisons tell the end, and the chain does not depend on how the arc was found. No vertex is passed twice,
// unless the order contradicts itself.
template <class Complex, class Order>
Plain_vector<Halfedge_index> walk_pieces(const Complex& complex,
                                         const Order& order,
                                         const Chain_piece* begin,
                                         const Chain_piece* end,
                                         std::size_t* begins_of_pieces)
{
  Plain_vector<Halfedge_index> halfedges;
  halfedges.reserve(3 * static_cast<std::size_t>(end - begin));
  const std::size_t most = complex.number_of_vertices() + static_cast<std::size_t>(end - begin);
  const auto add = [&](const Ascending_step& step) {
    const bool is_ascending = complex.target(step.edge) == step.target;
    halfedges.push_back(is_ascending ? step.edge : opposite_of(step.edge));
  };
  for(const Chain_piece* piece = begin; piece != end; ++piece)
  {
    *begins_of_pieces++ = halfedges.size();
    add(piece->first_step);
    const auto is_below = [&](Vertex_index vertex) { return order(vertex, piece->upper_vertex); };
    climb(complex, order, piece->first_step.target, is_below, [&](Vertex_index vertex, const Ascending_step& step) {
      if(halfedges.size() == most)
        complex.throw_contradiction_near(vertex);
      add(step);
    });
  }
  return halfedges;
}

// Engines find arcs by and large in the order of where they begin on the mesh, and pieces have kept that order.
template <class ConcurrencyTag, class Complex, class Order>
Flat_chains find_arc_chains(const Complex& complex, const Order& order, const Flat_graph& graph)
{
  const std::size_t size = graph.pieces.size();
  Flat_chains chains;
  constexpr std::size_t smallest_part = 4; // On a smooth field there are few chains, but long ones.
  chains.parts.resize(number_of_parts<ConcurrencyTag>(size, smallest_part));
  chains.begins_of_pieces.renew(size + 1);
  for_each_part<ConcurrencyTag>(chains.parts.size(), size, [&](std::size_t part, std::size_t begin, std::size_t end) {
    chains.parts[part] = walk_pieces(complex, order, graph.pieces.data() + begin, graph.pieces.data() + end,
                                     chains.begins_of_pieces.data() + begin);
  });
  std::size_t sum = 0;
  for(const Plain_vector<Halfedge_index>& part : chains.parts)
  {
    chains.begins_of_parts.push_back(sum);
    sum += part.size();
  }
  chains.begins_of_pieces.back() = sum;
  for_each_part<ConcurrencyTag>(chains.parts.size(), size, [&](std::size_t part, std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; part != 0 && i != end; ++i)
      chains.begins_of_pieces[Piece_index(i)] += chains.begins_of_parts[part];
  });
  return chains;
}

#define CGAL_REEB_GRAPH_FIND_ARC_CHAINS(PREFIX, TAG, COMPLEX, SCALAR)                                                  \
  PREFIX template Flat_chains find_arc_chains<TAG>(const COMPLEX&, const Natural_order<SCALAR>&, const Flat_graph&);
CGAL_REEB_GRAPH_FOR_COMPLEXES(CGAL_REEB_GRAPH_FIND_ARC_CHAINS)

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_OUTPUT_ARC_CHAINS_H
