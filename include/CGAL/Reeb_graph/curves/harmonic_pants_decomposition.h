// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_HARMONIC_PANTS_DECOMPOSITION_H
#define CGAL_REEB_GRAPH_CURVES_HARMONIC_PANTS_DECOMPOSITION_H

#include <CGAL/Reeb_graph/curves/internal/cut_and_mark.h>
#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/internal/simple_reeb_graph.h>
#include <CGAL/Reeb_graph/curves/pants_decomposition.h>
#include <CGAL/Reeb_graph/fields/harmonic_field.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>

#include <CGAL/boost/graph/properties.h>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphCurves
///
/// \brief refines a mesh and finds a pants decomposition by a harmonic field, which it computes.
///
/// The field is that of `compute_harmonic_field_between_borders()`: it has no extrema but the borders, or two vertices
/// that are far apart.
///
/// \reebGraphRefinedMesh
/// \tparam OutputIterator a model of `OutputIterator` for `Reeb_graph::Curve`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the mesh, which is changed
/// \param curves the output
/// \param np the named parameters of `pants_decomposition()`, but for `geom_traits`, and those of
///        `compute_harmonic_field()`
///
/// \pre Each connected component has a negative Euler characteristic.
///
/// \reebGraphComplexity
///
/// \returns the output iterator behind the last curve.
///
/// It throws the exceptions of these two functions. When one is thrown, the mesh is as it was before.
template <class MutableFaceGraph, class OutputIterator, class NamedParameters = parameters::Default_named_parameters>
OutputIterator harmonic_pants_decomposition(MutableFaceGraph& mesh,
                                            OutputIterator curves,
                                            const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::are_met<internal::Refinable_mesh<MutableFaceGraph>>);
  const internal::Progress progress(np);
  progress.report(0);
  internal::check_mesh(mesh);
  internal::check_negative_euler_characteristics(mesh);
  const auto field_map = get(dynamic_vertex_property_t<double>(), mesh);
  const internal::Stage_progress field_progress(progress, 0.05, 0.9);
  compute_harmonic_field_between_borders(mesh, field_map, np.callback(field_progress.callback()));
  const OutputIterator end =
    internal::cut_into_pants(mesh, field_map, curves, np, internal::Stage_progress(progress, 0.9, 1));
  progress.report_end();
  return end;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_CURVES_HARMONIC_PANTS_DECOMPOSITION_H
