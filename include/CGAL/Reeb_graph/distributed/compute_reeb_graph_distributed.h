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
#include <CGAL/Reeb_graph/distributed/internal/run_on_ranks.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/visitor.h>
#include <CGAL/Reeb_graph_soup_traits.h>

#include <boost/mpi/communicator.hpp>

#include <iterator>
#include <type_traits>

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
/// \tparam ScalarRange a random access range of built-in numbers
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
  typedef std::decay_t<decltype(*std::begin(local_scalars))> Scalar;
  if constexpr(internal::are_types_for_ranks<Scalar, ReebGraph>())
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
  typedef std::decay_t<decltype(*std::begin(local_scalars))> Scalar;
  if constexpr(internal::are_types_for_ranks<Scalar, ReebGraph>())
    internal::run_on_ranks<internal::Simplicial_complex>(communicator, local_vertices, local_triangles, local_scalars,
                                                         graph, np);
}

} // namespace CGAL

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_COMPUTE_REEB_GRAPH_DISTRIBUTED_H
