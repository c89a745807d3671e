// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_BRANCH_CURVES_H
#define CGAL_REEB_GRAPH_CURVES_BRANCH_CURVES_H

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
/// \brief refines a mesh and finds branch curves: disjoint simple closed curves of mesh edges, each of which cuts off a
/// disk, a branch of the surface.
///
/// A branch is an arc of the Reeb graph with a leaf at one end, a minimum or maximum inside of the surface, and a
/// saddle at the other. Each gives one of its contours, which is contractible. A component whose Reeb graph is a single
/// arc has no branch.
///
/// Noise makes thousands of small leaf arcs. Those that do not reach a threshold are removed from the graph, the least
/// one first, relative to its threshold. Then the other two arcs at the saddle of a removed one are one arc, which can
/// be a branch that is long enough. A leaf arc that is the only one on its side of the saddle is not removed, as no arc
/// would go on there, but gives no curve either.
///
/// By default, the shortest contour of several candidates in the half next to the saddle is taken: a branch is cut off
/// where it is attached.
///
/// The method follows M. Hajij and P. Rosen, *An Efficient Data Retrieval Parallel Reeb Graph Algorithm*, 2020, Section
/// 7. In advance, saddles of higher multiplicity, which could hide handles, are made simple as in
/// `unfold_multi_saddles()`. The time is that of `cutting_system()`.
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
///   \cgalParamNBegin{persistence_threshold}
///     \cgalParamDescription{the least difference between the values at the ends of a branch}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0}
///     \cgalParamExtra{use the functions `parameters::persistence_threshold()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{area_threshold}
///     \cgalParamDescription{the least area of a branch: a third of the area of the faces at each of its vertices}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0}
///     \cgalParamExtra{use the functions `parameters::area_threshold()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{curve_cost}
///     \cgalParamDescription{chooses the place of each curve: the candidate of least cost is taken}
///     \cgalParamType{a function object that is called with a `Reeb_graph::Candidate_curve` and returns a `double`}
///     \cgalParamDefault{the length for positions up to 0.5, else more than that of any of these}
///     \cgalParamExtra{use the functions `parameters::curve_cost()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_candidates}
///     \cgalParamDescription{the number of places that are tried for each curve, at least 1. They are evenly spread
///                           over the edges of the chains of the arcs.}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{16}
///     \cgalParamExtra{use the functions `parameters::number_of_candidates()`}
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
/// \exception Reeb_graph::Threshold_error if a threshold is negative or NaN
///
/// and the exceptions of `compute_reeb_graph()`. When one is thrown, the mesh is as it was before.
template <class MutableFaceGraph,
          class ScalarMap,
          class OutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
OutputIterator branch_curves(MutableFaceGraph& mesh,
                             ScalarMap scalar_map,
                             OutputIterator curves,
                             const NamedParameters& np = parameters::default_values())
{
  internal::check_thresholds(np);
  const auto traits = internal::choose_traits(mesh, scalar_map, np);
  internal::check_input(mesh, scalar_map, traits);
  auto visitor_parameter = internal::choose_refinement_visitor(mesh, np);
  const auto ranked = internal::make_ranked_mesh(mesh, internal::unwrap_reference(visitor_parameter), np);
  const auto simple = internal::compute_simple_reeb_graph(ranked, scalar_map, traits);
  const auto contours = internal::choose_branch_curves(ranked, simple, np);
  const auto result = internal::cut_and_mark(ranked, contours, np);
  return std::copy(result.begin(), result.end(), curves);
}

} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_CURVES_BRANCH_CURVES_H
