// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_WRITE_GRAPH_H
#define CGAL_REEB_GRAPH_INTERNAL_WRITE_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Halfedge_chain.h>
#include <CGAL/Reeb_graph/internal/Flat_graph.h>
#include <CGAL/Reeb_graph/internal/arc_chains.h>
#include <CGAL/Reeb_graph/internal/flatten.h>
#include <CGAL/Reeb_graph/internal/parallel.h>
#include <CGAL/Reeb_graph/internal/prefetch.h>

#include <boost/graph/adjacency_list.hpp>

#include <memory>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The halfedges of the mesh that the steps of the chains stand for.
template <class ConcurrencyTag, class FaceListGraph, class Scalar>
auto chain_halfedges(const FaceListGraph& mesh,
                     const Flat_surface<FaceListGraph, Scalar>& surface,
                     const Flat_chains& chains)
{
  typedef typename boost::graph_traits<FaceListGraph>::halfedge_descriptor halfedge_descriptor;
  std::vector<halfedge_descriptor> halfedges(chains.steps.size());
  for_each_block<ConcurrencyTag>(halfedges.size(), [&](std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i != end; ++i)
    {
      const Ascending_step& step = chains.steps[i];
      const bool is_ascending = surface.complex.target(step.edge) == step.target;
      halfedges[i] = surface.halfedges(mesh, is_ascending ? step.edge : Triangle_complex::opposite(step.edge));
    }
  });
  return std::make_shared<const std::vector<halfedge_descriptor>>(std::move(halfedges));
}

// Replaces the content of `graph` by the Reeb graph.
template <class ConcurrencyTag, class FaceListGraph, class Scalar, class ReebGraph>
void write_graph(const FaceListGraph& mesh,
                 const Flat_surface<FaceListGraph, Scalar>& surface,
                 const Flat_graph& flat_graph,
                 const Flat_chains& chains,
                 ReebGraph& graph)
{
  typedef typename boost::vertex_bundle_type<ReebGraph>::type Node;

  const auto halfedges = chain_halfedges<ConcurrencyTag>(mesh, surface, chains);
  graph.clear();
  for(const Flat_node& flat_node : flat_graph.nodes)
  {
    Node node;
    node.vertex = surface.vertices[flat_node.vertex];
    node.value = surface.values[flat_node.vertex];
    node.kind = flat_node.kind;
    add_vertex(std::move(node), graph);
  }
  constexpr std::size_t arcs_ahead = 12;
  const std::size_t size = flat_graph.arcs.size();
  for(std::size_t i = 0; i != size; ++i)
  {
    if(i + arcs_ahead < size)
      prefetch(&graph[flat_graph.arcs[i + arcs_ahead].upper]);
    const auto arc = add_edge(flat_graph.arcs[i].lower, flat_graph.arcs[i].upper, graph).first;
    graph[arc].chain = {halfedges, chains.first_steps[i], chains.sizes[i]};
  }
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_WRITE_GRAPH_H
