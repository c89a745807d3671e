// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_COMPUTE_REEB_GRAPH_DISTRIBUTED_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_COMPUTE_REEB_GRAPH_DISTRIBUTED_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/Distributed_slab.h>
#include <CGAL/Reeb_graph/distributed/exceptions.h>
#include <CGAL/Reeb_graph/distributed/internal/compute_graph_of_slabs.h>
#include <CGAL/Reeb_graph/distributed/internal/distribute_surface.h>
#include <CGAL/Reeb_graph/distributed/internal/exchange.h>
#include <CGAL/Reeb_graph/distributed/internal/solve_slab.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/Reeb_graph/internal/complex/Simplicial_complex.h>
#include <CGAL/Reeb_graph/internal/engine/Between_stages.h>
#include <CGAL/Reeb_graph/internal/engine/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/find_arcs.h>
#include <CGAL/Reeb_graph/internal/engine/slabs.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>
#include <CGAL/Reeb_graph_soup_traits.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The sum of the counts of all ranks. Collective.
inline Critical_vertex_counts sum_counts(Exchange& exchange, const Critical_vertex_counts& own)
{
  typedef std::array<std::uint64_t, 2> Saddles; // their multiplicity, and how many they are
  std::vector<Saddles> saddles;
  exchange.in_agreement([&] { saddles.assign(own.saddles.size(), {}); });
  auto place = saddles.begin();
  for(const auto& [multiplicity, number] : own.saddles)
    *place++ = {multiplicity, number};
  std::vector<Saddles> all_saddles = gather_arrays(exchange, saddles).elements;
  exchange.broadcast(all_saddles);

  Critical_vertex_counts sum;
  exchange.in_agreement([&] {
    for(const auto& [multiplicity, number] : all_saddles)
      sum.saddles[static_cast<std::size_t>(multiplicity)] += static_cast<std::size_t>(number);
  });
  for(const auto& of_rank :
      exchange.all_gather(std::array<std::size_t, 4>{own.isolated, own.minima, own.maxima, own.border_saddles}))
  {
    sum.isolated += of_rank[0];
    sum.minima += of_rank[1];
    sum.maxima += of_rank[2];
    sum.border_saddles += of_rank[3];
  }
  return sum;
}

struct Border_path_tag;
typedef Index_of<Border_path_tag> Border_path;

// The parts of the border loops that are in the slab of a rank: paths between its levels, and closed loops.
class Border_paths
{
public:
  Border_paths(const Triangle_complex& complex, const Slab_surface& surface)
  {
    const auto& slabs = surface.slabs_of_vertices;
    Indexed_vector<Border_path, Edge_index> edges;
    for(const Edge_index edge : Index_range<Edge_index>(complex.number_of_edges()))
    {
      const Slab_index a = slabs[complex.source(even_halfedge(edge))], b = slabs[complex.target(even_halfedge(edge))];
      if(!complex.is_on_border_edge(even_halfedge(edge)) || (a == b && a != surface.inside()))
        continue;
      edges.push_back(edge);
      if(a == surface.inside()) // One end of each edge comes first in the order of all vertices.
        ++number_of_edges;
    }
    join_edges(complex, surface, edges);
  }

  std::uint64_t number_of_edges = 0;
  std::uint64_t number_of_loops = 0; // closed ones
  Index number_of_paths = 0;
  // Paths that cross a level, in the order of the edges that cross it, which is the same on both sides.
  By_side<std::vector<Border_path>> paths_across;

private:
  void join_edges(const Triangle_complex& complex,
                  const Slab_surface& surface,
                  const Indexed_vector<Border_path, Edge_index>& edges)
  {
    const auto& slabs = surface.slabs_of_vertices;
    Disjoint_sets<Border_path> sets(static_cast<Index>(edges.size()));
    Indexed_vector<Vertex_index, Index> edges_at_vertices(complex.number_of_vertices(), 0); // from 1 on
    Indexed_vector<Border_path, Index> names(edges.size(), no_index);
    for(const Border_path i : edges.keys())
    {
      for(const Halfedge_index halfedge : {even_halfedge(edges[i]), opposite_of(even_halfedge(edges[i]))})
      {
        Index& other = edges_at_vertices[complex.target(halfedge)];
        if(slabs[complex.target(halfedge)] == surface.inside() && other != 0)
          sets.unite(i, Border_path(other - 1));
        other = i.number() + 1;
      }
    }
    for(const Border_path i : edges.keys())
    {
      const Slab_index a = slabs[complex.source(even_halfedge(edges[i]))];
      const Slab_index b = slabs[complex.target(even_halfedge(edges[i]))];
      for(const Side side : both_sides)
      {
        const Slab_index outside = side == Side::LOWER ? surface.below() : surface.above();
        if((a == outside) == (b == outside))
          continue;
        Index& name = names[sets.find(i)];
        name = name == no_index ? number_of_paths++ : name;
        paths_across[side].push_back(Border_path(name));
      }
    }
    for(const Border_path i : edges.keys())
      number_of_loops += sets.find(i) == i && names[i] == no_index ? 1 : 0;
  }
};

