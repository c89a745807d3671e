// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_CUT_ALONG_CONTOURS_H
#define CGAL_REEB_GRAPH_CURVES_CUT_ALONG_CONTOURS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Contour.h>
#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/exceptions.h>
#include <CGAL/Reeb_graph/curves/internal/Ranked_mesh.h>
#include <CGAL/Reeb_graph/curves/internal/cut_and_mark.h>
#include <CGAL/Reeb_graph/curves/internal/simple_reeb_graph.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphCurves
///
/// \brief refines a mesh so that contours become paths of edges.
///
/// The edges that a contour crosses are split where it does, and the faces between them; what is left of a face is
/// triangulated. The mesh stays a triangle mesh with the same surface. Any number of contours may pass one edge or one
/// face, and may lie at levels as close to each other as they like. Their points on an edge are kept apart by at least
/// 0.4 / (<em>k</em> + 1) of its length, where \e k is the number of contours that cross it, and from its ends by at
/// least 0.1 / (<em>k</em> + 1). So no face is degenerate unless it comes from a degenerate one.
///
/// Handles of the mesh stay valid: an edge that is split keeps its upper part, a face that is split one of its parts.
/// With \f$ n \f$ vertices and faces and \f$ l \f$ crossed edges in all contours it takes \f$ O(n \log n + l) \f$
/// time, the first part for sorting the vertices.
///
/// \reebGraphRefinedMeshAndField
/// \tparam ContourRange a range of `Reeb_graph::Contour`, as `Reeb_graph::Augmentation` makes them
/// \tparam OutputIterator a model of `OutputIterator` for `Reeb_graph::Curve`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the mesh, which is changed. To keep it, pass a copy made by `CGAL::copy_face_graph()`.
/// \param scalar_map the scalar field that the contours are of
/// \param contours contours of any arcs at any levels
/// \param curves the output: one curve for each contour, in this order
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those below
///
/// \copydetails PkgReebGraphCuttingParameters
///
/// \copydetails PkgReebGraphRefinementParameters
///
/// \pre Each contour is one of the mesh and the field.
///
/// \reebGraphComplexity
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
  typedef internal::Chosen_traits<Reeb_graph_traits<MutableFaceGraph, ScalarMap>, NamedParameters> Traits;
  static_assert(internal::are_met<internal::Refinable_mesh<MutableFaceGraph>,
                                  internal::Field_of_numbers<MutableFaceGraph, ScalarMap, Traits>>);
  const internal::Progress progress(np);
  progress.report(0);
  internal::check_input(mesh, scalar_map, np);
  const auto traits = internal::choose_traits<Traits>(np);
  const OutputIterator end = internal::cut_along_found_contours(
    mesh, scalar_map, traits, curves, np, internal::Stage_progress(progress, 0.1, 0.3),
    internal::Stage_progress(progress, 0.3, 1), [&](const auto& ranked, const internal::Stage_progress& stage) {
      stage(0);
      internal::rank_vertices(ranked, scalar_map, traits);
      stage(0.7);
      return internal::make_contours_to_cut(ranked, contours);
    });
  progress.report_end();
  return end;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_CURVES_CUT_ALONG_CONTOURS_H
