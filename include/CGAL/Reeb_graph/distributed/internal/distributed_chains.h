// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_DISTRIBUTED_CHAINS_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_DISTRIBUTED_CHAINS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/internal/Chain_parts.h>
#include <CGAL/Reeb_graph/distributed/internal/Gathered_surface.h>
#include <CGAL/Reeb_graph/distributed/internal/Slab_surface.h>
#include <CGAL/Reeb_graph/distributed/internal/exchange.h>
#include <CGAL/Reeb_graph/distributed/internal/pass_arrays.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/engine/Flat_graph.h>
#include <CGAL/Reeb_graph/internal/engine/Slab.h>
#include <CGAL/Reeb_graph/internal/engine/write_graph.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The pieces of the chains, for the ranks where they begin. `begins_of_ranks` has the number of the first critical
// vertex of each rank, and the end. For rank 0.
template <class Scalar>
Gathered_arrays<Climbing_piece<Scalar>> list_pieces(const Gathered_surface<Scalar>& surface,
                                                    const Flat_graph& graph,
                                                    const std::vector<std::size_t>& begins_of_ranks)
{
  const auto order = surface.order();
  const auto& vertices = surface.global_vertices();
  const auto rank_of = [&](const Chain_piece& piece) {
    const Number lower = surface.arcs()[Slab_arc_index(piece.first_step.edge.number())].lower.number();
    const auto behind = std::upper_bound(begins_of_ranks.begin(), begins_of_ranks.end(), lower);
    return static_cast<std::size_t>(behind - begins_of_ranks.begin()) - 1;
  };
  Gathered_arrays<Climbing_piece<Scalar>> pieces = {{}, std::vector<std::size_t>(begins_of_ranks.size(), 0)};
  for(const Chain_piece& piece : graph.pieces)
    ++pieces.begins[rank_of(piece) + 1];
  std::partial_sum(pieces.begins.begin(), pieces.begins.end(), pieces.begins.begin());
  pieces.elements.resize(pieces.begins.back());
  std::vector<std::size_t> ends = pieces.begins;
  for(const Arc_index arc : graph.arcs.keys())
    for(Number i = 0; i != graph.arcs[arc].number_of_pieces; ++i)
    {
      const Piece_index piece(graph.arcs[arc].first_piece.number() + i);
      const auto& [first_step, upper_vertex] = graph.pieces[piece];
      const bool goes_on = order(first_step.target, upper_vertex);
      pieces.elements[ends[rank_of(graph.pieces[piece])]++] = {vertices[first_step.target],
                                                               vertices[surface.source(first_step.edge)],
                                                               vertices[upper_vertex],
                                                               surface.values()[upper_vertex],
                                                               arc.number(),
                                                               piece.number(),
                                                               goes_on ? Number(1) : Number(0)};
    }
  return pieces;
}

// Walks pieces slab by slab: each rank those in its slab, and hands them on upwards, until no rank has any left.
// Collective.
template <class Scalar, class ChainParts>
void walk_slab_by_slab(Exchange& exchange, std::vector<Climbing_piece<Scalar>> pieces, ChainParts& parts)
{
  const int rank = exchange.communicator().rank();
  const int above = rank + 1 < exchange.communicator().size() ? rank + 1 : no_rank;
  const int below = rank == 0 ? no_rank : rank - 1;
  exchange.in_agreement([&] { parts.begin(pieces); });
  while(true)
  {
    pieces = parts.take_leaving();
    if(!exchange.is_on_any_rank(!pieces.empty()))
      return;
    pieces = pass_array(exchange, pieces, above, below);
    exchange.in_agreement([&] { parts.go_on(pieces); });
  }
}

// The pairs of vertices of all chains, one behind the other as their pieces are, from the parts that the ranks have
// walked, slab by slab. For rank 0.
inline std::vector<std::pair<std::size_t, std::size_t>> join_chain_parts(std::size_t number_of_pieces,
                                                                         const std::vector<Part_of_piece>& parts,
                                                                         const std::vector<Global_vertex>& vertices,
                                                                         Flat_chains& chains)
{
  auto& begins = chains.begins_of_pieces;
  begins.renew(number_of_pieces + 1, 0);
  for(const Part_of_piece& part : parts)
    begins[Piece_index(part.piece + 1)] += part.size - 1;
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  std::vector<std::pair<std::size_t, std::size_t>> halfedges(begins.back());
  Indexed_vector<Piece_index, std::size_t> ends = begins;
  auto vertex = vertices.begin();
  for(const Part_of_piece& part : parts)
  {
    for(Number i = 1; i != part.size; ++i, ++vertex)
      halfedges[ends[Piece_index(part.piece)]++] = {vertex[0], vertex[1]};
    ++vertex;
  }
  return halfedges;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_DISTRIBUTED_CHAINS_H
