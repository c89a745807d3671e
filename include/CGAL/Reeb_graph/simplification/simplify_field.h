// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFY_FIELD_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFY_FIELD_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/simplification/internal/simplified_values.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>

#include <CGAL/Named_function_parameters.h>

#include <utility>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphSimplification
///
/// \brief computes a field whose Reeb graph is the simplified graph of a given field.
///
/// What `simplify()` removes from the graph is a piece of the surface. The values in this piece are moved to that of
/// its saddle, or next to it; all other values stay as they are, but for ties (see below). No value changes by as much
/// as the threshold, if the measure is the persistence. So everything that takes a field can be done with the
/// simplified one: cutting systems, pants, branches.
///
/// - With `Ties::CONTRACT`, a removed piece gets the value of its saddle: it becomes part of a plateau.
/// - With `Ties::PERTURB`, it gets different values next to that of its saddle, in an order in which each vertex has a
///   lower and a higher neighbor (an st-numbering: \cgalCite{t-tsdfsa-86}). If the field had no ties, contracting them
///   leads to the same graph. Where a saddle of higher multiplicity stays, its node can be at another vertex of the
///   pieces next to it, or come apart into several ones there, which are a tree. Where a vertex around a piece is tied
///   with the saddle, no number is left for the piece. There, the vertices of that value that come after the first such
///   saddle are moved up, in the order of the vertices, by at most a 1024th of the threshold. Only then does a value
///   outside of the pieces change.
///
/// With perturbed ties not every simplified graph is that of a field on the mesh. A removed piece with a border, or
/// with a handle that a multi-saddle hides, can need a loop, or has one in the order that is taken. So the graph of the
/// result is computed and compared; if it is another one, there is an exception. <b>With `Ties::CONTRACT` there is
/// always a field</b>: ask for it then.
///
/// On the subject, see \cgalCite{blw-otsdfs-12}, and \cgalCite{tp-gtssfs-12}. It takes the time of
/// `compute_reeb_graph()` twice, once with the places of the vertices, and near-linear time besides.
///
/// \tparam FaceListGraph a model of `FaceListGraph`
/// \tparam ScalarMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type and a value
///         type that `CGAL::to_double()` takes; with `Ties::PERTURB`, `double` or `float`. The order is that of
///         `operator<`.
/// \tparam SimplifiedScalarMap a model of `WritablePropertyMap` with the same key and value types
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the triangulated surface; it is only read
/// \param scalar_map the scalar field
/// \param threshold what is smaller is removed, in units of the measure
/// \param simplified_scalar_map the result; it can be the same map as `scalar_map`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `ties`, `vertex_index_map`,
///        `face_index_map` and `callback` of `compute_reeb_graph()`, and `number_of_leaves`, `place_weights` and
///        `branch_measure` of `simplify()`. The order is always that of `operator<`: there is no `geom_traits`
///
/// \pre The threshold is neither negative nor NaN, and the graph, if given, is that of the mesh and the field.
///
/// \reebGraphComplexity
///
/// \returns the largest absolute difference between a value of the result and the given one.
///
/// \exception Reeb_graph::Perturbed_ties_error with `Reeb_graph::Ties::PERTURB` only, if the result would have another
///            graph, or if there are too few numbers next to the value of a saddle for the vertices of a piece, as for
///            infinite values
/// \exception Reeb_graph::Parameter_error if `cancel_loops` is `true`
///
/// and the exceptions of `compute_reeb_graph()` and `simplify()`. When one is thrown, `simplified_scalar_map` is as it
/// was before.
template <class FaceListGraph,
          class ScalarMap,
          class SimplifiedScalarMap,
          class NamedParameters = parameters::Default_named_parameters>
double simplify_field(const FaceListGraph& mesh,
                      ScalarMap scalar_map,
                      double threshold,
                      SimplifiedScalarMap simplified_scalar_map,
                      const NamedParameters& np = parameters::default_values())
{
  static_assert(!internal::is_given<decltype(parameters::get_parameter(np, internal_np::geom_traits))>,
                "simplify_field() knows the order of operator< only: it takes no named parameter geom_traits.");
  typedef Reeb_graph_traits<FaceListGraph, ScalarMap> Traits;
  static_assert(internal::are_met<internal::Field_of_numbers<FaceListGraph, ScalarMap, Traits>,
                                  internal::Writable_vertex_map<SimplifiedScalarMap, FaceListGraph>>);
  return internal::write_simplified_field(
    mesh, scalar_map, threshold, simplified_scalar_map, np, [&](const auto& flat_field, const auto& progress) {
      std::pair<typename Traits::Graph, internal::Place_of_vertex> graph;
      graph.second = internal::compute_with_places(flat_field, graph.first, np, progress);
      return graph;
    });
}

/// \ingroup PkgReebGraphSimplification
///
/// \brief computes a field whose Reeb graph is the simplified graph of a given field, as above, with the graph of the
/// given field, which then need not be computed once more.
///
/// \param mesh the triangulated surface; it is only read
/// \param scalar_map the scalar field
/// \param graph the graph that `compute_reeb_graph()` has computed of them with the same `ties`. Where all values are
///        different, that is the same one for both.
/// \param threshold what is smaller is removed, in units of the measure
/// \param simplified_scalar_map the result; it can be the same map as `scalar_map`
/// \param np the named parameters of `simplify_field()` above, and `vertex_place_map`, the one that
///        `compute_reeb_graph()` has written, which has to be there
///
/// \pre The threshold is neither negative nor NaN, and the graph, if given, is that of the mesh and the field.
///
/// \reebGraphComplexity
///
/// \returns the largest absolute difference between a value of the result and the given one.
///
/// \exception Reeb_graph::Graph_mismatch_error if a place is none of the graph
///
/// and the other exceptions of `simplify_field()` above.
template <class FaceListGraph, class ScalarMap, class ReebGraph, class SimplifiedScalarMap, class NamedParameters>
double simplify_field(const FaceListGraph& mesh,
                      ScalarMap scalar_map,
                      const ReebGraph& graph,
                      double threshold,
                      SimplifiedScalarMap simplified_scalar_map,
                      const NamedParameters& np)
{
  typedef decltype(parameters::get_parameter(np, internal::vertex_place_map)) Place_map;
  static_assert(internal::is_given<Place_map>,
                "simplify_field() with a graph needs the named parameter vertex_place_map.");
  static_assert(!internal::is_given<decltype(parameters::get_parameter(np, internal_np::geom_traits))>,
                "simplify_field() knows the order of operator< only: it takes no named parameter geom_traits.");
  typedef Reeb_graph_traits<FaceListGraph, ScalarMap> Traits;
  static_assert(internal::are_met<internal::Field_of_numbers<FaceListGraph, ScalarMap, Traits>,
                                  internal::Writable_vertex_map<SimplifiedScalarMap, FaceListGraph>>);
  return internal::write_simplified_field(
    mesh, scalar_map, threshold, simplified_scalar_map, np, [&](const auto& flat_field, const auto&) {
      return std::pair<const ReebGraph&, internal::Place_of_vertex>(
        graph, internal::read_places(*flat_field.flat_values(mesh)->mesh,
                                     parameters::get_parameter(np, internal::vertex_place_map),
                                     num_vertices(graph) + num_edges(graph)));
    });
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFY_FIELD_H