// The numbers of border edges and of border loops of the whole surface, on all ranks. Collective.
inline std::array<std::uint64_t, 2> count_borders(Exchange& exchange,
                                                  const Triangle_complex& complex,
                                                  const Slab_surface& surface)
{
  std::optional<Border_paths> paths;
  exchange.in_agreement([&] { paths.emplace(complex, surface); });
  const auto lower = gather_arrays(exchange, paths->paths_across[Side::LOWER]);
  const auto upper = gather_arrays(exchange, paths->paths_across[Side::UPPER]);
  const auto first_paths = gather_begins(exchange, paths->number_of_paths);
  std::uint64_t loops_across = 0;
  exchange.in_agreement([&] {
    if(exchange.rank() != 0)
      return;
    Disjoint_sets<Border_path> loops(checked_index(first_paths.back()));
    loops_across = first_paths.back();
    for(std::size_t slab = 0; slab + 1 < surface.number_of_slabs; ++slab)
      for(std::size_t i = 0; i != upper.begins[slab + 1] - upper.begins[slab]; ++i)
      {
        const Border_path below = upper.elements[upper.begins[slab] + i];
        const Border_path above = lower.elements[lower.begins[slab + 1] + i];
        if(loops.unite(Border_path(first_paths[slab] + below.number()),
                       Border_path(first_paths[slab + 1] + above.number())))
          --loops_across;
      }
  });
  const std::array<std::uint64_t, 2> own = {paths->number_of_edges, paths->number_of_loops + loops_across};
  std::array<std::uint64_t, 2> sums;
  boost::mpi::all_reduce(exchange.communicator(), own.data(), 2, sums.data(), std::plus<std::uint64_t>());
  return sums;
}

// The parts of chains for the user: those of each arc in their order.
template <class Scalar>
void describe_chains(const std::vector<Part_of_segment>& parts,
                     const std::vector<Long_index>& vertices,
                     Distributed_slab<Scalar>& slab)
{
  std::vector<std::size_t> begins, order;
  std::size_t begin = 0;
  for(const Part_of_segment& part : parts)
  {
    order.push_back(begins.size());
    begins.push_back(begin);
    begin += part.size;
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(parts[a].arc, parts[a].segment) < std::tie(parts[b].arc, parts[b].segment);
  });
  slab.chain_vertices = vertices;
  slab.chain_parts.reserve(parts.size());
  for(const std::size_t i : order)
    slab.chain_parts.push_back({parts[i].arc, begins[i], parts[i].size});
}

// Tells the user what the rank holds. Collective.
template <class Scalar, class Complex, class ChainParts>
void describe_slab(Exchange& exchange,
                   const std::shared_ptr<Linked_slab<Complex>>& linked_slab,
                   const Distribution_counts& counts,
                   std::size_t number_of_triangles,
                   const ChainParts& parts,
                   bool are_chains_kept,
                   Distributed_slab<Scalar>& slab)
{
  const Slab_surface& surface = linked_slab->surface;
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
    const auto [edges, loops] = count_borders(exchange, linked_slab->classified->complex, surface);
    result.border_edges = edges;
    result.border_loops = loops;
  }
  result.has_slab = surface.has_slab();
  if(surface.lower_bound)
    result.lower_bound = static_cast<Scalar>(*surface.lower_bound);
  if(surface.upper_bound)
    result.upper_bound = static_cast<Scalar>(*surface.upper_bound);
  result.number_of_slabs = surface.number_of_slabs;
  result.crossings_per_triangle = counts.slabs_per_triangle_if_all;
  result.vertices = counts.vertices;
  result.triangles = number_of_triangles;
  result.copies = counts.copies;
  slab = std::move(result);
}

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

