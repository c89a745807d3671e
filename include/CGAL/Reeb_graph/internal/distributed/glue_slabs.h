// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_GLUE_SLABS_H
#define CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_GLUE_SLABS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/distributed/Slab_block.h>
#include <CGAL/Reeb_graph/internal/distributed/exchange.h>
#include <CGAL/Reeb_graph/internal/distributed/pass_arrays.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Glues the slabs of the ranks, each rank's block to the one above it, in as many rounds as it takes to double one slab
// to all of them. Afterwards, each arc between critical vertices is in the block of the rank where its last two parts
// have met. Collective.
template <class Scalar>
void glue_slabs(Exchange& exchange, std::size_t number_of_slabs, Slab_block<Scalar>& block)
{
  const std::size_t slab = exchange.rank();
  for(std::size_t size = 1; size < number_of_slabs; size *= 2)
  {
    const bool is_leader = slab % (2 * size) == 0 && slab + size < number_of_slabs;
    const bool is_on_top = slab % (2 * size) == size && slab < number_of_slabs;
    const int to = is_on_top ? static_cast<int>(slab - size) : no_rank;
    const int from = is_leader ? static_cast<int>(slab + size) : no_rank;
    const auto ends_of_contours = pass_array(exchange, block.ends_of_contours(), to, from);
    auto open_arcs = pass_array(exchange, block.open_arcs(), to, from);
    exchange.in_agreement([&] {
      if(is_leader)
        block.put_on_top(ends_of_contours, std::move(open_arcs));
    });
  }
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_GLUE_SLABS_H
