// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_CUT_ALONG_CONTOURS_H
#define CGAL_REEB_GRAPH_CURVES_CUT_ALONG_CONTOURS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Contour.h>
#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/curve_parameters.h>
#include <CGAL/Reeb_graph/curves/exceptions.h>
#include <CGAL/Reeb_graph/internal/curves/contours_to_cut.h>
#include <CGAL/Reeb_graph/internal/curves/cut_and_mark.h>
#include <CGAL/Reeb_graph/internal/curves/simple_reeb_graph.h>

#include <algorithm>

namespace CGAL {
namespace Reeb_graph {

/// \ingroup PkgReebGraphCurves
///
/// \brief refines a mesh so that contours become paths of edges.
///
/// The edges that a contour crosses are split where it does, and the faces between them; what is left of a face is
/// triangulated. The mesh stays a triangle mesh with the same surface. Any number of contours may pass one edge or one
/// face, and may lie at levels as close to each other as they like: their points on an edge are kept apart by at least
/// 0.4 / (<em>k</em> + 1) of its length, where \e k is the number of contours that cross it, and from its ends by at
/// least 0.1 / (<em>k</em> + 1). So no face is degenerate unless it comes from a degenerate one.
///
/// Handles of the mesh stay valid: an edge that is split keeps its upper part, a face that is split one of its parts.
/// With \f$ n \f$ vertices and faces and \f$ l \f$ crossed edges in all contours it takes \f$ O(n \log n + l) \f$
/// time, the first part for sorting the vertices.
///
/// \tparam MutableFaceGraph a model of `MutableFaceGraph` and `FaceListGraph` with dynamic property maps, such as
///         `Surface_mesh` and `Polyhedron_3`
/// \tparam ScalarMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type and a value
///         type that `CGAL::to_double()` takes. It is not read at new vertices.
/// \tparam ContourRange a range of `Reeb_graph::Contour`, as `Reeb_graph::Augmentation` makes them
/// \tparam OutputIterator a model of `OutputIterator` for `Reeb_graph::Curve`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the mesh, which is changed. To keep it, pass a copy made by `CGAL::copy_face_graph()`.
/// \param scalar_map the scalar field that the contours are of
/// \param contours contours of any arcs at any levels
/// \param curves the output: one curve for each contour, in this order
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
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
/// \exception Reeb_graph::Invalid_contour_error if a contour is not one of this mesh and field
///
/// and the exceptions of `compute_reeb_graph()`. When one is thrown, the mesh is as it was before.
template <class MutableFaceGraph,
          class ScalarMap,
          class ContourRange,
          class OutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
OutputIterator cut_along_contours(MutableFaceGraph& mesh,
                                  ScalarMap scalar_map,
                                  const ContourRange& contours,
                                  OutputIterator curves,
                                  const NamedParameters& np = parameters::default_values())
{
  const auto traits = internal::choose_traits(mesh, scalar_map, np);
  internal::check_input(mesh, scalar_map, traits);
  auto visitor_parameter = internal::choose_refinement_visitor(mesh, np);
  const auto ranked = internal::make_ranked_mesh(mesh, internal::unwrap_reference(visitor_parameter), np);
  internal::rank_vertices(ranked, scalar_map, traits);
  const auto contours_to_cut = internal::make_contours_to_cut(ranked, contours);
  const auto result = internal::cut_and_mark(ranked, contours_to_cut, np);
  return std::copy(result.begin(), result.end(), curves);
}

} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_CURVES_CUT_ALONG_CONTOURS_H
