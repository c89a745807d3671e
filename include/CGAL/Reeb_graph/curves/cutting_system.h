// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_CUTTING_SYSTEM_H
#define CGAL_REEB_GRAPH_CURVES_CUTTING_SYSTEM_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/internal/choose_contours.h>
#include <CGAL/Reeb_graph/curves/internal/simple_reeb_graph.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>

#include <type_traits>

namespace CGAL::Reeb_graph {

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
/// By default the curves are short. Leaves of the graph do not matter here, and are removed. Along each arc that is
/// left the shortest contour of several candidates is taken, and the arcs outside of a maximum spanning tree of these
/// lengths give the curves.
///
/// \reebGraphMethodOfCurves It takes \f$ O(n \log n + l) \f$ time, where
/// \f$ n \f$ is the number of vertices and faces, and \f$ l \f$ is the number of edges that are crossed by the contours
/// that the computation of the graph traces, by the candidates, and by the curves.
///
/// \reebGraphTparamsOfCurves
///
/// \param mesh the mesh, which is changed. To keep it, pass a copy made by `CGAL::copy_face_graph()`.
/// \reebGraphFieldOfCurves
/// \param curves the output
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{arc_weight}
///     \cgalParamDescription{chooses the curves: those of the arcs in a maximum spanning tree of the weights are not
///                           taken. It is called with the candidate that has been chosen for the arc.}
///     \cgalParamType{a function object that is called with a `Reeb_graph::Candidate_curve` and returns a `double`}
///     \cgalParamDefault{the length}
///     \cgalParamExtra{use the function `parameters::arc_weight()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \reebGraphNamedParamsOfCurves
///
/// \pre The mesh is a triangulated surface, and its borders are as `borders` says.
///
/// \reebGraphComplexity
///
/// \returns the output iterator behind the last curve.
///
/// \reebGraphBorderLevelError
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
  const internal::Progress progress(np);
  progress.report(0);
  internal::check_input(mesh, scalar_map, np);
  const OutputIterator end = internal::cut_along_chosen_contours(
    mesh, scalar_map, curves, np, internal::Stage_progress(progress, 0.05, 1), std::false_type(),
    [&](const auto& ranked, const auto& simple, const internal::Stage_progress& stage) {
      return internal::choose_cutting_system(ranked, simple, np, stage);
    });
  progress.report_end();
  return end;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_CURVES_CUTTING_SYSTEM_H
