// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_PANTS_DECOMPOSITION_H
#define CGAL_REEB_GRAPH_CURVES_PANTS_DECOMPOSITION_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/internal/choose_contours.h>
#include <CGAL/Reeb_graph/curves/internal/simple_reeb_graph.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphCurves
///
/// \brief refines a mesh and finds a pants decomposition: disjoint simple closed curves of mesh edges that cut the
/// surface into pairs of pants, that is, spheres with three holes.
///
/// The leaves of the Reeb graph are removed one after the other, except for those that are borders of the surface, and
/// arcs that meet at a node of degree 2 are joined. Each arc of what is left, except for those that end at a border,
/// gives one of its contours. On a connected surface of genus \f$ g \f$ with \f$ b \f$ border components these are
/// exactly \f$ 3g - 3 + b \f$ curves, and \f$ 2g - 2 + b \f$ pairs of pants, for any field. No curve is contractible,
/// and no two are homotopic. Several connected components are decomposed one by one.
///
/// By default, the shortest contour of several candidates along each arc is taken.
///
/// \reebGraphMethodOfCurves The time is that of `cutting_system()`.
///
/// \reebGraphTparamsOfCurves
///
/// \param mesh the mesh, which is changed. To keep it, pass a copy made by `CGAL::copy_face_graph()`. The Euler
///        characteristic of each of its connected components must be negative.
/// \reebGraphFieldOfCurves
/// \param curves the output
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those below
///
/// \reebGraphNamedParamsOfCurves
///
/// \pre Each connected component has a negative Euler characteristic, and borders are as `borders` says.
///
/// \reebGraphComplexity
///
/// \returns the output iterator behind the last curve.
///
/// \exception Reeb_graph::No_pants_decomposition_error if a connected component is a sphere, a disk, an annulus, or a
///            torus
/// \reebGraphBorderLevelError
///
/// and the exceptions of `compute_reeb_graph()`. When one is thrown, the mesh is as it was before.
template <class MutableFaceGraph,
          class ScalarMap,
          class OutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
OutputIterator pants_decomposition(MutableFaceGraph& mesh,
                                   ScalarMap scalar_map,
                                   OutputIterator curves,
                                   const NamedParameters& np = parameters::default_values())
{
  const internal::Progress progress(np);
  progress.report(0);
  internal::check_input(mesh, scalar_map, np);
  internal::check_negative_euler_characteristics(mesh);
  const OutputIterator end =
    internal::cut_into_pants(mesh, scalar_map, curves, np, internal::Stage_progress(progress, 0.05, 1));
  progress.report_end();
  return end;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_CURVES_PANTS_DECOMPOSITION_H
