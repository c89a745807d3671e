// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_BRANCH_CURVES_H
#define CGAL_REEB_GRAPH_CURVES_BRANCH_CURVES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/internal/choose_contours.h>
#include <CGAL/Reeb_graph/curves/internal/simple_reeb_graph.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphCurves
///
/// \brief refines a mesh and finds branch curves: disjoint simple closed curves of mesh edges, each of which cuts off a
/// disk, a branch of the surface.
///
/// A branch is an arc of the Reeb graph with a leaf at one end, a minimum or maximum inside of the surface, and a
/// saddle at the other. Each gives one of its contours, which is contractible. A component whose Reeb graph is a single
/// arc has no branch.
///
/// Noise makes thousands of small leaf arcs. Those that do not reach a threshold are removed from the graph as by
/// `simplify()`, the least one first, relative to its threshold. Then the other two arcs at the saddle of a removed one
/// are one arc, which can be a branch that is long enough. A leaf arc that is the only one on its side of the saddle is
/// not removed, as no arc would go on there, but gives no curve either if it is small.
///
/// By default, the shortest contour of several candidates in the half next to the saddle is taken: a branch is cut off
/// where it is attached.
///
/// \reebGraphMethodOfCurves The time is that of `cutting_system()`.
///
/// \reebGraphTparamsOfCurves
///
/// \param mesh the mesh, which is changed. To keep it, pass a copy made by `CGAL::copy_face_graph()`.
/// \reebGraphFieldOfCurves
/// \param curves the output
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{persistence_threshold}
///     \cgalParamDescription{the least persistence of a branch, as `simplify()` measures it by default: the difference
///                           between the values at its ends, or that at the saddle and one that has been removed}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0}
///     \cgalParamExtra{use the function `parameters::persistence_threshold()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{area_threshold}
///     \cgalParamDescription{the least area of a branch: a third of the area of the faces at each of its vertices}
///     \cgalParamType{a number}
///     \cgalParamDefault{0}
///     \cgalParamExtra{one of \cgal, which comes behind those of the package}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_count_threshold}
///     \cgalParamDescription{the least number of vertices of the given mesh in a branch}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{0}
///     \cgalParamExtra{use the function `parameters::vertex_count_threshold()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{branch_measure}
///     \cgalParamDescription{how large a branch is, for `measure_threshold`}
///     \cgalParamType{a function object that is called with a `Reeb_graph::Branch` whose nodes are vertices of the
///                    mesh, and whose weight is its area, and returns a `double`. Where a saddle has been unfolded, its
///                    vertex can be a new one.}
///     \cgalParamDefault{none}
///     \cgalParamExtra{use the function `parameters::branch_measure()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{measure_threshold}
///     \cgalParamDescription{the least `branch_measure` of a branch}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0}
///     \cgalParamExtra{use the function `parameters::measure_threshold()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \reebGraphNamedParamsOfCurves
///
/// \pre The mesh is a triangulated surface, its borders are as `borders` says, and no threshold is negative or NaN.
///
/// \reebGraphComplexity
///
/// \returns the output iterator behind the last curve.
///
/// \reebGraphBorderLevelError
/// \exception Reeb_graph::Parameter_error if a threshold is negative or NaN, or a measure NaN
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
  const internal::Branch_thresholds<NamedParameters> thresholds(np); // It checks them before the mesh is changed.
  const internal::Progress progress(np);
  progress.report(0);
  internal::check_input(mesh, scalar_map, np);
  const OutputIterator end = internal::cut_along_chosen_contours(
    mesh, scalar_map, curves, np, internal::Stage_progress(progress, 0.05, 1), thresholds.needs_places(),
    [&](const auto& ranked, const auto& simple, const internal::Stage_progress& stage) {
      return internal::choose_branch_curves(ranked, simple, thresholds, np, stage);
    });
  progress.report_end();
  return end;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_CURVES_BRANCH_CURVES_H
