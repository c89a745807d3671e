// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_DISTRIBUTED_CHAINS_H
#define CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_DISTRIBUTED_CHAINS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/arcs/Flat_graph.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/distributed/Chain_parts.h>
#include <CGAL/Reeb_graph/internal/distributed/Gathered_surface.h>
#include <CGAL/Reeb_graph/internal/distributed/Slab_surface.h>
#include <CGAL/Reeb_graph/internal/distributed/agreement.h>
#include <CGAL/Reeb_graph/internal/distributed/pass_arrays.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/output/arc_chains.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/operations.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The pieces of the chains that have more than a first step, each to be walked by the rank where it begins.
// `begins_of_ranks` has the number of the first critical vertex of each rank, and the end. For rank 0.
template <class Scalar>
Gathered_arrays<Climbing_piece<Scalar>> list_climbing_pieces(const Gathered_surface<Scalar>& surface,
                                                             const Flat_graph& graph,
                                                             const std::vector<std::size_t>& begins_of_ranks)
{
  const auto order = surface.order();
  std::vector<std::size_t> begins(begins_of_ranks.size(), 0);
  const auto for_each_piece = [&](const auto& visit) {
    for(const Piece_index i : graph.pieces.keys())
    {
      const Chain_piece& piece = graph.pieces[i];
      if(!order(piece.first_step.target, piece.upper_vertex))
        continue;
      const Number lower = surface.arcs()[Slab_arc_index(piece.first_step.edge.number())].lower.number();
      const auto rank = std::upper_bound(begins_of_ranks.begin(), begins_of_ranks.end(), lower) - 1;
      visit(i, piece, static_cast<std::size_t>(rank - begins_of_ranks.begin()));
    }
  };
  for_each_piece([&](Piece_index, const Chain_piece&, std::size_t rank) { ++begins[rank + 1]; });
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  Gathered_arrays<Climbing_piece<Scalar>> pieces = {std::vector<Climbing_piece<Scalar>>(begins.back()), begins};
  for_each_piece([&](Piece_index i, const Chain_piece& piece, std::size_t rank) {
    pieces.elements[begins[rank]++] = {surface.global_vertices()[piece.first_step.target],
                                       surface.global_vertices()[piece.upper_vertex],
                                       surface.values()[piece.upper_vertex], i.number()};
  });
  return pieces;
}

// Walks pieces slab by slab: each rank those in its slab, and hands them on upwards, until no rank has any left.
// Collective.
template <class Scalar, class Order>
void walk_slab_by_slab(const boost::mpi::communicator& communicator,
                       std::vector<Climbing_piece<Scalar>> pieces,
                       Chain_parts<Scalar, Order>& parts)
{
  namespace mpi = boost::mpi;
  const int rank = communicator.rank(), above = rank + 1 < communicator.size() ? rank + 1 : no_rank;
  const int below = rank == 0 ? no_rank : rank - 1;
  while(true)
  {
    run_in_agreement(communicator, [&] { pieces = parts.walk(std::move(pieces)); });
    if(!mpi::all_reduce(communicator, static_cast<int>(!pieces.empty()), mpi::maximum<int>()))
      return;
    pieces = pass_array(communicator, pieces, above, below);
  }
}

// The pairs of vertices of all chains, one behind the other as their pieces are, from what the ranks have walked, slab
// by slab. For rank 0.
template <class Scalar>
std::vector<std::pair<std::size_t, std::size_t>> join_chain_parts(const Gathered_surface<Scalar>& surface,
                                                                  const Flat_graph& graph,
                                                                  const std::vector<Part_of_piece>& parts,
                                                                  const std::vector<Global_vertex>& vertices,
                                                                  Flat_chains& chains)
{
  Indexed_vector<Piece_index, std::size_t> ends(graph.pieces.size(), 1); // how many halfedges; then, their end
  for(const Part_of_piece& part : parts)
    ends[Piece_index(part.piece)] += part.size;
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<std::pair<std::size_t, std::size_t>> halfedges(ends.empty() ? 0 : ends.back());
  chains.begins_of_pieces.renew(graph.pieces.size() + 1, 0);
  std::copy(ends.begin(), ends.end(), chains.begins_of_pieces.begin() + 1);
  for(const Piece_index i : graph.pieces.keys())
  {
    const Ascending_step& step = graph.pieces[i].first_step;
    ends[i] = chains.begins_of_pieces[i] + 1;
    halfedges[ends[i] - 1] = {surface.global_vertices()[surface.source(step.edge)],
                              surface.global_vertices()[step.target]};
  }
  auto vertex = vertices.begin();
  for(const Part_of_piece& part : parts)
  {
    std::size_t& end = ends[Piece_index(part.piece)];
    for(Number i = 0; i != part.size; ++i, ++vertex, ++end)
      halfedges[end] = {halfedges[end - 1].second, *vertex};
  }
  return halfedges;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_DISTRIBUTED_CHAINS_H