// From the parts of the surface that the ranks bring to the graph at rank 0. `Complex` is what each rank makes of its
// triangles.
template <class Complex,
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
  using parameters::get_parameter;
  namespace stages = Reeb_graph::internal;
  typedef std::decay_t<decltype(*std::begin(local_scalars))> Scalar;
  static_assert(std::is_arithmetic_v<Scalar> && !std::is_same_v<Scalar, bool>,
                "On ranks of MPI, scalar values are built-in numbers, and not of type bool.");
  static_assert(are_met<Graph_is_not_const<ReebGraph>, Graph_of_field<ReebGraph, Simplicial_complex, Scalar>>);
  auto visitor_parameter = stages::parameter_or(np, internal_np::visitor, Default_visitor());
  const auto method = stages::parameter_or(np, stages::method, Default_method());
  const auto ties = stages::parameter_or(np, stages::ties, Ties::PERTURB);
  const bool are_degree_two_nodes_kept = stages::parameter_or(np, stages::keep_degree_two_nodes, false);
  const bool are_chains_gathered = stages::parameter_or(np, stages::gather_chains, true);
  const std::size_t number_of_slabs = stages::parameter_or(np, stages::number_of_slabs, std::size_t(0));
  auto slab_parameter = get_parameter(np, stages::slab_of_rank);
  constexpr bool is_slab_wanted = is_given<decltype(slab_parameter)>;

  Exchange exchange(communicator);
  Stages_of_rank stage(exchange, unwrap_reference(visitor_parameter), np);
  stage.go_on(0, Stage::FLATTEN);
  Distribution_counts counts;
  std::shared_ptr<Linked_slab<Complex>> linked_slab;
  exchange.in_agreement([&] { linked_slab.reset(new Linked_slab<Complex>); });
  Slab_surface& surface = linked_slab->surface;
  auto& classified = linked_slab->classified;
  surface = distribute_surface(exchange, local_vertices, local_triangles, local_scalars, number_of_slabs, counts);
  const Vertex_order order(surface.keys);
  const std::size_t number_of_triangles = surface.triangles.size();

  stage.go_on(0.4, Stage::CLASSIFY);
  exchange.in_agreement([&] { classified.emplace(make_and_classify<Complex>(surface, order)); });
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

