// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_CUTTING_SYSTEM_H
#define CGAL_REEB_GRAPH_CURVES_CUTTING_SYSTEM_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/curve_parameters.h>
#include <CGAL/Reeb_graph/internal/curves/choose_contours.h>
#include <CGAL/Reeb_graph/internal/curves/cut_and_mark.h>
#include <CGAL/Reeb_graph/internal/curves/simple_reeb_graph.h>

#include <algorithm>

namespace CGAL {
namespace Reeb_graph {

/// \ingroup PkgReebGraphCurves
///
/// \brief refines a mesh and finds a cutting system: disjoint simple closed curves of mesh edges, as many as the
/// surface has handles, whose complement is connected and has genus 0.
///
/// A spanning tree of the Reeb graph is found, and each arc that is not in it gives one of its contours. On a connected
/// surface of genus \f$ g \f$ with \f$ b \f$ border components these are exactly \f$ g \f$ curves, for any field;
/// the surface cut along them has \f$ 2g + b \f$ border components. A sphere has no curve. Several connected
/// components are cut one by one.
///
/// By default the curves are short: along each arc of the graph, without the leaves that do not matter here, the
/// shortest contour of several candidates is taken, and the arcs outside of a maximum spanning tree of these lengths
/// are cut.
///
/// The method follows M. Hajij and P. Rosen, *An Efficient Data Retrieval Parallel Reeb Graph Algorithm*, 2020, Section
/// 7. In advance, saddles of higher multiplicity, which could hide handles, are made simple as in
/// `unfold_multi_saddles()`. It takes \f$ O(n \log n + l) \f$ time, where
/// \f$ n \f$ is the number of vertices and faces, and \f$ l \f$ is the number of edges that are crossed by the contours
/// that the computation of the graph traces, by the candidates, and by the curves.
///
/// \tparam MutableFaceGraph a model of `MutableFaceGraph` and `FaceListGraph` with dynamic property maps, such as
///         `Surface_mesh` and `Polyhedron_3`
/// \tparam ScalarMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type and a value
///         type that `CGAL::to_double()` takes. It is not read at new vertices.
/// \tparam OutputIterator a model of `OutputIterator` for `Reeb_graph::Curve`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the mesh, which is changed. To keep it, pass a copy made by `CGAL::copy_face_graph()`.
/// \param scalar_map the scalar field. If the mesh has borders, all vertices of a border component must have the same
///        value, and not have lower neighbors as well as higher ones.
/// \param curves the output
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{curve_cost}
///     \cgalParamDescription{chooses the place of each curve: the candidate of least cost is taken}
///     \cgalParamType{a function object that is called with a `Reeb_graph::Candidate_curve` and returns a `double`}
///     \cgalParamDefault{the length}
///     \cgalParamExtra{use the functions `parameters::curve_cost()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_candidates}
///     \cgalParamDescription{the number of places that are tried for each curve, at least 1. They are evenly spread
///                           over the edges of the chains of the arcs.}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{16}
///     \cgalParamExtra{use the functions `parameters::number_of_candidates()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{arc_weight}
///     \cgalParamDescription{chooses the curves: those of the arcs in a maximum spanning tree of the weights are not
///                           taken. It is called with the candidate that has been chosen for the arc.}
///     \cgalParamType{a function object that is called with a `Reeb_graph::Candidate_curve` and returns a `double`}
///     \cgalParamDefault{the length}
///     \cgalParamExtra{use the functions `parameters::arc_weight()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{is set to `true` for each edge of a curve; other edges are not written}
///     \cgalParamType{a model of `WritablePropertyMap` with the edge descriptors as key type and `bool` as value type}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_curve_map}
///     \cgalParamDescription{is set to the number of the curve, from 0, for each edge of a curve; other edges are not
///                           written}
///     \cgalParamType{a model of `WritablePropertyMap` with the edge descriptors as key type and an integer type as
///                    value type}
///     \cgalParamDefault{none}
///     \cgalParamExtra{use the functions `parameters::edge_curve_map()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_patch_map}
///     \cgalParamDescription{is set to the number of the piece that the face belongs to once the mesh is cut along all
///                           curves, from 0}
///     \cgalParamType{a model of `WritablePropertyMap` with the face descriptors as key type and an integer type as
///                    value type}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{cut_open}
///     \cgalParamDescription{whether the mesh is cut open along the curves, so that each closed curve becomes two
///                           border cycles. The lower side gets new vertices at the points of the curve.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///     \cgalParamExtra{use the functions `parameters::cut_open()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices}
///     \cgalParamType{a model of `ReadWritePropertyMap` with the vertex descriptors as key type and points of a
///                    three-dimensional kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is told of all edges and faces that are split, so that attributes can be carried over}
///     \cgalParamType{a model of `ReebGraphRefinementVisitor`, by value or as `std::reference_wrapper`}
///     \cgalParamDefault{`Reeb_graph::Default_refinement_visitor`}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of a traits class, for scalar values ordered by another function object}
///     \cgalParamType{a model of `ReebGraphTraits`}
///     \cgalParamDefault{`Reeb_graph_traits<MutableFaceGraph, ScalarMap>`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the output iterator behind the last curve.
///
/// \exception Reeb_graph::Border_level_error if the vertices of a border component do not have one value, or have lower
///            as well as higher neighbors
///
/// and the exceptions of `compute_reeb_graph()`. When one is thrown, the mesh is as it was before.
template <class MutableFaceGraph,
          class ScalarMap,
          class OutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
OutputIterator cutting_system(MutableFaceGraph& mesh,
                              ScalarMap scalar_map,
                              OutputIterator curves,
                              const NamedParameters& np = parameters::default_values())
{
  const auto traits = internal::choose_traits(mesh, scalar_map, np);
  internal::check_input(mesh, scalar_map, traits);
  auto visitor_parameter = internal::choose_refinement_visitor(mesh, np);
  const auto ranked = internal::make_ranked_mesh(mesh, internal::unwrap_reference(visitor_parameter), np);
  const auto simple = internal::compute_simple_reeb_graph(ranked, scalar_map, traits);
  const auto contours = internal::choose_cutting_system(ranked, simple, np);
  const auto result = internal::cut_and_mark(ranked, contours, np);
  return std::copy(result.begin(), result.end(), curves);
}

} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_CURVES_CUTTING_SYSTEM_H
