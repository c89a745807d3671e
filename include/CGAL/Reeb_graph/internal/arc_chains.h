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
#include <CGAL/Reeb_graph/internal/parallel.h>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The chains of all arcs, one behind the other, in the order of where they begin on the mesh.
struct Flat_chains
{
  Large_vector<Ascending_step> steps;
  Large_vector<std::size_t> first_steps; // by arc
  Large_vector<Index> sizes;
};

// The arcs in an order in which those that begin near to each other on the mesh follow each other.
inline Large_vector<Index> arcs_in_mesh_order(const Triangle_complex& complex, const Flat_graph& graph)
{
  constexpr Index halfedges_per_bucket = 64;
  const auto bucket = [&](const Flat_arc& arc) {
    return graph.pieces[arc.first_piece].first_step.edge / halfedges_per_bucket;
  };
  Large_vector<Index> begins(complex.number_of_halfedges() / halfedges_per_bucket + 2, 0);
  for(const Flat_arc& arc : graph.arcs)
    ++begins[bucket(arc) + 1];
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  Large_vector<Index> arcs(graph.arcs.size());
  for(Index i = 0; i != arcs.size(); ++i)
    arcs[begins[bucket(graph.arcs[i])]++] = i;
  return arcs;
}

// Walks the chains of the arcs from `begin` to `end`. A path that has entered an arc cannot leave it below the upper
// node, so comparisons tell the end, and the chain does not depend on how the arc was found.
template <class Order>
Large_vector<Ascending_step> walk_chains(const Triangle_complex& complex,
                                         const Order& order,
                                         const Flat_graph& graph,
                                         const Index* begin,
                                         const Index* end,
                                         Flat_chains& chains)
{
  Large_vector<Ascending_step> steps;
  steps.reserve(2 * static_cast<std::size_t>(end - begin));
  for(const Index* i = begin; i != end; ++i)
  {
    const Flat_arc& arc = graph.arcs[*i];
    chains.first_steps[*i] = steps.size();
    for(std::size_t j = 0; j != arc.number_of_pieces; ++j)
    {
      const Chain_piece& piece = graph.pieces[arc.first_piece + j];
      steps.push_back(piece.first_step);
      while(order(steps.back().target, piece.upper_vertex))
        steps.push_back(steepest_step(complex, order, steps.back().target));
    }
    chains.sizes[*i] = static_cast<Index>(steps.size() - chains.first_steps[*i]);
  }
  return steps;
}

template <class ConcurrencyTag, class Order>
Flat_chains find_arc_chains(const Triangle_complex& complex, const Order& order, const Flat_graph& graph)
{
  const Large_vector<Index> arcs = arcs_in_mesh_order(complex, graph);
  Flat_chains chains;
  chains.first_steps.resize(arcs.size());
  chains.sizes.resize(arcs.size());
  std::vector<Large_vector<Ascending_step>> steps_of_parts(number_of_parts<ConcurrencyTag>(arcs.size()));
  for_each_part<ConcurrencyTag>(
    steps_of_parts.size(), arcs.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
      steps_of_parts[part] = walk_chains(complex, order, graph, arcs.data() + begin, arcs.data() + end, chains);
    });
  chains.steps = std::move(steps_of_parts[0]);
  for(std::size_t part = 1; part != steps_of_parts.size(); ++part)
  {
    const std::size_t first_step = chains.steps.size();
    chains.steps.insert(chains.steps.end(), steps_of_parts[part].begin(), steps_of_parts[part].end());
    const std::size_t end = (part + 1) * arcs.size() / steps_of_parts.size();
    for(std::size_t i = part * arcs.size() / steps_of_parts.size(); i != end; ++i)
      chains.first_steps[arcs[i]] += first_step;
  }
  return chains;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_ARC_CHAINS_H