namespace CGAL {

/// \ingroup PkgReebGraphRef
///
/// \brief computes the augmented Reeb graph of a scalar field on a surface that is spread over the ranks of a
/// communicator of MPI.
///
/// All ranks call this together. Each brings any part of the vertices, a range of their indices and their values, and
/// any of the triangles, by the indices of their vertices. Rank 0 gets the graph of the whole surface, the other ranks
/// an empty one. It is the graph of `compute_reeb_graph_of_soup()`, number by number, and that of
/// `compute_reeb_graph()` where the mesh has the same indices, whatever the number of ranks and the distribution.
///
/// The field is cut at levels into slabs, one for each rank, with about the same numbers of vertices. A triangle goes
/// to every rank whose slab it meets. Each rank finds the arcs in its slab, as `compute_reeb_graph()` does in its own
/// slabs. The two ranks at a level hold all that it crosses, so they find the same contours there, and name them alike
/// without a message. Along these, the slabs are glued, pairs of neighbors first, then pairs of pairs, up to all of
/// them. At rank 0, arcs that pass vertices are joined, and the graph is written. The chains of the arcs are walked by
/// the ranks in whose slabs they are, and handed on upwards.
///
/// Triangles that meet many slabs are copied to many ranks, as on noise. If by a sample of the triangles they would
/// meet more than two slabs on average, fewer slabs than ranks are used; `Reeb_graph::Distributed_slab` tells. Surfaces
/// of less than 2<sup>15</sup> triangles are sliced nevertheless.
///
/// With \f$ n \f$ vertices and triangles on \f$ k \f$ ranks, a rank takes the time and the memory of
/// `compute_reeb_graph()` for the triangles that meet its slab, about \f$ n / k \f$ of them where the field is smooth.
/// Up to a sixth of a byte for each vertex of all ranks comes on top. Rank 0 also takes \f$ O(c \log c) \f$ time and
/// \f$ O(c) \f$ memory for \f$ c \f$ critical vertices of all ranks. Gluing takes \f$ \log_2 k \f$ rounds of messages,
/// and chains at most \f$ k \f$ rounds.
///
/// \tparam VertexRange a range of consecutive integers, such as `boost::irange(first, last)`
/// \tparam TriangleRange a random access range of triples of indices, such as
///         `std::vector<std::array<std::uint64_t, 3>>`
/// \tparam ScalarRange a random access range of built-in numbers that a `double` holds
/// \tparam ReebGraph the type `Graph` of `Reeb_graph_soup_traits` with the value type of `ScalarRange`
///
/// \param communicator the ranks. They are taken to store numbers alike
/// \param local_vertices the indices of the vertices that this rank brings. The ranges of all ranks together are all
///        indices from 0, each one once, in any order; some can be empty
/// \param local_triangles the triangles that this rank brings. Each triangle of the surface is brought once
/// \param local_scalars the values of `local_vertices`
/// \param graph the result; whatever it held before is cleared
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below. All
///        ranks give the same ones, but for what they refer to
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{number_of_slabs}
///     \cgalParamDescription{how many slabs there are at most; 0 stands for as many as ranks. It has no influence on
///                           the result.}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{gather_chains}
///     \cgalParamDescription{whether the arcs at rank 0 get their chains. If not, the chains of the graph are empty,
///                           and stay on the ranks: `slab` tells the parts of each rank.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{slab}
///     \cgalParamDescription{an output: what this rank holds afterwards}
///     \cgalParamType{`std::reference_wrapper<Reeb_graph::Distributed_slab<Scalar>>`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{that of rank 0 is called now and then with the fraction of the work done, from 0 to 1.
///                           If it returns `false`, the computation stops on all ranks, except at 1.}
///     \cgalParamType{a function object that can be called with a `double` and returns `bool`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is called on each rank at the beginning and the end of each stage,
///                           `Reeb_graph::Stage::FLATTEN` being the distribution of the surface, and of the critical
///                           vertices of all ranks}
///     \cgalParamType{a model of `ReebGraphVisitor`, by value or as `std::reference_wrapper`}
///     \cgalParamDefault{`Reeb_graph::Default_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// The named parameters `keep_degree_two_nodes`, `ties` and `method` are those of `compute_reeb_graph()`.
///
/// Each exception is thrown on all ranks, for the first thing that is wrong on any of them:
/// \pre The triangles of all ranks together are a triangulated surface, oriented alike.
///
/// \reebGraphComplexity
///
/// \exception Reeb_graph::Vertex_ranges_error if the ranges of vertices are not all indices from 0, each one once
/// \exception Reeb_graph::Scalar_count_error if a rank has not one value for each of its vertices
/// \exception Reeb_graph::Unordered_scalar_error if a scalar value is NaN
/// \exception Reeb_graph::Inexact_scalar_error if no `double` holds a scalar value, as integers beyond 2<sup>53</sup>
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
/// After one of these but the last, `graph` is as it was before. After any other exception, it can be empty, or, if a
/// visitor throws at the end of the last stage, complete.
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
  namespace internal = Reeb_graph::internal;
  internal::run_on_ranks<internal::Triangle_complex>(communicator, local_vertices, local_triangles, local_scalars,
                                                     graph, np);
}

/// \ingroup PkgReebGraphRef
///
/// \brief computes the augmented Reeb graph of a scalar field on any set of triangles that is spread over the ranks of
/// a communicator of MPI.
///
/// It works as `compute_reeb_graph_distributed()`, but the triangles need not be a surface. Any number of them can meet
/// at an edge, and any number of fans at a vertex. They need not be orientable, nor oriented alike. A triangle that is
/// listed twice counts once. The graph is that of `compute_reeb_graph_of_soup()`. A rank takes the time and about the
/// memory of that function for the triangles that meet a slab, which is more than for a surface.
/// `Reeb_graph::Distributed_slab` counts no borders and has no contours.
///
/// \param communicator the ranks
/// \param local_vertices the numbers of vertices of this rank
/// \param local_triangles the triangles of this rank
/// \param local_scalars the values of the vertices of this rank
/// \param graph the result
/// \param np the named parameters of `compute_reeb_graph_distributed()`
///
/// The exceptions are those of `compute_reeb_graph_distributed()`, except the three that refuse surfaces that are not
/// oriented.
///
/// \reebGraphComplexity
template <class VertexRange,
          class TriangleRange,
          class ScalarRange,
          class ReebGraph,
          class NamedParameters = parameters::Default_named_parameters>
void compute_reeb_graph_of_soup_distributed(const boost::mpi::communicator& communicator,
                                            const VertexRange& local_vertices,
                                            const TriangleRange& local_triangles,
                                            const ScalarRange& local_scalars,
                                            ReebGraph& graph,
                                            const NamedParameters& np = parameters::default_values())
{
  namespace internal = Reeb_graph::internal;
  internal::run_on_ranks<internal::Simplicial_complex>(communicator, local_vertices, local_triangles, local_scalars,
                                                       graph, np);
}

} // namespace CGAL

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_COMPUTE_REEB_GRAPH_DISTRIBUTED_H
