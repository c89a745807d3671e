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

#include <algorithm>
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
  Large_vector<Index> halfedges;             // ascending
  Large_vector<std::size_t> first_halfedges; // by arc
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
Large_vector<Index> walk_chains(const Triangle_complex& complex,
                                const Order& order,
                                const Flat_graph& graph,
                                const Index* begin,
                                const Index* end,
                                Flat_chains& chains)
{
  Large_vector<Index> halfedges;
  halfedges.reserve(3 * static_cast<std::size_t>(end - begin));
  const auto add = [&](const Ascending_step& step) {
    const bool is_ascending = complex.target(step.edge) == step.target;
    halfedges.push_back(is_ascending ? step.edge : Triangle_complex::opposite(step.edge));
  };
  for(const Index* i = begin; i != end; ++i)
  {
    const Flat_arc& arc = graph.arcs[*i];
    chains.first_halfedges[*i] = halfedges.size();
    for(std::size_t j = 0; j != arc.number_of_pieces; ++j)
    {
      const Chain_piece& piece = graph.pieces[arc.first_piece + j];
      Ascending_step step = piece.first_step;
      for(add(step); order(step.target, piece.upper_vertex); add(step))
        step = steepest_step(complex, order, step.target);
    }
    chains.sizes[*i] = static_cast<Index>(halfedges.size() - chains.first_halfedges[*i]);
  }
  return halfedges;
}

template <class ConcurrencyTag, class Order>
Flat_chains find_arc_chains(const Triangle_complex& complex, const Order& order, const Flat_graph& graph)
{
  const Large_vector<Index> arcs = arcs_in_mesh_order(complex, graph);
  Flat_chains chains;
  chains.first_halfedges.resize(arcs.size());
  chains.sizes.resize(arcs.size());
  std::vector<Large_vector<Index>> parts(number_of_parts<ConcurrencyTag>(arcs.size()));
  for_each_part<ConcurrencyTag>(parts.size(), arcs.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
    parts[part] = walk_chains(complex, order, graph, arcs.data() + begin, arcs.data() + end, chains);
  });
  if(parts.size() == 1)
  {
    chains.halfedges = std::move(parts[0]);
    return chains;
  }
  std::vector<std::size_t> begins_of_parts(1, 0);
  for(const Large_vector<Index>& part : parts)
    begins_of_parts.push_back(begins_of_parts.back() + part.size());
  chains.halfedges.resize(begins_of_parts.back());
  for_each_part<ConcurrencyTag>(parts.size(), arcs.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
    std::copy(parts[part].begin(), parts[part].end(), chains.halfedges.begin() + begins_of_parts[part]);
    for(std::size_t i = begin; i != end; ++i)
      chains.first_halfedges[arcs[i]] += begins_of_parts[part];
  });
  return chains;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_ARC_CHAINS_H
