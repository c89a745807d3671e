// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_COMPUTE_REEB_GRAPH_OF_SOUP_H
#define CGAL_COMPUTE_REEB_GRAPH_OF_SOUP_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/complex/Simplicial_complex.h>
#include <CGAL/Reeb_graph/internal/engine/loops_of_complexes.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph_soup_traits.h>
#include <CGAL/compute_reeb_graph.h>

#include <cstddef>

namespace CGAL {
namespace Reeb_graph::internal {

template <std::size_t vertices_per_cell,
          class PointsOrNumber,
          class Cells,
          class Scalars,
          class ReebGraph,
          class NamedParameters>
void compute_graph_of_cells(Threads threads,
                            const PointsOrNumber& points,
                            const Cells& cells,
                            const Scalars& scalars,
                            ReebGraph& graph,
                            const NamedParameters& np)
{
  typedef Reeb_graph_soup_traits<Value_of_range<Scalars>> Default_traits;
  typedef Chosen_traits<Default_traits, NamedParameters> Traits;
  static_assert(
    are_met<Graph_is_not_const<ReebGraph>, Graph_of_field<ReebGraph, Simplicial_complex, typename Traits::Scalar>>);
  const auto traits = choose_traits<Default_traits>(np);
  const auto flatten = [&](const Threads& threads) {
    return flatten_cells<vertices_per_cell>(threads, points, cells, parameters::get_parameter(np, edges_of_soup),
                                            scalars, traits);
  };
  const auto mesh_of = [](const Simplicial_complex& complex) -> const Simplicial_complex& { return complex; };
  if(threads.are_parallel() && count_vertices(points) < smallest_parallel_mesh / 2)
    threads = Threads();
  run_pipeline(threads, flatten, mesh_of, graph, np);
}

} // namespace Reeb_graph::internal

/// \ingroup PkgReebGraphRef
///
/// \brief computes the augmented Reeb graph of a scalar field on any set of triangles and edges.
///
/// The soup need not be a surface: any number of triangles can meet at an edge, and any number of fans of triangles at
/// a vertex. It need not be orientable. Edges and vertices may be on no triangle. The field is linear on each triangle.
/// A vertex is an index, and a triangle consists of three of them. A triangle that is listed twice counts once. Points
/// are only counted.
///
/// The graph is exact. Its nodes, arcs, order and chains are as for `compute_reeb_graph()`, and for a soup that is an
/// oriented surface, the two graphs are the same. Here vertices are indices, and the chains of the arcs are ascending
/// pairs of indices.
///
/// \tparam ConcurrencyTag as for `compute_reeb_graph()`. One thread builds the complex.
/// \tparam PointsOrNumber any range of points, as they are only counted, or an integer type; the constructors of
///         `Reeb_graph::Soup_augmentation` and `Reeb_graph::Tetrahedra_augmentation` need a random access range
/// \tparam TriangleRange a range of ranges of indices, as for the polygon soups of \cgal, such as
///         `std::vector<std::array<std::size_t, 3>>` and `std::vector<std::vector<int>>`
/// \tparam ScalarRange a random access range of scalar values
/// \tparam ReebGraph the type `Graph` of the traits class
///
/// \param points the points, or how many vertices there are
/// \param triangles the triangles
/// \param scalars the scalar field, one value per vertex
/// \param graph the result; whatever it held before is cleared
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{edges}
///     \cgalParamDescription{edges that may be on no triangle, as a range of pairs of indices}
///     \cgalParamType{a range of `std::pair`, or of ranges of two indices, copied or as `std::reference_wrapper`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of a traits class, for scalar values ordered by another function object}
///     \cgalParamType{a model of `ReebGraphTraits`, derived from `Reeb_graph_soup_traits`}
///     \cgalParamDefault{`Reeb_graph_soup_traits` of the value type of `scalars`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// The named parameters `keep_degree_two_nodes`, `ties`, `method`, `number_of_slabs`, `vertex_place_map`, `callback`
/// and `visitor` are those of `compute_reeb_graph()`; vertices are their indices there. Each slab looks at the whole
/// complex once, so many slabs cost more than the default, which is one.
///
/// Let there be \f$ n \f$ vertices, edges and triangles, and let \f$ l \f$ be the number of edges that are crossed by
/// the contours that close loops. There are at most as many of these as the first Betti number of the complex. By
/// default, this takes \f$ O(n \log n + l \log l) \f$ steps of a union-find, and \f$ O(n + l) \f$ memory. On parts that
/// are simply connected, or closed surfaces that can be oriented, the first summand is \f$ n + c \log c \f$ for
/// \f$ c \f$ critical vertices.
///
/// \pre Each triangle has three different vertices, and each index is one of a vertex.
///
/// \reebGraphComplexity
///
/// \exception Reeb_graph::Non_triangular_face_error if a face has not three vertices
/// \exception Reeb_graph::Degenerate_face_error if a face has one vertex at two corners
/// \exception Reeb_graph::Degenerate_edge_error if an edge has not two different vertices
/// \exception Reeb_graph::Vertex_out_of_range_error if an index is not one of a vertex
/// \exception Reeb_graph::Scalar_count_error if there is not one value for each vertex
/// \exception Reeb_graph::Unordered_scalar_error if a scalar value is NaN, or if the order of the values is found to
///            contradict itself
/// \exception Reeb_graph::Cancelled_error if `callback` returns `false`
/// \exception Reeb_graph::Mesh_size_error if there are too many vertices, edges or triangles for 32-bit indices
///
/// After one of these, `graph` is as it was before. After any other exception, such as `std::bad_alloc`, or if the
/// order of the values contradicts itself, it can be empty.
template <class ConcurrencyTag = Sequential_tag,
          class PointsOrNumber,
          class TriangleRange,
          class ScalarRange,
          class ReebGraph,
          class NamedParameters = parameters::Default_named_parameters>
void compute_reeb_graph_of_soup(const PointsOrNumber& points,
                                const TriangleRange& triangles,
                                const ScalarRange& scalars,
                                ReebGraph& graph,
                                const NamedParameters& np = parameters::default_values())
{
  Reeb_graph::internal::compute_graph_of_cells<3>(Reeb_graph::internal::threads_of<ConcurrencyTag>(), points, triangles,
                                                  scalars, graph, np);
}

/// \ingroup PkgReebGraphRef
///
/// \brief computes the augmented Reeb graph of a scalar field on any set of tetrahedra.
///
/// The field is linear on each tetrahedron. The components of its level sets are those on the faces of the tetrahedra,
/// so the graph is that of `compute_reeb_graph_of_soup()` for all faces. All that is said there holds here.
///
/// \tparam TetrahedronRange a range of ranges of four indices, such as `std::vector<std::array<std::size_t, 4>>`
///
/// \param points the points, or their number
/// \param tetrahedra the tetrahedra
/// \param scalars a value for each point
/// \param graph the result
/// \param np the named parameters of `compute_reeb_graph_of_soup()`
///
/// \pre Each tetrahedron has four different vertices, and each index is one of a vertex.
///
/// \reebGraphComplexity
///
/// \exception Reeb_graph::Non_tetrahedral_cell_error if a tetrahedron has not four different vertices
template <class ConcurrencyTag = Sequential_tag,
          class PointsOrNumber,
          class TetrahedronRange,
          class ScalarRange,
          class ReebGraph,
          class NamedParameters = parameters::Default_named_parameters>
void compute_reeb_graph_of_tetrahedra(const PointsOrNumber& points,
                                      const TetrahedronRange& tetrahedra,
                                      const ScalarRange& scalars,
                                      ReebGraph& graph,
                                      const NamedParameters& np = parameters::default_values())
{
  Reeb_graph::internal::compute_graph_of_cells<4>(Reeb_graph::internal::threads_of<ConcurrencyTag>(), points,
                                                  tetrahedra, scalars, graph, np);
}

} // namespace CGAL

#endif // CGAL_COMPUTE_REEB_GRAPH_OF_SOUP_H
