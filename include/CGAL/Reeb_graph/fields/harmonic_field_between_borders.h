// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_HARMONIC_FIELD_BETWEEN_BORDERS_H
#define CGAL_REEB_GRAPH_FIELDS_HARMONIC_FIELD_BETWEEN_BORDERS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/Field_report.h>
#include <CGAL/Reeb_graph/fields/harmonic_field.h>
#include <CGAL/Reeb_graph/fields/internal/constraints.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphFields
///
/// \brief computes the harmonic field whose extrema are the borders of the mesh, so that they are levels, as
/// `cutting_system()`, `pants_decomposition()` and `branch_curves()` need it.
///
/// In each connected component, the field is 0 on the first border component and 1 on the other ones, in the order of
/// their first vertices. If there is one border, the field is 1 at a vertex far from it, or 0 all over where all
/// vertices are on it. If there is none, it is 0 and 1 at the two vertices of `find_far_apart_vertices()`. An isolated
/// vertex gets the value 0. Borders at 1 that share edges are one plateau.
///
/// The template parameters, the named parameters, the result, and the exceptions are those of
/// `compute_harmonic_field()`.
template <class FaceListGraph, class FieldMap, class NamedParameters = parameters::Default_named_parameters>
Field_report compute_harmonic_field_between_borders(const FaceListGraph& mesh,
                                                    FieldMap field_map,
                                                    const NamedParameters& np = parameters::default_values())
{
  if constexpr(internal::Mesh_with_vertex_map<FaceListGraph, FieldMap>::value)
  {
    const internal::scalar_fields::Harmonic_constraints<FaceListGraph> constraints(mesh, np);
    return compute_harmonic_field(mesh, field_map, constraints.range(), np);
  }
  else
    return Field_report();
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_FIELDS_HARMONIC_FIELD_BETWEEN_BORDERS_H
