// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ARC_CHAINS_H
#define CGAL_REEB_GRAPH_INTERNAL_ARC_CHAINS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/Flat_graph.h>
#include <CGAL/Reeb_graph/internal/Large_vector.h>
#include <CGAL/Reeb_graph/internal/Triangle_complex.h>
#include <CGAL/Reeb_graph/internal/ascending_path.h>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The chains of all arcs, one behind the other.
struct Flat_chains
{
  Large_vector<Ascending_step> steps;
  Large_vector<std::size_t> first_steps; // one more than there are arcs
};

// Walks the chain of each arc. A path that has entered an arc cannot leave it below the upper node, so comparisons
// tell the end, and the chain does not depend on how the arc was found.
template <class Order>
Flat_chains find_arc_chains(const Triangle_complex& complex, const Order& order, const Flat_graph& graph)
{
  Flat_chains chains;
  chains.first_steps.reserve(graph.arcs.size() + 1);
  for(const Flat_arc& arc : graph.arcs)
  {
    chains.first_steps.push_back(chains.steps.size());
    for(std::size_t i = 0; i != arc.number_of_pieces; ++i)
    {
      const Chain_piece& piece = graph.pieces[arc.first_piece + i];
      chains.steps.push_back(piece.first_step);
      while(order(chains.steps.back().target, piece.upper_vertex))
        chains.steps.push_back(steepest_step(complex, order, chains.steps.back().target));
    }
  }
  chains.first_steps.push_back(chains.steps.size());
  return chains;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_ARC_CHAINS_H
