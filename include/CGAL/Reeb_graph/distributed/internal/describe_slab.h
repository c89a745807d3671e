// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_DESCRIBE_SLAB_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_DESCRIBE_SLAB_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/Distributed_slab.h>
#include <CGAL/Reeb_graph/distributed/internal/Chain_parts.h>
#include <CGAL/Reeb_graph/distributed/internal/Slab_complex.h>
#include <CGAL/Reeb_graph/distributed/internal/Slab_surface.h>
#include <CGAL/Reeb_graph/distributed/internal/count_borders.h>
#include <CGAL/Reeb_graph/distributed/internal/distribute_surface.h>
#include <CGAL/Reeb_graph/distributed/internal/exchange.h>
#include <CGAL/Reeb_graph/internal/engine/Slab.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The parts of chains for the user: those of each arc in their order.
template <class Scalar>
void describe_chains(const std::vector<Part_of_piece>& parts,
                     const std::vector<Global_vertex>& vertices,
                     Distributed_slab<Scalar>& slab)
{
  std::vector<std::size_t> begins, order;
  std::size_t begin = 0;
  for(const Part_of_piece& part : parts)
  {
    order.push_back(begins.size());
    begins.push_back(begin);
    begin += part.size;
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(parts[a].arc, parts[a].piece) < std::tie(parts[b].arc, parts[b].piece);
  });
  slab.chain_vertices = vertices;
  slab.chain_parts.reserve(parts.size());
  for(const std::size_t i : order)
    slab.chain_parts.push_back({parts[i].arc, begins[i], parts[i].size});
}

// Tells the user what the rank holds. Collective.
template <class Scalar, class Complex, class ChainParts>
void describe_slab(Exchange& exchange,
                   const std::shared_ptr<Linked_slab<Scalar, Complex>>& linked_slab,
                   const Distribution_counts& counts,
                   std::size_t number_of_triangles,
                   const ChainParts& parts,
                   bool are_chains_kept,
                   Distributed_slab<Scalar>& slab)
{
  const Slab_surface<Scalar>& surface = linked_slab->surface;
  Distributed_slab<Scalar> result;
  exchange.in_agreement([&] {
    if(are_chains_kept)
      describe_chains(parts.parts(), parts.vertices(), result);
  });
  result.is_surface_kept = slab.is_surface_kept;
  if constexpr(Complex::is_surface)
  {
    if(result.is_surface_kept)
      result.keep(linked_slab);
    const Border_counts borders = count_borders(exchange, linked_slab->classified->complex, surface);
    result.border_edges = borders.edges;
    result.border_loops = borders.loops;
  }
  result.has_slab = surface.has_slab();
  result.lower_bound = surface.lower_bound;
  result.upper_bound = surface.upper_bound;
  result.number_of_slabs = surface.number_of_slabs;
  result.crossings_per_triangle = counts.slabs_per_triangle_if_all;
  result.vertices = counts.vertices;
  result.triangles = number_of_triangles;
  result.copies = counts.copies;
  slab = std::move(result);
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_DESCRIBE_SLAB_H
