// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_COMPUTE_REEB_GRAPH_DISTRIBUTED_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_COMPUTE_REEB_GRAPH_DISTRIBUTED_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/Distributed_slab.h>
#include <CGAL/Reeb_graph/distributed/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/count_critical_vertices.h>
#include <CGAL/Reeb_graph/internal/distributed/Linked_slab.h>
#include <CGAL/Reeb_graph/internal/distributed/Stages_of_rank.h>
#include <CGAL/Reeb_graph/internal/distributed/compute_graph_of_slabs.h>
#include <CGAL/Reeb_graph/internal/distributed/describe_slab.h>
#include <CGAL/Reeb_graph/internal/distributed/distribute_surface.h>
#include <CGAL/Reeb_graph/internal/distributed/exchange.h>
#include <CGAL/Reeb_graph/internal/distributed/solve_slab.h>
#include <CGAL/Reeb_graph/internal/distributed/sum_counts.h>
#include <CGAL/Reeb_graph/internal/mesh/Vertex_order.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>
#include <CGAL/Reeb_graph/visitor.h>
#include <CGAL/Reeb_graph_soup_traits.h>

#include <boost/mpi/communicator.hpp>

#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <type_traits>
#include <utility>

namespace CGAL {

/// \ingroup PkgReebGraphRef
///
/// \brief computes the augmented Reeb graph of a scalar field on a surface that is spread over the ranks of a
/// communicator of MPI.
///
/// All ranks call this together. Each brings any part of the vertices, a range of their indices and their values, and any
/// of the triangles, by the indices of their vertices. Rank 0 gets the graph of the whole surface, the other ranks an
/// empty one. It is the graph of `compute_reeb_graph_of_soup()`, number by number, and that of `compute_reeb_graph()`
/// where the mesh has the same indices, whatever the number of ranks and the distribution.
///
/// The field is cut at levels into slabs, one for each rank, with about the same numbers of vertices. A triangle goes to
/// every rank whose slab it meets. Each rank finds the arcs in its slab, as `compute_reeb_graph()` does in its own slabs.
/// The two ranks at a level hold all that it crosses, so they find the same contours there, and name them alike
/// without a word; along these, the slabs are glued, pairs of neighbors first, then pairs of pairs, up to all of them. At
/// rank 0, arcs that pass vertices are joined, and the graph is written. The chains of the arcs are walked by the ranks
/// in whose slabs they are, and handed on upwards.
///
/// Triangles that meet many slabs are copied to many ranks, as on noise. If by a sample of the triangles they would meet
/// more than two slabs on average, fewer slabs than ranks are used; `Reeb_graph::Distributed_slab` tells.
///
/// With \f$ n \f$ vertices and triangles on \f$ k \f$ ranks, a rank takes the time and the memory of
/// `compute_reeb_graph()` for the triangles that meet its slab, about \f$ n / k \f$ of them where the field is smooth,
/// and rank 0 also \f$ O(c \log c) \f$ time and \f$ O(c) \f$ memory for \f$ c \f$ critical vertices of all ranks.
/// Gluing takes \f$ \log_2 k \f$ rounds of messages, and chains at most \f$ k \f$ rounds.
///
/// \tparam VertexRange a range of consecutive integers, such as `boost::irange(first, last)`
/// \tparam TriangleRange a random access range of triples of indices, such as
///         `std::vector<std::array<std::uint64_t, 3>>`
/// \tparam ScalarRange a random access range of built-in numbers
/// \tparam ReebGraph the type `Graph` of `Reeb_graph_soup_traits` with the value type of `ScalarRange`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param communicator the ranks. They are taken to store numbers alike
/// \param local_vertices the indices of the vertices that this rank brings. The ranges of all ranks together are all
///        indices from 0, each one once, in any order; some can be empty
/// \param local_triangles the triangles that this rank brings. Each triangle of the surface is brought once
/// \param local_scalars the values of `local_vertices`
/// \param graph the result; whatever it held before is cleared
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below, the same on
///        all ranks but for what they refer to
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{number_of_slabs}
///     \cgalParamDescription{how many slabs there are at most; 0 stands for as many as ranks. It has no influence on the
///                           result.}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{0}
///     \cgalParamExtra{use the functions `parameters::number_of_slabs()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{gather_chains}
///     \cgalParamDescription{whether the arcs at rank 0 get their chains. If not, the chains of the graph are empty, and
///                           stay on the ranks: `slab` tells the parts of each rank.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///     \cgalParamExtra{use the functions `parameters::gather_chains()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{slab}
///     \cgalParamDescription{an output: what this rank holds afterwards}
///     \cgalParamType{`std::reference_wrapper<Reeb_graph::Distributed_slab<Scalar>>`}
///     \cgalParamDefault{none}
///     \cgalParamExtra{use the functions `parameters::slab()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{that of rank 0 is told now and then which fraction of the work is done, from 0 to 1. If it
///                           returns `false`, the computation stops on all ranks; not any more at 1.}
///     \cgalParamType{a function object that can be called with a `double` and returns `bool`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is told on each rank of the beginning and the end of each stage, `Reeb_graph::Stage::FLATTEN`
///                           being the distribution of the surface, and of the critical vertices of all ranks}
///     \cgalParamType{a model of `ReebGraphVisitor`, by value or as `std::reference_wrapper`}
///     \cgalParamDefault{`Reeb_graph::Default_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// The named parameters `keep_degree_two_nodes`, `ties` and `method` are those of `compute_reeb_graph()`.
///
/// Each exception is thrown on all ranks, for the first thing that is wrong on any of them:
/// \exception Reeb_graph::Vertex_ranges_error if the ranges of vertices are not all indices from 0, each one once
/// \exception Reeb_graph::Scalar_count_error if a rank has not one value for each of its vertices
/// \exception Reeb_graph::Unordered_scalar_error if a scalar value is NaN
/// \exception Reeb_graph::Vertex_out_of_range_error if an index of a triangle is not one of a vertex
/// \exception Reeb_graph::Degenerate_face_error if a triangle has one vertex at two corners
/// \exception Reeb_graph::Non_manifold_edge_error if an edge is on more than two triangles
/// \exception Reeb_graph::Inconsistent_orientation_error if two triangles at an edge are not oriented alike
/// \exception Reeb_graph::Non_manifold_vertex_error if the triangles of a vertex form more than one fan
/// \exception Reeb_graph::Cancelled_error if `callback` returns `false`
/// \exception Reeb_graph::Mesh_size_error if a rank has too many vertices or halfedges for 32-bit indices, or all ranks
///            together have too many critical vertices
/// \exception Reeb_graph::Other_rank_error if another rank has thrown an exception of another kind
///
/// When one of these is thrown, `graph` is as it was before. When anything else is, such as `std::bad_alloc`, it can be
/// empty instead.
template <class VertexRange,
          class TriangleRange,
          class ScalarRange,
          class ReebGraph,
          class NamedParameters = parameters::Default_named_parameters>
void compute_reeb_graph_distributed(const boost::mpi::communicator& communicator,
                                    const VertexRange& local_vertices,
                                    const TriangleRange& local_triangles,
                                    const ScalarRange& local_scalars,
                                    ReebGraph& graph,
                                    const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Reeb_graph::Stage;
  namespace stages = Reeb_graph::internal;
  typedef std::decay_t<decltype(*std::begin(local_scalars))> Scalar;
  static_assert(std::is_arithmetic_v<Scalar> && !std::is_same_v<Scalar, bool>,
                "On ranks of MPI, scalar values are built-in numbers, and not of type bool.");
  static_assert(stages::Graph_of_field<ReebGraph, stages::Simplicial_complex, Scalar>::value);

  auto visitor_parameter = choose_parameter<Reeb_graph::Default_visitor>(get_parameter(np, internal_np::visitor));
  auto& visitor = stages::unwrap_reference(visitor_parameter);
  const auto method = choose_parameter(get_parameter(np, stages::method), stages::Default_method());
  const auto ties = choose_parameter(get_parameter(np, stages::ties), Reeb_graph::Ties::PERTURB);
  const bool are_degree_two_nodes_kept = choose_parameter(get_parameter(np, stages::keep_degree_two_nodes), false);
  const bool are_chains_gathered = choose_parameter(get_parameter(np, stages::gather_chains), true);
  const std::size_t number_of_slabs = choose_parameter(get_parameter(np, stages::number_of_slabs), std::size_t(0));
  constexpr bool is_slab_wanted = stages::is_given<decltype(get_parameter(np, stages::slab_of_rank))>;

  stages::Exchange exchange(communicator);
  stages::Stages_of_rank stage(exchange, visitor, np);
  stage.go_on(0, Stage::FLATTEN);
  stages::Distribution_counts counts;
  const auto linked_slab = std::make_shared<stages::Linked_slab<Scalar>>();
  stages::Slab_surface<Scalar>& surface = linked_slab->surface;
  auto& classified = linked_slab->classified;
  surface = stages::distribute_surface<Scalar>(exchange, local_vertices, local_triangles, local_scalars,
                                               number_of_slabs, counts);
  const stages::Vertex_order order(surface.values, std::less<Scalar>());
  const std::size_t number_of_triangles = surface.triangles.size();

  stage.go_on(0.4, Stage::CLASSIFY);
  exchange.in_agreement([&] { classified.emplace(stages::link_and_classify(surface, order)); });
  auto& [complex, critical_vertices] = *classified;
  stage.tell_critical_vertices(stages::sum_counts(exchange, stages::count_critical_vertices(critical_vertices)));

  stage.go_on(0.7, Stage::ARCS);
  stages::Arcs_of_slab found;
  exchange.in_agreement([&] { found = stages::solve_slab(surface, *classified, order, method, stage.part(0.7, 0.9)); });
  const auto gathered =
    stages::glue_and_gather(exchange, surface, critical_vertices, std::move(found), ties, are_degree_two_nodes_kept);
  critical_vertices = stages::Swept_vertices();

  stage.go_on(0.9, Stage::WRITE);
  stages::Chain_parts parts(surface, complex, order);
  if(are_chains_gathered || is_slab_wanted)
    stages::walk_chains(exchange, gathered, parts);
  if(are_chains_gathered)
    stages::write_gathered_graph(exchange, gathered, parts.parts(), parts.vertices(), graph);
  else
    stages::write_gathered_graph(exchange, gathered, {}, {}, graph);
  if constexpr(is_slab_wanted)
  {
    auto slab_parameter = get_parameter(np, stages::slab_of_rank);
    stages::describe_slab(exchange, linked_slab, counts, number_of_triangles, parts, !are_chains_gathered,
                          stages::unwrap_reference(slab_parameter));
  }
  stage.end();
}

} // namespace CGAL

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_COMPUTE_REEB_GRAPH_DISTRIBUTED_H
