// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_RUN_ON_RANKS_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_RUN_ON_RANKS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/internal/Chain_parts.h>
#include <CGAL/Reeb_graph/distributed/internal/Slab_surface.h>
#include <CGAL/Reeb_graph/distributed/internal/compute_graph_of_slabs.h>
#include <CGAL/Reeb_graph/distributed/internal/describe_slab.h>
#include <CGAL/Reeb_graph/distributed/internal/distribute_surface.h>
#include <CGAL/Reeb_graph/distributed/internal/exchange.h>
#include <CGAL/Reeb_graph/distributed/internal/pass_arrays.h>
#include <CGAL/Reeb_graph/distributed/internal/solve_slab.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/complex/Simplicial_complex.h>
#include <CGAL/Reeb_graph/internal/complex/Vertex_order.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/find_arcs.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>
#include <CGAL/Reeb_graph/visitor.h>
#include <CGAL/Reeb_graph_soup_traits.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/mpi/communicator.hpp>

#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL::Reeb_graph::internal {

// Leads all ranks from stage to stage. The visitor of each rank is told, the callback of rank 0 is asked, and what any
// of them throws, all ranks throw.
template <class Visitor>
class Stages_of_rank
{
public:
  template <class NamedParameters>
  Stages_of_rank(Exchange& exchange, Visitor& visitor, const NamedParameters& np)
    : exchange_(exchange),
      visitor_(visitor),
      progress_(exchange.rank() == 0 ? Progress(np) : Progress(parameters::default_values()))
  {}

  // Ends a stage, if there has been one, and begins another one, at a fraction of the whole. Collective.
  void go_on(double fraction, Stage next)
  {
    exchange_.in_agreement([&] {
      if(last_)
        visitor_.end_stage(*last_);
      progress_.report(fraction);
      last_ = next;
      visitor_.begin_stage(next);
    });
  }

  // Ends the last stage. There is nothing left to cancel. Collective.
  void end()
  {
    exchange_.in_agreement([&] {
      visitor_.end_stage(*last_);
      progress_.report_end();
    });
  }

  // Collective.
  void tell_critical_vertices(const Critical_vertex_counts& counts)
  {
    exchange_.in_agreement([&] { visitor_.critical_vertices(counts); });
  }

  Stage_progress part(double begin, double end) const { return {progress_, begin, end}; }

private:
  Exchange& exchange_;
  Visitor& visitor_;
  const Progress progress_;
  std::optional<Stage> last_;
};

// What each rank makes of its triangles.
struct Oriented_surface
{
  typedef Slab_complex Complex;

  template <class Scalar, class Order>
  auto operator()(Slab_surface<Scalar>& surface, const Order& order) const
  {
    return link_and_classify(surface, order);
  }
};

struct Any_triangles
{
  typedef Simplicial_complex Complex;

  template <class Scalar, class Order>
  auto operator()(Slab_surface<Scalar>& surface, const Order& order) const
  {
    return list_and_classify(surface, order);
  }
};

template <class Scalar, class ReebGraph>
constexpr bool are_types_for_ranks()
{
  static_assert(std::is_arithmetic_v<Scalar> && !std::is_same_v<Scalar, bool>,
                "On ranks of MPI, scalar values are built-in numbers, and not of type bool.");
  return Then<Graph_is_not_const<ReebGraph>::value, Graph_of_field<ReebGraph, Simplicial_complex, Scalar>>::value;
}

// From the parts of the surface that the ranks bring to the graph at rank 0.
template <class MakeComplex,
          class VertexRange,
          class TriangleRange,
          class ScalarRange,
          class ReebGraph,
          class NamedParameters>
void run_on_ranks(const boost::mpi::communicator& communicator,
                  const VertexRange& local_vertices,
                  const TriangleRange& local_triangles,
                  const ScalarRange& local_scalars,
                  ReebGraph& graph,
                  const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  namespace stages = Reeb_graph::internal;
  typedef std::decay_t<decltype(*std::begin(local_scalars))> Scalar;
  auto visitor_parameter = choose_parameter<Default_visitor>(get_parameter(np, internal_np::visitor));
  const auto method = choose_parameter(get_parameter(np, stages::method), Default_method());
  const auto ties = choose_parameter(get_parameter(np, stages::ties), Ties::PERTURB);
  const bool are_degree_two_nodes_kept = choose_parameter(get_parameter(np, stages::keep_degree_two_nodes), false);
  const bool are_chains_gathered = choose_parameter(get_parameter(np, stages::gather_chains), true);
  const std::size_t number_of_slabs = choose_parameter(get_parameter(np, stages::number_of_slabs), std::size_t(0));
  auto slab_parameter = get_parameter(np, stages::slab_of_rank);
  constexpr bool is_slab_wanted = is_given<decltype(slab_parameter)>;

  Exchange exchange(communicator);
  Stages_of_rank stage(exchange, unwrap_reference(visitor_parameter), np);
  stage.go_on(0, Stage::FLATTEN);
  Distribution_counts counts;
  std::shared_ptr<Linked_slab<Scalar, typename MakeComplex::Complex>> linked_slab;
  exchange.in_agreement([&] { linked_slab.reset(new Linked_slab<Scalar, typename MakeComplex::Complex>); });
  Slab_surface<Scalar>& surface = linked_slab->surface;
  auto& classified = linked_slab->classified;
  surface =
    distribute_surface<Scalar>(exchange, local_vertices, local_triangles, local_scalars, number_of_slabs, counts);
  const Vertex_order order(surface.values, std::less<Scalar>());
  const std::size_t number_of_triangles = surface.triangles.size();

  stage.go_on(0.4, Stage::CLASSIFY);
  exchange.in_agreement([&] { classified.emplace(MakeComplex()(surface, order)); });
  stage.tell_critical_vertices(sum_counts(exchange, count_critical_vertices(classified->critical_vertices)));

  stage.go_on(0.7, Stage::ARCS);
  Arcs_of_slab found;
  exchange.in_agreement([&] { found = solve_slab(surface, *classified, order, method, stage.part(0.7, 0.9)); });
  const auto gathered = glue_and_gather(exchange, surface, classified->critical_vertices, std::move(found), ties,
                                        are_degree_two_nodes_kept);
  classified->critical_vertices = Swept_vertices();

  stage.go_on(0.9, Stage::WRITE);
  Chain_parts parts(surface, classified->complex, order);
  if(are_chains_gathered || is_slab_wanted)
    walk_chains(exchange, gathered, parts);
  if constexpr(is_slab_wanted)
    describe_slab(exchange, linked_slab, counts, number_of_triangles, parts, !are_chains_gathered,
                  unwrap_reference(slab_parameter));
  if(are_chains_gathered)
    write_gathered_graph(exchange, gathered, parts.parts(), parts.vertices(), graph);
  else
    write_gathered_graph(exchange, gathered, {}, {}, graph);
  if constexpr(is_slab_wanted)
    unwrap_reference(slab_parameter).bytes_sent = exchange.bytes_sent();
  stage.end();
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_RUN_ON_RANKS_H
