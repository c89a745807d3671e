// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_COMPUTE_GRAPH_OF_SLABS_H
#define CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_COMPUTE_GRAPH_OF_SLABS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/arcs/Flat_graph.h>
#include <CGAL/Reeb_graph/internal/arcs/find_arcs.h>
#include <CGAL/Reeb_graph/internal/arcs/reduce_arcs.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/distributed/Chain_parts.h>
#include <CGAL/Reeb_graph/internal/distributed/Gathered_surface.h>
#include <CGAL/Reeb_graph/internal/distributed/Slab_block.h>
#include <CGAL/Reeb_graph/internal/distributed/Slab_surface.h>
#include <CGAL/Reeb_graph/internal/distributed/agreement.h>
#include <CGAL/Reeb_graph/internal/distributed/distributed_chains.h>
#include <CGAL/Reeb_graph/internal/distributed/glue_slabs.h>
#include <CGAL/Reeb_graph/internal/distributed/pass_arrays.h>
#include <CGAL/Reeb_graph/internal/distributed/solve_slab.h>
#include <CGAL/Reeb_graph/internal/mesh/Vertex_order.h>
#include <CGAL/Reeb_graph/internal/output/arc_chains.h>
#include <CGAL/Reeb_graph/internal/output/write_graph.h>
#include <CGAL/Reeb_graph/options.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// What decides the graph, but for the surface and its field.
template <class ChosenMethod>
struct Graph_options
{
  ChosenMethod method;
  Ties ties;
  bool are_degree_two_nodes_kept;
};

// The graph by the vertices of rank 0, and those; for the other ranks, there is nothing in it.
template <class Scalar>
struct Gathered_graph
{
  std::optional<Gathered_surface<Scalar>> surface;
  Flat_graph graph;
  std::vector<std::size_t> begins_of_ranks; // by rank: the number of its first critical vertex; and the end
};

// Glues the slabs, and gathers the graph at rank 0. Takes the arcs of the slab. Collective.
template <class Scalar, class ChosenMethod>
Gathered_graph<Scalar> glue_and_gather(const boost::mpi::communicator& communicator,
                                       const Slab_surface<Scalar>& surface,
                                       Solved_slab& solved,
                                       const Graph_options<ChosenMethod>& options)
{
  const std::size_t number_of_critical_vertices = solved.critical_vertices.size();
  const std::size_t end = boost::mpi::scan(communicator, number_of_critical_vertices, std::plus<std::size_t>());
  Slab_block<Scalar> block;
  std::vector<Global_vertex_with_value<Scalar>> critical_vertices;
  run_in_agreement(communicator, [&] {
    block = Slab_block<Scalar>(solved, surface, static_cast<Number>(checked_index(end) - number_of_critical_vertices));
    critical_vertices.reserve(number_of_critical_vertices);
    for(const Swept_index i : solved.critical_vertices.indices())
    {
      const Vertex_index vertex = solved.critical_vertices.vertex(i);
      critical_vertices.push_back({surface.global_vertices[vertex], surface.values[vertex]});
    }
    solved.critical_vertices = Swept_vertices();
    solved.arcs = Slab_arcs();
  });
  glue_slabs(communicator, surface.number_of_slabs, block);

  const auto all_critical_vertices = gather_arrays(communicator, critical_vertices);
  const auto all_arcs = gather_arrays(communicator, block.arcs());
  Gathered_graph<Scalar> gathered;
  run_in_agreement(communicator, [&] {
    if(communicator.rank() != 0)
      return;
    gathered.surface.emplace(all_critical_vertices.elements, all_arcs.elements);
    gathered.begins_of_ranks = all_critical_vertices.begins;
    gathered.graph =
      reduce_arcs<Sequential_tag>(*gathered.surface, gathered.surface->order(), gathered.surface->critical_vertices(),
                                  gathered.surface->arcs(), options.ties, options.are_degree_two_nodes_kept, false);
  });
  return gathered;
}

// Walks the chains on the ranks, and gathers them at rank 0, where the graph is written. Collective.
template <class Scalar, class Order, class ReebGraph>
void walk_and_write(const boost::mpi::communicator& communicator,
                    const Slab_surface<Scalar>& surface,
                    const Solved_slab& solved,
                    const Order& order,
                    const Gathered_graph<Scalar>& gathered,
                    ReebGraph& graph)
{
  const bool is_root = communicator.rank() == 0;
  Gathered_arrays<Climbing_piece<Scalar>> all_pieces;
  run_in_agreement(communicator, [&] {
    if(is_root)
      all_pieces = list_climbing_pieces(*gathered.surface, gathered.graph, gathered.begins_of_ranks);
  });
  Chain_parts<Scalar, Order> parts(surface, solved.complex, order);
  walk_slab_by_slab(communicator, scatter_arrays(communicator, all_pieces), parts);
  const auto all_parts = gather_arrays(communicator, parts.parts());
  const auto all_vertices = gather_arrays(communicator, parts.vertices());
  run_in_agreement(communicator, [&] {
    if(!is_root)
      return graph.clear();
    typedef std::vector<std::pair<std::size_t, std::size_t>> Vertex_pairs;
    Flat_chains chains;
    auto pairs = std::make_shared<const Vertex_pairs>(
      join_chain_parts(*gathered.surface, gathered.graph, all_parts.elements, all_vertices.elements, chains));
    struct Field
    {
      const Indexed_vector<Vertex_index, Global_vertex>& vertices;
      const Indexed_vector<Vertex_index, Scalar>& values;
    };
    write_nodes_and_arcs(Field{gathered.surface->global_vertices(), gathered.surface->values()}, gathered.graph, graph);
    write_chains(pairs, chains, gathered.graph, graph);
  });
}

// From the slabs of the ranks to the graph at rank 0. Takes the triangles of the surface. Collective.
template <class Scalar, class ReebGraph, class ChosenMethod, class Report>
void compute_graph_of_slabs(const boost::mpi::communicator& communicator,
                            Slab_surface<Scalar>& surface,
                            const Graph_options<ChosenMethod>& options,
                            ReebGraph& graph,
                            const Report& report)
{
  const Vertex_order order(surface.values, std::less<Scalar>());
  std::optional<Solved_slab> solved;
  run_in_agreement(communicator, [&] { solved.emplace(solve_slab(surface, order, options.method, report)); });
  const auto gathered = glue_and_gather(communicator, surface, *solved, options);
  walk_and_write(communicator, surface, *solved, order, gathered, graph);
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_COMPUTE_GRAPH_OF_SLABS_H
